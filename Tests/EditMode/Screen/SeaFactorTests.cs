using System;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Interference over a smooth sea, against closed forms of the flat earth and the horizon.</summary>
    public sealed class SeaFactorTests
    {
        const double WaveNumber = 2 * Math.PI * 9.41e9 / 299792458;

        // |F|^4 in dB on a flat earth, antenna 15 m, reflector 3.5 m. The earth's curvature changes the detour by a
        // tenth at 2 km, so that only near ranges are those of the plane.
        [TestCase(500, 1, 11.36, 0.3)]
        [TestCase(500, 0.5, 6.44, 0.3)]
        public void Factor_NearTheRadar_IsThatOfThePlane(double range, double reflection, double decibels, double within) =>
            Assert.That(20 * Math.Log10(SeaFactor.Squared(15, 3.5, range, reflection, WaveNumber)),
                Is.EqualTo(decibels).Within(within));

        // Ways by the law of cosines around the earth's centre, with the shortest one over the sea.
        [TestCase(15, 3.5, 2000)]
        [TestCase(15, 3.5, 9000)]
        [TestCase(30, 10, 20000)]
        public void Detour_IsThatOfTheShortestWayOverTheSphere(double antenna, double reflector, double distance)
        {
            const double radius = 4.0 / 3 * 6371000;
            double Way(double height, double along)
            {
                // Exact and stable: chord to a point so far above the sphere.
                double half = Math.Sin(along / radius / 2);
                return Math.Sqrt(height * height + 4 * radius * (radius + height) * half * half);
            }
            double shortest = double.PositiveInfinity;
            for (int i = 1; i < 20000; i++)
                shortest = Math.Min(shortest, Way(antenna, distance * i / 20000)
                    + Way(reflector, distance * (20000 - i) / 20000));
            double half = Math.Sin(distance / radius / 2), direct = Math.Sqrt((antenna - reflector) * (antenna - reflector)
                + 4 * (radius + antenna) * (radius + reflector) * half * half);
            Assert.That(SeaFactor.Detour(antenna, reflector, distance),
                Is.EqualTo(shortest - direct).Within(1e-2 * (shortest - direct) + 1e-6));
        }

        [Test]
        public void Factor_HasNullsAndFourfoldFields()
        {
            double least = double.PositiveInfinity, most = 0;
            for (double range = 1000; range < 5000; range++)
            {
                double factor = SeaFactor.Squared(15, 3.5, range, 1, WaveNumber);
                (least, most) = (Math.Min(least, factor), Math.Max(most, factor));
            }
            Assert.That(least, Is.LessThan(0.01));
            Assert.That(most, Is.EqualTo(4).Within(0.01));
            Assert.That(SeaFactor.Squared(15, 3.5, 3000, 0, WaveNumber), Is.EqualTo(1), "no image");
            Assert.That(SeaFactor.Detour(15, 3.5, 12.78 * 1852), Is.LessThan(1e-4), "at the horizon");
        }
    }
}
