using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>The spectrum of Elfouhaily against values that three other programs agree on.</summary>
    public sealed class ElfouhailyTests
    {
        // A fully developed sea of 10 m/s.
        [TestCase(0.1, 3.05280)]
        [TestCase(1, 5.65182e-3)]
        [TestCase(10, 4.07045e-6)]
        [TestCase(100, 7.80091e-9)]
        [TestCase(370, 2.47713e-10)]
        [TestCase(419.2, 1.68921e-10)]
        [TestCase(1000, 4.90380e-12)]
        public void Omnidirectional_Of10MetresASecond_IsKnown(double waveNumber, double known) =>
            Assert.That(new Elfouhaily(10).Omnidirectional(waveNumber), Is.EqualTo(known).Within(2e-6 * known));

        // Significant wave height, mean square slope of all waves and of those below 100 rad/m.
        [TestCase(5, 0.648, 0.0317, 0.0247)]
        [TestCase(10, 2.634, 0.0605, 0.0356)]
        [TestCase(15, 5.940, 0.0845, 0.0446)]
        public void Omnidirectional_Integrated_IsKnown(double wind, double height, double slope, double longSlope)
        {
            var spectrum = new Elfouhaily(wind);
            double Slope(double k) => k * k * spectrum.Omnidirectional(k);
            Assert.That(4 * Math.Sqrt(Integral(spectrum.Omnidirectional, 1e-3, 2e3)), Is.EqualTo(height).Within(5e-4));
            Assert.That(Integral(Slope, 1e-3, 2e3), Is.EqualTo(slope).Within(5e-5));
            Assert.That(Integral(Slope, 1e-3, 100), Is.EqualTo(longSlope).Within(5e-5));
        }

        // Waves on the ocean travel with the wind where they are long; Delta has its minimum near waves of half a
        // metre, and its largest value among ripples where they are slowest.
        [Test]
        public void Spreading_IsNarrowForLongWavesAndAgainForTheSlowest()
        {
            var spectrum = new Elfouhaily(10);
            Assert.That(spectrum.Spreading(0.02), Is.EqualTo(1).Within(1e-6));
            double[] numbers = Enumerable.Range(0, 400).Select(i => Math.Pow(10, i / 100.0)).Where(k => k < 2000)
                .ToArray();
            double narrowest = numbers.Where(k => k > 50).OrderByDescending(spectrum.Spreading).First();
            Assert.That(narrowest, Is.EqualTo(370).Within(10));
            Assert.That(spectrum.Spreading(numbers.OrderBy(spectrum.Spreading).First()), Is.InRange(0.17, 0.19));
        }

        [Test]
        public void Density_OverAllDirections_IsTheOmnidirectionalOneAndSymmetric([Values(0.1, 30, 500)] double k)
        {
            var spectrum = new Elfouhaily(10);
            double sum = Enumerable.Range(0, 360).Sum(i => spectrum.Density(k, Math.Cos(i * Math.PI / 180)));
            Assert.That(sum * k * Math.PI / 180, Is.EqualTo(spectrum.Omnidirectional(k)).Within(1e-9).Percent);
            Assert.That(spectrum.Density(k, -0.3), Is.EqualTo(spectrum.Density(k, 0.3)));
            Assert.That(spectrum.Density(k, 1) / spectrum.Density(k, 0), Is.EqualTo(
                (1 + spectrum.Spreading(k)) / (1 - spectrum.Spreading(k))).Within(1e-9).Percent);
        }

        // The peak of a sea of inverse wave age 5 is at 25 g / U^2, shifted a little by the slope of the spectrum.
        [Test]
        public void Fetch_OfAYoungSea_PutsThePeakAt25OverTheWavesOfTheWind()
        {
            var young = new Elfouhaily(10, 592);
            double[] numbers = Enumerable.Range(0, 4000).Select(i => 0.01 * Math.Pow(10, i / 1000.0)).ToArray();
            double peak = numbers.OrderByDescending(young.Omnidirectional).First();
            Assert.That(peak, Is.EqualTo(25 * 9.81 / 100).Within(3).Percent);
        }

        [Test]
        public void Fetch_WithoutEnd_IsAFullyDevelopedSea() =>
            Assert.That(new Elfouhaily(5, 1e7).Omnidirectional(0.4),
                Is.EqualTo(new Elfouhaily(5).Omnidirectional(0.4)).Within(0.01).Percent);

        // Capillary waves: w^2 = g k + 7.2e-5 k^3, at its slowest 0.231 m/s.
        [Test]
        public void PhaseSpeed_HasSurfaceTension()
        {
            double Squared(double k) => Math.Pow(k * Elfouhaily.PhaseSpeed(k), 2);
            Assert.That(Squared(0.1), Is.EqualTo(0.981).Within(1e-4).Percent);
            Assert.That(Squared(419), Is.EqualTo(9.81 * 419 + 7.2e-5 * Math.Pow(419, 3)).Within(0.5).Percent);
            Assert.That(Elfouhaily.PhaseSpeed(370), Is.EqualTo(0.231).Within(0.001));
        }

        [TestCase(0, 0, "wind speed 0 m/s must be from 3 to 20")]
        [TestCase(2.9, 0, "wind speed 2.9 m/s must be from 3 to 20")]
        [TestCase(21, 0, "wind speed 21 m/s")]
        [TestCase(double.NaN, 0, "wind speed NaN m/s")]
        [TestCase(10, 500, "fetch 500 m must be 0, which is unlimited, or from 592 to 1e7")]
        public void Spectrum_OutsideItsRange_IsRefused(double wind, double fetch, string part) => Assert.That(
            Assert.Throws<GlintException>(() => new Elfouhaily(wind, fetch)).Message,
            Does.StartWith("Elfouhaily's spectrum: " + part));

        // Midpoints in equal ratios.
        static double Integral(Func<double, double> density, double from, double to)
        {
            const int steps = 4000;
            double ratio = Math.Log(to / from) / steps;
            return Enumerable.Range(0, steps).Select(i => from * Math.Exp(ratio * (i + 0.5)))
                .Sum(k => density(k) * k * ratio);
        }
    }
}
