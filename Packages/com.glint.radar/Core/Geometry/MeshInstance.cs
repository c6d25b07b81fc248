namespace Glint.Core
{
    /// <summary>A mesh at its place in the world.</summary>
    public struct MeshInstance
    {
        public TriangleMesh Mesh;

        public Affine ToWorld;
    }
}
