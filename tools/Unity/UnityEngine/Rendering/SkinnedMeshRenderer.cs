using Glint.Host;

namespace UnityEngine;

/// <summary>Known by name only; the host does not pose it.</summary>
public class SkinnedMeshRenderer : Renderer
{
    Mesh _sharedMesh;

    public Mesh sharedMesh
    {
        get
        {
            EnsureAlive();
            return _sharedMesh;
        }
        set
        {
            EnsureAlive();
            _sharedMesh = value;
        }
    }

    internal override Bounds LocalBounds() => sharedMesh == null ? default : sharedMesh.bounds;

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        _sharedMesh = ((SkinnedMeshRenderer)source)._sharedMesh;
    }
}
