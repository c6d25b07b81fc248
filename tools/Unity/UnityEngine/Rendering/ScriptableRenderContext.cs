namespace UnityEngine.Rendering;

public struct ScriptableRenderContext
{
}
