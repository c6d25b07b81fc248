using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Echoes, beam, pulse, noise and receiver of the radar screen's kernels.</summary>
    public sealed class ScreenTracerTests
    {
        const double NauticalMile = 1852;

        // 80 dB over noise at 4.9 miles, so that noise changes the level by less than 0.002 dB.
        const double Large = 1e7;

        // The radar of the published sum, whose bandwidth is 10 MHz: 10 m2 at 4.9 miles are 21.6 dB over noise.
        [Test]
        public void Point_HasThePowerOfTheRadarEquation()
        {
            var radar = ScreenRadar.Default;
            radar.PulseNanoseconds = 100;
            const double range = 4.9 * NauticalMile, bearing = 45;
            using (var bench = new ScreenBench(radar, (bearing, range, Large)))
            {
                bench.Turn(bearing - 1, bearing + 1);
                double gain = 26000 / (1.2 * 22), wave = 299792458 / 9.41e9, noise = 1.380649e-23 * 290 * 10e6 *
                    Math.Pow(10, 0.5), power = 25000 * gain * gain * wave * wave * Large
                    / (Math.Pow(4 * Math.PI, 3) * Math.Pow(range, 4));
                // The reflector is below the middle of the beam by the earth's curvature, 4.8 m: nothing.
                double level = bench.Levels()[bench.Element(512, (int)(range / (6 * NauticalMile) * 1024))];
                Assert.That(level, Is.EqualTo(10 * Math.Log10(power / noise)).Within(0.02));
                Assert.That(level - 60, Is.EqualTo(21.6).Within(0.1), "of 10 m2");
                Assert.That(bench.Geometry.NoisePower, Is.EqualTo(noise).Within(1e-6 * noise));
            }
        }

        // 250 ns are 37.5 m, 3.45 cells. The beam falls by 3 dB each way at 0.6 degrees.
        [Test]
        public void Point_HasTheWidthOfTheBeam_AndTheLengthOfThePulse()
        {
            var radar = ScreenRadar.Default;
            radar.PulseNanoseconds = 250;
            using (var bench = new ScreenBench(radar, (90, 5000, Large)))
            {
                bench.Turn(86, 94);
                var levels = bench.Levels();
                const int spoke = 1024, cell = 460;
                double LevelAt(int spokes, int cells) => levels[bench.Element(spoke + spokes, cell + cells)];
                double peak = LevelAt(0, 0);
                for (int i = -20; i <= 20; i++)
                    Assert.That(LevelAt(i, 0) - peak, Is.EqualTo(-2 * 3.0103 * Math.Pow(i * 360 / 4096.0 / 0.6, 2))
                        .Within(0.05), $"{i} spokes");
                double size = 6 * NauticalMile / 1024, length = 299792458 / 2.0 * 250e-9;
                for (int i = -3; i <= 3; i++)
                    Assert.That(LevelAt(0, i) - peak,
                        Is.EqualTo(20 * Math.Log10(1 - Math.Abs(i) * size / length)).Within(0.05), $"{i} cells");
                Assert.That(LevelAt(0, 4), Is.LessThan(15), "noise");
                Assert.That(LevelAt(26, 0), Is.LessThan(15), "noise");
            }
        }

        // Two equal reflectors in one cell, on neighbouring bearings: their fields add. 1/4 wavelength apart they cancel.
        [Test]
        public void Reflectors_InOneCell_AddAsFields()
        {
            double quarter = 299792458 / 9.41e9 / 4;
            double Level(double further)
            {
                using (var bench = new ScreenBench(ScreenRadar.Default, (90, 5000, Large), (90, 5000 + further, Large)))
                {
                    bench.Turn(89, 91);
                    return bench.Levels()[bench.Element(1024, 460)];
                }
            }
            double one = Level(2000), together = Level(2 * quarter), against = Level(quarter);
            Assert.That(together - one, Is.EqualTo(6.02).Within(0.02));
            Assert.That(against, Is.LessThan(one - 40));
        }

        // -ln(1e-3) of the mean. The pulse of 1 us covers 14 cells, and its noise is correlated.
        [TestCase(10)]
        [TestCase(1000)]
        public void Noise_HasItsPower_AndItsRateOfFalseAlarms(double nanoseconds)
        {
            var radar = ScreenBench.Small(4096, 1024);
            radar.PulseNanoseconds = nanoseconds;
            using (var bench = new ScreenBench(radar))
            {
                bench.Turn(0, 90);
                double[] power = bench.Levels().Take(1024 * 1024).Where((_, i) => i % 1024 >= 14 && i % 1024 < 1010)
                    .Select(level => Math.Pow(10, level / 10)).ToArray();
                double correlated = bench.Geometry.Pulse.Length;
                Assert.That(power.Average(), Is.EqualTo(1).Within(4e-3 * Math.Sqrt(correlated)));
                double rate = power.Count(value => value > -Math.Log(1e-3)) / (double)power.Length;
                Assert.That(rate, Is.EqualTo(1e-3).Within(1e-4 * Math.Sqrt(correlated)));
            }
        }

        [Test]
        public void Noise_DiffersFromTurnToTurn_AndBySeed_AndIsTheSameAgain()
        {
            float[] Run(int seed, double from)
            {
                var radar = ScreenBench.Small();
                radar.Seed = seed;
                using (var bench = new ScreenBench(radar))
                {
                    bench.Turn(from, from + 10);
                    return bench.Levels();
                }
            }
            var first = Run(1, 0);
            Assert.That(Run(1, 0), Is.EqualTo(first));
            Assert.That(Run(2, 0), Is.Not.EqualTo(first));
            Assert.That(Run(1, 360), Is.Not.EqualTo(first));
        }

        [Test]
        public void Frames_OfAnyLength_GiveTheSameBits()
        {
            (float[], float2[]) Run(double step)
            {
                using (var bench = new ScreenBench(ScreenBench.Small(),
                    (3, 4000, 1e3), (179.9, 5000, 1e3), (359.9, 6000, 1e3)))
                {
                    bench.Turn(-5, 725, step);
                    return (bench.Levels(), bench.Video());
                }
            }
            var expected = Run(170);
            foreach (double step in new[] { 33.3, 11 })
            {
                var (levels, video) = Run(step);
                Assert.That(levels.AsSpan().SequenceEqual(expected.Item1), $"levels, {step} deg");
                Assert.That(video.AsSpan().SequenceEqual(expected.Item2), $"video, {step} deg");
            }
        }

        // Bearings are clockwise from +Z, and a reflector is on one spoke only.
        [TestCase(0, 0)]
        [TestCase(90, 256)]
        [TestCase(180, 512)]
        [TestCase(-90, 768)]
        [TestCase(359.9, 0)]
        public void Point_IsOnTheSpokeOfItsBearing(double bearing, int spoke)
        {
            using (var bench = new ScreenBench(ScreenBench.Small(), (bearing, 3000, 1e4)))
            {
                bench.Turn(bearing - 10, bearing + 10);
                var levels = bench.Levels();
                int largest = Array.IndexOf(levels, levels.Max());
                Assert.That((largest / 256, largest % 256), Is.EqualTo((spoke, (int)(3000 / bench.Geometry.CellSize))));
            }
        }

        [Test]
        public void ReceiverAndPersistence_AreThoseOfTheFormulas()
        {
            var radar = ScreenBench.Small(1024, 128);
            (radar.PulseNanoseconds, radar.RainRate) = (1000, 20);
            using (var bench = new ScreenBench(radar, (4, 4000, 1e3), (5, 4300, 1e5)))
            {
                bench.Receiver = new ScreenReceiver
                {
                    GainDb = -3, DynamicRangeDb = 50, SensitivityTimeRange = 5000, RainFilter = 0.4, ClutterFilter = 0.6,
                    PersistenceTurns = 1.5
                };
                bench.Turn(0, 10);
                var reference = new ScreenVideoReference(bench.Geometry, bench.Receiver);
                reference.Finish(bench.Levels(), 0, 27);
                AssertVideo(bench, reference);
                bench.Turn(360, 370, 90);
                reference.Finish(bench.Levels(), 0, 27);
                AssertVideo(bench, reference);
                Assert.That(reference.Video.Count(value => value.x > 0.1), Is.GreaterThan(100), "something is shown");
            }
        }

        // Marshall and Palmer's drops at 10 mm/h: Z = 7962 mm6/m3. The beam's half above the sea holds the volume.
        // The pulse of 45 m is shorter than a cell, or many cells long.
        [TestCase(64)]
        [TestCase(512)]
        public void Rain_HasTheMeanPowerOfItsVolume(int cells)
        {
            var radar = ScreenBench.Small(4096, cells);
            (radar.RainRate, radar.RangeScale, radar.PulseNanoseconds) = (10, 3000, 300);
            using (var bench = new ScreenBench(radar))
            {
                bench.Turn(0, 180, 80);
                double gain = 26000 / (1.2 * 22), wave = 299792458 / 9.41e9, range = 20.5 / 64 * 3000,
                    density = Math.Pow(Math.PI, 5) * 0.93 * 200 * Math.Pow(10, 1.6) * 1e-18 / Math.Pow(wave, 4),
                    // Beams out and back are narrower by sqrt(2), and 1.0645 widths hold the power of a Gaussian.
                    width = 1.0645 * math.radians(1.2) / Math.Sqrt(2), height = 1.0645 * math.radians(22) / Math.Sqrt(2),
                    // The square of the pulse's triangle has a third of its base.
                    length = 2.0 / 3 * 299792458 / 2 * 300e-9,
                    section = density * range * range * width * height / 2 * length,
                    // ITU-R P.838-3, HH at 9.41 GHz: 0.0093 rate^1.2895 dB/km, there and back.
                    loss = Math.Pow(10, -0.2 * 0.0093 * Math.Pow(10, 1.2895) * range / 1000),
                    power = 25000 * gain * gain * wave * wave * section * loss
                        / (Math.Pow(4 * Math.PI, 3) * Math.Pow(range, 4));
                var levels = bench.Levels();
                int first = cells / 64 * 20;
                double measured = Enumerable.Range(0, 2048).Average(spoke => Enumerable.Range(first, cells / 64)
                    .Average(cell => Math.Pow(10, levels[bench.Element(spoke, cell)] / 10))) - 1;
                // Half a turn has 150 beams.
                Assert.That(10 * Math.Log10(measured * bench.Geometry.NoisePower / power), Is.EqualTo(0).Within(0.8));
            }
        }

        static void AssertVideo(ScreenBench bench, ScreenVideoReference reference)
        {
            var video = bench.Video();
            for (int i = 0; i < 27 * 128; i++)
                Assert.That(math.distance(video[i], (float2)reference.Video[i]), Is.LessThan(1e-4),
                    $"spoke {i / 128}, cell {i % 128}: {video[i]}, {reference.Video[i]}");
        }
    }
}
