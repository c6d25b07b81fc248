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
        public void Archive_IsTheSameAtAnyTime()
        {
            byte[] first = File.ReadAllBytes(Write("a.npz"));
            // Bytes 10 to 13 of an entry: time and date of its file, whose days and months count from 1.
            Assert.That(BitConverter.ToUInt32(first, 10), Is.EqualTo((1 << 5 | 1) << 16), "the first moment of 1980");
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
