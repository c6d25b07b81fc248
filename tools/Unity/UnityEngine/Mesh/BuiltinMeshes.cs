using System.Collections.Generic;
using UnityEngine;

namespace Glint.Host;

/// <summary>
/// Unity's primitive meshes, without texture coordinates. Cube, Plane and Quad have Unity's vertices. The round ones
/// have Unity's size and triangle count; their vertices, which are unknown, lie on the true surface.
/// </summary>
internal static class BuiltinMeshes
{
    internal const string AssetPath = "Library/unity default resources";

    static readonly Dictionary<PrimitiveType, Mesh> _meshes = new();

    static readonly Dictionary<PrimitiveType, long> _fileIds = new()
    {
        [PrimitiveType.Cube] = 10202,
        [PrimitiveType.Cylinder] = 10206,
        [PrimitiveType.Sphere] = 10207,
        [PrimitiveType.Capsule] = 10208,
        [PrimitiveType.Plane] = 10209,
        [PrimitiveType.Quad] = 10210,
    };

    internal static Mesh Get(PrimitiveType type)
    {
        if (!_meshes.TryGetValue(type, out Mesh mesh) || mesh.IsDestroyed)
            _meshes[type] = mesh = Make(type);
        return mesh;
    }

    /// <summary>The mesh of a fileID in scenes; null if it is not a mesh.</summary>
    internal static Mesh ByFileId(long fileId)
    {
        foreach ((PrimitiveType type, long id) in _fileIds)
        {
            if (id == fileId)
                return Get(type);
        }
        return null;
    }

    static Mesh Make(PrimitiveType type)
    {
        var mesh = ObjectRegistry.Make(true, () => new Mesh { name = type.ToString() });
        MeshBuilder builder = type switch
        {
            PrimitiveType.Cube => FlatMeshes.Cube(),
            PrimitiveType.Plane => FlatMeshes.Plane(),
            PrimitiveType.Quad => FlatMeshes.Quad(),
            PrimitiveType.Sphere => RoundMeshes.Sphere(),
            PrimitiveType.Capsule => RoundMeshes.Capsule(),
            _ => RoundMeshes.Cylinder(),
        };
        builder.Fill(mesh);
        mesh.AssetPath = AssetPath;
        mesh.FileId = _fileIds[type];
        return mesh;
    }
}
