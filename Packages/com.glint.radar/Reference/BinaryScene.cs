using System.IO;
using Glint.Core;

namespace Glint.Reference
{
    /// <summary>
    /// Triangles as plain numbers, for other programs: number of vertices and of triangles, x, y, z of each vertex
    /// (float32, metres), three vertex numbers of each triangle. All little-endian, whole numbers int32.
    /// </summary>
    public static class BinaryScene
    {
        const int BufferBytes = 1 << 20;

        /// <summary>Writes a mesh.</summary>
        /// <exception cref="System.IO.IOException">The stream takes no more.</exception>
        public static void Write(Stream stream, TriangleMesh mesh)
        {
            // Neither is disposed: that would close the stream, which is the caller's.
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
