using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A scene as one mesh.</summary>
    public static class WorldMesh
    {
        /// <summary>
        /// All instances in the world's axes, metres, in their order; positions are rounded to float32 at the end.
        /// </summary>
        /// <exception cref="GlintException">More vertices or indices than an array can hold.</exception>
        public static TriangleMesh Of(RadarScene scene)
        {
            long vertexCount = 0, indexCount = 0;
            foreach (var instance in scene.Instances)
            {
                vertexCount += instance.Mesh.Vertices.Length;
                indexCount += instance.Mesh.Indices.Length;
            }
            if (vertexCount > int.MaxValue || indexCount > int.MaxValue)
                throw new GlintException($"{scene.TriangleCount} triangles do not go into one mesh, "
                    + $"which holds at most {int.MaxValue / 3}: use fewer or simpler objects");

            var vertices = new float3[vertexCount];
            var indices = new int[indexCount];
            int vertex = 0, index = 0;
            foreach (var instance in scene.Instances)
            {
                int first = vertex;
                foreach (var position in instance.Mesh.Vertices)
                    vertices[vertex++] = (float3)instance.ToWorld.Point(position);
                foreach (int number in instance.Mesh.Indices)
                    indices[index++] = first + number;
            }
            return new TriangleMesh(vertices, indices);
        }
    }
}
