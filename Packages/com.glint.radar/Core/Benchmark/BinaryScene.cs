using System.IO;

namespace Glint.Core
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
}
