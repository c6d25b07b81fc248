namespace UnityEngine;

public class MeshRenderer : Renderer
{
    internal override Bounds LocalBounds()
    {
        Mesh mesh = TryGetComponent(out MeshFilter filter) ? filter.sharedMesh : null;
        return mesh == null ? default : mesh.bounds;
    }
}
