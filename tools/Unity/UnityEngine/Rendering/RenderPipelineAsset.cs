namespace UnityEngine.Rendering;

/// <summary>Nothing is drawn here: only the material of new objects matters.</summary>
public abstract class RenderPipelineAsset : ScriptableObject
{
    /// <summary>That of new objects; null in a player.</summary>
    public virtual Material defaultMaterial => null;
}
