using System;
using System.IO;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class NumpyArchiveTests
    {
        TemporaryFolder _folder;

        [SetUp]
        public void SetUp() => _folder = new TemporaryFolder();

        [TearDown]
        public void TearDown() => _folder.Dispose();

        [Test]
        public void Archive_OfRealAndComplexArrays_IsReadBack()
        {
            string path = Write("a.npz");

            Assert.That(NumpyReader.Names(path), Is.EqualTo(new[] { "angle.npy", "S.npy" }));
            var angle = NumpyReader.Read(path, "angle");
            Assert.That(angle.Type, Is.EqualTo("<f8"));
            Assert.That(angle.Sizes, Is.EqualTo(new[] { 3 }));
            Assert.That(angle.Numbers, Is.EqualTo(new[] { 0, -1.5, double.NaN }));
            var s = NumpyReader.Read(path, "S");
            Assert.That(s.Type, Is.EqualTo("<c16"));
            Assert.That(s.Sizes, Is.EqualTo(new[] { 2, 1 }));
            Assert.That(s.Numbers, Is.EqualTo(new[] { 1, 2, -3, 1e-300 }));
        }

        [Test]
        public void Archive_IsNotCompressedAndTheSameAtAnyTime()
        {
            byte[] first = File.ReadAllBytes(Write("a.npz"));
            // A method other than 0 is at byte 8 of the first entry.
            Assert.That(BitConverter.ToUInt16(first, 8), Is.Zero, "stored");
            Assert.That(File.ReadAllBytes(Write("b.npz")), Is.EqualTo(first));
        }

        string Write(string name)
        {
            string path = _folder.PathOf(name);
            using (var file = File.Create(path))
            using (var archive = new NumpyArchive(file))
            {
                archive.Add("angle", new[] { 3 }, new[] { 0, -1.5, double.NaN });
                archive.Add("S", new[] { 2, 1 }, new[] { new Complex(1, 2), new Complex(-3, 1e-300) });
            }
            return path;
        }
    }
}
