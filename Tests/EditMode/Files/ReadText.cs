using System.IO;
using System.Text;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Reads mesh files that are text in a test.</summary>
    static class ReadText
    {
        public static MeshFile Obj(string text, string unit = "m", UpAxis up = UpAxis.Y) =>
            Bytes("model.obj", Encoding.UTF8.GetBytes(text), unit, up);

        public static MeshFile Stl(string text, string unit = "m", UpAxis up = UpAxis.Y) =>
            Bytes("model.stl", Encoding.UTF8.GetBytes(text), unit, up);

        public static MeshFile Bytes(string name, byte[] content, string unit = "m", UpAxis up = UpAxis.Y) =>
            MeshFileReader.Read(new MemoryStream(content), name, LengthUnit.Parse(unit), up);

        /// <summary>Asserts that reading fails with one line that contains every part.</summary>
        public static void AssertRefused(TestDelegate read, params string[] parts)
        {
            var error = Assert.Throws<GlintException>(read);
            Assert.That(error.ExitCode, Is.EqualTo(1));
            Assert.That(error.Message, Does.Not.Contain("\n"));
            foreach (string part in parts)
                Assert.That(error.Message, Does.Contain(part));
        }
    }
}
