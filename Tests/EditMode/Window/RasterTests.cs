using System;
using System.Linq;
using Glint.Editor;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    public sealed class RasterTests
    {
        const string Ascii = "!\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`"
            + "abcdefghijklmnopqrstuvwxyz{|}~";

        // Ink is what is missing from white, in whole pixels.
        [Test]
        public void Line_OfALengthAndWidth_HasItsAreaAndTwoRoundEnds()
        {
            var raster = new Raster(100, 100, 1);
            raster.Line(new[] { new Vector2(20, 20), new Vector2(80, 65) }, false, 6, Color.black);
            Assert.That(Ink(raster), Is.EqualTo(75 * 6 + Math.PI * 9).Within(0.02 * 75 * 6));
        }

        [Test]
        public void Area_OfATriangle_HasItsAreaInItsOpacity()
        {
            var raster = new Raster(50, 50, 2);
            raster.Area(new[] { new Vector2(5, 5), new Vector2(45, 10), new Vector2(15, 40) },
                new Color(0, 0, 0, 0.2f));
            // Half of 40 x 35 less 5 x 10, in points of four pixels.
            Assert.That(Ink(raster), Is.EqualTo(0.2 * 4 * (40 * 35 - 5 * 10) / 2).Within(0.02 * 540));
            Assert.That(raster[40, 40].r, Is.EqualTo(204).Within(1), "within");
        }

        // A corner is no darker than the pieces that meet in it.
        [Test]
        public void Line_OverItself_IsNoDarker()
        {
            Raster once = new Raster(40, 40, 1), twice = new Raster(40, 40, 1);
            Vector2 a = new Vector2(5, 8), b = new Vector2(30, 33);
            once.Line(new[] { a, b }, false, 2, new Color(0, 0, 0, 0.5f));
            twice.Line(new[] { a, b, a }, false, 2, new Color(0, 0, 0, 0.5f));
            Assert.That(Pixels(twice), Is.EqualTo(Pixels(once)));
        }

        [Test]
        public void Shapes_BesideThePicture_AreCutOff()
        {
            var raster = new Raster(20, 20, 1);
            raster.Line(new[] { new Vector2(-50, -70), new Vector2(60, 90) }, false, 3, Color.red);
            raster.Area(new[] { new Vector2(-9, 5), new Vector2(90, 5), new Vector2(90, 99), new Vector2(-9, 99) },
                Color.blue);
            raster.Write("far away", new Vector2(500, -300), Vector2.zero, 12, Color.black);
            Assert.That(raster[0, 19], Is.EqualTo((Color32)Color.blue));
        }

        [Test]
        public void Letters_OfTheSmallestFont_AreAllDifferent()
        {
            var pictures = Ascii.Select(letter => string.Join(",", Pixels(Write(letter.ToString(), 11))
                .Select(pixel => pixel.r / 64))).ToArray(); // four shades, as an eye sees a letter
            for (int i = 0; i < Ascii.Length; i++)
                for (int j = 0; j < i; j++)
                    Assert.That(pictures[i], Is.Not.EqualTo(pictures[j]), $"{Ascii[i]} and {Ascii[j]}");
            Assert.That(Ascii.Select(letter => Ink(Write(letter.ToString(), 11))), Is.All.GreaterThan(4));
            Assert.That(Ink(Write(" ", 11)), Is.Zero);
        }

        [TestCase("Amplitude, normalised, dB")]
        [TestCase("Göteborg ± 5°")]
        [TestCase("中文")]
        public void Text_IsInItsBox(string text)
        {
            var size = StrokeFont.SizeOf(text, 11);
            var corners = StrokeFont.Lines(text, 11).SelectMany(line => line).ToArray();
            Assert.That(corners.Min(corner => corner.x), Is.Zero);
            Assert.That(corners.Max(corner => corner.x), Is.EqualTo(size.x).Within(1e-3));
            Assert.That(corners.Min(corner => corner.y), Is.GreaterThan(0));
            Assert.That(corners.Max(corner => corner.y), Is.LessThanOrEqualTo(size.y));
        }

        static Raster Write(string text, float size)
        {
            var raster = new Raster(12, 16, 2);
            raster.Write(text, new Vector2(1, 1), Vector2.zero, size, Color.black);
            return raster;
        }

        static Color32[] Pixels(Raster raster) =>
            Enumerable.Range(0, raster.Width * raster.Height).Select(i => raster[i % raster.Width, i / raster.Width])
                .ToArray();

        static double Ink(Raster raster) => Pixels(raster).Sum(pixel => 1 - pixel.r / 255.0);
    }
}
