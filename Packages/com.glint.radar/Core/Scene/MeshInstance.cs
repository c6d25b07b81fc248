namespace Glint.Core
{
    /// <summary>A mesh at its place in the world.</summary>
    public struct MeshInstance
    {
        /// <summary>The triangles, in a frame of their own. The same object may stand at many places.</summary>
        public TriangleMesh Mesh;

        /// <summary>From the mesh's frame to the scene's, metres.</summary>
        public Affine ToWorld;
    }
}
