using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Trails that keep their place beside the own ship, or over the ground.</summary>
    [Category("Slow")]
    public sealed class ScreenTrailsTests
    {
        // A turn takes 2.5 s, and has 10 frames.
        const int Frames = 10;
        const double Frame = 0.25, Section = 1e4;

        // Metres of a pixel of the map.
        const double Pixel = 6.25;

        static readonly double3 s_reflector = new double3(400, ScreenBench.Height, 0);

        // Half a cell, half a pixel and 10 dB of the beam are 1.5 pixels.
        const double Extent = 2;

        // A reflector abeam while the own ship sails 125 m to the north in five turns, 20 pixels.
        [Test]
        public void OwnShipThatMoves_LeavesTrailsOfFixedTargets_OnlyWhenTheyAreRelative()
        {
            double2 ShipAt(double time) => new double2(0, 10 * (time - 6.25));
            using (var bench = MakeBench(TrailMotion.True))
            {
                Play(bench, 0, 5, ShipAt, _ => s_reflector);
                var (least, most) = ExtentOf(bench, s_reflector.xz);
                Assert.That(math.cmin(least), Is.GreaterThan(-Extent));
                Assert.That(math.cmax(most), Is.LessThan(Extent));
            }
            using (var bench = MakeBench(TrailMotion.Relative))
            {
                Play(bench, 0, 5, ShipAt, _ => s_reflector);
                var (least, most) = ExtentOf(bench, s_reflector.xz);
                // The antenna passes it at 0.625 s and the last time at 10.625 s, from -56.25 m and from 43.75 m.
                Assert.That(most.y, Is.EqualTo(56.25 / Pixel).Within(Extent));
                Assert.That(least.y, Is.EqualTo(-43.75 / Pixel).Within(Extent));
                Assert.That(most.x - least.x, Is.LessThan(2 * Extent));
            }
        }

        // 15 m/s to the north. The own ship is 100 pixels to the east and 300 to the south of the map's corner.
        [Test]
        public void TargetThatMoves_LeavesTheSameTrail_WhileTheOwnShipStandsStill()
        {
            var at = new double2(100, -300) * Pixel;
            float[] Trails(TrailMotion motion)
            {
                using (var bench = MakeBench(motion))
                {
                    Play(bench, 0, 3, _ => at,
                        time => s_reflector + new double3(at.x, 0, at.y) + new double3(0, 0, 15 * time));
                    return bench.Trails();
                }
            }
            float[] relative = Trails(TrailMotion.Relative), overGround = Trails(TrailMotion.True);
            Assert.That(relative.Count(trail => trail > 0.3), Is.GreaterThan(10));
            for (int y = 0; y < TrailMap.Side; y++)
                for (int x = 0; x < TrailMap.Side; x++)
                    if (relative[y * TrailMap.Side + x] != overGround[(y - 300 & TrailMap.Side - 1) * TrailMap.Side
                        + (x + 100 & TrailMap.Side - 1)])
                        Assert.Fail($"pixel {x}, {y}");
        }

        // exp(-2 / 4) after two turns.
        [Test]
        public void Trails_Fade()
        {
            using (var bench = MakeBench(TrailMotion.True))
            {
                bench.Receiver.TrailTurns = 4;
                Play(bench, 0, 0.4, _ => 0, _ => s_reflector);
                float before = bench.Trails().Max();
                bench.Points = new ScreenPoint[0];
                for (int frame = 1; frame <= 2 * Frames; frame++)
                    bench.Frame(144 + 360.0 * frame / Frames);
                Assert.That(before, Is.GreaterThan(0.9));
                Assert.That(bench.Trails().Max() / before, Is.EqualTo(Math.Exp(-0.5)).Within(1e-4));
            }
        }

        // The map repeats after 1,024 pixels: the trail must be gone when its pixel is in sight again.
        [Test]
        public void Trails_OutOfRange_AreGone()
        {
            using (var bench = MakeBench(TrailMotion.True))
            {
                double speed = 1024 * Pixel / (2 * Frames * Frame);
                Play(bench, 0, 1, _ => 0, _ => s_reflector);
                Assert.That(bench.Trails().Max(), Is.GreaterThan(0.3));
                Play(bench, 1, 3, time => new double2(speed * (time - Frames * Frame), 0), _ => s_reflector);
                Assert.That(bench.Trails().Max(), Is.Zero);
            }
        }

        [Test]
        public void Trails_BeforeAJumpOrAnotherMotion_AreGone()
        {
            using (var bench = MakeBench(TrailMotion.True))
            {
                Play(bench, 0, 0.5, _ => 0, _ => s_reflector);
                bench.Points = new ScreenPoint[0];
                bench.Position = new double2(800, 0);
                bench.Frame(190);
                Assert.That(bench.Trails().Max(), Is.Zero);
                Play(bench, 0.6, 1.5, _ => bench.Position, _ => s_reflector);
                Assert.That(bench.Trails().Max(), Is.GreaterThan(0.3));
                bench.Receiver.TrailMotion = TrailMotion.Relative;
                bench.Points = new ScreenPoint[0];
                bench.Frame(550);
                Assert.That(bench.Trails().Max(), Is.Zero);
            }
        }

        // Narrow beam and short pulse. Only the last 10 dB below the reflector's level are shown, far above the noise.
        static ScreenBench MakeBench(TrailMotion motion)
        {
            var radar = ScreenBench.Small(2048, 512);
            (radar.RangeScale, radar.BeamWidth, radar.PulseNanoseconds) = (480 * Pixel, 0.6, 20);
            var bench = new ScreenBench(radar);
            double level = 20 * Math.Log10(bench.Geometry.PointOf(s_reflector,
                new double3(0, ScreenBench.Height, 0), Section).Amplitude / ScreenGeometry.UnitsOfNoise);
            bench.Receiver = new ScreenReceiver
            {
                GainDb = 10 - level, DynamicRangeDb = 10, PersistenceTurns = 5, TrailTurns = 10, TrailMotion = motion
            };
            return bench;
        }

        static void Play(ScreenBench bench, double from, double to, Func<double, double2> shipAt,
            Func<double, double3> reflectorAt)
        {
            for (int frame = (int)Math.Round(from * Frames); frame <= (int)Math.Round(to * Frames); frame++)
            {
                bench.Position = shipAt(frame * Frame);
                bench.Points = new[]
                {
                    bench.Geometry.PointOf(reflectorAt(frame * Frame),
                        new double3(bench.Position.x, ScreenBench.Height, bench.Position.y), Section)
                };
                bench.Frame(360.0 * frame / Frames);
            }
        }

        // Of the trails that are seen, in pixels from a position.
        static (double2, double2) ExtentOf(ScreenBench bench, double2 position)
        {
            var trails = bench.Trails();
            double2 middle = TrailMap.PixelOf(position, bench.Geometry.Radar.RangeScale), least = 1e9, most = -1e9;
            for (int i = 0; i < trails.Length; i++)
                if (trails[i] > 0.3)
                {
                    double2 from = new double2(i % TrailMap.Side, i / TrailMap.Side) + 0.5 - middle;
                    from -= TrailMap.Side * math.round(from / TrailMap.Side);
                    (least, most) = (math.min(least, from), math.max(most, from));
                }
            return (least, most);
        }
    }
}
