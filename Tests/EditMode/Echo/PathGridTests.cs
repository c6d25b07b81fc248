using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class PathGridTests
    {
        static readonly FrequencyBand s_band = PointEchoes.Band(512);
        double[] _lengths;
        Complex[] _amplitudes, _direct;

        // 20,000 paths of random phase, over 40 m around 100 km.
        [OneTimeSetUp]
        public void SumDirectly()
        {
            var random = new Random(7);
            _lengths = Enumerable.Range(0, 20000).Select(_ => 2e5 + 80 * random.NextDouble()).ToArray();
            _amplitudes = _lengths.Select(_ => Complex.FromPolarCoordinates(random.NextDouble(),
                2 * Math.PI * random.NextDouble())).ToArray();
            _direct = PointEchoes.Sum(s_band, _lengths, _amplitudes);
        }

        // -106 dB is the figure of another implementation of the same kernel, with as many taps and cells.
        [Test]
        public void Responses_OfManyPaths_AreTheDirectSum()
        {
            var errors = Grid().Responses().Zip(_direct, (grid, direct) => grid - direct).ToArray();
            double signal = PowerLevel.Of(_direct).Average();
            Assert.That(10 * Math.Log10(PowerLevel.Of(errors).Average() / signal), Is.EqualTo(-106).Within(2.5));
            Assert.That(10 * Math.Log10(PowerLevel.Of(errors).Max() / signal), Is.LessThan(-90), "at any frequency");
        }

        // In the profile the error of one path lies in all cells: far from the path nothing else is above -100 dB.
        [Test]
        public void Profile_OfOnePath_HasNoFloorOfTheGrid()
        {
            var grid = new PathGrid(s_band);
            grid.Add(2 * 60.123, 1);
            var transform = new RangeTransform(s_band, Window.Taylor(20, -100));
            var decibels = PowerLevel.Decibels(transform.Profile(grid.Responses()));
            var (cell, level) = PointEchoes.Peak(decibels);
            Assert.That(transform.RangeOf(cell), Is.EqualTo(60.123).Within(0.01));
            Assert.That(level, Is.EqualTo(0).Within(0.01));
            Assert.That(decibels.Where((_, k) => Math.Abs(transform.RangeOf(k) - 60.123) > 10).Max(),
                Is.LessThan(-95));
        }

        [Test]
        public void Responses_OfFewFrequencies_AreTheDirectSum([Values(1, 2, 3, 5, 100)] int count)
        {
            var band = PointEchoes.Band(count);
            double[] lengths = { 0, 12.5, 1e6 + 0.123 };
            Complex[] amplitudes = { 1, new Complex(0, -2), new Complex(0.5, 0.5) };
            var grid = new PathGrid(band);
            for (int i = 0; i < lengths.Length; i++)
                grid.Add(lengths[i], amplitudes[i]);
            var direct = PointEchoes.Sum(band, lengths, amplitudes);
            var responses = grid.Responses();
            for (int n = 0; n < count; n++)
                Assert.That(Complex.Abs(responses[n] - direct[n]), Is.LessThan(1e-4));
        }

        // 5 m/s towards the radar at 100 km: 2 v / lambda turns of phase a second.
        [Test]
        public void Phase_OfAMovingPathAt100Kilometres_IsLinearInTime()
        {
            var grid = new PathGrid(s_band);
            double first = 0;
            for (int pulse = 0; pulse < 64; pulse++)
            {
                grid.Clear();
                double moved = 2 * 5 * pulse / 2000.0;
                grid.Add(2e5 - moved, 1);
                double phase = grid.Responses()[0].Phase;
                if (pulse == 0)
                    first = phase;
                double error = phase - first - 2 * Math.PI * s_band.Start * moved / PointEchoes.C;
                Assert.That(Math.IEEERemainder(error, 2 * Math.PI), Is.EqualTo(0).Within(1e-5), $"pulse {pulse}");
            }
        }

        [Test]
        public void Grid_Cleared_IsEmpty()
        {
            var grid = Grid();
            grid.Clear();
            Assert.That(grid.Responses(), Has.All.EqualTo(Complex.Zero));
        }

        PathGrid Grid()
        {
            var grid = new PathGrid(s_band);
            for (int i = 0; i < _lengths.Length; i++)
                grid.Add(_lengths[i], _amplitudes[i]);
            return grid;
        }
    }
}
