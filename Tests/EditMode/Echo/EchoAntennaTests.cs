using System;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The pattern of a run's antenna towards the phase centre, one way.</summary>
    public sealed class EchoAntennaTests
    {
        const double GainDb = 30;

        static readonly double s_half = 10 * Math.Log10(0.5);

        // To the right and to the left alike, and with the beam in elevation too.
        [TestCase("gaussian")]
        [TestCase("sinc")]
        public void Gain_AtHalfTheBeamWidth_IsHalf(string name)
        {
            var antenna = new EchoAntenna(name, new double2(2, 10), null);
            Assert.That(Level(antenna, 0), Is.EqualTo(GainDb).Within(1e-9));
            foreach (double squint in new[] { -1.0, 1 })
            {
                antenna.Squint = squint;
                Assert.That(Level(antenna, 3), Is.EqualTo(GainDb + s_half).Within(1e-9));
            }
            antenna.Tilt = -8;
            Assert.That(Level(antenna, 3), Is.EqualTo(GainDb + 2 * s_half).Within(1e-9),
                "the target is 3 degrees below the horizontal, the beam 8");
        }

        // A radar at 2 to 30 degrees over the target, at one height h: R = h / sin, and G^2 / R^4 stays the same.
        [Test]
        public void CosecantSquared_LooksDown_WithOneEchoFromOneHeight()
        {
            var antenna = new EchoAntenna("csc2", new double2(2, 4), new double2(-2, -30)) { Tilt = 0 };
            double Echo(double elevation) =>
                2 * Level(antenna, elevation) + 40 * Math.Log10(Math.Sin(math.radians(elevation)));
            Assert.That(Echo(10), Is.EqualTo(Echo(2)).Within(1e-9));
            Assert.That(Echo(29.9), Is.EqualTo(Echo(2)).Within(1e-9));
            Assert.That(Level(antenna, 2), Is.EqualTo(GainDb + s_half).Within(1e-9), "the edge of the beam");
            Assert.That(antenna.Field(GainDb, 31).Magnitude, Is.Zero);
        }

        // Fields of 1 and 0.5 at 0 and 4 degrees: 0.75 at 2, and the root of a half at 8 - 4 sqrt(2) to the right.
        [Test]
        public void Table_IsLinearInTheField_WithItsHalfPowerWidth()
        {
            double quarter = 20 * Math.Log10(0.5);
            var antenna = new EchoAntenna(FormattableString.Invariant(
                $"angle_deg,azimuth_db,elevation_db\n-4,-300,{quarter:r}\n0,0,0\r\n4,{quarter:r},{quarter:r}\n"));
            Assert.That(antenna.Width, Is.EqualTo(4 * (1 - Math.Sqrt(0.5)) + 8 - 4 * Math.Sqrt(2)).Within(1e-9));
            antenna.Squint = -2;
            Assert.That(Level(antenna, 0), Is.EqualTo(GainDb + 20 * Math.Log10(0.75)).Within(1e-9));
            antenna.Tilt = -3;
            Assert.That(Level(antenna, 5), Is.EqualTo(GainDb + 40 * Math.Log10(0.75)).Within(1e-9));
            antenna.Squint = 4.1;
            Assert.That(antenna.Field(GainDb, 5).Magnitude, Is.Zero, "beside the table");
        }

        // The usual gain is that of the figures of a marine antenna.
        [Test]
        public void UsualGain_IsThatOfTheWidths() => Assert.That(new EchoAntenna("gaussian", new double2(1.2, 22),
            null).UsualGainDb, Is.EqualTo(29.9).Within(0.05));

        [TestCase("0,0,0\n1,0,0", "must begin with the line angle_deg,azimuth_db,elevation_db")]
        [TestCase(EchoAntenna.TableHeader + "\n0,0\n", "the row 0,0 of the antenna's table must be three numbers")]
        [TestCase(EchoAntenna.TableHeader + "\n0,3,0\n1,0,0", "the row 0,3,0 of the antenna's table")]
        [TestCase(EchoAntenna.TableHeader + "\n0,0,0\n", "a pattern's table needs 2 rows or more, it has 1")]
        public void WrongTables_AreRefused(string table, string message) =>
            Assert.That(() => new EchoAntenna(table), Throws.Exception.With.Message.Contains(message));

        static double Level(EchoAntenna antenna, double elevation) =>
            PowerLevel.ToDecibels(PowerLevel.Of(antenna.Field(GainDb, elevation)));
    }
}
