using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Patterns of a radar screen's antenna, in azimuth and in elevation.</summary>
    public sealed class ScreenPatternTests
    {
        // 90 dB over noise.
        const double Range = 5000, Large = 1e8;
        const int Spoke = 256, Spokes = 1024;

        // An aperture of constant field: the echo is sin(x)^4 / x^4, with sidelobes of 2 x -13.26 dB.
        [Test]
        public void Sinc_HasItsSidelobesOutAndBack()
        {
            var radar = ScreenBench.Small(Spokes, 64);
            (radar.Pattern, radar.BeamWidth) = (ScreenPattern.Sinc, 3);
            using (var bench = new ScreenBench(radar, (90, Range, Large)))
            {
                bench.Turn(60, 120);
                var levels = bench.Levels();
                double Level(int offset) => levels[bench.Element(Spoke + offset, (int)(Range / bench.Geometry.CellSize))];
                double highest = double.NegativeInfinity;
                for (int offset = -60; offset <= 60; offset++)
                {
                    // sin(x) / x is the root of a half at 1.3916.
                    double x = 1.39156 * Math.Sin(2 * Math.PI * offset / Spokes) / Math.Sin(math.radians(1.5)),
                        expected = offset == 0 ? 0 : 40 * Math.Log10(Math.Abs(Math.Sin(x) / x));
                    if (expected > -50)
                        Assert.That(Level(offset) - Level(0), Is.EqualTo(expected).Within(0.15), $"{offset} spokes");
                    if (Math.Abs(x) > Math.PI)
                        highest = Math.Max(highest, Level(offset) - Level(0));
                }
                Assert.That(highest, Is.EqualTo(2 * -13.26).Within(0.3));
            }
        }

        // A lobe 12 spokes to the right of the beam: a target has an echo when the beam is as far to its left.
        [Test]
        public void Table_HasItsSidelobe_OnItsSide()
        {
            double degrees = 360.0 / Spokes;
            string table = FormattableString.Invariant(
                $"{EchoAntenna.TableHeader}\n{-8 * degrees},-90,0\n0,0,0\n{8 * degrees},-90,0\n{11 * degrees},-90,0\n{12 * degrees},-12.5,0\n{13 * degrees},-90,0\n");
            var radar = ScreenBench.Small(Spokes, 64);
            radar.Pattern = ScreenPattern.Table;
            using (var bench = new ScreenBench(radar, table, (90, Range, Large)))
            {
                bench.Turn(70, 110);
                var levels = bench.Levels();
                double Level(int offset) => levels[bench.Element(Spoke + offset, (int)(Range / bench.Geometry.CellSize))];
                Assert.That(Level(-12) - Level(0), Is.EqualTo(-25).Within(0.05));
                Assert.That(Level(12), Is.LessThan(15), "noise");
                // Half of the field is at 4 spokes; half of the power at 2.34.
                Assert.That(bench.Geometry.BeamWidth, Is.EqualTo(2 * 2.343 * degrees).Within(0.01));
            }
        }

        // 1 / sin^2 out and back: the echo is that of one range, whatever the range. At 3,200 m the earth's curvature adds
        // 0.6 m to the 200 m: 0.05 dB.
        [Test]
        public void Cosecant_HasOneEchoOfAllRangesAtOneHeight()
        {
            var radar = ScreenRadar.Default;
            (radar.Pattern, radar.VerticalBeamWidth, radar.CosecantFrom, radar.CosecantTo) =
                (ScreenPattern.Cosecant, 4, -2, -40);
            var geometry = new ScreenGeometry(radar, "test");
            double Amplitude(double range) => geometry.PointOf(new double3(range, 0, 0), new double3(0, 200, 0), 1).Amplitude;
            double nearest = Amplitude(400);
            foreach (double range in new[] { 800, 1600, 3200 })
                Assert.That(20 * Math.Log10(Amplitude(range) / nearest), Is.EqualTo(0).Within(0.06), $"{range} m");
            Assert.That(Amplitude(200), Is.Zero, "at -45 degrees");
        }

        // The volume is that of the integral of the fourth power of the field above the horizontal.
        [Test]
        public void Rain_IsThatOfThePatternAboveTheSea()
        {
            var radar = ScreenRadar.Default;
            (radar.RainRate, radar.VerticalBeamWidth) = (10, 20);
            double gaussian = new ScreenGeometry(radar, "test").RainAmplitude;
            radar.Pattern = ScreenPattern.Sinc;
            var sinc = new ScreenGeometry(radar, "test");
            // That of sin(x)^4 / x^4 is pi / 3 from 0 on.
            double exponent = 4 * Math.Log(2) / Math.Pow(math.radians(20), 2), width = math.radians(20) / (2 * 1.39156);
            Assert.That(20 * Math.Log10(sinc.RainAmplitude / gaussian), Is.EqualTo(10 * Math.Log10(
                width * Math.PI / 3 / (0.5 * Math.Sqrt(Math.PI / (2 * exponent))))).Within(0.1));
        }

        // Both cuts 3 dB below the gain in the middle of the beam: 6 dB one way, 12 dB out and back.
        [Test]
        public void Table_BelowItsGain_WeakensReflectors() => AssertTwelveDecibels(TableRadar(),
            bench => bench.Tracer.AddPoints(new[] { bench.Geometry.PointOf(ScreenBench.At(90, Range),
                new double3(0, ScreenBench.Height, 0), 1e5) }, 1));

        [Test]
        public void Table_BelowItsGain_WeakensMeshes()
        {
            double3 antenna = new double3(0, ScreenBench.Height, 0);
            float3 At(double y, double z) => (float3)(antenna + new double3(Range, y, z));
            var wall = new TriangleMesh(new[] { At(-2, -9), At(-2, 9), At(2, 9), At(2, -9) }, new[] { 0, 1, 2, 0, 2, 3 });
            using (var targets = new ScreenTargets("test", new ScreenGeometry(TableRadar(), "test", TableOf(0))))
            {
                targets.SetScene(new RadarScene(new MeshInstance { Mesh = wall, ToWorld = Affine.Identity }), new bool[1]);
                AssertTwelveDecibels(TableRadar(), bench => bench.Tracer.AddTargets(targets, antenna, 0, 0));
            }
        }

        [Test]
        public void Table_BelowItsGain_WeakensTheSea()
        {
            var waves = SeaSettings.Default;
            (waves.WindSpeed, waves.TileSize, waves.GridSize, waves.Choppiness) = (10, 256, 256, 0);
            var geometry = new ScreenGeometry(TableRadar(), "test", TableOf(0));
            using (var sea = new ScreenSea(TestKernels.SeaField, "test", geometry, waves, SeaClutterSettings.On))
            {
                sea.Update(0);
                AssertTwelveDecibels(TableRadar(), bench => bench.Tracer.AddSea(sea, new double3(0, 200, 0), 0));
            }
        }

        [Test]
        public void Table_BelowItsGain_WeakensRain()
        {
            var radar = TableRadar();
            radar.RainRate = 50;
            AssertTwelveDecibels(radar, bench => bench.Tracer.AddRain());
        }

        // The radar equation with the table's own level in the middle, once each way.
        [Test]
        public void Table_BelowItsGain_HasTheRadarEquation()
        {
            using (var bench = new ScreenBench(TableRadar(), TableOf(-3), (90, Range, 1e5)))
            {
                bench.Turn(60, 120);
                double gainDb = 10 * Math.Log10(26000 / bench.Geometry.BeamWidth / 40) - 6, wave = 299792458 / 9.41e9,
                    noise = 1.380649e-23 * 290 / 80e-9 * Math.Pow(10, 0.5), expected = 2 * gainDb
                        + 10 * Math.Log10(1e6 * wave * wave * 1e5 / (Math.Pow(4 * Math.PI, 3) * Math.Pow(Range, 4) * noise));
                Assert.That(bench.Levels()[bench.Element(Spoke, (int)(Range / bench.Geometry.CellSize))],
                    Is.EqualTo(expected).Within(0.05));
                Assert.That(bench.Geometry.OverNoiseDb(1e5, Range), Is.EqualTo(expected).Within(0.01));
            }
        }

        // The power of what is 40 dB over noise, with both cuts at the gain and 3 dB below it in the middle.
        static void AssertTwelveDecibels(in ScreenRadar radar, Action<ScreenBench> add)
        {
            float[] full = LevelsOf(radar, 0, add), weak = LevelsOf(radar, -3, add);
            int[] strong = Enumerable.Range(0, full.Length).Where(i => full[i] > 40).ToArray();
            Assert.That(strong, Is.Not.Empty);
            double Power(float[] levels) => strong.Sum(i => Math.Pow(10, levels[i] / 10));
            Assert.That(10 * Math.Log10(Power(full) / Power(weak)), Is.EqualTo(12).Within(0.1));
        }

        static float[] LevelsOf(in ScreenRadar radar, double level, Action<ScreenBench> add)
        {
            using (var bench = new ScreenBench(radar, TableOf(level)))
            {
                foreach (double turns in new[] { 0.23, 0.27 })
                {
                    bench.Tracer.Begin(turns);
                    add(bench);
                    bench.Tracer.Finish(bench.Receiver);
                }
                return bench.Levels();
            }
        }

        static ScreenRadar TableRadar()
        {
            var radar = ScreenBench.Small(Spokes, 256);
            (radar.Pattern, radar.Power, radar.RangeScale) = (ScreenPattern.Table, 1e6, 6000);
            return radar;
        }

        // 40 degrees in elevation at one level, dB, and 2 degrees in azimuth below the same one.
        static string TableOf(double level) => FormattableString.Invariant(
            $"{EchoAntenna.TableHeader}\n-20,-200,{level}\n-3,{level - 40},{level}\n0,{level},{level}\n3,{level - 40},{level}\n20,-200,{level}\n");

        [TestCase("angle,azimuth,elevation", "must begin with the line angle_deg,azimuth_db,elevation_db")]
        [TestCase("angle_deg,azimuth_db,elevation_db\n0,0", "must be three numbers")]
        [TestCase("angle_deg,azimuth_db,elevation_db\n-0.1,-3,0\n0,0,0\n0.1,-3,0", "fewer than three across the beam")]
        public void WrongTables_AreRefused(string table, string message)
        {
            var radar = ScreenRadar.Default;
            radar.Pattern = ScreenPattern.Table;
            Assert.That(() => new ScreenGeometry(radar, "screen", table), Throws.InstanceOf<GlintException>()
                .With.Message.StartsWith("screen: ").And.Message.Contains(message));
        }
    }
}
