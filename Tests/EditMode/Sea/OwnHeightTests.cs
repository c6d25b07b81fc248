using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Seas whose height is that of their wind.</summary>
    public sealed class OwnHeightTests
    {
        // The tile holds waves from 1024 to 4 m; shorter ones have some 0.3 % of the variance.
        [TestCase(SeaSpectrumKind.Elfouhaily, 2.634)]
        [TestCase(SeaSpectrumKind.PiersonMoskowitz, 2.245)]
        public void WaveHeight_OnALargeTile_IsThatOfTheWind(SeaSpectrumKind kind, double known)
        {
            var settings = OfWind(kind, 512, 1024);
            Assert.That(new SeaSurface(settings).SignificantWaveHeight, Is.EqualTo(known).Within(0.5).Percent);
            settings.HeightFactor = 2;
            Assert.That(new SeaSurface(settings).SignificantWaveHeight, Is.EqualTo(2 * known).Within(0.5).Percent);
        }

        [Test]
        public void Waves_HaveTheDensityOfTheirSpectrum(
            [Values(SeaSpectrumKind.Elfouhaily, SeaSpectrumKind.PiersonMoskowitz, SeaSpectrumKind.Jonswap)]
            SeaSpectrumKind kind)
        {
            var settings = OfWind(kind, 16, 64);
            double known = PrintedSpectra.Variances(settings).Values.Sum();
            Assert.That(new SeaSurface(settings).SignificantWaveHeight,
                Is.EqualTo(4 * Math.Sqrt(known)).Within(1e-9).Percent);
        }

        // A correction of the seed's height would put a step between the tile's waves and the shorter ones.
        [Test]
        public void FactorFor_AnySeed_IsOne() =>
            Assert.That(SeaSurface.FactorFor(OfWind(SeaSpectrumKind.Elfouhaily, 16, 64), new[] { 0.0 }), Is.EqualTo(1));

        // Elfouhaily's waves run across the wind too: of each pair k, -k one.
        [TestCase(0)]
        [TestCase(90)]
        [TestCase(180)]
        [TestCase(30)]
        public void Modes_AreOneOfEachPair(double direction)
        {
            var settings = OfWind(SeaSpectrumKind.Elfouhaily, 16, 64);
            settings.WindDirectionDegrees = direction;
            var modes = new SeaSurface(settings).Modes;
            Assert.That(modes.Count, Is.EqualTo((15 * 15 - 1) / 2));
            Assert.That(modes.Select(mode => (mode.Column, mode.Row)), Is.Unique);
        }

        // Waves of a tile of 1 m are ripples: g k + 7.2e-5 k^3 for Elfouhaily, g k for the others.
        [TestCase(SeaSpectrumKind.Elfouhaily, 7.2e-5)]
        [TestCase(SeaSpectrumKind.PiersonMoskowitz, 0)]
        public void Frequency_OfRipples_HasSurfaceTensionInElfouhailysSea(SeaSpectrumKind kind, double tension)
        {
            foreach (var mode in new SeaSurface(OfWind(kind, 128, 1)).Modes)
            {
                double k = 2 * Math.PI * Math.Sqrt(mode.Column * mode.Column + mode.Row * mode.Row);
                double squared = Math.Pow(2 * Math.PI * mode.Frequency, 2);
                Assert.That(squared, Is.EqualTo(9.81 * k + tension * k * k * k).Within(0.5).Percent);
            }
        }

        static SeaSettings OfWind(SeaSpectrumKind kind, int grid, double tile)
        {
            var settings = SeaSettings.Default;
            (settings.Kind, settings.GridSize, settings.Cells, settings.TileSize) = (kind, grid, 4, tile);
            (settings.WindSpeed, settings.Fetch) = (10, kind == SeaSpectrumKind.Jonswap ? 1e5 : 0);
            return settings;
        }
    }
}
