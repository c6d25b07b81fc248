using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class SeaSettingsTests
    {
        delegate void Change(ref SeaSettings settings);

        [Test]
        public void Default_MakesASea() =>
            Assert.That(new SeaSurface(SeaSettings.Default).Mesh(0).TriangleCount, Is.EqualTo(2 * 64 * 64));

        [TestCase(-1)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        [TestCase(101)]
        public void Validate_WaveHeightOfNoSea_IsRefused(double height) =>
            AssertRefused((ref SeaSettings s) => s.SignificantWaveHeight = height, "significant wave height",
                "0 to 100", "flat plate");

        [TestCase(0)]
        [TestCase(-5)]
        [TestCase(double.NaN)]
        public void Validate_WindThatRaisesNothing_IsRefused(double wind) =>
            AssertRefused((ref SeaSettings s) => s.WindSpeed = wind, "wind speed", "0.1 to 100", "direction");

        [TestCase(0)]
        [TestCase(-64)]
        [TestCase(double.NaN)]
        [TestCase(8193)]
        public void Validate_TileSizeOfNoTile_IsRefused(double tile) =>
            AssertRefused((ref SeaSettings s) => s.TileSize = tile, "tile size", "1 to 8192");

        [Test]
        public void Validate_TileSizeThatFloatsCannotRepeat_NamesTheNearestThatTheyCan()
        {
            AssertRefused((ref SeaSettings s) => s.TileSize = 100.1, "tile size 100.1 m",
                "1/1024", "use 100.099609375");
            var settings = SeaSettings.Default;
            settings.TileSize = 100.099609375;
            Assert.DoesNotThrow(() => settings.Validate());
        }

        [TestCase(0)]
        [TestCase(2)]
        [TestCase(63)]
        [TestCase(94)]
        [TestCase(-64)]
        [TestCase(2048)]
        public void Validate_GridThatIsNoPowerOfTwo_IsRefused(int grid) => AssertRefused(
            (ref SeaSettings s) => s.GridSize = grid, $"grid size {grid} ", "power of two", "4 to 1024", "cells");

        [TestCase(0)]
        [TestCase(-1)]
        [TestCase(2049)]
        public void Validate_CellsOfNoMesh_AreRefused(int cells) =>
            AssertRefused((ref SeaSettings s) => s.Cells = cells, $"cells {cells} ", "1 to 2048");

        [TestCase(-0.1)]
        [TestCase(11)]
        [TestCase(double.NaN)]
        public void Validate_Choppiness_IsRefused(double choppiness) =>
            AssertRefused((ref SeaSettings s) => s.Choppiness = choppiness, "choppiness", "0 to 10");

        [Test]
        public void Validate_OtherValuesOutOfTheirRange_AreRefusedByName()
        {
            AssertRefused((ref SeaSettings s) => s.Kind = (SeaSpectrumKind)7, "spectrum 7",
                "Phillips or PiersonMoskowitz or Jonswap or Elfouhaily");
            AssertRefused((ref SeaSettings s) => s.WindDirectionDegrees = double.NaN, "wind direction NaN deg");
            AssertRefused((ref SeaSettings s) => s.ShortestWave = -1, "shortest wave -1 m", "0 to 32");
            AssertRefused((ref SeaSettings s) => s.ShortestWave = 40, "shortest wave 40 m", "0 to 32");
            AssertRefused((ref SeaSettings s) => s.HeightFactor = 0, "height factor 0 ");
            AssertRefused((ref SeaSettings s) => s.HeightFactor = double.NaN, "height factor NaN ");
        }

        [Test]
        public void Validate_FetchAndPeak_MatterForTheirSpectraOnly()
        {
            Change noFetch = (ref SeaSettings s) => { s.Kind = SeaSpectrumKind.Jonswap; s.Fetch = 0; };
            AssertRefused(noFetch, "fetch 0 m", "100000");
            AssertRefused(
                (ref SeaSettings s) => (s.Kind, s.Fetch, s.PeakEnhancement) = (SeaSpectrumKind.Jonswap, 1e5, 0),
                "peak enhancement 0 ", "3.3");
            foreach (var kind in new[] { SeaSpectrumKind.Phillips, SeaSpectrumKind.PiersonMoskowitz })
            {
                var settings = SeaFields.Settings();
                (settings.Kind, settings.Fetch, settings.PeakEnhancement) = (kind, -1, 0);
                Assert.DoesNotThrow(() => settings.Validate());
            }
        }

        [Test]
        public void Validate_TheWindsHeight_IsRefusedForPhillipsOnly()
        {
            AssertRefused((ref SeaSettings s) => s.Kind = SeaSpectrumKind.Phillips, "significant wave height 0 m",
                "Phillips", "give the height");
            foreach (var kind in new[] { SeaSpectrumKind.PiersonMoskowitz, SeaSpectrumKind.Jonswap })
            {
                var settings = SeaSettings.Default;
                (settings.Kind, settings.Fetch) = (kind, 1e5);
                Assert.DoesNotThrow(() => settings.Validate());
            }
        }

        [TestCase(2.9)]
        [TestCase(20.1)]
        public void Validate_WindOutsideElfouhailysModel_IsRefusedForItOnly(double wind)
        {
            AssertRefused((ref SeaSettings s) => s.WindSpeed = wind, "wind speed", "from 3 to 20", "another spectrum");
            var settings = SeaFields.Settings(wind: wind);
            Assert.DoesNotThrow(() => settings.Validate());
        }

        // The inverse wave age is 5 at 591 m, for a wind of 10 m/s.
        [TestCase(-1)]
        [TestCase(590)]
        [TestCase(1.1e7)]
        [TestCase(double.NaN)]
        public void Validate_FetchOutsideElfouhailysModel_IsRefused(double fetch) => AssertRefused(
            (ref SeaSettings s) => (s.WindSpeed, s.Fetch) = (10, fetch), "fetch", "from 592 to 1e7", "0, which is");

        [TestCase(-1)]
        [TestCase(101)]
        [TestCase(double.NaN)]
        public void Validate_SwellOfNoHeight_IsRefused(double height) =>
            AssertRefused((ref SeaSettings s) => s.SwellHeight = height, "swell height", "0 to 100", "without swell");

        // Waves of 10 s are 156 m long, those of 3.5 s 19 m; tile and grid hold waves of 2.1 to 64 m.
        [Test]
        public void Validate_SwellThatTheTileCannotHold_IsRefused()
        {
            AssertRefused((ref SeaSettings s) => s.SwellHeight = 1, "swell period 10 s", "waves of 156", "to 64 m");
            AssertRefused((ref SeaSettings s) => (s.SwellHeight, s.SwellPeriod, s.ShortestWave) = (1, 3.5, 20),
                "swell period 3.5 s", "waves of 19", "from 20 to 64 m");
            AssertRefused((ref SeaSettings s) => (s.SwellHeight, s.SwellPeriod) = (1, double.NaN), "swell period NaN s",
                "3 to 30");
            AssertRefused((ref SeaSettings s) =>
                (s.SwellHeight, s.SwellPeriod, s.SwellDirectionDegrees) = (1, 5, 400), "swell direction 400 deg");
        }

        [Test]
        public void Validate_WithoutSwell_ItsNumbersDoNotMatter()
        {
            var settings = SeaSettings.Default;
            (settings.SwellPeriod, settings.SwellDirectionDegrees) = (double.NaN, double.NaN);
            Assert.DoesNotThrow(() => settings.Validate());
        }

        // Waves as fast as 0.1 m/s are 6 mm long; the 64 m grid has none below 2 m.
        [Test]
        public void Surface_OfAWindTooWeakForItsGrid_IsRefused()
        {
            var settings = SeaFields.Settings(64, wind: 0.1);
            string message = Assert.Throws<GlintException>(() => new SeaSurface(settings)).Message;
            Assert.That(message, Does.Contain("wind of 0.1 m/s").And.Contain("smaller tile"));
        }

        [TestCase(double.NaN)]
        [TestCase(double.NegativeInfinity)]
        [TestCase(1e8)]
        public void Mesh_AtNoTime_IsRefused(double time) =>
            Assert.That(Assert.Throws<GlintException>(() => new SeaSurface(SeaSettings.Default).Mesh(time)).Message,
                Does.Contain("time").And.Contain(" s "));

        [Test]
        public void FactorFor_NoTimes_IsRefused() => Assert.That(
            Assert.Throws<GlintException>(() => SeaSurface.FactorFor(SeaSettings.Default, new double[0])).Message,
            Does.Contain("at least one time"));

        // World Meteorological Organization, code table 3700.
        [TestCase(1, 0, 0.1)]
        [TestCase(2, 0.1, 0.5)]
        [TestCase(3, 0.5, 1.25)]
        [TestCase(4, 1.25, 2.5)]
        [TestCase(5, 2.5, 4)]
        [TestCase(6, 4, 6)]
        [TestCase(7, 6, 9)]
        [TestCase(8, 9, 14)]
        public void SeaState_OfACode_IsTheMiddleOfItsRange(int code, double from, double to)
        {
            Assert.That(SeaState.Range(code), Is.EqualTo((from, to)));
            Assert.That(SeaState.WaveHeight(code), Is.EqualTo((from + to) / 2));
        }

        [TestCase(-1)]
        [TestCase(0)]
        [TestCase(9)]
        public void SeaState_WithoutARange_IsRefused(int code) =>
            Assert.That(Assert.Throws<GlintException>(() => SeaState.WaveHeight(code)).Message,
                Does.Contain($"sea state {code} ").And.Contain("1 to 8").And.Contain("metres"));

        static void AssertRefused(Change change, params string[] fragments)
        {
            var settings = SeaSettings.Default;
            change(ref settings);
            string message = Assert.Throws<GlintException>(() => settings.Validate()).Message;
            Assert.That(message, Does.StartWith("sea: "));
            foreach (string fragment in fragments)
                Assert.That(message, Does.Contain(fragment));
        }
    }
}
