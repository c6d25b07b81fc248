using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Swell: its height, period, direction and band, and the waves of the wind beside it.</summary>
    public sealed class SwellTests
    {
        const double Height = 2, Period = 8, Direction = 130, Tile = 512;

        // Waves of 8 s are 100 m long; a wind of 4 m/s raises waves of 0.4 m.
        static SeaSettings Settings(double height = Height, int seed = 1)
        {
            var settings = SeaSettings.Default;
            (settings.TileSize, settings.WindSpeed, settings.WindDirectionDegrees) = (Tile, 4, -70);
            (settings.SwellHeight, settings.SwellPeriod, settings.SwellDirectionDegrees) = (height, Period, Direction);
            settings.Seed = seed;
            return settings;
        }

        // Variances add.
        [Test]
        public void WaveHeight_HasThatOfTheSwell()
        {
            double wind = new SeaSurface(Settings(0)).SignificantWaveHeight;
            Assert.That(new SeaSurface(Settings()).SignificantWaveHeight,
                Is.EqualTo(Math.Sqrt(wind * wind + Height * Height)).Within(1e-9));
            var requested = Settings();
            requested.SignificantWaveHeight = 1.5;
            Assert.That(new SeaSurface(requested).SignificantWaveHeight, Is.EqualTo(2.5).Within(1e-9));
        }

        [Test]
        public void HeightFactor_MakesTheRequestedHeightOfBoth()
        {
            var settings = Settings();
            settings.SignificantWaveHeight = 1.5;
            double[] times = { 0, 7, 30 };
            settings.HeightFactor = SeaSurface.FactorFor(settings, times);
            var surface = new SeaSurface(settings);
            Assert.That(Math.Sqrt(times.Average(time => math.square(surface.MeasuredWaveHeight(time)))),
                Is.EqualTo(2.5).Within(1e-6));
        }

        // Weighted by variance, over 30 draws of some ten waves: the mean frequency is that of the peak, and its
        // standard deviation 0.11 of it. Directions deviate by 9 degrees, that of cos^150 of half the angle.
        [Test]
        public void Swell_TravelsInItsBandAndDirection()
        {
            var waves = Enumerable.Range(1, 30).SelectMany(seed => new SeaSurface(Settings(seed: seed)).Modes)
                .Select(mode => (Variance: mode.Real * mode.Real + mode.Imaginary * mode.Imaginary,
                    Frequency: Math.Abs(mode.Frequency), Angle: AngleTo(mode, Direction))).ToArray();
            double sum = waves.Sum(wave => wave.Variance);
            double Mean(Func<(double Variance, double Frequency, double Angle), double> of) =>
                waves.Where(wave => wave.Frequency < 0.2 && Math.Abs(wave.Angle) < 60)
                    .Sum(wave => wave.Variance * of(wave)) / sum;
            // The waves of the wind are 4 % of the variance.
            Assert.That(Mean(_ => 1), Is.GreaterThan(0.94));
            Assert.That(Mean(wave => wave.Frequency) * Period / Mean(_ => 1), Is.EqualTo(1).Within(0.03));
            Assert.That(Mean(wave => wave.Angle), Is.Zero.Within(2));
            Assert.That(Math.Sqrt(Mean(wave => math.square(wave.Frequency * Period - 1))),
                Is.EqualTo(0.11).Within(0.03));
            Assert.That(Math.Sqrt(Mean(wave => wave.Angle * wave.Angle)), Is.EqualTo(9.3).Within(2.5));
        }

        // Against the wind too: each wave and its opposite are one, and the waves of the wind keep their variance.
        [Test]
        public void Variance_WithSwellAgainstTheWind_IsConstant()
        {
            var settings = Settings();
            (settings.WindSpeed, settings.SwellDirectionDegrees) = (10, settings.WindDirectionDegrees + 180);
            var surface = new SeaSurface(settings);
            Assert.That(surface.Modes.Select(mode => (mode.Column, mode.Row)), Is.Unique);
            Assert.That(surface.MeasuredWaveHeight(17),
                Is.EqualTo(surface.MeasuredWaveHeight(0)).Within(1e-9));
            settings.SwellHeight = 0;
            double wind = new SeaSurface(settings).SignificantWaveHeight;
            Assert.That(surface.SignificantWaveHeight,
                Is.EqualTo(Math.Sqrt(wind * wind + Height * Height)).Within(1e-9));
        }

        [Test]
        public void NoSwell_ChangesNoBit()
        {
            var plain = Settings(0);
            (plain.SwellPeriod, plain.SwellDirectionDegrees) = (0, 0);
            Assert.That(new SeaSurface(Settings(0)).Mesh(3).Vertices,
                Is.EqualTo(new SeaSurface(plain).Mesh(3).Vertices));
        }

        // The finer tile has the shorter waves of the wind alone.
        [Test]
        public void FinerTile_HasNoSwell() => Assert.That(new SeaSurface(Settings()).Finer(64).Mesh(0).Vertices,
            Is.EqualTo(new SeaSurface(Settings(0)).Finer(64).Mesh(0).Vertices));

        // Of the slopes: wave number squared times variance, along the swell.
        [Test]
        public void SlopeVariances_HaveThoseOfTheSwell()
        {
            var settings = Settings();
            settings.WindDirectionDegrees = Direction;
            double2 Slopes(double height)
            {
                settings.SwellHeight = height;
                return Enumerable.Range(1, 30).Select(seed =>
                {
                    settings.Seed = seed;
                    return new SeaSurface(settings).SlopeVariances(10);
                }).Aggregate((a, b) => a + b) / 30;
            }

            double2 swell = Slopes(Height) - Slopes(0);
            double number = math.square(2 * Math.PI / Period) / 9.81, slope = number * Height / 4;
            // The band widens the mean of the fourth power of the frequency by 7 %; some ten waves in each of 30 draws.
            Assert.That(swell.x + swell.y, Is.EqualTo(1.07 * slope * slope).Within(15).Percent);
            Assert.That(swell.y / swell.x, Is.LessThan(0.06));
        }

        // Degrees from a direction to that of a wave.
        static double AngleTo(SeaMode mode, double direction)
        {
            double sign = mode.Frequency < 0 ? -1 : 1;
            double angle = math.degrees(Math.Atan2(sign * mode.AlongX, sign * mode.AlongZ)) - direction;
            return angle - 360 * Math.Round(angle / 360);
        }
    }
}
