using System.Globalization;
using System.IO;
using System.Text;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Writes meshes in each format that the reader accepts, with enough digits for every float.</summary>
    static class MeshFileWriter
    {
        public static byte[] Obj(float3[] vertices, int[] indices)
        {
            var text = new StringBuilder("# a mesh\no mesh\n");
            foreach (var vertex in vertices)
                text.Append($"v {Text(vertex)}\n");
            for (int i = 0; i < indices.Length; i += 3)
                text.Append(Invariant($"f {indices[i] + 1} {indices[i + 1] + 1} {indices[i + 2] + 1}\n"));
            return Encoding.ASCII.GetBytes(text.ToString());
        }

        public static byte[] StlText(float3[] vertices, int[] indices)
        {
            var text = new StringBuilder("solid mesh\n");
            for (int i = 0; i < indices.Length; i += 3)
            {
                text.Append("  facet normal 0 0 0\n    outer loop\n");
                for (int corner = 0; corner < 3; corner++)
                    text.Append($"      vertex {Text(vertices[indices[i + corner]])}\n");
                text.Append("    endloop\n  endfacet\n");
            }
            return Encoding.ASCII.GetBytes(text.Append("endsolid mesh\n").ToString());
        }

        /// <param name="head">The first of the 80 bytes before the count.</param>
        /// <param name="count">Number of triangles in the header; null for the true number.</param>
        public static byte[] StlBinary(float3[] vertices, int[] indices, string head = "", uint? count = null)
        {
            var stream = new MemoryStream();
            using (var writer = new BinaryWriter(stream))
            {
                writer.Write(Encoding.ASCII.GetBytes(head.PadRight(80)));
                writer.Write(count ?? (uint)(indices.Length / 3));
                for (int i = 0; i < indices.Length; i++)
                {
                    if (i % 3 == 0)
                        Write(writer, new float3(float.NaN, float.NaN, float.NaN));
                    Write(writer, vertices[indices[i]]);
                    if (i % 3 == 2)
                        writer.Write((ushort)0xffff);
                }
            }
            return stream.ToArray();
        }

        static void Write(BinaryWriter writer, float3 point)
        {
            writer.Write(point.x);
            writer.Write(point.y);
            writer.Write(point.z);
        }

        static string Text(float3 point) => Invariant($"{point.x:G9} {point.y:G9} {point.z:G9}");

        static string Invariant(System.FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
    }
}
