using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>
    /// The estimate of the sampling error against pictures whose converged sum has a closed form, and against the
    /// reference tracer's rays.
    /// </summary>
    [Category("Slow")]
    public sealed class SamplingEstimateTests
    {
        const double Lambda = Signal.SpeedOfLight / 10e9;

        // Amplitude of one ray of these pictures, normalised.
        static double Norm(in RadarSettings settings) => RadarResult.NormalRays / settings.RayCount;

        static SampledWave Rectangle(in RadarSettings settings, double x0, double y0, double x1, double y1,
            double slopeX, double slopeY) =>
            new SampledWave(settings, (x, y) =>
                x >= x0 && x < x1 && y >= y0 && y < y1 ? 20 + Lambda * (slopeX * x + slopeY * y) : double.NaN);

        // |integral of exp(2 pi i slope x) over a length|.
        static double Line(double length, double slope) =>
            slope == 0 ? length : Math.Abs(Math.Sin(Math.PI * slope * length) / (Math.PI * slope));

        [Test]
        public void Estimate_OfAPlaneWaveOverARectangle_IsAboutTheDifferenceToTheClosedForm()
        {
            var random = new Random(1);
            var settings = TestRadar.Settings();
            AssertGood(Enumerable.Range(0, 300).Select(i =>
            {
                double x0 = 5 + 20 * random.NextDouble(), y0 = 5 + 20 * random.NextDouble(),
                    width = 10 + 90 * random.NextDouble(), height = 10 + 40 * random.NextDouble();
                double slopeX = 0.2 * random.NextDouble(), slopeY = 0.2 * random.NextDouble();
                var result = Rectangle(settings, x0, y0, x0 + width, y0 + height, slopeX, slopeY).Trace();
                return (result, Norm(settings) * Line(width, slopeX) * Line(height, slopeY));
            }));
        }

        [Test]
        public void Estimate_OfADiscInPhase_IsAboutTheDifferenceToItsArea()
        {
            var random = new Random(2);
            var settings = TestRadar.Settings();
            AssertGood(Enumerable.Range(0, 300).Select(i =>
            {
                double radius = 3 + 35 * random.NextDouble(), x0 = 70 + random.NextDouble(),
                    y0 = 45 + random.NextDouble();
                var result = new SampledWave(settings,
                    (x, y) => (x - x0) * (x - x0) + (y - y0) * (y - y0) < radius * radius ? 20 : double.NaN).Trace();
                return (result, Norm(settings) * Math.PI * radius * radius);
            }));
        }

        // The worst case of a grid: all rays of an edge are off by the same part of a pixel, and finer rays may miss
        // it.
        [Test]
        public void Estimate_OfEdgesAlongTheRows_IsNeverFarBelowTheError(
            [Values(0.02, 0.06, 0.1, 0.12, 0.13, 0.2, 0.3, 0.4, 0.49)] double overhang)
        {
            var settings = TestRadar.Settings();
            var result = Rectangle(settings, 20 - overhang, 20 - overhang, 100 + overhang, 60 + overhang, 0, 0).Trace();
            double error = Norm(settings) * ((80 + 2 * overhang) * (40 + 2 * overhang) - 80 * 40);
            Assert.That(result.SamplingError / error, Is.GreaterThan(0.25));
        }

        [Test]
        public void PathsThatStepMoreThanHalfAWavelength_AreFlagged()
        {
            var settings = TestRadar.Settings();
            RadarResult Ramp(double slope) => Rectangle(settings, 30.2, 20.3, 90.7, 60.4, slope, 0.1).Trace();

            Assert.That(Ramp(0.3).Undersampled, Is.False);
            Assert.That(Ramp(0.7).Undersampled, Is.True);
            // Diagonal neighbours are the farthest apart; float32 resolves lengths of 20 m to 1e-6 m.
            Assert.That(Ramp(0.3).LargestPathStep, Is.EqualTo(0.4).Within(1e-4));
        }

        // At one wavelength a pixel all rays are in phase, so their amplitude is the area instead of almost nothing.
        [Test]
        public void Estimate_OfAnAliasedWave_KnowsThatTheSumIsWrong()
        {
            var settings = TestRadar.Settings();
            var result = Rectangle(settings, 30.2, 20.3, 90.7, 60.4, 1, 0).Trace();
            double converged = Norm(settings) * Line(60.5, 1) * 40.1, error = result.NormalisedAmplitude - converged;
            Assert.That(error, Is.GreaterThan(0.9 * result.NormalisedAmplitude));
            Assert.That(result.SamplingError / error, Is.EqualTo(1).Within(0.1));
        }

        [Test]
        public void SmoothPixels_AreNotRefined()
        {
            var estimate = Rectangle(TestRadar.Settings(), 20, 20, 100, 60, 0.2, 0.1).Begin();
            // The rays along the edges, and the adjacent pixels outside.
            Assert.That(estimate.PixelsToRefine.Length, Is.EqualTo(82 * 42 - 78 * 38));
            Assert.That(estimate.PixelsToRefine, Is.Ordered);
        }

        [Test]
        public void WaveOverTheWholePicture_InPhase_HasNoError()
        {
            var result = new SampledWave(TestRadar.Settings(), (x, y) => 20).Trace();
            Assert.That(result.SamplingError / result.NormalisedAmplitude, Is.LessThan(1e-6));
            Assert.That(result.Undersampled, Is.False);
        }

        // Rays outside a region are not emitted, so its boundary is exact.
        [Test]
        public void Region_BoundsTheRefinedPixels_AndIsNoEdge()
        {
            var settings = TestRadar.Settings();
            settings.Region = new RayRegion { Left = 30, Bottom = 20, Width = 40, Height = 10 };
            var wave = new SampledWave(settings, (x, y) => x < 50.3 ? 20 : double.NaN);

            foreach (uint pixel in wave.Begin().PixelsToRefine)
            {
                Assert.That(pixel % 160, Is.InRange(30, 69), $"column of {pixel}");
                Assert.That(pixel / 160, Is.InRange(20, 29), $"row of {pixel}");
            }
            double error = Norm(settings) * 0.3 * 10;
            Assert.That(wave.Trace().SamplingError / error, Is.InRange(1 / 3.0, 3));
        }

        [Test]
        public void OrderOfTheRays_ChangesNothing()
        {
            var settings = TestRadar.Settings();
            SampledWave Wave() => new SampledWave(settings,
                (x, y) => (x - 80) * (x - 80) + (y - 45) * (y - 45) < 900 ? 20 + 1e-5 * x * x : double.NaN);
            var (inOrder, shuffled) = (Wave(), Wave());
            var random = new Random(3);
            for (int i = shuffled.Rays.Count - 1; i > 0; i--)
            {
                int other = random.Next(i + 1);
                (shuffled.Rays[i], shuffled.Rays[other]) = (shuffled.Rays[other], shuffled.Rays[i]);
            }
            Assert.That(shuffled.Begin().PixelsToRefine, Is.EqualTo(inOrder.Begin().PixelsToRefine));
            Assert.That(shuffled.Trace().LargestPathStep, Is.EqualTo(inOrder.Trace().LargestPathStep));
        }

        [TestCase(0, 160, 90)]
        [TestCase(1, 160, 90)]
        [TestCase(1, 1, 1)]
        [TestCase(3, 3, 1)]
        [TestCase(3, 1, 7)]
        public void FewRays_AreFlagged(int rays, int across, int down)
        {
            var settings = TestRadar.Settings(across, down);
            var result = new SampledWave(settings,
                (x, y) => Math.Floor(x) + across * Math.Floor(y) < rays ? 20 : double.NaN).Trace();
            Assert.That(result.Undersampled, Is.True);
            Assert.That(result.SamplingError, Is.InRange(0, (rays + 1) * Norm(settings)));
        }

        // A return narrower than a pixel is hit or missed by chance.
        [Test]
        public void NoRay_LeavesAPartOfOneInDoubt()
        {
            var settings = TestRadar.Settings();
            var result = new SampledWave(settings, (x, y) => double.NaN).Trace();
            Assert.That(result.SamplingError, Is.EqualTo(Norm(settings) / 3).Within(1e-9));
        }

        // Too many pixels to refine: the sub-rays are limited to the number of rays, and the estimate is still valid.
        [Test]
        public void RoughPicture_IsRefinedInPart()
        {
            var settings = TestRadar.Settings(1600, 900);
            var wave = new SampledWave(settings, (x, y) => 20 + Lambda * 0.2 * (Math.Sin(2.1 * x) + Math.Sin(1.7 * y)));
            Assert.That(wave.Begin().PixelsToRefine.Length,
                Is.EqualTo(1600 * 900 / SamplingEstimate.SubGrids).Within(5).Percent);
        }

        // The published reflector before a receiver square to the view axis, whose rays differ by several wavelengths.
        // The densities are half the published one, where sums are several times too large, and the published one. The
        // published table has 676 received rays.
        [TestCase(960, 182, true)]
        [TestCase(1920, 676, false)]
        public void Estimate_OfTheCornerReflector_HoldsAgainstAliasing(int across, int received, bool isFlagged)
        {
            var scene = CornerReflector.Turned(0);
            var view = AccuracyScene.PublishedView(CornerReflector.Distance, CornerReflector.PitchDegrees);
            var settings = ReferencePose.RegionOfReturns(scene, TestRadar.Settings(across, across * 9 / 16), view);
            var pose = new ReferencePose(scene, settings, view);
            var result = pose.Trace();
            double converged = pose.ConvergedAmplitude();

            Assert.That(result.RaysReceived, Is.EqualTo(received));
            Assert.That(result.NormalisedAmplitude / converged, isFlagged ? Is.GreaterThan(3) : Is.LessThan(1.5));
            Assert.That(result.SamplingError / Math.Abs(result.NormalisedAmplitude - converged),
                Is.InRange(1 / 3.0, 3));
            Assert.That(result.Undersampled, Is.EqualTo(isFlagged));
        }

        [Test]
        [Timeout(600000)]
        public void Estimate_OfTheReferenceRays_IsWithinAThirdAndThreeTimesTheError()
        {
            AssertGood(ReferencePose.Sample().Select(pose => (pose.Trace(), pose.ConvergedAmplitude())));
        }

        // Within a factor of three of the error in four of five poses that are not flagged, and never below a tenth.
        static void AssertGood(IEnumerable<(RadarResult result, double converged)> poses)
        {
            var ratios = poses.Where(pose => !pose.result.Undersampled)
                .Select(pose => pose.result.SamplingError / Math.Abs(pose.result.NormalisedAmplitude - pose.converged))
                .ToArray();
            Assert.That(ratios.Length, Is.GreaterThan(20));
            Assert.That(ratios.Min(), Is.GreaterThan(0.1));
            Assert.That(ratios.Count(ratio => ratio > 1 / 3.0 && ratio < 3) / (double)ratios.Length,
                Is.GreaterThan(0.8));
        }
    }
}
