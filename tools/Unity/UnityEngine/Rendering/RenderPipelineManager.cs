using System;

namespace UnityEngine.Rendering;

/// <summary>The host has no render pipeline and never raises the events.</summary>
public static class RenderPipelineManager
{
#pragma warning disable CS0067 // never used
    public static event Action<ScriptableRenderContext, Camera> beginCameraRendering;
#pragma warning restore CS0067
}
