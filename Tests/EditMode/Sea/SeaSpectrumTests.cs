using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class SeaSpectrumTests
    {
        const double Gravity = 9.81;

        // Twice the formula's sum over the whole grid, in both directions, with constant 1 and wind along an axis, has
        // a known value. Damping of waves below a thousandth of the longest removes some 1e-7 of it. Density is the
        // half that travels with the wind.
        [TestCase(128, 256, 10, 5.40840e5)]
        [TestCase(256, 500, 15, 1.04651e7)]
        public void Phillips_SummedOverAGrid_IsTheKnownSum(int grid, double tile, double wind, double known)
        {
            var settings = SeaFields.Settings(grid, grid, wind);
            double sum = 0;
            for (int row = 1 - grid / 2; row < grid / 2; row++)
                for (int column = 1 - grid / 2; column < grid / 2; column++)
                    if (row != 0 || column != 0)
                    {
                        double length = Math.Sqrt(row * row + column * column);
                        sum += SeaSpectrum.Density(settings, 2 * Math.PI / tile * length, row / length);
                    }
            Assert.That(4 * sum, Is.EqualTo(known).Within(1e-5 * known));
        }

        // Closed form of the integral: Hs = 4 sqrt(alpha / (4 beta)) U19^2 / g,
        // from Pierson and Moskowitz' alpha and beta.
        [TestCase(5, 0.561)]
        [TestCase(10, 2.245)]
        [TestCase(20, 8.981)]
        public void PiersonMoskowitz_Integrated_IsTheHeightOfAFullyRisenSea(double wind, double height)
        {
            var settings = SeaFields.Settings(wind: wind);
            settings.Kind = SeaSpectrumKind.PiersonMoskowitz;
            Assert.That(4 * Math.Sqrt(Integral(settings)), Is.EqualTo(height).Within(6e-4));
        }

        // Without peak enhancement the integral over frequency is alpha g^2 / (5 wp^4).
        [TestCase(10, 1e5)]
        [TestCase(20, 3e4)]
        public void Jonswap_WithoutEnhancement_HasItsKnownVariance(double wind, double fetch)
        {
            var settings = Jonswap(wind, fetch, 1);
            double alpha = 0.076 * Math.Pow(wind * wind / (fetch * Gravity), 0.22),
                peak = PrintedSpectra.Peak(wind, fetch);
            double variance = alpha * Gravity * Gravity / (5 * Math.Pow(peak, 4));
            Assert.That(Integral(settings), Is.EqualTo(variance).Within(1e-4 * variance));
        }

        [Test]
        public void Jonswap_AtItsPeak_IsEnhancedByItsFactor_AndFarFromItNot()
        {
            SeaSettings flat = Jonswap(10, 1e5, 1), sharp = Jonswap(10, 1e5, 3.3);
            double Ratio(double frequency)
            {
                double k = frequency * frequency / Gravity;
                return SeaSpectrum.Omnidirectional(sharp, k) / SeaSpectrum.Omnidirectional(flat, k);
            }
            double peak = PrintedSpectra.Peak(10, 1e5);
            Assert.That(Ratio(peak), Is.EqualTo(3.3).Within(1e-12));
            Assert.That(Ratio(2 * peak), Is.EqualTo(1).Within(1e-9));
            // One width from the peak the enhancement's exponent is exp(-1/2): at frequencies 7 % below and 9 % above.
            Assert.That(Ratio(0.93 * peak), Is.EqualTo(Math.Pow(3.3, Math.Exp(-0.5))).Within(1e-9));
            Assert.That(Ratio(1.09 * peak), Is.EqualTo(Math.Pow(3.3, Math.Exp(-0.5))).Within(1e-9));
        }

        [Test]
        public void Density_OverAllDirections_IsTheOmnidirectionalOne([Values] SeaSpectrumKind kind)
        {
            var settings = Jonswap(10, 1e5, 3.3);
            settings.Kind = kind;
            const int steps = 360;
            const double k = 0.3;
            double sum = Enumerable.Range(0, steps).Sum(i =>
                SeaSpectrum.Density(settings, k, Math.Cos(2 * Math.PI * (i + 0.5) / steps)) * k * 2 * Math.PI / steps);
            Assert.That(sum, Is.EqualTo(SeaSpectrum.Omnidirectional(settings, k)).Within(1e-9 * sum));
        }

        [Test]
        public void Density_AgainstTheWind_IsZero([Values] SeaSpectrumKind kind, [Values(-1, -0.5)] double cosine)
        {
            var settings = SeaFields.Settings();
            settings.Kind = kind;
            Assert.That(SeaSpectrum.Density(settings, 1, cosine), Is.Zero);
            Assert.That(SeaSpectrum.Density(settings, 1, -cosine), Is.GreaterThan(0));
        }

        [Test]
        public void Density_AcrossTheWind_IsZeroForASquaredCosine() =>
            Assert.That(SeaSpectrum.Density(SeaFields.Settings(), 1, 0), Is.Zero);

        [Test]
        public void Density_OfWavesShorterThanTheShortest_IsZero()
        {
            var settings = SeaFields.Settings();
            settings.ShortestWave = 4;
            Assert.That(SeaSpectrum.Density(settings, 2 * Math.PI / 3.99, 1), Is.Zero);
            Assert.That(SeaSpectrum.Density(settings, 2 * Math.PI / 4.01, 1), Is.GreaterThan(0));
        }

        // Each wave's random number does not depend on the spectrum, so the ratio of two seas is that of their
        // formulas.
        [Test]
        public void Surface_OfAnySpectrum_DrawsByItsFormula([Values] SeaSpectrumKind kind,
            [Values(0, 30)] double direction)
        {
            SeaSettings phillips = SeaFields.Settings(16, 16, 9), settings = phillips;
            settings.Kind = kind;
            settings.WindSpeed = 14;
            settings.Fetch = 2e4;
            (phillips.WindDirectionDegrees, settings.WindDirectionDegrees) = (direction, direction);
            var drawn = Powers(settings);
            var first = Powers(phillips);
            Dictionary<(int, int), double> expected = PrintedSpectra.Variances(settings),
                expectedFirst = PrintedSpectra.Variances(phillips);

            Assert.That(drawn.Keys, Is.EquivalentTo(expected.Keys));
            // Phillips has no waves across the wind.
            foreach (var wave in drawn.Keys.Where(first.ContainsKey))
                Assert.That(drawn[wave] / first[wave],
                    Is.EqualTo(expected[wave] / expectedFirst[wave]).Within(1e-9).Percent, $"wave {wave}");
        }

        static Dictionary<(int, int), double> Powers(in SeaSettings settings) =>
            new SeaSurface(settings).Modes.ToDictionary(mode => (mode.Column, mode.Row),
                mode => mode.Real * mode.Real + mode.Imaginary * mode.Imaginary);

        static SeaSettings Jonswap(double wind, double fetch, double enhancement)
        {
            var settings = SeaFields.Settings(wind: wind);
            (settings.Kind, settings.Fetch, settings.PeakEnhancement) = (SeaSpectrumKind.Jonswap, fetch, enhancement);
            return settings;
        }

        // Wavelengths from 1 mm to 10 km in equal ratios.
        static double Integral(in SeaSettings settings)
        {
            const int steps = 20000;
            double from = Math.Log(2 * Math.PI / 1e4), to = Math.Log(2 * Math.PI / 1e-3), sum = 0;
            for (int i = 0; i < steps; i++)
            {
                double k = Math.Exp(from + (to - from) * (i + 0.5) / steps);
                sum += SeaSpectrum.Omnidirectional(settings, k) * k;
            }
            return sum * (to - from) / steps;
        }
    }
}
