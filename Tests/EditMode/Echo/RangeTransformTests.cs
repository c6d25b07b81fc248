using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class RangeTransformTests
    {
        static IEnumerable<Window> Windows()
        {
            yield return Window.None;
            yield return Window.Taylor(4, -35);
            yield return Window.Hann;
            yield return Window.Hamming;
            yield return Window.Blackman;
        }

        [Test]
        public void Band_Of150MHz_HasKnownResolutionAndAmbiguity()
        {
            var band = PointEchoes.Band();
            Assert.That(band.RangeResolution, Is.EqualTo(0.99931).Within(5e-6));
            Assert.That(band.UnambiguousRange, Is.EqualTo(255.823).Within(5e-4));
            Assert.That(band.Centre, Is.EqualTo(0.5 * (band.Frequency(0) + band.Frequency(255))));
        }

        // A trihedral of 0.5 m edges at 10 GHz: 4 pi a^4 / (3 lambda^2).
        [TestCaseSource(nameof(Windows))]
        public void Profile_OfATrihedral_PeaksAtItsRangeWithItsCrossSection(Window window)
        {
            double sigma = 4 * Math.PI * Math.Pow(0.5, 4) / (3 * Math.Pow(PointEchoes.C / 10e9, 2));
            var band = PointEchoes.Band();
            var transform = new RangeTransform(band, window);
            foreach (double range in new[] { 40, 100.37, 201.123 })
            {
                var decibels = PowerLevel.Decibels(transform.Profile(PointEchoes.Point(band, range, sigma)));
                var (cell, level) = PointEchoes.Peak(decibels);
                Assert.That(level, Is.EqualTo(10 * Math.Log10(sigma)).Within(0.01));
                Assert.That(transform.RangeOf(cell), Is.EqualTo(range).Within(0.01 * band.RangeResolution));
                Assert.That(decibels.Max(), Is.EqualTo(10 * Math.Log10(sigma)).Within(0.06), "between two cells");
            }
        }

        [TestCaseSource(nameof(Windows))]
        public void Profile_OfAPoint_HasTheWindowsWidthAndSidelobe(Window window)
        {
            var band = PointEchoes.Band();
            var transform = new RangeTransform(band, window, 64);
            double cellsABin = transform.Cells / 256;
            var responses = PointEchoes.Point(band, 64 * band.RangeResolution, 1);
            var decibels = PowerLevel.Decibels(transform.Profile(responses));
            int peak = 64 * transform.Cells / 256;
            Assert.That(decibels[peak], Is.EqualTo(0).Within(1e-9));
            int inside = decibels.Count(level => level > 10 * Math.Log10(0.5));
            Assert.That(inside / cellsABin, Is.EqualTo(window.Width(0.5)).Within(2 / cellsABin));
            int firstNull = peak;
            while (decibels[firstNull + 1] < decibels[firstNull])
                firstNull++;
            double sidelobe = decibels.Skip(firstNull).Take(transform.Cells / 4).Max();
            Assert.That(sidelobe, Is.EqualTo(window.SidelobeDb).Within(0.05));
        }

        // The formula of the transform, at any cell: the phase is that of the path at the band's centre.
        [Test]
        public void Profile_OfAPoint_HasTheCarriersPhase()
        {
            var band = PointEchoes.Band(100);
            var transform = new RangeTransform(band, Window.Hamming, 4, -20);
            double range = transform.RangeOf(77);
            var value = transform.Profile(PointEchoes.Point(band, range, 9))[77];
            double turns = 2 * band.Centre * range / PointEchoes.C;
            var expected = Complex.FromPolarCoordinates(3, -2 * Math.PI * (turns - Math.Floor(turns)));
            Assert.That(Complex.Abs(value - expected), Is.LessThan(1e-6));
        }

        [Test]
        public void Profile_FromAStart_HoldsTheUnambiguousRangeFromThere()
        {
            var band = PointEchoes.Band();
            var transform = new RangeTransform(band, Window.Hann, 8, 5000);
            Assert.That(transform.RangeOf(transform.Cells), Is.EqualTo(5000 + band.UnambiguousRange).Within(1e-9));
            foreach (double range in new[] { 5100, 5100 - 3 * band.UnambiguousRange })
            {
                var profile = transform.Profile(PointEchoes.Point(band, range, 1));
                var (cell, level) = PointEchoes.Peak(PowerLevel.Decibels(profile));
                Assert.That(transform.RangeOf(cell), Is.EqualTo(5100).Within(0.01), "folded in");
                Assert.That(level, Is.EqualTo(0).Within(0.01));
            }
        }

        [Test]
        public void Profile_OfAnyCount_IsPaddedToAPowerOfTwo([Values(1, 3, 300)] int count)
        {
            var band = PointEchoes.Band(count);
            var transform = new RangeTransform(band, Window.None, 2);
            Assert.That(transform.Cells, Is.EqualTo(count == 300 ? 1024 : count == 3 ? 8 : 2));
            Assert.That(transform.Cells * transform.CellSize, Is.EqualTo(band.UnambiguousRange).Within(1e-9));
            var profile = transform.Profile(PointEchoes.Point(band, 0, 4));
            Assert.That(profile[0].Magnitude, Is.EqualTo(2).Within(1e-12));
        }

        [Test]
        public void WrongNumbers_AreRefused()
        {
            var band = PointEchoes.Band();
            AssertRefused(() => new FrequencyBand(0, 1e6, 4),
                "frequency band: the start is 0 Hz, it must be above 0 and finite");
            AssertRefused(() => new FrequencyBand(1e9, double.NaN, 4),
                "frequency band: the step is NaN Hz, it must be above 0 and finite");
            AssertRefused(() => new FrequencyBand(1e9, 1e6, 0),
                "frequency band: the number of frequencies is 0, it must be from 1 to 1.049e6");
            AssertRefused(() => new RangeTransform(band, Window.None, 65),
                "range profile: the zero padding is 65, it must be from 1 to 64");
            AssertRefused(() => new RangeTransform(band, Window.None).Profile(new Complex[3]),
                "range profile: 3 responses, 256 are needed");
        }

        static void AssertRefused(TestDelegate call, string message) =>
            Assert.That(call, Throws.TypeOf<GlintException>().With.Message.EqualTo(message));
    }
}
