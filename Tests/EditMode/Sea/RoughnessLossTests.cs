using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class RoughnessLossTests
    {
        // 10 GHz and a deviation of 0.29 m, that of sea state 3, at a grazing angle in degrees.
        [TestCase(0.5, 0.570, 0.616)]
        [TestCase(1, 0.105, 0.287)]
        [TestCase(2, 0.0001, 0.135)]
        [TestCase(3, 0, 0.089)]
        public void Factors_OfARoughSea_AreKnown(double grazing, double ament, double millerBrown)
        {
            double roughness = 2 * Math.PI * 10e9 / 299792458 * 0.29 * Math.Sin(grazing * Math.PI / 180);
            Assert.That(RoughnessLoss.Ament(roughness), Is.EqualTo(ament).Within(ament == 0.0001 ? 5e-5 : 6e-4));
            Assert.That(RoughnessLoss.MillerBrown(roughness), Is.EqualTo(millerBrown).Within(6e-4));
        }

        // I0(x) is the mean of exp(x cos phi) over phi. Both series are used, to either side of x = 30.
        [TestCase(0)]
        [TestCase(0.1)]
        [TestCase(1)]
        [TestCase(3.87)]
        [TestCase(3.88)]
        [TestCase(10)]
        [TestCase(40)]
        public void MillerBrown_IsTheMeanOverAWave(double roughness)
        {
            const int steps = 4096;
            double x = 2 * roughness * roughness, mean = Enumerable.Range(0, steps)
                .Average(i => Math.Exp(x * (Math.Cos(2 * Math.PI * i / steps) - 1)));
            Assert.That(RoughnessLoss.MillerBrown(roughness), Is.EqualTo(mean).Within(1e-10).Percent);
        }

        [Test]
        public void Factors_OfASmoothAndOfAnEndlesslyRoughSurface_AreOneAndZero()
        {
            Assert.That(RoughnessLoss.Ament(0), Is.EqualTo(1));
            Assert.That(RoughnessLoss.MillerBrown(0), Is.EqualTo(1));
            Assert.That(RoughnessLoss.Ament(1e200), Is.Zero);
            Assert.That(RoughnessLoss.MillerBrown(1e200), Is.Zero);
        }
    }
}
