using System;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class SignalTests
    {
        const double Wavelength = 0.0299792458; // c / 10 GHz, m

        [Test]
        public void Wavelength_OfTenGigahertz_IsThreeCentimetres() =>
            Assert.That(Signal.Wavelength(10e9), Is.EqualTo(Wavelength).Within(1e-15));

        [TestCase(0, 0)]
        [TestCase(0.25, Math.PI / 2)]
        [TestCase(1000.5, Math.PI)]
        public void Phase_OfSoManyWavelengths_IsTheRestOfATurn(double wavelengths, double expected) =>
            Assert.That(Signal.Phase(wavelengths * Wavelength, Wavelength), Is.EqualTo(expected).Within(1e-9));

        [Test]
        public void Phase_OfAnyLength_LiesInOneTurn()
        {
            for (double length = 0; length < 1; length += 0.0007)
                Assert.That(Signal.Phase(length, Wavelength), Is.InRange(0, 2 * Math.PI));
        }

        [TestCase(1, 0)]
        [TestCase(10, 20)]
        [TestCase(0.1, -20)]
        public void Decibels_OfAnAmplitude_AreTwentyTimesItsLogarithm(double amplitude, double expected) =>
            Assert.That(Signal.Decibels(amplitude), Is.EqualTo(expected).Within(1e-12));

        [Test]
        public void Decibels_OfNothing_AreNone() => Assert.That(Signal.Decibels(0), Is.Null);

        [TestCase(0, 0)]
        [TestCase(Math.PI, Signal.PhaseBins / 2)]
        [TestCase(2 * Math.PI - 1e-9, Signal.PhaseBins - 1)]
        [TestCase(2 * Math.PI, 0)]
        public void PhaseBin_OfAPhase_CountsFromZero(double phase, int bin) =>
            Assert.That(Signal.PhaseBin(phase), Is.EqualTo(bin));

        [Test]
        public void Amplitude_OfOppositeRays_IsZeroAndOfEqualRaysTheirNumber()
        {
            var sums = new RadarSums();
            sums.AddReceived(0, 1, 0);
            sums.AddReceived(Math.PI, -1, 0);
            var cancelled = new RadarResult(sums);
            Assert.That(cancelled.Amplitude, Is.Zero);
            Assert.That(cancelled.AmplitudeDb, Is.Null);
            Assert.That(cancelled.RaysReceived, Is.EqualTo(2));

            sums = new RadarSums();
            for (int i = 0; i < 5; i++)
                sums.AddReceived(Math.PI / 2, 0, 1);
            var equal = new RadarResult(sums);
            Assert.That(equal.Amplitude, Is.EqualTo(5));
            Assert.That(equal.PhaseHistogram[Signal.PhaseBins / 4], Is.EqualTo(5));
        }
    }
}
