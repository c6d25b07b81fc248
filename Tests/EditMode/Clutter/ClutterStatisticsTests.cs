using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Shape, texture, shadow and curved earth against published values; shapes also by sampling.</summary>
    public sealed class ClutterStatisticsTests
    {
        [TestCase(1, 100, false, 0, 0.336)]
        [TestCase(1, 100, true, 0, 0.067)]
        [TestCase(1, 1000, false, 90, 6.582)]
        [TestCase(0.5, 500, true, 45, 0.249)]
        [TestCase(5, 200, false, 45, 3.267)]
        [TestCase(3, 1000, true, 90, 2.732)]
        public void EmpiricalShape_IsThePublishedOne(double grazing, double area, bool isHorizontal, double swell,
            double expected) => Assert.That(ClutterStatistics.EmpiricalShape(grazing, area, isHorizontal, swell),
                Is.EqualTo(expected).Within(5e-4));

        [TestCase(0.05, 100, "grazing angle 0.05 deg")]
        [TestCase(30, 100, "grazing angle 30 deg")]
        [TestCase(3, 0, "area 0 m2")]
        public void EmpiricalShape_OutOfRange_IsRefused(double grazing, double area, string says) =>
            Assert.That(() => ClutterStatistics.EmpiricalShape(grazing, area, true, 0),
                Throws.TypeOf<GlintException>().With.Message.Contains(says));

        // Textures of a whole shape nu are means of nu exponential numbers.
        [TestCase(1)]
        [TestCase(4)]
        public void Shapes_OfKDistributedSamples_AreTheirs(int looks)
        {
            var random = new System.Random(3);
            double Exponential() => -Math.Log(1 - random.NextDouble());
            var textures = Enumerable.Range(0, 200000)
                .Select(_ => Enumerable.Range(0, looks).Average(__ => Exponential())).ToArray();
            var intensities = textures.Select(texture => texture * Exponential()).ToArray();
            Assert.That(ClutterStatistics.ShapeOfTexture(textures), Is.EqualTo(looks).Within(3).Percent);
            Assert.That(ClutterStatistics.ShapeOfIntensity(intensities), Is.EqualTo(looks).Within(5).Percent);
        }

        [TestCase(5, 8.0)]
        [TestCase(8.5, 23.2)]
        [TestCase(10, 32.1)]
        [TestCase(14, 62.8)]
        public void TextureLength_IsThePublishedOne(double wind, double metres)
        {
            Assert.That(ClutterStatistics.TextureLength(wind, 0), Is.EqualTo(metres).Within(0.1));
            Assert.That(ClutterStatistics.TextureLength(wind, 90), Is.EqualTo(metres / 2).Within(0.05));
        }

        [TestCase(0.3, 0.0324)]
        [TestCase(1, 0.1051)]
        [TestCase(3, 0.2909)]
        [TestCase(5, 0.4467)]
        [TestCase(10, 0.7255)]
        [TestCase(20, 0.9585)]
        [TestCase(30, 0.9979)]
        public void LitFraction_IsThePublishedOne(double grazing, double expected) => Assert.That(
            ClutterGeometry.LitFraction(math.radians(grazing), 0.2), Is.EqualTo(expected).Within(5.1e-5));

        // On a plane the sine is height over range; at the horizon, sqrt(2 height radius) away, the angle is 0.
        [Test]
        public void Grazing_OnACurvedEarth_FallsToZeroAtTheHorizon()
        {
            Assert.That(ClutterGeometry.Grazing(15, 30), Is.EqualTo(Math.PI / 6).Within(1e-5));
            Assert.That(ClutterGeometry.Grazing(15, 15), Is.EqualTo(Math.PI / 2).Within(2e-3));
            double radius = ClutterGeometry.EarthRadius, horizon = Math.Sqrt(2 * 15 * radius + 15 * 15);
            Assert.That(ClutterGeometry.Grazing(15, horizon), Is.EqualTo(0).Within(1e-9));
            Assert.That(ClutterGeometry.Grazing(15, 1.1 * horizon), Is.LessThan(0));
            // By the cosine rule in the triangle with the earth's centre.
            double top = radius + 15;
            double sine = (top * top - 5000.0 * 5000 - radius * radius) / (2 * 5000 * radius);
            Assert.That(Math.Sin(ClutterGeometry.Grazing(15, 5000)), Is.EqualTo(sine).Within(1e-9));
        }

        // Values of Abramowitz and Stegun, table 7.1, and of erfc at 5.
        [TestCase(0, 0)]
        [TestCase(0.5, 0.5204998778130465)]
        [TestCase(1, 0.8427007929497149)]
        [TestCase(2.4, 0.9993114861033549)]
        [TestCase(2.6, 0.9997639655834707)]
        [TestCase(-1, -0.8427007929497149)]
        public void Erf_IsTheTable(double x, double expected)
        {
            Assert.That(ErrorFunction.Erf(x), Is.EqualTo(expected).Within(1e-12));
            Assert.That(ErrorFunction.Erfc(x), Is.EqualTo(1 - expected).Within(1e-12));
        }

        [Test]
        public void Erfc_OfALargeArgument_KeepsItsDigits() =>
            Assert.That(ErrorFunction.Erfc(5), Is.EqualTo(1.5374597944280349e-12).Within(1e-9).Percent);
    }
}
