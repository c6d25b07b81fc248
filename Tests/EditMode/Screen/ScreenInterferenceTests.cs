using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// What a radar screen shows of other radars, of echoes that come after the next pulse, and of a blind sector.
    /// </summary>
    [Category("Slow")]
    public sealed class ScreenInterferenceTests
    {
        const double LightSpeed = 299792458, NoiseDb = 15;
        const int Spokes = 1024, Cells = 64;

        // -30 dB at all bearings but the beam's.
        const string Table = EchoAntenna.TableHeader
            + "\n-180,-30,0\n-4,-30,0\n-2,-30,0\n0,0,0\n2,-30,0\n4,-30,0\n180,-30,0\n";

        // The other radar's beam stands on the screen's antenna. Its pulses are where arrivals after the own pulse say, and
        // as strong as Friis' formula says, in the beam and in the sidelobes.
        [TestCase(0)]
        [TestCase(1000)]
        public void Pulses_OfAnotherRadar_AreDotsOnACurve(double rate)
        {
            const double miles = 3.1, bearing = 45, otherRate = 8963;
            var radar = ScreenBench.Small(Spokes, Cells);
            (radar.Pattern, radar.PulseRate) = (ScreenPattern.Table, rate);
            using (var bench = new ScreenBench(radar, Table))
            {
                bench.Others = new[] { Other(miles * ScreenRadar.NauticalMile, bearing, otherRate) };
                bench.Turn(0, 360, 45);
                var levels = bench.Levels();
                double gain = 26000.0 / bench.Geometry.BeamWidth / 360, wave = LightSpeed / 9.41e9,
                    noise = 1.380649e-23 * 290 / 80e-9 * Math.Pow(10, 0.5), peak = 10 * Math.Log10(
                        1000 * gain * gain * Math.Pow(wave / (4 * Math.PI * miles * 1852), 2) / noise);
                int count = 0;
                for (int spoke = 0; spoke < Spokes; spoke++)
                {
                    int[] expected = Arrivals(spoke, rate, otherRate, miles * 1852, bench.Geometry.CellSize);
                    Assert.That(Shown(bench, levels, spoke), Is.EquivalentTo(expected), $"spoke {spoke}");
                    count += expected.Length;
                    foreach (int cell in expected)
                        if (Math.Abs(spoke - 128) > 12)
                            Assert.That(levels[bench.Element(spoke, cell)], Is.EqualTo(peak - 30).Within(0.5));
                        else if (spoke == 128)
                            Assert.That(levels[bench.Element(spoke, cell)], Is.EqualTo(peak).Within(0.3));
                }
                // 74 us of 112 us.
                Assert.That(count, Is.EqualTo(Spokes * 2 / 3.0).Within(60));
            }
        }

        [Test]
        public void AnotherRadar_IsSeen_WhenItsBeamOrThatOfTheScreenPoints()
        {
            var geometry = new ScreenGeometry(PatternOfTable(), "test", Table);
            var interference = new ScreenInterference(geometry);
            var other = Other(5000, 90, 2000);
            (other.TurnsAMinute, other.StartTurns) = (24, 0);
            double Level(long spoke) => 20 * Math.Log10(interference.PulsesOf(spoke, other).z);
            // Both turn as fast. At spoke 768 its beam points to the screen, at 256 the screen's to it.
            double away = Level(0);
            Assert.That(Level(256) - away, Is.EqualTo(30).Within(0.1));
            Assert.That(Level(768) - away, Is.EqualTo(30).Within(0.1));
            other.Offset.y = -14;
            other.Offset *= 10;
            Assert.That(interference.PulsesOf(256, other).z, Is.Zero, "behind the horizon");
        }

        // Over a curved earth antennas of one height see each other below the horizontal, both by half of the arc
        // between them: half of 40 km / 8,495 km is 0.135 degrees. The field falls from 1 at -0.2 degrees to 0 at 0.2.
        [Test]
        public void RadarsOfOneHeight_SeeEachOtherBelowTheHorizontal()
        {
            const string table = EchoAntenna.TableHeader + "\n-180,0,-300\n-0.2,0,0\n0.2,0,-300\n180,0,-300\n",
                level = EchoAntenna.TableHeader + "\n-180,0,0\n0.2,0,0\n180,0,0\n";
            var radar = PatternOfTable();
            double Field(string pattern)
            {
                var geometry = new ScreenGeometry(radar, "test", pattern);
                var other = Other(40000, 90, 2000);
                other.AntennaHeight = 100;
                return new ScreenInterference(geometry).PulsesOf(256, other).z
                    / Math.Pow(geometry.Antenna.Peak, 2);
            }
            double below = 40000 / (2 * 4 / 3.0 * 6371000) * 180 / Math.PI, field = (0.2 + below) / 0.4;
            Assert.That(Field(table) / Field(level), Is.EqualTo(field * field).Within(1e-3));
        }

        [Test]
        public void Frames_OfAnyLength_GiveTheSameBits()
        {
            float[] Run(double step)
            {
                using (var bench = new ScreenBench(PatternOfTable(), Table))
                {
                    bench.Others = new[] { Other(5000, 45, 9000), Other(8000, 200, 7000) };
                    bench.Turn(-5, 365, step);
                    return bench.Levels();
                }
            }
            Assert.That(Run(33.3), Is.EqualTo(Run(170)));
        }

        // At 10 kHz pulses are 14,990 m apart.
        [Test]
        public void Reflector_BeyondTheUnambiguousRange_IsShownNearer()
        {
            const double rate = 10000, apart = LightSpeed / 2 / rate, shown = 4000;
            var radar = ScreenBench.Small(Spokes, Cells);
            float[] Run(double pulseRate, double range, double section)
            {
                radar.PulseRate = pulseRate;
                using (var bench = new ScreenBench(radar, (90, range, section)))
                {
                    bench.Turn(80, 100);
                    return bench.Levels();
                }
            }
            int element = 256 * Cells + (int)(shown / radar.RangeScale * Cells);
            double ratio = Math.Pow((apart + shown) / shown, 4),
                near = Run(rate, shown, 1e6)[element], far = Run(rate, apart + shown, 1e6 * ratio)[element];
            // It is 8 m lower in the beam.
            Assert.That(far, Is.EqualTo(near).Within(0.05));
            Assert.That(Run(0, apart + shown, 1e9).Max(), Is.LessThan(NoiseDb), "without a rate");
        }

        // The sector is 30 degrees to both sides of the stern.
        [Test]
        public void BlindSector_HasNoiseAlone_AndTurnsWithTheShip()
        {
            var radar = ScreenBench.Small(Spokes, Cells);
            (radar.BlindFrom, radar.BlindWidth) = (150, 60);
            using (var bench = new ScreenBench(radar, (180, 5000, 1e6), (100, 5000, 1e6), (280, 5000, 1e6)))
            {
                double Level(double bearing) => bench.Levels()[
                    bench.Element((int)Math.Round(bearing / 360 * Spokes), (int)(5000 / bench.Geometry.CellSize))];
                bench.Turn(0, 360, 90);
                Assert.That(new[] { Level(100) > 40, Level(180) > 40, Level(280) > 40 },
                    Is.EqualTo(new[] { true, false, true }));
                double[] power = bench.Levels().Skip(500 * Cells).Take(24 * Cells)
                    .Select(level => Math.Pow(10, level / 10)).ToArray();
                Assert.That(power.Average(), Is.EqualTo(1).Within(0.06), "noise");
                bench.Heading = 100.0 / 360;
                bench.Turn(360, 720, 90);
                Assert.That(new[] { Level(100) > 40, Level(180) > 40, Level(280) > 40 },
                    Is.EqualTo(new[] { true, true, false }));
            }
        }

        static ScreenRadar PatternOfTable()
        {
            var radar = ScreenBench.Small(Spokes, Cells);
            radar.Pattern = ScreenPattern.Table;
            return radar;
        }

        // 1 kW, and a beam that stands on the screen's antenna.
        static OtherRadar Other(double range, double bearing, double rate) => new OtherRadar
        {
            Offset = range * new double3(Math.Sin(math.radians(bearing)), 0, Math.Cos(math.radians(bearing))),
            AntennaHeight = ScreenBench.Height, Power = 1000, PulseRate = rate, StartTurns = (bearing + 180) / 360
        };

        // Cells of the pulses in a spoke of the first turn, pulse by pulse: a turn takes 2.5 s.
        static int[] Arrivals(int spoke, double rate, double otherRate, double range, double cellSize)
        {
            double time = 2.5 * spoke / Spokes, sent = rate > 0 ? Math.Floor(time * rate) / rate : time;
            return Enumerable.Range(-10, (int)(2.6 * otherRate)).Select(pulse => pulse / otherRate + range / LightSpeed)
                .Select(arrival => LightSpeed / 2 * (arrival - sent) / cellSize)
                .Where(cell => cell >= 0 && cell < Cells).Select(cell => (int)cell).ToArray();
        }

        // Peaks far over noise. A cell is longer than the pulse.
        static IEnumerable<int> Shown(ScreenBench bench, float[] levels, int spoke) => Enumerable.Range(0, Cells)
            .Where(cell => levels[bench.Element(spoke, cell)] > NoiseDb);
    }
}
