using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Sea water as a medium, against values of an independent program for the model of 2012.</summary>
    public sealed class SeaWaterTests
    {
        // Degrees of grazing at which |R_h| and |R_v| are known.
        static readonly double[] s_grazing = { 60, 10, 1 };

        [TestCase(1, 71.579, 89.973)]
        [TestCase(3, 69.847, 39.954)]
        [TestCase(10, 55.061, 37.513)]
        [TestCase(35, 18.309, 29.041)]
        [TestCase(94, 7.182, 13.224)]
        public void Permittivity_At20Degrees_IsKnown(double gigahertz, double permittivity, double loss)
        {
            var sample = SeaWater.At(gigahertz * 1e9, 20, 35);
            Assert.That(sample.Permittivity, Is.EqualTo(permittivity).Within(6e-4));
            Assert.That(sample.PermittivityLoss, Is.EqualTo(loss).Within(6e-4));
            Assert.That((sample.Permeability, sample.PermeabilityLoss), Is.EqualTo((1, 0)));
        }

        [TestCase(10, 10, 35, 49.814, 40.436)]
        [TestCase(10, 0, 35, 40.843, 41.871)]
        [TestCase(5.3, 15, 35, 66.065, 35.770)]
        [TestCase(9.4, 20, 35, 56.563, 37.149)]
        public void Medium_OfOtherWater_IsKnown(double gigahertz, double celsius, double salinity, double permittivity,
            double loss)
        {
            var (value, permeability) = Medium.SeaWater(celsius, salinity).At(gigahertz * 1e9);
            Assert.That(value.Real, Is.EqualTo(permittivity).Within(1.5e-3));
            Assert.That(-value.Imaginary, Is.EqualTo(loss).Within(1.5e-3));
            Assert.That(permeability, Is.EqualTo(Complex.One));
        }

        // Fresh water has no conductivity: its loss vanishes towards low frequency, where e' is the static one.
        // The National Physical Laboratory's value at 20 C is 80.1.
        [Test]
        public void Permittivity_OfFreshWaterAtLowFrequency_IsItsStaticOne()
        {
            var fresh = SeaWater.At(1e6, 20, 0);
            Assert.That(fresh.Permittivity, Is.EqualTo(80.1).Within(0.3));
            Assert.That(fresh.PermittivityLoss, Is.InRange(0, 0.01));
        }

        [TestCase(1, 10.24)]
        [TestCase(3, 6.90)]
        [TestCase(10, 1.98)]
        [TestCase(35, 0.48)]
        [TestCase(94, 0.26)]
        public void SkinDepth_IsKnown(double gigahertz, double millimetres)
        {
            var q = Complex.Sqrt(Permittivity(gigahertz));
            double wavenumber = 2 * Math.PI * gigahertz * 1e9 / Signal.SpeedOfLight;
            Assert.That(1000 / (wavenumber * -q.Imaginary), Is.EqualTo(millimetres).Within(0.006));
        }

        // |R_h|, |R_v| at each grazing angle, then the angle of the smallest |R_v|, degrees.
        [TestCase(1, 0.8645, 0.8236, 0.9712, 0.3771, 0.9971, 0.7121, 5.34)]
        [TestCase(3, 0.8292, 0.7792, 0.9631, 0.2555, 0.9962, 0.7361, 6.37)]
        [TestCase(10, 0.8159, 0.7625, 0.9600, 0.2299, 0.9959, 0.7591, 6.99)]
        [TestCase(35, 0.7719, 0.7080, 0.9494, 0.2514, 0.9948, 0.8338, 9.75)]
        [TestCase(94, 0.6819, 0.6001, 0.9262, 0.3198, 0.9923, 0.8867, 14.69)]
        public void Reflection_OfTheSea_IsKnown(double gigahertz, double h60, double v60, double h10, double v10,
            double h1, double v1, double smallest)
        {
            var value = Permittivity(gigahertz);
            var surface = new SurfaceMaterial("sea",
                halfSpace: Medium.Constant(value.Real, -value.Imaginary));
            double[] expected = { h60, v60, h10, v10, h1, v1 };
            for (int i = 0; i < s_grazing.Length; i++)
            {
                var (h, v) = Magnitudes(surface, s_grazing[i], gigahertz);
                Assert.That(h, Is.EqualTo(expected[2 * i]).Within(6e-5), $"R_h at {s_grazing[i]} degrees");
                Assert.That(v, Is.EqualTo(expected[2 * i + 1]).Within(6e-5), $"R_v at {s_grazing[i]} degrees");
            }
            double found = Enumerable.Range(100, 3000).Select(i => i * 0.01)
                .OrderBy(grazing => Magnitudes(surface, grazing, gigahertz).v).First();
            Assert.That(found, Is.EqualTo(smallest).Within(0.011));
        }

        // The vertical coefficient turns by half a circle through its minimum: degrees of R_v at 10 GHz, in the
        // convention in which both coefficients agree at normal incidence.
        [TestCase(90, 0.7906, -4.19)]
        [TestCase(10, 0.2299, -38.7)]
        [TestCase(5, 0.2224, -139.5)]
        [TestCase(0.3, 0.9210, -178.6)]
        public void PublishedMaterial_OfTheSea_ReflectsSo(double grazing, double magnitude, double degrees)
        {
            var sea = PublishedMaterial.Find("sea_water").ToSurface("sea");
            var v = sea.Reflection(Math.Sin(grazing * Math.PI / 180), 10e9).P;
            Assert.That(v.Magnitude, Is.EqualTo(magnitude).Within(1e-4));
            Assert.That(v.Phase * 180 / Math.PI, Is.EqualTo(degrees).Within(0.06));
        }

        [TestCase(0.99e9)]
        [TestCase(90.1e9)]
        [TestCase(94e9)]
        public void Reflection_OutsideTheRange_IsRefused(double frequency) => Assert.That(
            Assert.Throws<GlintException>(() =>
                PublishedMaterial.Find("sea_water").ToSurface("sea").Reflection(1, frequency)).Message,
            Does.StartWith("material 'sea' has no data at ").And.Contain("from 1e9 to 9e10 Hz"));

        [TestCase(-2.1, 35, "temperature -2.1 C must be from -2 to 29")]
        [TestCase(29.5, 35, "temperature 29.5 C")]
        [TestCase(double.NaN, 35, "temperature NaN C")]
        [TestCase(20, -1, "salinity -1 psu must be from 0 to 40")]
        [TestCase(20, 40.5, "salinity 40.5 psu")]
        public void Medium_OfWaterOutsideTheModel_IsRefused(double celsius, double salinity, string part) =>
            Assert.That(Assert.Throws<GlintException>(() => Medium.SeaWater(celsius, salinity)).Message,
                Does.StartWith("sea water: " + part).And.Contain("Meissner"));

        [Test]
        public void Medium_OfTheSameWater_IsTheSameMaterial()
        {
            SurfaceMaterial Sea(double celsius) => new SurfaceMaterial("sea", halfSpace: Medium.SeaWater(celsius, 35));
            Assert.That(Sea(20), Is.EqualTo(PublishedMaterial.Find("sea_water").ToSurface("sea")));
            Assert.That(Sea(10), Is.Not.EqualTo(Sea(20)));
        }

        static Complex Permittivity(double gigahertz)
        {
            var sample = SeaWater.At(gigahertz * 1e9, 20, 35);
            return new Complex(sample.Permittivity, -sample.PermittivityLoss);
        }

        static (double h, double v) Magnitudes(SurfaceMaterial surface, double grazing, double gigahertz)
        {
            var reflection = surface.Reflection(Math.Sin(grazing * Math.PI / 180), gigahertz * 1e9);
            return (reflection.S.Magnitude, reflection.P.Magnitude);
        }
    }
}
