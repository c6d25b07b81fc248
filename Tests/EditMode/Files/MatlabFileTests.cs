using System;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class MatlabFileTests
    {
        // The bytes of the published description, by hand: a column of two numbers named x.
        [Test]
        public void File_OfOneArray_HasTheFormatsBytes()
        {
            byte[] file = Write(matlab => matlab.Add("x", new[] { 2 }, new double[] { 1, -2 }));
            Assert.That(Encoding.ASCII.GetString(file, 0, 116).TrimEnd(),
                Is.EqualTo("MATLAB 5.0 MAT-file, written by Glint"));
            Assert.That(file.Skip(116), Is.EqualTo(new byte[]
            {
                0, 0, 0, 0, 0, 0, 0, 0, 0x00, 0x01, 0x49, 0x4D,
                14, 0, 0, 0, 64, 0, 0, 0,
                6, 0, 0, 0, 8, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0,
                5, 0, 0, 0, 8, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0,
                1, 0, 1, 0, (byte)'x', 0, 0, 0,
                9, 0, 0, 0, 16, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xF0, 0x3F, 0, 0, 0, 0, 0, 0, 0, 0xC0
            }));
        }

        [Test]
        public void File_OfRealAndComplexArrays_IsReadBack()
        {
            var arrays = MatlabReader.Read(Write(matlab =>
            {
                matlab.Add("angle", new[] { 3 }, new[] { 0, -1.5, double.NaN });
                matlab.Add("S", new[] { 2, 1 }, new[] { new Complex(1, 2), new Complex(-3, 1e-300) });
                matlab.Add("scalar_8", new int[0], new[] { 7.5 });
                matlab.Add("none", new[] { 0, 4 }, new double[0]);
            }));
            Assert.That(arrays.Select(array => array.Name), Is.EqualTo(new[] { "angle", "S", "scalar_8", "none" }));
            Assert.That(arrays.Select(array => array.Sizes),
                Is.EqualTo(new[] { new[] { 3, 1 }, new[] { 2, 1 }, new[] { 1, 1 }, new[] { 0, 4 } }));
            Assert.That(arrays[0].Real, Is.EqualTo(new[] { 0, -1.5, double.NaN }));
            Assert.That(arrays[0].Imaginary, Is.Null);
            Assert.That(arrays[1].Real, Is.EqualTo(new double[] { 1, -3 }));
            Assert.That(arrays[1].Imaginary, Is.EqualTo(new[] { 2, 1e-300 }));
            Assert.That(arrays[2].Real, Is.EqualTo(new[] { 7.5 }));
            Assert.That(arrays[3].Real, Is.Empty);
        }

        // a(i, j, k) = 100 i + 10 j + k: MATLAB counts the first index fastest.
        [Test]
        public void Array_OfThreeIndices_KeepsThem()
        {
            var values = Enumerable.Range(0, 24).Select(n => (double)(100 * (n / 12) + 10 * (n / 4 % 3) + n % 4));
            var array = MatlabReader.Read(Write(matlab => matlab.Add("a", new[] { 2, 3, 4 }, values)))[0];
            Assert.That(array.Sizes, Is.EqualTo(new[] { 2, 3, 4 }));
            for (int i = 0; i < 2; i++)
                for (int j = 0; j < 3; j++)
                    for (int k = 0; k < 4; k++)
                        Assert.That(array.Real[i + 2 * (j + 3 * k)], Is.EqualTo(100 * i + 10 * j + k));
        }

        [TestCase("")]
        [TestCase("2nd")]
        [TestCase("range m")]
        [TestCase("é")]
        public void Name_ThatMatlabLacks_IsRefused(string name) =>
            Assert.That(() => Write(matlab => matlab.Add(name, new[] { 1 }, new double[1])),
                Throws.TypeOf<GlintException>().With.Message.StartsWith($"MAT-file: the name \"{name}\" must have"));

        [Test]
        public void Values_ThatDoNotFillTheArray_AreRefused() =>
            Assert.That(() => Write(matlab => matlab.Add("x", new[] { 2, 2 }, new double[3])),
                Throws.TypeOf<GlintException>().With.Message.EqualTo("MAT-file: 3 values of an array, 4 are needed"));

        static byte[] Write(Action<MatlabFile> add)
        {
            var stream = new MemoryStream();
            using (var matlab = new MatlabFile(stream))
                add(matlab);
            return stream.ToArray();
        }
    }
}
