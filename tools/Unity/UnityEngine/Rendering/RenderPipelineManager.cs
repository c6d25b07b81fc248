using System;

namespace UnityEngine.Rendering;

/// <summary>There is no render pipeline: nobody calls it.</summary>
public static class RenderPipelineManager
{
#pragma warning disable CS0067 // never used
    public static event Action<ScriptableRenderContext, Camera> beginCameraRendering;
#pragma warning restore CS0067
}
