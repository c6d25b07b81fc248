using System.IO;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Writes meshes as binary STL files, whose float32 coordinates are those of the mesh.</summary>
    public static class StlFile
    {
        const int HeaderBytes = 80;

        /// <summary>Writes a mesh in metres and Unity's axes: as glint reads it without further options.</summary>
        /// <param name="output">Stays open.</param>
        public static void Write(Stream output, TriangleMesh mesh)
        {
            var writer = new BinaryWriter(output);
            writer.Write(new byte[HeaderBytes]);
            writer.Write(mesh.TriangleCount);
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out var a, out var b, out var c);
                // A normal of 0 means that of the corners.
                foreach (var row in new[] { float3.zero, a, b, c })
                {
                    writer.Write(row.x);
                    writer.Write(row.y);
                    writer.Write(row.z);
                }
                writer.Write((ushort)0);
            }
            writer.Flush();
        }
    }
}
