using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class AntennaPatternTests
    {
        const double Degree = Math.PI / 180;

        [Test]
        public void Beams_AtHalfTheirWidth_HaveHalfThePower([Values(1.2, 22, 100)] double width)
        {
            foreach (var pattern in new[] { AntennaPattern.Gaussian(width), AntennaPattern.Sinc(width) })
            {
                Assert.That(Power(pattern, 0), Is.EqualTo(1));
                Assert.That(Power(pattern, width / 2), Is.EqualTo(0.5).Within(1e-12));
                Assert.That(Power(pattern, -width / 2), Is.EqualTo(0.5).Within(1e-12));
                Assert.That(Power(pattern, 360 + width / 2), Is.EqualTo(0.5).Within(1e-9), "a turn further");
            }
        }

        // exp(-4 ln 2 (t / t3)^2): 1/16 at the width.
        [Test]
        public void Gaussian_AtItsWidth_HasASixteenth() =>
            Assert.That(Power(AntennaPattern.Gaussian(3), 3), Is.EqualTo(1 / 16.0).Within(1e-12));

        // The field of a line of sources along its length L, summed source by source: L = 0.886 wavelengths / width.
        [Test]
        public void Sinc_IsTheFieldOfALine()
        {
            const double width = 5;
            const int sources = 2000;
            double length = 0.8858929 / (2 * Math.Sin(width / 2 * Degree));
            var pattern = AntennaPattern.Sinc(width);
            foreach (double angle in new[] { 1, 4.9, 7.1, 30, 80 })
            {
                double field = Enumerable.Range(0, sources).Average(i =>
                    Math.Cos(2 * Math.PI * length * ((i + 0.5) / sources - 0.5) * Math.Sin(angle * Degree)));
                Assert.That(pattern.Field(angle * Degree).Real, Is.EqualTo(field).Within(1e-5), $"at {angle}");
            }
            double sidelobe = Enumerable.Range(0, 1000).Max(i => Power(pattern, 6 + 0.05 * i));
            Assert.That(10 * Math.Log10(sidelobe), Is.EqualTo(-13.26).Within(0.01));
            Assert.That(Power(pattern, 180), Is.Zero);
        }

        // A target at height h is at the range h / sin t: its echo falls with G^2 / R^4, which stays the same.
        [TestCase(1)]
        [TestCase(-1)]
        public void CosecantSquared_AtOneHeight_GivesOneEcho(int side)
        {
            var pattern = AntennaPattern.CosecantSquared(5, side * 3, side * 40);
            double Echo(double angle) =>
                Math.Pow(Power(pattern, side * angle) * Math.Pow(Math.Sin(angle * Degree), 2), 2);
            Assert.That(Echo(10), Is.EqualTo(Echo(3)).Within(1e-9).Percent, "at the end of the beam");
            Assert.That(Echo(39.9), Is.EqualTo(Echo(3)).Within(1e-9).Percent);
            Assert.That(Power(pattern, side * 40.1), Is.Zero);
            Assert.That(Power(pattern, 2.5), Is.EqualTo(0.5).Within(1e-12), "within the beam");
            Assert.That(Power(pattern, -2.5), Is.EqualTo(0.5).Within(1e-12));
            Assert.That(Power(pattern, side * -10), Is.EqualTo(Math.Pow(0.5, 16)).Within(1e-12), "no cosecant");
        }

        // Between a lobe and the next, of opposite sign, the field is 0: a phase that is interpolated gives no null.
        [Test]
        public void Table_IsLinearInTheField()
        {
            var pattern = AntennaPattern.Table(new[] { -10.0, 0, 10, 20 },
                new[] { new Complex(0, 0.5), new Complex(1, 0), new Complex(-1, 0), new Complex(-1, 0) });
            AssertField(pattern, -10, new Complex(0, 0.5));
            AssertField(pattern, 0, 1);
            AssertField(pattern, 5, 0);
            AssertField(pattern, 2.5, 0.5);
            AssertField(pattern, -5, new Complex(0.5, 0.25));
            AssertField(pattern, 365, 0);
            AssertField(pattern, -10.1, 0);
            AssertField(pattern, 20.1, 0);
        }

        [Test]
        public void Field_OfAnAntenna_IsTheProductOfItsCuts()
        {
            var antenna = new Antenna(30, AntennaPattern.Gaussian(2), AntennaPattern.Sinc(20));
            double Gain(double azimuth, double elevation) =>
                PowerLevel.Decibels(new[] { antenna.Field(azimuth * Degree, elevation * Degree) })[0];
            double half = 10 * Math.Log10(0.5);
            Assert.That(Gain(0, 0), Is.EqualTo(30).Within(1e-9));
            Assert.That(Gain(1, 0), Is.EqualTo(30 + half).Within(1e-9));
            Assert.That(Gain(0, -10), Is.EqualTo(30 + half).Within(1e-9));
            Assert.That(Gain(-1, 10), Is.EqualTo(30 + 2 * half).Within(1e-9));
        }

        [Test]
        public void WrongPatterns_AreRefused()
        {
            AssertRefused(() => AntennaPattern.Gaussian(0),
                "antenna: the beam width is 0 degrees, it must be from 0.01 to 179");
            AssertRefused(() => AntennaPattern.CosecantSquared(5, 3, -40),
                "antenna: the cosecant's angles from 3 to -40 degrees must lead away from 0 on one side");
            AssertRefused(() => AntennaPattern.Table(new[] { 1.0, 1 }, new Complex[2]),
                "antenna: the angle 1 degrees of the pattern's table follows 1: put the rows in ascending order");
            AssertRefused(() => AntennaPattern.Table(new[] { 0.0, 359 }, new Complex[2]),
                "antenna: the angle 359 degrees of the pattern's table must be from -180 to 180: write 359 as -1, and put "
                    + "the rows in ascending order");
            AssertRefused(() => AntennaPattern.Table(new[] { 1.0, 2 }, new Complex[3]),
                "antenna: 3 fields of the pattern's table, 2 are needed");
            AssertRefused(() => AntennaPattern.Table(new[] { 1.0 }, new Complex[1]),
                "antenna: a pattern's table needs 2 rows or more, it has 1");
        }

        static void AssertRefused(TestDelegate call, string message) =>
            Assert.That(call, Throws.TypeOf<GlintException>().With.Message.EqualTo(message));

        static void AssertField(AntennaPattern pattern, double degrees, Complex expected) =>
            Assert.That(Complex.Abs(pattern.Field(degrees * Degree) - expected), Is.LessThan(1e-12), $"at {degrees}");

        static double Power(AntennaPattern pattern, double degrees) =>
            Math.Pow(pattern.Field(degrees * Degree).Magnitude, 2);
    }
}
