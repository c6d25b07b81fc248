using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class StlReaderTests
    {
        const string Facet =
            "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

        static readonly float3[] Vertices = Solid.BoxVertices(1, 1, 1);

        [TestCase("solid a b c\n" + Facet + "endsolid a b c\n", 1, TestName = "Text_OneSolid_IsRead")]
        [TestCase("solid\n" + Facet + "endsolid", 1, TestName = "Text_WithoutNameAndLastLineEnd_IsRead")]
        [TestCase("solid a\n" + Facet + "endsolid a\nsolid b\n" + Facet + Facet + "endsolid b\n", 3,
            TestName = "Text_SeveralSolids_BecomeOneMesh")]
        [TestCase("\ufeffsolid a\n" + Facet + "endsolid a\n", 1, TestName = "Text_WithByteOrderMark_IsRead")]
        [TestCase("solid a\nfacet normal nan 0 -1.#IND outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop "
            + "endfacet endsolid", 1, TestName = "Text_OnOneLine_IsRead")]
        public void Text_InEachForm_GivesItsTriangles(string text, int triangles)
        {
            foreach (string form in new[]
            {
                text, text.Replace("\n", "\r\n"), text.ToUpperInvariant().Replace("\n", "\n\t\n  ")
            })
                Assert.That(ReadText.Stl(form).TriangleCount, Is.EqualTo(triangles));
        }

        [TestCase("solid a\n" + Facet, "model.stl:9:", "ends", "endsolid", TestName = "Text_WithoutEndSolid_IsRefused")]
        [TestCase("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1", "model.stl:5:", "ends where y",
            TestName = "Text_TruncatedInAVertex_IsRefused")]
        [TestCase("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop", "model.stl:6:",
            "\"endloop\"", "vertex", TestName = "Text_FacetOfTwoCorners_IsRefused")]
        [TestCase("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n",
            "model.stl:7:", "\"vertex\"", "endloop", TestName = "Text_FacetOfFourCorners_IsRefused")]
        [TestCase("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0\n", "model.stl:4:", "y is \"nan\"",
            TestName = "Text_NaN_IsRefused")]
        [TestCase("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 1e39 0\n", "model.stl:4:", "y is \"1e39\" m",
            TestName = "Text_BeyondFloat_IsRefused")]
        [TestCase("solid a\nendsolid a\n", "model.stl:", "no triangles", TestName = "Text_EmptySolid_IsRefused")]
        [TestCase("solid a\n" + Facet + "endsolid a\nv 0 0 0", "model.stl:10:", "\"v\"", "solid",
            TestName = "Text_GoesOnInAnotherFormat_IsRefused")]
        [TestCase("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "model.stl:", "too few", "\"solid\"",
            TestName = "Text_ShortAndOfAnotherFormat_IsRefused")]
        public void Text_Damaged_IsRefused(string text, params string[] parts) =>
            ReadText.AssertRefused(() => ReadText.Stl(text), parts);

        [Test]
        public void Binary_BeginningWithSolid_IsReadByItsLength()
        {
            var mesh = ReadText.Bytes("model.stl",
                MeshFileWriter.StlBinary(Vertices, Solid.BoxIndices, "solid exported\nfacet normal 0 0 1"));
            Assert.That(Solid.Triangles(mesh).ToArray(),
                Is.EqualTo(Solid.Triangles(Vertices, Solid.BoxIndices).ToArray()));
        }

        [TestCase("", 13u)]
        [TestCase("", 11u)]
        [TestCase("", 0u)]
        [TestCase("solid", 13u)]
        [TestCase("", uint.MaxValue)]
        public void Binary_LyingCount_IsRefused(string head, uint count)
        {
            byte[] content = MeshFileWriter.StlBinary(Vertices, Solid.BoxIndices, head, count);
            ReadText.AssertRefused(() => ReadText.Bytes("model.stl", content), "model.stl:",
                $"announces {count} triangles", (84 + 50L * count).ToString(), "684");
        }

        [TestCase(683, "announces 12 triangles", "684")]
        [TestCase(84, "announces 12 triangles", "84")]
        [TestCase(83, "has 83 bytes")]
        [TestCase(1, "has 1 bytes")]
        public void Binary_Truncated_IsRefused(int length, params string[] parts)
        {
            byte[] content = MeshFileWriter.StlBinary(Vertices, Solid.BoxIndices).Take(length).ToArray();
            ReadText.AssertRefused(() => ReadText.Bytes("model.stl", content), parts);
        }

        [Test]
        public void Binary_WithoutTriangles_IsRefused()
        {
            ReadText.AssertRefused(() => ReadText.Bytes("model.stl", MeshFileWriter.StlBinary(Vertices, new int[0])),
                "model.stl:", "no triangles");
        }

        [TestCase(float.NaN, "NaN")]
        [TestCase(float.PositiveInfinity, "infinite")]
        [TestCase(float.NegativeInfinity, "minus infinite")]
        public void Binary_NotFinite_NamesTriangleCornerAndAxis(float value, string name)
        {
            byte[] content = MeshFileWriter.StlBinary(Vertices, Solid.BoxIndices);
            // The y of the third corner of the fifth triangle.
            BitConverter.GetBytes(value).CopyTo(content, 84 + 50 * 4 + 12 + 12 * 2 + 4);
            ReadText.AssertRefused(() => ReadText.Bytes("model.stl", content), "triangle 5, corner 3: y is " + name);
        }

        [Test]
        public void Binary_BeyondFloatByItsUnit_NamesValueAndUnit()
        {
            byte[] content = MeshFileWriter.StlBinary(new[] { new float3(0, 0, 3e38f) }, new int[3]);
            ReadText.AssertRefused(() => ReadText.Bytes("model.stl", content, "km"), "triangle 1, corner 1: z is ",
                "E+38 km", "another unit");
            Assert.That(ReadText.Bytes("model.stl", content, "mm").TriangleCount, Is.EqualTo(1));
        }
    }
}
