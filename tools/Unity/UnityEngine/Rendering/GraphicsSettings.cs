namespace UnityEngine.Rendering;

public sealed class GraphicsSettings : Object
{
    GraphicsSettings()
    {
    }

    /// <summary>Null: the built-in render pipeline.</summary>
    public static RenderPipelineAsset defaultRenderPipeline { get; set; }

    public static RenderPipelineAsset currentRenderPipeline => defaultRenderPipeline;
}
