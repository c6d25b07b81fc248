using System.IO;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// A binary format of triangles for other programs: number of vertices and of triangles, x, y, z of each vertex
    /// (float32, metres), three vertex indices of each triangle. Little-endian; integers are int32.
    /// </summary>
    public static class BinaryScene
    {
        const int BufferBytes = 1 << 20;

        /// <summary>Writes a mesh.</summary>
        /// <exception cref="System.IO.IOException">Writing to the stream fails.</exception>
        public static void Write(Stream stream, TriangleMesh mesh)
        {
            // Neither is disposed: that would close the caller's stream.
            var buffer = new BufferedStream(stream, BufferBytes);
            var writer = new BinaryWriter(buffer);
            writer.Write(mesh.Vertices.Length);
            writer.Write(mesh.TriangleCount);
            foreach (var vertex in mesh.Vertices)
            {
                writer.Write(vertex.x);
                writer.Write(vertex.y);
                writer.Write(vertex.z);
            }
            foreach (int index in mesh.Indices)
                writer.Write(index);
            writer.Flush();
        }
    }

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
