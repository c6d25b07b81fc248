using UnityEngine;

namespace Glint.Host;

/// <summary>CreatePrimitive without colliders, since the host has no physics.</summary>
internal static class Primitives
{
    internal static GameObject Create(PrimitiveType type)
    {
        var item = new GameObject(type.ToString());
        item.AddComponent<MeshFilter>().sharedMesh = BuiltinMeshes.Get(type);
        item.AddComponent<MeshRenderer>().sharedMaterial = BuiltinMaterial.Get();
        return item;
    }
}
