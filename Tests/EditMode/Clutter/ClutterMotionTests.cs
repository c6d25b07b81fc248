using System;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Bragg lines, coherence and mean velocity against published and independently computed values.</summary>
    public sealed class ClutterMotionTests
    {
        static readonly double3 s_wind = new double3(0, 0, 1);

        [TestCase(3, 1, 49.97, 5.90)]
        [TestCase(5.6, 1, 26.77, 9.05)]
        [TestCase(9.4, 1, 15.95, 14.47)]
        [TestCase(10, 1, 14.99, 15.44)]
        [TestCase(16, 1, 9.37, 26.77)]
        [TestCase(35, 1, 4.28, 78.24)]
        [TestCase(3, 60, 99.93, 4.01)]
        [TestCase(10, 60, 29.98, 8.30)]
        [TestCase(35, 60, 8.57, 30.04)]
        public void BraggLine_IsThePublishedOne(double gigahertz, double grazing, double millimetres, double hertz)
        {
            double k = 4 * Math.PI / Signal.Wavelength(gigahertz * 1e9) * Math.Cos(math.radians(grazing));
            Assert.That(2e3 * Math.PI / k, Is.EqualTo(millimetres).Within(0.0051));
            Assert.That(ClutterMotion.AngularFrequency(k) / (2 * Math.PI), Is.EqualTo(hertz).Within(0.0051));
        }

        // Milliseconds for cells of 0.5, 1, 2, 10, 30 m and very large ones.
        [TestCase(5, 80, 57, 40, 21, 20, 20)]
        [TestCase(10, 80, 57, 40, 18, 11, 9.9)]
        [TestCase(15, 80, 57, 40, 18, 11, 6.6)]
        public void CoherenceTime_IsThePublishedOne(double wind, params double[] milliseconds)
        {
            var sizes = new[] { 0.5, 1, 2, 10, 30, 1e6 };
            for (int i = 0; i < sizes.Length; i++)
                Assert.That(1e3 * ClutterMotion.CoherenceTime(SeaTestBed.Wavelength, wind, sizes[i]),
                    Is.EqualTo(milliseconds[i]).Within(milliseconds[i] < 10 ? 0.051 : 0.6), $"{sizes[i]} m");
        }

        [Test]
        public void CoherenceTime_OutOfRange_IsRefused()
        {
            Assert.That(() => ClutterMotion.CoherenceTime(0.03, 0, 1), Throws.TypeOf<GlintException>().With.Message
                .Contains("wind 0 m/s"));
            Assert.That(() => ClutterMotion.CoherenceTime(0.03, 5, 0), Throws.TypeOf<GlintException>().With.Message
                .Contains("size 0 m"));
        }

        [Test]
        public void ApproachingShare_IsThatOfTheWind()
        {
            Assert.That(ClutterMotion.ApproachingShare(1, 2), Is.EqualTo(1));
            Assert.That(ClutterMotion.ApproachingShare(-1, 2), Is.EqualTo(0));
            Assert.That(ClutterMotion.ApproachingShare(0, 2), Is.EqualTo(0.5));
            // cos^4 of 30 deg is 9/16, sin^4 1/16.
            Assert.That(ClutterMotion.ApproachingShare(0.5, 2), Is.EqualTo(0.9).Within(1e-12));
            Assert.That(ClutterMotion.ApproachingShare(0.3, 1e4), Is.EqualTo(1));
            Assert.That(ClutterMotion.ApproachingShare(0.3, 7) + ClutterMotion.ApproachingShare(-0.3, 7),
                Is.EqualTo(1).Within(1e-12));
        }

        [TestCase(5, 0.073)]
        [TestCase(10, 0.158)]
        [TestCase(15, 0.244)]
        public void TestSpectrum_HasThePublishedStokesDrift(double wind, double drift) =>
            Assert.That(2 * new ElfouhailyFromPaper(wind).HalfStokesDrift(37), Is.EqualTo(drift).Within(0.0006));

        // C band, 10 m/s, upwind, drift 1.5 %; sigma0 is the two-scale mean of Bragg scattering.
        [TestCase(30, 23.2, 30.0)]
        [TestCase(35, 20.7, 29.1)]
        [TestCase(40, 18.1, 26.6)]
        public void MeanVelocity_IsThePublishedDoppler(double incidence, double vv, double hh)
        {
            var bed = new SeaTestBed(10, 5.35e9, new System.Numerics.Complex(67.05, -35.6));
            var slopes = bed.Slopes(SeaTestBed.LongestWave);
            const double step = 0.5;
            Sigma0 At(double degrees)
            {
                var radar = SeaTestBed.Radar(degrees, 0);
                double mirrors = bed.Scattering.Specular(new double3(0, 1, 0), radar, s_wind, slopes);
                return bed.Scattering.TwoScaleMean(radar, s_wind, slopes) + new Sigma0(-mirrors, -mirrors, 0);
            }

            Sigma0 before = At(incidence - step), after = At(incidence + step);
            double theta = math.radians(incidence), drift = 2 * bed.Spectrum.HalfStokesDrift(bed.Scattering.TiltCut);
            double Hertz(double first, double last) => bed.Scattering.WaveNumber / Math.PI * ClutterMotion.MeanVelocity(
                theta, Math.Log(first / last) / math.radians(2 * step), drift,
                2 * bed.Scattering.WaveNumber * Math.Sin(theta), 0.015 * 10);
            Assert.That(Hertz(before.VV, after.VV), Is.EqualTo(vv).Within(0.3));
            Assert.That(Hertz(before.HH, after.HH), Is.EqualTo(hh).Within(0.3));
        }
    }
}
