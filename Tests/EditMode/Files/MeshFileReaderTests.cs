using System.IO;
using System.Linq;
using System.Text;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Claims that hold for every format; each mesh is read from disk.</summary>
    public sealed class MeshFileReaderTests
    {
        static readonly float3[] Vertices = Solid.BoxVertices(2, 3, 5);

        TemporaryFolder _folder;

        [SetUp]
        public void SetUp() => _folder = new TemporaryFolder();

        [TearDown]
        public void TearDown() => _folder.Dispose();

        [TestCase("box.obj")]
        [TestCase("box.stl")]
        [TestCase("binary.stl")]
        [TestCase("BOX.OBJ")]
        public void Read_Box_GivesTheSameTriangles(string name)
        {
            var mesh = ReadBox(name, "m", UpAxis.Y);
            Assert.That(mesh.Name, Is.EqualTo(Path.GetFileNameWithoutExtension(name)));
            Assert.That(mesh.TriangleCount, Is.EqualTo(12));
            Assert.That(Solid.Triangles(mesh).ToArray(),
                Is.EqualTo(Solid.Triangles(Vertices, Solid.BoxIndices).ToArray()));
            Assert.That(Solid.Volume(mesh), Is.EqualTo(30).Within(1e-9), "closed, its outer sides outwards");
        }

        [TestCase("box.obj")]
        [TestCase("box.stl")]
        [TestCase("binary.stl")]
        public void Read_ZUp_SwapsYAndZAndKeepsOuterSides(string name)
        {
            var mesh = ReadBox(name, "m", UpAxis.Z);
            Assert.That(mesh.Vertices.Max(vertex => vertex.x), Is.EqualTo(2));
            Assert.That(mesh.Vertices.Max(vertex => vertex.y), Is.EqualTo(5));
            Assert.That(mesh.Vertices.Max(vertex => vertex.z), Is.EqualTo(3));
            Assert.That(Solid.Volume(mesh), Is.EqualTo(30).Within(1e-9));
        }

        [TestCase("box.obj")]
        [TestCase("box.stl")]
        [TestCase("binary.stl")]
        public void Read_Millimetres_GivesMetresRoundedOnce(string name)
        {
            var mesh = ReadBox(name, "mm", UpAxis.Y);
            Assert.That(mesh.Vertices.Max(vertex => vertex.x), Is.EqualTo((float)(2 * 0.001)));
            Assert.That(Solid.Volume(mesh), Is.EqualTo(30e-9).Within(30e-15));
        }

        [Test]
        public void Read_InForeignCulture_StillTakesPoints()
        {
            using (new ForeignCulture())
            {
                var mesh = ReadText.Obj("v -1.5 0 0\nv 1e-1 0 0\nv 0 123456789012345678901 0\nf 1 2 3\n");
                Assert.That(mesh.Vertices[0].x, Is.EqualTo(-1.5f));
                Assert.That(mesh.Vertices[1].x, Is.EqualTo(0.1f));
                Assert.That(mesh.Vertices[2].y, Is.EqualTo(123456789012345678901f));
            }
        }

        [Test]
        public void CountDegenerate_CoincidingAndCollinearCorners_AreKeptAndCounted()
        {
            var mesh = ReadText.Obj("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1e-30 0\nf 1 2 3\nf 1 1 4\nf 1 2 4\n");
            Assert.That(mesh.TriangleCount, Is.EqualTo(3));
            Assert.That(mesh.CountDegenerate(), Is.EqualTo(2), "the third is thin, but has an area");
        }

        [TestCase("mesh.fbx")]
        [TestCase("mesh")]
        [TestCase("obj")]
        [TestCase("")]
        public void Read_OtherExtension_IsAWrongCall(string name)
        {
            var error = Assert.Throws<UsageException>(() => MeshFileReader.Read(name, LengthUnit.Parse("m"), UpAxis.Y));
            Assert.That(error.Message, Does.StartWith(name).And.Contain(".obj or .stl"));
            Assert.That(MeshFileReader.IsMeshFile(name), Is.False);
        }

        [Test]
        public void Read_MissingFile_IsRefused() => AssertRefused(_folder.PathOf("none.obj"), "there is no such file");

        [Test]
        public void Read_Folder_IsRefused()
        {
            Directory.CreateDirectory(_folder.PathOf("parts.stl"));
            AssertRefused(_folder.PathOf("parts.stl"), "is a folder");
        }

        [TestCase("x.obj")]
        [TestCase("x.stl")]
        public void Read_EmptyFile_IsRefused(string name) =>
            AssertRefused(_folder.Write(name, new byte[0]), "is empty");

        [TestCase("x.obj")]
        [TestCase("x.stl")]
        public void Read_LargeFilePointer_SaysHowToFetch(string name)
        {
            string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
            AssertRefused(_folder.Write(name, Encoding.ASCII.GetBytes(pointer)), "Git LFS pointer", "git lfs pull");
        }

        [TestCase("x.obj", new byte[] { 0x1f, 0x8b, 8, 0, 1, 2 }, "gunzip")]
        [TestCase("x.stl", new byte[] { 0x1f, 0x8b, 8, 0, 1, 2 }, "gunzip")]
        [TestCase("x.obj", new byte[] { 0x50, 0x4b, 3, 4, 1, 2 }, "unzip")]
        [TestCase("x.obj", new byte[] { 0xff, 0xfe, 0x76, 0, 0x20, 0 }, "UTF-8")]
        public void Read_WrappedFile_SaysHowToUnwrap(string name, byte[] content, string remedy) =>
            AssertRefused(_folder.Write(name, content), remedy);

        static void AssertRefused(string path, params string[] parts)
        {
            ReadText.AssertRefused(() => MeshFileReader.Read(path, LengthUnit.Parse("m"), UpAxis.Y),
                parts.Append(path).ToArray());
        }

        MeshFile ReadBox(string name, string unit, UpAxis up)
        {
            byte[] content = MeshFileWriter.StlText(Vertices, Solid.BoxIndices);
            if (name.StartsWith("binary"))
                content = MeshFileWriter.StlBinary(Vertices, Solid.BoxIndices);
            else if (name.ToLowerInvariant().EndsWith(".obj"))
                content = MeshFileWriter.Obj(Vertices, Solid.BoxIndices);
            return MeshFileReader.Read(_folder.Write(name, content), LengthUnit.Parse(unit), up);
        }
    }
}
