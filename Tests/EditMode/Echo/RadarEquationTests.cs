using System;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class RadarEquationTests
    {
        const double NauticalMile = 1852;

        // A marine X band radar: 25 kW, 9.41 GHz, beams of 1.2 and 22 degrees.
        readonly RadarEquation _radar = new RadarEquation(25e3, 9.41e9);
        readonly Antenna _antenna = new Antenna(Antenna.UsualGainDb(1.2, 22), AntennaPattern.Gaussian(1.2),
            AntennaPattern.Gaussian(22));

        [Test]
        public void Level_OfASquareMetreAtAMile_IsKnown()
        {
            Assert.That(Antenna.UsualGainDb(1.2, 22), Is.EqualTo(29.9).Within(0.05));
            Assert.That(Dbw(_radar, 1, 1), Is.EqualTo(-89.8).Within(0.05));
        }

        // Signal to noise ratios of a pulse, noise figure 5 dB, 10 MHz: targets of IMO's table of minimum ranges.
        [TestCase(1, 1, 39.2)]
        [TestCase(10, 4.9, 21.6)]
        [TestCase(7.5, 5, 20.0)]
        [TestCase(2.5, 3.4, 21.9)]
        public void SignalToNoise_OfMarineTargets_IsKnown(double crossSection, double miles, double expected)
        {
            double noise = PowerLevel.ToDecibels(new ThermalNoise(1, 10e6, 5).Power);
            Assert.That(noise, Is.EqualTo(-129.0).Within(0.05));
            Assert.That(Dbw(_radar, crossSection, miles) - noise, Is.EqualTo(expected).Within(0.1));
        }

        [Test]
        public void Level_FollowsTheRadarEquation()
        {
            double level = Dbw(_radar, 1, 1);
            Assert.That(Dbw(_radar, 1, 10), Is.EqualTo(level - 40).Within(1e-9), "tenfold range");
            Assert.That(Dbw(_radar, 100, 1), Is.EqualTo(level + 20).Within(1e-9), "hundredfold cross section");
            Assert.That(Dbw(new RadarEquation(25e3, 9.41e9, 3), 1, 1), Is.EqualTo(level - 3).Within(1e-9), "3 dB loss");
            Assert.That(Dbw(new RadarEquation(2.5e3, 9.41e9), 1, 1), Is.EqualTo(level - 10).Within(1e-9), "less power");
            Assert.That(Dbw(new RadarEquation(25e3, 4.705e9), 1, 1),
                Is.EqualTo(level + 20 * Math.Log10(2)).Within(1e-9), "twice the wavelength");
        }

        // Half of the power on each way: 6 dB in the echo.
        [Test]
        public void Level_AtTheEdgeOfTheBeam_IsSixDecibelsLower()
        {
            var edge = _antenna.Field(0.6 * Math.PI / 180, 0);
            var echo = _radar.Amplitude(edge, edge, 1, NauticalMile);
            Assert.That(Dbw(_radar, 1, 1) - PowerLevel.Decibels(new[] { echo })[0],
                Is.EqualTo(20 * Math.Log10(2)).Within(1e-9));
        }

        [Test]
        public void WrongNumbers_AreRefused()
        {
            Assert.That(() => new RadarEquation(0, 1e9), Throws.TypeOf<GlintException>().With.Message
                .EqualTo("radar equation: the transmit power is 0 W, it must be above 0 and finite"));
            Assert.That(() => new RadarEquation(1, 1e9, -1), Throws.TypeOf<GlintException>().With.Message
                .EqualTo("radar equation: the loss is -1 dB, it must be from 0 to 100"));
        }

        double Dbw(RadarEquation radar, double crossSection, double miles)
        {
            var field = _antenna.Field(0, 0);
            return PowerLevel.Decibels(new[]
            {
                radar.Amplitude(field, field, Math.Sqrt(crossSection), miles * NauticalMile)
            })[0];
        }
    }
}
