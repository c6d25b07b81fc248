using System;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>The waves that a sea's mesh leaves out.</summary>
    public sealed class ShortWavesTests
    {
        // Waves up to a third of the wave number of 10 GHz tilt the ripples that scatter.
        const double Tilting = 2 * Math.PI * 10e9 / 299792458 / 3;

        // Facets of a side in metres, wind 10 m/s: mean square slopes along and across the wind.
        [TestCase(0.25, 0.0044, 0.0036)]
        [TestCase(0.5, 0.0060, 0.0049)]
        [TestCase(1, 0.0078, 0.0064)]
        [TestCase(2, 0.0100, 0.0081)]
        [TestCase(4, 0.0122, 0.0098)]
        [TestCase(8, 0.0145, 0.0112)]
        public void SlopeVariances_OfWavesShorterThanFacets_AreKnown(double side, double along, double across)
        {
            var found = OfWind(10).SlopeVariances(ShortWaves.CutOf(side), Tilting);
            Assert.That(found.Along, Is.EqualTo(along).Within(6e-5));
            Assert.That(found.Across, Is.EqualTo(across).Within(6e-5));
        }

        [Test]
        public void SlopeVariances_OfAllTiltingWaves_AreKnown()
        {
            var found = OfWind(10).SlopeVariances(1e-3, Tilting);
            Assert.That(found.Along, Is.EqualTo(0.01967).Within(5e-6));
            Assert.That(found.Across, Is.EqualTo(0.01338).Within(5e-6));
        }

        // Roughness of the ripples at 10 GHz: the wave number times their deviation.
        [TestCase(5, 0.11)]
        [TestCase(10, 0.19)]
        [TestCase(15, 0.24)]
        public void HeightDeviation_OfRipples_IsKnown(double wind, double roughness) =>
            Assert.That(3 * Tilting * OfWind(wind).HeightDeviation(Tilting, 2e3), Is.EqualTo(roughness).Within(0.005));

        [Test]
        public void HeightDeviation_OfAllWaves_IsAQuarterOfTheirHeight() =>
            Assert.That(4 * OfWind(10).HeightDeviation(1e-3, 2e3), Is.EqualTo(2.634).Within(5e-4));

        // A tile of 64 m: facets of 1 m hold waves of 2 m, 64 grid points a side 63 half waves.
        [TestCase(64, 256, 0, 2)]
        [TestCase(256, 64, 0, 2 * 64 / 63.0)]
        [TestCase(256, 256, 5, 5)]
        [TestCase(64, 256, 1, 2)]
        public void Cut_IsWhereTheMeshEnds(int cells, int grid, double shortest, double wave)
        {
            var settings = SeaSettings.Default;
            (settings.Cells, settings.GridSize, settings.ShortestWave) = (cells, grid, shortest);
            Assert.That(2 * Math.PI / ShortWaves.CutOf(settings), Is.EqualTo(wave).Within(1e-12));
        }

        // One spectrum: no step, whatever the facets.
        [Test]
        public void Step_OfElfouhailysSea_IsNone([Values(16, 64, 128)] int cells)
        {
            var settings = SeaSettings.Default;
            settings.Cells = cells;
            var waves = new ShortWaves(new SeaSurface(settings));
            Assert.That(waves.Step, Is.EqualTo(0).Within(1e-12));
            Assert.That(waves.StepWarning, Is.Null);
            Assert.That(waves.Wind, Is.EqualTo(settings.WindSpeed));
        }

        // Long waves of twice or half the height have four times or a quarter of the variance, 6.02 dB.
        [TestCase(2, -6.0206)]
        [TestCase(0.5, 6.0206)]
        [TestCase(1.2, -1.5836)]
        public void Step_OfScaledLongWaves_IsTheirScale(double factor, double decibels)
        {
            var settings = SeaSettings.Default;
            double own = new SeaSurface(settings).SignificantWaveHeight;
            settings.SignificantWaveHeight = factor * own;
            var asked = new ShortWaves(new SeaSurface(settings));
            (settings.SignificantWaveHeight, settings.HeightFactor) = (0, factor);
            var scaled = new ShortWaves(new SeaSurface(settings));
            foreach (var waves in new[] { asked, scaled })
            {
                Assert.That(waves.Step, Is.EqualTo(decibels).Within(1e-4));
                Assert.That(waves.StepWarning, Math.Abs(decibels) > 3
                    ? Does.Contain(decibels > 0 ? " 6.0 dB above " : " 6.0 dB below ").And.Contain(" 2.032 m")
                    : Is.Null);
            }
        }

        // Far above its peak Pierson and Moskowitz' spectrum is 0.0081 / (2 k^3).
        [Test]
        public void Step_OfPiersonMoskowitz_IsThatOfBothTails()
        {
            var settings = SeaSettings.Default;
            (settings.Kind, settings.WindSpeed) = (SeaSpectrumKind.PiersonMoskowitz, 10);
            var waves = new ShortWaves(new SeaSurface(settings));
            double cut = 63 * Math.PI / 64, tail = new Elfouhaily(10).Omnidirectional(cut) * Math.Pow(cut, 3);
            Assert.That(waves.Step, Is.EqualTo(10 * Math.Log10(tail / (0.0081 / 2))).Within(0.01));
        }

        // The stored seas have the height of a wind of 10.4 and 14.7 m/s. Their tail, 1 / k^3, follows from the wave
        // along the wind with the largest wave number: variance over its cell of wave vectors, times pi k / 2.
        [TestCase(5, 10.4)]
        [TestCase(6, 14.7)]
        public void StoredSeas_HaveTheWindOfTheirHeight_AndAStep(int state, double wind)
        {
            var settings = StoredSeas.All[state - 5].Settings;
            var waves = new ShortWaves(new SeaSurface(settings));
            Assert.That(waves.Wind, Is.EqualTo(wind).Within(0.05));
            var unscaled = settings;
            unscaled.HeightFactor = 1;
            double step = 2 * Math.PI / 64, k = 31 * step,
                density = PrintedSpectra.Variances(unscaled)[(0, 31)] * Math.Pow(settings.HeightFactor / step, 2);
            double tail = density * Math.PI / 2 * k * Math.Pow(k / waves.Cut, 3);
            Assert.That(waves.Step,
                Is.EqualTo(10 * Math.Log10(new Elfouhaily(waves.Wind).Omnidirectional(waves.Cut) / tail)).Within(0.01));
            Assert.That(waves.StepWarning != null, Is.EqualTo(Math.Abs(waves.Step) > 3));
        }

        [Test]
        public void Wind_Given_IsThatOfTheShortWaves()
        {
            var waves = new ShortWaves(new SeaSurface(StoredSeas.SeaState5.Settings), 8);
            Assert.That(waves.Wind, Is.EqualTo(8));
            Assert.That(waves.Spectrum.Omnidirectional(100), Is.EqualTo(new Elfouhaily(8).Omnidirectional(100)));
        }

        [TestCase(2, 21, "clutter wind 21 m/s must be from 3 to 20")]
        [TestCase(2, -1, "clutter wind -1 m/s")]
        [TestCase(2, double.NaN, "clutter wind NaN m/s")]
        [TestCase(0.05, 0, "clutter wind 2.166")]
        [TestCase(0.05, 0, "that of waves of 0.05 m, must be from 3 to 20")]
        public void Wind_OutsideTheModel_IsRefused(double height, double wind, string part)
        {
            var settings = SeaFields.Settings();
            settings.SignificantWaveHeight = height;
            var surface = new SeaSurface(settings);
            Assert.That(Assert.Throws<GlintException>(() => new ShortWaves(surface, wind)).Message,
                Does.StartWith("sea: ").And.Contain(part).And.Contain("give a clutter wind"));
        }

        // Facets of 1 mm hold ripples shorter than the spectrum's.
        [Test]
        public void Mesh_FinerThanTheSpectrum_IsRefused()
        {
            var settings = SeaFields.Settings(1024, 1024);
            settings.TileSize = 1;
            var surface = new SeaSurface(settings);
            Assert.That(Assert.Throws<GlintException>(() => new ShortWaves(surface)).Message,
                Does.StartWith("sea: its mesh holds waves up to 3213").And.Contain("from 0.001 to 2000"));
        }

        [Test]
        public void Integrals_OutsideTheSpectrum_AreRefused() => Assert.That(
            Assert.Throws<GlintException>(() => OfWind(10).SlopeVariances(1, 3000)).Message,
            Does.StartWith("sea: waves from 1 to 3000 rad/m must be from 0.001 to 2000"));

        static ShortWaves OfWind(double wind)
        {
            var settings = SeaSettings.Default;
            settings.WindSpeed = wind;
            return new ShortWaves(new SeaSurface(settings));
        }
    }
}
