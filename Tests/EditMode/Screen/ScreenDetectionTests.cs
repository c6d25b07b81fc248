using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Detection on the levels of a turn from the kernels.</summary>
    public sealed class ScreenDetectionTests
    {
        // Spokes have noise of their own. A pulse of 50 ns is shorter than a cell of 10.9 m: cells are independent. That
        // of 80 ns, 12 m, correlates the fields of neighbours by 0.1, their powers by 0.01. 1,000 false alarms in a
        // million cells have a spread of 3.2 %. A pulse of 600 ns is 8.3 cells long: of 127,000 independent cells 127 false
        // alarms have a spread of 9 %, and reference cells a pulse apart, correlated by 0.06 in power, raise the rate by
        // up to 9 %.
        [TestCase(CfarLevel.Mean, 50, 10)]
        [TestCase(CfarLevel.Rank, 50, 10)]
        [TestCase(CfarLevel.Mean, 80, 10)]
        [TestCase(CfarLevel.Mean, 600, 35)]
        [TestCase(CfarLevel.Rank, 600, 35)]
        public void FalseAlarms_InNoise_AreAsManyAsAskedFor(CfarLevel level, double nanoseconds, double percent)
        {
            var radar = ScreenBench.Small(1024, 1024);
            radar.PulseNanoseconds = nanoseconds;
            using (var bench = new ScreenBench(radar))
            {
                bench.Turn(0, 360);
                int alarms = new ScreenDetection { Level = level, FalseAlarmRate = 1e-3 }
                    .Detect(bench.Geometry, bench.Levels()).Count;
                Assert.That(alarms / (1024.0 * 1024), Is.EqualTo(1e-3).Within(percent).Percent);
            }
        }

        // 10 m2 at 3,000 m are about 38 dB over noise. It is found at its place, and nothing outside of beam and pulse.
        [Test]
        public void Point_IsFoundAtItsPlace([Values] CfarLevel level)
        {
            const double bearing = 200, range = 3000;
            using (var bench = new ScreenBench(ScreenBench.Small(1024, 512), (bearing, range, 10)))
            {
                bench.Turn(0, 360);
                var detected = new ScreenDetection { Level = level, FalseAlarmRate = 1e-8 }
                    .Detect(bench.Geometry, bench.Levels());
                Assert.That(detected, Is.Not.Empty);
                double width = bench.Geometry.Radar.BeamWidth, cell = bench.Geometry.CellSize;
                foreach (var each in detected)
                {
                    Assert.That(each.BearingDegrees, Is.EqualTo(bearing).Within(1.5 * width));
                    Assert.That(each.Range, Is.EqualTo(range).Within(1.5 * cell));
                    Assert.That(each.OverThresholdDb, Is.GreaterThan(0));
                }
                var strongest = detected.OrderByDescending(each => each.OverThresholdDb).First();
                Assert.That(strongest.BearingDegrees, Is.EqualTo(bearing).Within(180.0 / 1024 + 1e-9));
                Assert.That(strongest.LevelDb, Is.EqualTo(detected.Max(each => each.LevelDb)).Within(1));
            }
        }

        // Between two ships the mean of the cells around is that of the ships; the rank of three quarters is noise.
        [Test]
        public void Rank_FindsAWeakPointBesideStrongOnes()
        {
            const double bearing = 100, range = 3000;
            var radar = ScreenBench.Small(1024, 1024);
            radar.PulseNanoseconds = 50;
            double cell = radar.RangeScale / radar.Cells;
            using (var bench = new ScreenBench(radar, (bearing, range, 1), (bearing, range - 8 * cell, 1000),
                (bearing, range + 8 * cell, 1000)))
            {
                bench.Turn(0, 360);
                bool IsFound(CfarLevel level) => new ScreenDetection { Level = level, FalseAlarmRate = 1e-6 }
                    .Detect(bench.Geometry, bench.Levels()).Any(each => Math.Abs(each.Range - range) < cell);
                Assert.That(IsFound(CfarLevel.Mean), Is.False);
                Assert.That(IsFound(CfarLevel.Rank), Is.True);
            }
        }

        [Test]
        public void Rate_OutOfItsRange_IsRefused() => Assert.That(
            () => new ScreenDetection().Validate("RadarScreen of 'Mast'"), Throws.TypeOf<GlintException>().With.Message
                .StartsWith("RadarScreen of 'Mast': false alarm rate 0 must be from 1e-12 to 0.5"));
    }
}
