using System;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Settings, beam, pulse and echoes of points.</summary>
    public sealed class ScreenGeometryTests
    {
        // 2-way fields: half power each way is half the field.
        [Test]
        public void Beam_IsHalfAtItsHalfPowerPoints()
        {
            var radar = ScreenRadar.Default;
            radar.BeamWidth = 360.0 / 4096 * 20;
            var geometry = new ScreenGeometry(radar, "test");
            Assert.That(geometry.Beam[geometry.HalfBeam], Is.EqualTo(1));
            Assert.That(geometry.Beam[geometry.HalfBeam + 10], Is.EqualTo(0.5).Within(1e-6));
            Assert.That(geometry.Beam[geometry.HalfBeam - 20], Is.EqualTo(1 / 16.0).Within(1e-6));
            Assert.That(geometry.Beam[0], Is.GreaterThanOrEqualTo(1e-4));
        }

        [Test]
        public void Horizon_HidesWhatIsBehindIt()
        {
            var radar = ScreenRadar.Default;
            radar.RangeScale = 30000;
            var geometry = new ScreenGeometry(radar, "test");
            // 15 m and 3.5 m: 12.78 nautical miles.
            ScreenPoint At(double miles) => geometry.PointOf(new double3(0, 3.5, miles * 1852),
                new double3(0, 15, 0), 1);
            Assert.That(At(12.7).Amplitude, Is.GreaterThan(0));
            Assert.That(At(12.9).Amplitude, Is.Zero);
            Assert.That(At(17).Amplitude, Is.Zero, "outside the scale");
            // A cell of 1e300 has no number.
            Assert.That(geometry.PointOf(new double3(0, 1e300, 0), new double3(0, 15, 0), 1).Amplitude, Is.Zero);
            Assert.That(geometry.PointOf(new double3(double.NaN, 5, 9), new double3(0, 15, 0), 1).Amplitude, Is.Zero);
        }

        // At 22 deg of vertical width a point 11 deg above the antenna loses 3 dB each way.
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        [TestCase(-1)]
        [TestCase(0)]
        public void Section_ThatIsNone_HasNoEcho(double section) =>
            Assert.That(new ScreenGeometry(ScreenRadar.Default, "test").PointOf(new double3(0, 3, 1000),
                new double3(0, 15, 0), section), Is.EqualTo(new ScreenPoint()));

        [Test]
        public void Elevation_LosesThePatternTwice()
        {
            var geometry = new ScreenGeometry(ScreenRadar.Default, "test");
            var antenna = new double3(0, 15, 0);
            double Amplitude(double degrees) => geometry.PointOf(antenna + 1000 * new double3(
                Math.Cos(math.radians(degrees)), Math.Sin(math.radians(degrees)), 0), antenna, 1).Amplitude;
            Assert.That(20 * Math.Log10(Amplitude(11) / Amplitude(0)), Is.EqualTo(-6.02).Within(0.01));
        }

        [Test]
        public void Settings_OutOfTheirRanges_AreRefused()
        {
            void Refuses(Func<ScreenRadar, ScreenRadar> change, string message) => Assert.That(
                () => new ScreenGeometry(change(ScreenRadar.Default), "screen"),
                Throws.InstanceOf<GlintException>().With.Message.StartsWith("screen: ")
                    .And.Message.Contains(message));
            Refuses(radar => { radar.Spokes = 3000; return radar; }, "spokes 3000 must be a power of two");
            Refuses(radar => { radar.Spokes = 256; return radar; }, "fewer than three across the beam");
            Refuses(radar => { radar.RangeScale = double.NaN; return radar; }, "range scale NaN m must be from 100");
            Refuses(radar => { radar.RangeScale = 500; radar.PulseNanoseconds = 1000; return radar; }, "pulse of 1000 ns");
            // c / 2 over the range scale is 13,489 Hz.
            Refuses(radar => { radar.PulseRate = 13500; return radar; }, "use a rate of 13489 Hz at most");
            Refuses(radar => { radar.PulseRate = -1; return radar; }, "pulse rate -1 Hz must be from 0");
            Refuses(radar => { radar.Pattern = (ScreenPattern)9; return radar; },
                "no pattern 9: choose one of Gaussian, Sinc, Cosecant, Table");
            Refuses(radar => { radar.Pattern = ScreenPattern.Table; return radar; }, "there is none: give a Pattern Table");
            Refuses(radar => { radar.Pattern = ScreenPattern.Cosecant; return radar; }, "must lead away from 0");
            Refuses(radar => { radar.Power = 0; return radar; }, "power 0 W must be");
            var receiver = ScreenReceiver.Default;
            receiver.RainFilter = 2;
            Assert.That(() => receiver.Validate("screen"), Throws.InstanceOf<GlintException>()
                .With.Message.Contains("rain filter 2 must be from 0 to 1"));
            var display = ScreenDisplay.Default;
            display.Side = 10;
            Assert.That(() => display.Validate("screen"), Throws.InstanceOf<GlintException>()
                .With.Message.Contains("side 10 pixels must be from 64"));
        }
    }
}
