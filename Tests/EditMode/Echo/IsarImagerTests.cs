using System;
using System.Linq;
using System.Numerics;
using System.Runtime.InteropServices;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Backprojection on the device beside that in double precision.</summary>
    public sealed class IsarImagerTests
    {
        /// <summary>
        /// Points of the whole unambiguous range, which the image exceeds, from more looks than a dispatch takes:
        /// phases are 1,300 turns and more.
        /// </summary>
        [TestCase(75, 75, 33, double.PositiveInfinity)]
        [TestCase(40, 10, 64, double.PositiveInfinity)]
        [TestCase(200, 1, 17, double.PositiveInfinity)]
        [TestCase(75, 75, 33, 60)]
        [TestCase(40, 10, 64, 5000)]
        public void Image_OnTheDevice_IsThatOfTheProcessor(int looks, double degrees, int pixels, double distance)
        {
            var band = new FrequencyBand(9.85e9, 300e6 / 72, 72);
            var range = new RangeTransform(band, Window.Named("hann"), IsarTransform.Padding,
                -0.5 * band.UnambiguousRange);
            var aspects = Enumerable.Range(0, looks).Select(look =>
                RadarAspect.At(20 + degrees * ((look + 0.5) / looks - 0.5), 10)).ToArray();
            var transform = new IsarTransform(range, band, aspects, 20, Window.Named("taylor"), 40, pixels,
                aspects.Select((_, look) => distance + look).ToArray());
            var random = new Random(7);
            var profiles = aspects.Select(_ => range.Profile(Enumerable.Range(0, band.Count).Select(frequency =>
                new Complex(random.NextDouble() - 0.5, random.NextDouble() - 0.5)).ToArray())).ToArray();
            var expected = transform.Image(profiles);
            Complex[] found;
            using (var imager = new IsarImager(TestKernels.Backprojection))
            {
                imager.Image(transform, profiles);
                found = imager.Image(transform, profiles);
            }
            // A curvature of up to 430 turns in float32 is off by 1e-4 turns, and 75 looks average it.
            double peak = expected.Max(value => value.Magnitude), part = double.IsPositiveInfinity(distance) ? 1e-5 : 1e-4;
            Assert.That(found.Zip(expected, (a, b) => (a - b).Magnitude).Max(), Is.LessThan(part * peak));
        }

        [Test]
        public void Look_IsWholeRowsOfSixteenBytes() => Assert.That(Marshal.SizeOf<IsarLook>(), Is.EqualTo(64));
    }
}
