using System.Linq;
using System.Text;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class ObjReaderTests
    {
        const string Corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

        [TestCase("f 1 2 3", new[] { 0, 1, 2 })]
        [TestCase("f 1/7 2/8 3/9", new[] { 0, 1, 2 })]
        [TestCase("f 1//7 2//8 3//9", new[] { 0, 1, 2 })]
        [TestCase("f 1/7/4 2/8/5 3/9/6", new[] { 0, 1, 2 })]
        [TestCase("f -4 -3/-1 -1//-1", new[] { 0, 1, 3 })]
        [TestCase("f 1 2 3 4", new[] { 0, 1, 2, 0, 2, 3 })]
        [TestCase("f 1 2 3 # first\nf 3 4 1", new[] { 0, 1, 2, 2, 3, 0 })]
        [TestCase("\tf  1\t2 3  ", new[] { 0, 1, 2 })]
        [TestCase("f 1 \\\n 2 \\\r\n3", new[] { 0, 1, 2 })]
        public void Face_InEachForm_GivesItsTriangles(string face, int[] indices)
        {
            Assert.That(ReadText.Obj(Corners + face).Indices, Is.EqualTo(indices));
        }

        [Test]
        public void Face_Polygon_IsAFanAboutItsFirstCorner()
        {
            Assert.That(ReadText.Obj(Corners + "v 0 0.5 0\nf 1 2 3 4 5").Indices,
                Is.EqualTo(new[] { 0, 1, 2, 0, 2, 3, 0, 3, 4 }));
        }

        [Test]
        public void Face_BeforeItsVertices_IsRead() =>
            Assert.That(ReadText.Obj("f 1 2 3\n" + Corners).TriangleCount, Is.EqualTo(1));

        [TestCase("1 2 3", 1f, 2f, 3f)]
        [TestCase("-1.5 +.25 3.", -1.5f, 0.25f, 3f)]
        [TestCase("1e2 -2.5E-3 4E+1", 100f, -0.0025f, 40f)]
        [TestCase("0.1 0.30000000000000004 1234567.1234567890123", 0.1f, 0.3f, 1234567.125f)]
        [TestCase("1e-400 0e999 -0", 0f, 0f, 0f)]
        [TestCase("1 2 3 1.0", 1f, 2f, 3f)]
        [TestCase("1 2 3 0.5 0.5 0.5", 1f, 2f, 3f)]
        [TestCase("1 2 3 1 0.5 0.5 0.5", 1f, 2f, 3f)]
        [TestCase("1 2 3 # a corner", 1f, 2f, 3f)]
        public void Vertex_InEachForm_GivesItsPosition(string numbers, float x, float y, float z)
        {
            Assert.That(ReadText.Obj($"v {numbers}\nf 1 1 1").Vertices.Single(), Is.EqualTo(new float3(x, y, z)));
        }

        [TestCase("g a\no b\ns off\nmtllib d.mtl")]
        [TestCase("vt 0 0\nvn 0 0 1\nvp 1 1")]
        [TestCase("p 1\nl 1 2\ncstype bezier\ndeg 3\ncurv 0 1 1 2\nparm u 0 1\nend")]
        [TestCase("# a path ends in a backslash \\")]
        [TestCase("\n\n  \n#")]
        public void Statement_ThatMakesNoTriangle_IsPassedOver(string statements)
        {
            Assert.That(ReadText.Obj($"{statements}\n{Corners}{statements}\nf 1 2 3\n{statements}").TriangleCount,
                Is.EqualTo(1));
        }

        [Test]
        public void UseMaterial_PutsTheTrianglesOfEachMaterialInARow()
        {
            var file = ReadText.Obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nusemtl dark wood # oak\nf 1 2 4\n"
                + "usemtl steel\nf 2 3 4\nusemtl dark wood\nf 1 3 4\nusemtl none of it\n");
            Assert.That(file.Surfaces.Select(surface => (surface.FirstTriangle, surface.Material)),
                Is.EqualTo(new[] { (0, null), (1, "dark wood"), (3, "steel") }));
            Assert.That(file.Indices, Is.EqualTo(new[] { 0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3 }));
        }

        [Test]
        public void File_WithByteOrderMarkAndCrLf_IsRead()
        {
            Assert.That(ReadText.Obj("\ufeff" + (Corners + "f 1 2 3\n").Replace("\n", "\r\n")).TriangleCount,
                Is.EqualTo(1));
        }

        [Test]
        public void Line_LongerThanTheBuffer_IsRead()
        {
            // A fan of 20,000 corners is a line of more than 64 KiB.
            string face = "f " + string.Join(" ",
                Enumerable.Range(0, 20000).Select(i => "1 2 3".Substring(2 * (i % 3), 1) + "//1234"));
            Assert.That(ReadText.Obj(Corners + face).TriangleCount, Is.EqualTo(19998));
        }

        [TestCase("v 1 2\nf 1 1 1", "model.obj:1:", "no z", TestName = "Vertex_Truncated_IsRefused")]
        [TestCase("v 1 # 2 3\nf 1 1 1", "model.obj:1:", "no y", TestName = "Vertex_CommentedOff_IsRefused")]
        [TestCase("v 0 0 0\nv 1 nan 3", "model.obj:2:", "y is \"nan\"", "not a finite number",
            TestName = "Vertex_NaN_IsRefused")]
        [TestCase("v 0 0 inf", "model.obj:1:", "z is \"inf\"", TestName = "Vertex_Infinite_IsRefused")]
        [TestCase("v 1,5 0 0", "model.obj:1:", "x is \"1,5\"", TestName = "Vertex_DecimalComma_IsRefused")]
        [TestCase("v 1e 0 0", "model.obj:1:", "x is \"1e\"", TestName = "Vertex_ExponentWithoutDigits_IsRefused")]
        [TestCase("v 0 -3.5e38 0", "model.obj:1:", "y is \"-3.5e38\" m", "than a float holds",
            TestName = "Vertex_BeyondFloat_IsRefused")]
        [TestCase("v 0 1e999 0", "model.obj:1:", "y is \"1e999\" m", TestName = "Vertex_BeyondDouble_IsRefused")]
        [TestCase("v 1 2 3 v 4 5 6", "model.obj:1:", "\"v\" does not belong",
            TestName = "Vertex_JoinedWithTheNext_IsRefused")]
        [TestCase("v 1 2 3 4 5 6 7 8", "model.obj:1:", "\"8\" does not belong",
            TestName = "Vertex_TooManyNumbers_IsRefused")]
        [TestCase(Corners + "f 1 2", "model.obj:5:", "2 corners", TestName = "Face_TwoCorners_IsRefused")]
        [TestCase(Corners + "f 1 2 0", "model.obj:5:", "vertex 0", "counts from 1",
            TestName = "Face_IndexZero_IsRefused")]
        [TestCase(Corners + "f 1 2 5\nf 1 2 3", "model.obj:5:", "refers to vertex 5", "the file has 4",
            TestName = "Face_IndexBeyondTheEnd_IsRefused")]
        [TestCase(Corners + "f 1 2 99999999999999999999", "model.obj:5:", "the file has 4",
            TestName = "Face_IndexBeyondInteger_IsRefused")]
        [TestCase(Corners + "f 1 2 -5", "model.obj:5:", "\"-5\"", "4 up to here",
            TestName = "Face_IndexBeforeTheStart_IsRefused")]
        [TestCase(Corners + "f 1 2 3.5", "model.obj:5:", "\"3.5\"", "whole numbers",
            TestName = "Face_IndexNotWhole_IsRefused")]
        [TestCase(Corners + "f 1 2 3/x", "model.obj:5:", "\"3/x\"", TestName = "Face_TextureNotANumber_IsRefused")]
        [TestCase(Corners + "f 1 \\\n2 \\\n0\n", "model.obj:5:", "vertex 0",
            TestName = "Face_OverSeveralLines_IsRefusedByItsFirst")]
        [TestCase(Corners, "model.obj:", "no triangles", "4 vertices", TestName = "File_WithoutFaces_IsRefused")]
        [TestCase("# nothing\n", "model.obj:", "no triangles", TestName = "File_OfComments_IsRefused")]
        [TestCase("solid x\n", "model.obj:1:", "\"solid\" is not an OBJ statement",
            TestName = "File_OfAnotherFormat_IsRefused")]
        [TestCase("v 0 0 0\nv 1 0\0 0\n", "model.obj:2:", "binary data", TestName = "File_WithBinaryData_IsRefused")]
        public void Text_Damaged_IsRefused(string text, params string[] parts) =>
            ReadText.AssertRefused(() => ReadText.Obj(text), parts);

        [Test]
        public void Vertex_BeyondFloatByItsUnit_NamesTheUnit()
        {
            ReadText.AssertRefused(() => ReadText.Obj("v 1e36 0 0", "km"), "x is \"1e36\" km", "another unit");
            Assert.That(ReadText.Obj("v 1e40 0 0\nf 1 1 1", "mm").Vertices[0].x, Is.EqualTo(1e37f),
                "the file may hold more than a float does");
        }

        [Test]
        public void Line_WithoutEnd_IsRefused()
        {
            byte[] text = Encoding.ASCII.GetBytes(new string(' ', 1 << 25));
            ReadText.AssertRefused(() => ReadText.Bytes("model.obj", text), "model.obj:1:", "longer than");
        }
    }
}
