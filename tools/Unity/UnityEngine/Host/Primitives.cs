using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host;

/// <summary>CreatePrimitive without colliders, since the host has no physics.</summary>
internal static class Primitives
{
    static Material PipelineMaterial =>
        GraphicsSettings.currentRenderPipeline is { } pipeline ? pipeline.defaultMaterial : null;

    internal static GameObject Create(PrimitiveType type)
    {
        var item = new GameObject(type.ToString());
        item.AddComponent<MeshFilter>().sharedMesh = BuiltinMeshes.Get(type);
        item.AddComponent<MeshRenderer>().sharedMaterial = PipelineMaterial ?? BuiltinMaterial.Get();
        return item;
    }
}
