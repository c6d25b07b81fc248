using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>A finer tile continues the spectrum of a sea where the grid of the larger tile ends.</summary>
    public sealed class SeaCascadeTests
    {
        // Waves of the finer tile are "ratio" steps of the larger tile's wave numbers apart. The first of them stand
        // for a steep part of the spectrum, by its density in their middle: the variance differs by a few percent.
        [Test]
        public void Finer_AndItsTile_HaveTheVarianceOfATileThatHoldsAllWaves([Values] SeaSpectrumKind kind,
            [Values(4, 8)] int ratio)
        {
            var settings = SettingsOf(kind, 64);
            var coarse = new SeaSurface(settings);
            settings.GridSize = 512;
            double rest = new SeaSurface(settings).Modes
                .Where(mode => Largest(mode) > 31 && Largest(mode) < 31.5 * ratio)
                .Sum(mode => SeaSpectrum.Density(settings, WaveNumber(mode, 128), CosineToWind(mode, settings)));
            double asked = coarse.DensityScale * rest * math.square(2 * Math.PI / 128),
                variance = math.square(coarse.Finer(128 / ratio).SignificantWaveHeight) / 16;
            Assert.That(variance, Is.EqualTo(asked).Within(ratio == 4 ? 1.5 : 4).Percent);
        }

        [Test]
        public void Finer_HasNoWaveOfTheLargerTile_AndNumbersOfItsOwn()
        {
            var coarse = new SeaSurface(SettingsOf(SeaSpectrumKind.Elfouhaily, 64));
            var finer = coarse.Finer(16);
            Assert.That(finer.DensityScale, Is.EqualTo(coarse.DensityScale).Within(1e-12).Percent);
            Assert.That(finer.Modes, Is.Not.Empty);
            // A wave stands for half a step of wave numbers to either side: 8 of those of the larger tile.
            foreach (var mode in finer.Modes)
                Assert.That(8 * Largest(mode) + 4, Is.GreaterThan(31));
            var same = coarse.Modes.ToDictionary(mode => (mode.Column, mode.Row), mode => mode.Real / mode.Imaginary);
            Assert.That(finer.Modes.Where(mode => same.ContainsKey((mode.Column, mode.Row)))
                .Select(mode => mode.Real / mode.Imaginary - same[(mode.Column, mode.Row)]),
                Is.Not.Empty.And.All.Not.EqualTo(0).Within(1e-9));
        }

        [TestCase(128, "finer tile of 128 m must be smaller than the tile of 128 m")]
        [TestCase(double.NaN, "finer tile of NaN m must be smaller")]
        [TestCase(16.0001, "tile size 16.0001 m must be a multiple of 1/1024 m")]
        public void Finer_OfAnImpossibleTile_IsRefused(double tile, string message)
        {
            var coarse = new SeaSurface(SettingsOf(SeaSpectrumKind.Elfouhaily, 64));
            Assert.That(() => coarse.Finer(tile), Throws.InstanceOf<GlintException>().With.Message.Contains(message));
        }

        [Test]
        public void Finer_OfASeaWithoutShorterWaves_IsRefused()
        {
            var settings = SettingsOf(SeaSpectrumKind.Elfouhaily, 64);
            settings.ShortestWave = 5;
            Assert.That(() => new SeaSurface(settings).Finer(16), Throws.InstanceOf<GlintException>()
                .With.Message.Contains("raises no wave between"));
        }

        static int Largest(SeaMode mode) => math.max(math.abs(mode.Column), math.abs(mode.Row));

        static double WaveNumber(SeaMode mode, double tile) =>
            2 * Math.PI / tile * math.length(math.double2(mode.Column, mode.Row));

        static double CosineToWind(SeaMode mode, SeaSettings settings)
        {
            math.sincos(math.radians(settings.WindDirectionDegrees), out double sine, out double cosine);
            return math.abs(mode.AlongX * sine + mode.AlongZ * cosine);
        }

        static SeaSettings SettingsOf(SeaSpectrumKind kind, int grid)
        {
            var settings = SeaSettings.Default;
            (settings.Kind, settings.TileSize, settings.GridSize) = (kind, 128, grid);
            (settings.Fetch, settings.WindDirectionDegrees) = (1e5, 30);
            settings.SignificantWaveHeight = kind == SeaSpectrumKind.Phillips ? 1 : 0;
            return settings;
        }
    }
}
