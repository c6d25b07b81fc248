using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class RangeDopplerTransformTests
    {
        static readonly PulseTrain s_pulses = new PulseTrain(2000, 64);

        // 150 MHz around 10 GHz.
        static readonly FrequencyBand s_band = new FrequencyBand(10e9 - 127.5 * 150e6 / 256, 150e6 / 256, 256);
        static readonly RangeTransform s_range = new RangeTransform(s_band, Window.Taylor(4, -35), 4);

        [Test]
        public void PulseTrain_At10GHz_HasKnownAmbiguities()
        {
            Assert.That(s_pulses.BlindSpeed(10e9), Is.EqualTo(29.98).Within(0.005));
            Assert.That(s_pulses.UnambiguousRange, Is.EqualTo(74.95e3).Within(5));
            Assert.That(s_pulses.SpeedResolution(10e9), Is.EqualTo(0.4684).Within(5e-5));
            Assert.That(s_pulses.TimeOf(63), Is.EqualTo(0.0315));
        }

        // 2 v / lambda = 333.56 Hz.
        [Test]
        public void Map_OfAPlateThatApproaches_ShowsItsDopplerShift()
        {
            var transform = Transform(Window.Hann);
            var (column, row, level) = Peak(transform, Echo((100, 5, 100)));
            Assert.That(transform.DopplerOf(row), Is.EqualTo(333.56).Within(0.1 * 2000 / 64));
            Assert.That(transform.SpeedOf(row), Is.EqualTo(5).Within(0.1 * 0.4684));
            // It moves 0.16 m within the burst, around the place of its middle.
            Assert.That(s_range.RangeOf(column), Is.EqualTo(100 - 5 * 0.0315 / 2).Within(0.1));
            Assert.That(level, Is.EqualTo(20).Within(0.1));
        }

        [TestCase(14.9, 14.9)]
        [TestCase(-14.9, -14.9)]
        [TestCase(20, -9.979)]
        [TestCase(-29.979, 0)]
        public void Speed_IsShownModuloTheBlindSpeed(double speed, double shown)
        {
            var transform = Transform(Window.Hann);
            var (_, row, _) = Peak(transform, Echo((100, speed, 1)));
            Assert.That(transform.SpeedOf(row), Is.EqualTo(shown).Within(0.05));
        }

        [Test]
        public void Map_OfTwoSpeedsAtOneRange_HasBothWithTheirLevels()
        {
            var transform = Transform(Window.Blackman);
            double[] levels = PowerLevel.Decibels(transform.Map(Echo((150, 3, 1000), (150, -6, 0.01))));
            int column = (int)Math.Round(150 / s_range.CellSize);
            double Level(double speed) => Enumerable.Range(-2, 5).Max(dx => Enumerable.Range(0, transform.Rows)
                .Where(row => Math.Abs(transform.SpeedOf(row) - speed) < 0.3)
                .Max(row => levels[row * transform.Columns + column + dx]));
            Assert.That(Level(3), Is.EqualTo(30).Within(0.15));
            Assert.That(Level(-6), Is.EqualTo(-20).Within(0.4));
            Assert.That(Level(10), Is.LessThan(-38), "only sidelobes 68 dB below the strong echo");
        }

        // White noise: a share of 1 / (N M) of each sample's power, times both windows' noise bandwidths.
        [Test]
        public void Map_OfNoise_HasItsPowerInBothWindows()
        {
            var noise = new ThermalNoise(3, 150e6, 5);
            var window = Window.Hann;
            var responses = Enumerable.Range(0, 64).Select(pulse => noise.AddTo(new Complex[256], pulse)).ToArray();
            double mean = PowerLevel.Of(Transform(window).Map(responses)).Average();
            double expected = noise.Power / (256 * 64) * Window.Taylor(4, -35).NoiseBandwidth * window.NoiseBandwidth;
            Assert.That(mean, Is.EqualTo(expected).Within(5).Percent);
        }

        [Test]
        public void WrongCounts_AreRefused()
        {
            Assert.That(() => new PulseTrain(2000, 0), Throws.TypeOf<GlintException>().With.Message
                .EqualTo("pulses: the number is 0, it must be from 1 to 65536"));
            Assert.That(() => Transform(Window.None).Map(new Complex[63][]), Throws.TypeOf<GlintException>()
                .With.Message.EqualTo("range-Doppler map: 63 pulses, 64 are needed"));
        }

        static RangeDopplerTransform Transform(Window window) =>
            new RangeDopplerTransform(s_range, s_band, s_pulses, window, 4);

        // Exact paths at the time of each pulse.
        static Complex[][] Echo(params (double range, double speed, double crossSection)[] points) =>
            Enumerable.Range(0, s_pulses.Count).Select(pulse => PointEchoes.Sum(s_band,
                points.Select(point => 2 * (point.range - point.speed * s_pulses.TimeOf(pulse))).ToArray(),
                points.Select(point => new Complex(Math.Sqrt(point.crossSection), 0)).ToArray())).ToArray();

        static (double column, double row, double level) Peak(RangeDopplerTransform transform,
            IReadOnlyList<Complex[]> responses)
        {
            double[] levels = PowerLevel.Decibels(transform.Map(responses));
            int at = Array.IndexOf(levels, levels.Max()), row = at / transform.Columns, column = at % transform.Columns;
            var along = levels.Skip(row * transform.Columns).Take(transform.Columns).ToArray();
            // From a quarter of the blind speed off, so that a peak at the edge has both neighbours.
            int from = (row + transform.Rows - transform.Rows / 4) % transform.Rows;
            var across = Enumerable.Range(0, transform.Rows)
                .Select(i => levels[(from + i) % transform.Rows * transform.Columns + column]).ToArray();
            var (offset, level) = PointEchoes.Peak(across);
            return (PointEchoes.Peak(along).index, row + offset - transform.Rows / 4, level);
        }
    }
}
