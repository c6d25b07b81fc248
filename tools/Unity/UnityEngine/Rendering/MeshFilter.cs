using Glint.Host;

namespace UnityEngine;

public sealed class MeshFilter : Component
{
    Mesh _sharedMesh;
    Mesh _instance;

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

    /// <summary>The first read copies the shared mesh, so that changes stay with this object.</summary>
    public Mesh mesh
    {
        get
        {
            if (sharedMesh != null && sharedMesh != _instance)
            {
                string meshName = sharedMesh.name;
                _sharedMesh = _instance = Instantiate(sharedMesh);
                _instance.name = meshName + " Instance";
            }
            return _sharedMesh;
        }
        set => sharedMesh = _instance = value;
    }

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        _sharedMesh = ((MeshFilter)source)._sharedMesh;
    }
}
