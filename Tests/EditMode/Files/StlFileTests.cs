using System.IO;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class StlFileTests
    {
        [Test]
        public void Write_ThenRead_GivesTheSameTrianglesWithTheirOuterSides()
        {
            var box = new TriangleMesh(Solid.BoxVertices(0.1f, 2, 3e4f), Solid.BoxIndices);
            var stream = new MemoryStream();
            StlFile.Write(stream, box);

            stream.Position = 0;
            Assert.That(stream.Length, Is.EqualTo(84 + 50 * box.TriangleCount));
            var read = MeshFileReader.Read(stream, "box.stl", LengthUnit.Parse("m"), UpAxis.Y);
            Assert.That(Solid.Triangles(read), Is.EqualTo(Solid.Triangles(box.Vertices, box.Indices)));
            Assert.That(Solid.Volume(read), Is.EqualTo(0.1f * 2.0 * 3e4f).Within(1e-6).Percent);
        }
    }
}
