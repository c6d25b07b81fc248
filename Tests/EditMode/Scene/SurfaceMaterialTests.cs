using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Reflection of plane waves by half-spaces and layers.</summary>
    public sealed class SurfaceMaterialTests
    {
        const double Frequency = 10e9, Wavelength = Signal.SpeedOfLight / Frequency;
        static readonly double s_cos45 = Math.Sqrt(0.5);

        static readonly Medium s_coating = Medium.Constant(4, 0.4), s_absorber = Medium.Constant(17, 0.34, 1.5, 1.8),
            s_dielectric = Medium.Constant(4, 0), s_sea = Medium.Constant(55.062, 37.514);

        // To four digits, by an independent program in double precision; time factor exp(+j omega t).
        static IEnumerable<object[]> Printed()
        {
            yield return new object[]
            {
                OnMetal(s_coating, 0.002), new Complex(-0.5134, 0.8245), new Complex(-0.7356, 0.6457),
                new Complex(0.3765, -0.8810)
            };
            yield return new object[]
            {
                OnMetal(s_absorber, 0.0015), new Complex(-0.3464, -0.2667), new Complex(-0.4957, -0.2250),
                new Complex(0.1736, 0.2895)
            };
            yield return new object[]
            {
                HalfSpace(s_dielectric), new Complex(-1 / 3.0, 0), new Complex(-0.4514, 0), new Complex(0.2038, 0)
            };
            // R_p is R_s squared at 45 degrees, of any half-space that is not magnetic.
            yield return new object[]
            {
                HalfSpace(s_sea), new Complex(-0.7885, 0.0578), new Complex(-0.8457, 0.0439),
                Complex.Pow(new Complex(-0.8457, 0.0439), 2)
            };
        }

        [TestCaseSource(nameof(Printed))]
        public void Reflection_OfPrintedCases_IsPrinted(SurfaceMaterial material, Complex normal, Complex s45,
            Complex p45)
        {
            var straight = material.Reflection(1, Frequency);
            AssertEqual(straight.S, normal, 1e-4);
            AssertEqual(straight.P, -straight.S, 1e-15);
            var slanted = material.Reflection(s_cos45, Frequency);
            AssertEqual(slanted.S, s45, 1e-4);
            AssertEqual(slanted.P, p45, 2e-4);
        }

        [TestCase(0)]
        [TestCase(1e-9)]
        [TestCase(0.3)]
        [TestCase(1)]
        public void Reflection_OfAConductor_IsThatOfMetal(double cosine)
        {
            var reflection = SurfaceMaterial.PerfectConductor.Reflection(cosine, Frequency);
            Assert.That((reflection.S, reflection.P), Is.EqualTo((-Complex.One, Complex.One)));
            Assert.That(SurfaceMaterial.PerfectConductor.IsConductor);
            Assert.That(HalfSpace(s_sea).IsConductor, Is.False);
            Assert.That(OnMetal(s_coating, 0).IsConductor, Is.False);
        }

        // Sums of waves that bounce between the interfaces, by reflection coefficients of each interface: another
        // recursion than that of impedances.
        // A sea of 0.29 m at 10 GHz (Miller, Brown and Vegh 1984): published factors.
        [TestCase(0.5, 0.616)]
        [TestCase(1, 0.287)]
        [TestCase(2, 0.135)]
        [TestCase(3, 0.089)]
        public void Reflection_OfARoughSurface_IsWeakerByThePublishedFactor(double grazing, double factor)
        {
            double cosine = Math.Sin(grazing * Math.PI / 180);
            var rough = new SurfaceMaterial("sea", null, s_sea, 0.29).Reflection(cosine, 10e9);
            var smooth = new SurfaceMaterial("sea", null, s_sea).Reflection(cosine, 10e9);
            Assert.That(Complex.Abs(rough.S / smooth.S - factor), Is.LessThan(6e-4));
            Assert.That(Complex.Abs(rough.P / smooth.P - factor), Is.LessThan(6e-4));
        }

        [TestCase(0)]
        [TestCase(0.002)]
        [TestCase(0.03)]
        [TestCase(0.1)]
        public void Reflection_OfARoughSurface_IsThatOfTheReference(double roughness)
        {
            var layer = new[] { new MaterialLayer(s_coating, 1e-3) };
            foreach (var material in new[]
            {
                new SurfaceMaterial("metal", roughness: roughness),
                new SurfaceMaterial("sea", null, s_sea, roughness),
                new SurfaceMaterial("coated", layer, s_sea, roughness)
            })
                for (double cosine = 0.01; cosine <= 1; cosine += 0.11)
                {
                    var (s, p) = new Reference.ReferenceSurface(material, 10e9).Coefficients(cosine);
                    var found = material.Reflection(cosine, 10e9);
                    Assert.That(Complex.Abs(found.S - s), Is.LessThan(1e-10), $"{material} at {cosine}");
                    Assert.That(Complex.Abs(found.P - p), Is.LessThan(1e-10), $"{material} at {cosine}");
                }
        }

        [Test]
        public void Roughness_IsPartOfTheMaterial()
        {
            var smooth = new SurfaceMaterial("metal");
            var rough = new SurfaceMaterial("metal", roughness: 0.01);
            Assert.That(rough, Is.Not.EqualTo(smooth));
            Assert.That(rough, Is.EqualTo(new SurfaceMaterial("metal", roughness: 0.01)));
            Assert.That((smooth.IsConductor, rough.IsConductor), Is.EqualTo((true, false)));
            Assert.That(rough.ToString(), Is.EqualTo("metal: perfect conductor, roughness 0.01 m"));
            Assert.That(smooth.ToString(), Is.EqualTo("metal: perfect conductor"));
        }

        [TestCase(-1)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void Roughness_ThatIsNoHeight_IsRefused(double roughness) => Assert.That(
            Assert.Throws<GlintException>(() => new SurfaceMaterial("sea", roughness: roughness)).Message,
            Does.StartWith("material 'sea': its roughness ").And.Contain("give 0 for a smooth surface"));

        [Test]
        public void Reflection_OfRandomStacks_IsThatOfWavesBetweenInterfaces()
        {
            var random = new Random(1);
            for (int i = 0; i < 2000; i++)
            {
                var material = RandomStack(random);
                double cosine = Math.Cos(random.NextDouble() * Math.PI / 2);
                var reflection = material.Reflection(cosine, Frequency);
                AssertEqual(reflection.S, BetweenInterfaces(material, cosine, isS: true), 1e-9, material);
                AssertEqual(reflection.P, -BetweenInterfaces(material, cosine, isS: false), 1e-9, material);
            }
        }

        // Also media with negative real parts, such as plasmas, and thick ones.
        [Test]
        public void Reflection_OfRandomPassiveStacks_ReturnsNoMoreThanCame()
        {
            var random = new Random(2);
            for (int i = 0; i < 20000; i++)
            {
                var material = RandomStack(random);
                double cosine = i % 3 == 0 ? Math.Pow(10, -9 * random.NextDouble()) : random.NextDouble();
                var reflection = material.Reflection(cosine, Frequency);
                Assert.That(Complex.Abs(reflection.S), Is.InRange(0, 1 + 1e-9), $"{material} at {cosine}");
                Assert.That(Complex.Abs(reflection.P), Is.InRange(0, 1 + 1e-9), $"{material} at {cosine}");
            }
        }

        [Test]
        public void Reflection_OfALosslessStackOnMetal_ReturnsEverything()
        {
            var random = new Random(3);
            for (int i = 0; i < 500; i++)
            {
                var layers = Enumerable.Range(0, 1 + i % 3).Select(_ => new MaterialLayer(
                    Medium.Constant(0.2 + 5 * random.NextDouble(), 0, 0.2 + 2 * random.NextDouble()),
                    0.05 * random.NextDouble()));
                var reflection = new SurfaceMaterial("", layers).Reflection(random.NextDouble(), Frequency);
                Assert.That(Complex.Abs(reflection.S), Is.EqualTo(1).Within(1e-9));
                Assert.That(Complex.Abs(reflection.P), Is.EqualTo(1).Within(1e-9));
            }
        }

        [Test]
        public void Reflection_OfALayerWithoutThickness_IsThatOfWhatIsBehind()
        {
            foreach (var behind in new[] { null, s_sea, s_absorber })
                foreach (double cosine in new[] { 0, 1e-6, 0.4, 1 })
                {
                    var covered = new SurfaceMaterial("", new[] { new MaterialLayer(s_coating, 0) }, behind);
                    var bare = new SurfaceMaterial("", null, behind);
                    Assert.That(covered.Reflection(cosine, Frequency), Is.EqualTo(bare.Reflection(cosine, Frequency)));
                }
        }

        [TestCase(1e-6)]
        [TestCase(0.003)]
        [TestCase(10)]
        public void Reflection_OfALayerOnItsOwnMedium_IsThatOfTheMedium(double thickness)
        {
            foreach (var medium in new[] { s_coating, s_absorber, s_dielectric, s_sea })
                foreach (double cosine in new[] { 0, 0.01, 0.7, 1 })
                {
                    var layered = new SurfaceMaterial("", new[] { new MaterialLayer(medium, thickness) }, medium);
                    AssertSame(layered.Reflection(cosine, Frequency), HalfSpace(medium).Reflection(cosine, Frequency));
                }
        }

        // 100 m of lossy material: tan(k q t) overflows there, as exp of up to 1e7 does.
        [Test]
        public void Reflection_OfAThickLossyLayer_IsThatOfItsMedium()
        {
            foreach (var medium in new[] { s_coating, s_absorber, s_sea, Medium.Constant(1, 1e7) })
                foreach (double cosine in new[] { 0, 1e-9, 0.5, 1 })
                    AssertSame(OnMetal(medium, 100).Reflection(cosine, Frequency),
                        HalfSpace(medium).Reflection(cosine, Frequency));
        }

        // A quarter of a wave with the geometric mean of both impedances.
        [Test]
        public void Reflection_OfAQuarterWaveOnADielectric_Vanishes()
        {
            var material = new SurfaceMaterial("",
                new[] { new MaterialLayer(Medium.Constant(2, 0), Wavelength / 4 / Math.Sqrt(2)) }, s_dielectric);
            Assert.That(Complex.Abs(material.Reflection(1, Frequency).S), Is.EqualTo(0).Within(1e-14));
            Assert.That(Complex.Abs(material.Reflection(1, Frequency).P), Is.EqualTo(0).Within(1e-14));
            Assert.That(Complex.Abs(material.Reflection(1, 2 * Frequency).S), Is.EqualTo(1 / 3.0).Within(1e-12),
                "half a wave is nothing");
        }

        [Test]
        public void Reflection_OfAQuarterWaveOnMetal_IsThatOfAMagneticConductor()
        {
            var reflection = OnMetal(s_dielectric, Wavelength / 8).Reflection(1, Frequency);
            AssertEqual(reflection.S, 1, 1e-14);
            AssertEqual(reflection.P, -1, 1e-14);
        }

        // The path through a layer of free space is 2 t cos(theta) longer for the phase, at every angle.
        [TestCase(1)]
        [TestCase(0.3)]
        [TestCase(0)]
        public void Reflection_OfFreeSpaceOnMetal_IsThatOfMetalFurtherAway(double cosine)
        {
            const double thickness = 0.0123;
            var reflection = OnMetal(Medium.Constant(1, 0), thickness).Reflection(cosine, Frequency);
            var delay = Complex.Exp(new Complex(0, -4 * Math.PI / Wavelength * thickness * cosine));
            AssertEqual(reflection.S, -delay, 1e-12);
            AssertEqual(reflection.P, delay, 1e-12);
        }

        [TestCase(1)]
        [TestCase(0.3)]
        [TestCase(1e-9)]
        [TestCase(0)]
        public void Reflection_OfFreeSpace_IsNone(double cosine)
        {
            var reflection = HalfSpace(Medium.Constant(1, 0)).Reflection(cosine, Frequency);
            Assert.That((reflection.S, reflection.P), Is.EqualTo((Complex.Zero, Complex.Zero)));
        }

        // eps = mu = -1 (Veselago 1968): the wave carries its power into the medium, its phase comes out of it.
        [TestCase(1)]
        [TestCase(0.3)]
        public void Reflection_OfAMatchedMediumOfNegativeIndex_IsNone(double cosine)
        {
            var reflection = HalfSpace(Medium.Constant(-1, 0, -1, 0)).Reflection(cosine, Frequency);
            Assert.That(Complex.Abs(reflection.S), Is.EqualTo(0).Within(1e-15));
            Assert.That(Complex.Abs(reflection.P), Is.EqualTo(0).Within(1e-15));
        }

        // A plasma below its plasma frequency.
        [Test]
        public void Reflection_OfALosslessPlasma_IsTotal()
        {
            var reflection = HalfSpace(Medium.Constant(-3, 0)).Reflection(0.6, Frequency);
            Assert.That(Complex.Abs(reflection.S), Is.EqualTo(1).Within(1e-14));
            Assert.That(Complex.Abs(reflection.P), Is.EqualTo(1).Within(1e-14));
        }

        [TestCase(2.5)]
        [TestCase(80)]
        public void Reflection_AtBrewstersAngle_HasNoP(double permittivity)
        {
            double cosine = Math.Cos(Math.Atan(Math.Sqrt(permittivity)));
            var reflection = HalfSpace(Medium.Constant(permittivity, 0)).Reflection(cosine, Frequency);
            Assert.That(Complex.Abs(reflection.P), Is.EqualTo(0).Within(1e-14));
            Assert.That(reflection.S.Real, Is.LessThan(-0.3));
        }

        // Permittivity and permeability exchanged: s and p exchange their roles.
        [Test]
        public void Reflection_OfTheDualMedium_ExchangesSAndP()
        {
            foreach (double cosine in new[] { 0.05, 0.5, 0.9 })
            {
                var medium = HalfSpace(Medium.Constant(3, 0.2, 1.4, 0.7)).Reflection(cosine, Frequency);
                var dual = HalfSpace(Medium.Constant(1.4, 0.7, 3, 0.2)).Reflection(cosine, Frequency);
                AssertEqual(dual.P, medium.S, 1e-14);
                AssertEqual(dual.S, medium.P, 1e-14);
            }
        }

        [TestCase(0)]
        [TestCase(1e-9)]
        public void Reflection_AtGrazing_IsMinusOne(double cosine)
        {
            var layers = new[] { new MaterialLayer(s_absorber, 0.001), new MaterialLayer(s_coating, 0.002) };
            foreach (var material in new[]
            {
                HalfSpace(s_dielectric), HalfSpace(s_sea), HalfSpace(s_absorber), OnMetal(s_coating, 0.002),
                new SurfaceMaterial("", layers, s_dielectric)
            })
            {
                var reflection = material.Reflection(cosine, Frequency);
                AssertEqual(reflection.S, -1, 1e-7);
                AssertEqual(reflection.P, -1, 1e-7);
            }
        }

        // eps mu = sin^2: the wave in the layer runs along the surface, z_l is infinite or 0. The limit of
        // z = z_l j tan(k q t) is j k t mu for s, and 0 for p.
        [Test]
        public void Reflection_AtTheCriticalAngleOfALayerOnMetal_IsTheLimit()
        {
            const double cosine = 0.5, thickness = 0.004;
            var reflection = OnMetal(Medium.Constant(0.75, 0), thickness).Reflection(cosine, Frequency);
            var z = new Complex(0, 2 * Math.PI / Wavelength * thickness);
            AssertEqual(reflection.S, (z * cosine - 1) / (z * cosine + 1), 1e-14);
            AssertEqual(reflection.P, 1, 1e-14);
            foreach (double nearby in new[] { cosine - 1e-9, cosine + 1e-9 })
            {
                var near = OnMetal(Medium.Constant(0.75, 0), thickness).Reflection(nearby, Frequency);
                AssertEqual(near.S, reflection.S, 1e-8);
                AssertEqual(near.P, reflection.P, 1e-8);
            }
        }

        [TestCase(-0.1)]
        [TestCase(1.1)]
        [TestCase(double.NaN)]
        public void Reflection_OfACosineThatIsNone_IsRefused(double cosine) =>
            Assert.Throws<ArgumentOutOfRangeException>(() => HalfSpace(s_sea).Reflection(cosine, Frequency));

        [TestCase(0)]
        [TestCase(-1)]
        [TestCase(double.PositiveInfinity)]
        public void Reflection_WithoutAFrequency_IsRefused(double frequency) =>
            Assert.Throws<ArgumentOutOfRangeException>(() => HalfSpace(s_sea).Reflection(1, frequency));

        [Test]
        public void Reflection_WithoutDataAtTheFrequency_NamesMaterialFrequencyAndRange()
        {
            var table = Medium.Table(new[] { new MediumSample(8e9, 4, 0), new MediumSample(12e9, 4, 0) });
            var material = new SurfaceMaterial("hull", new[]
            {
                new MaterialLayer(s_coating, 0.001), new MaterialLayer(table, 0.001)
            }, Medium.PowerLaw(5, 0, 0.1, 0, 1e9, 10e9));
            Assert.That(Assert.Throws<GlintException>(() => material.Reflection(1, 12.5e9)).Message, Is.EqualTo(
                "material 'hull' has no data at 12500000000 Hz: its layer 2 has data from 8e9 to 1.2e10 Hz; give a "
                    + "frequency in that range, or another material"));
            Assert.That(Assert.Throws<GlintException>(() => material.Reflection(1, 11e9)).Message, Does.StartWith(
                "material 'hull' has no data at 11000000000 Hz: its half-space has data from 1e9 to 1e10 Hz"));
            Assert.DoesNotThrow(() => material.Reflection(1, 8e9));
            Assert.DoesNotThrow(() => material.Reflection(1, 10e9));
        }

        [TestCase(-1e-9)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void Layer_OfAThicknessThatIsNone_IsRefused(double thickness) =>
            Assert.That(Assert.Throws<GlintException>(() => new MaterialLayer(s_sea, thickness)).Message,
                Does.StartWith("the thickness of a layer is ").And.EndsWith(" m: give 0 or more"));

        [Test]
        public void Text_HoldsEverything_SoThatEqualMaterialsAreEqual()
        {
            var table = Medium.Table(new[] { new MediumSample(8e9, 4, 0.1), new MediumSample(12e9, 4, 0.2) });
            SurfaceMaterial[] All() => new[]
            {
                new SurfaceMaterial("paint"), OnMetal(s_coating, 0.002, "paint"), OnMetal(s_coating, 0.002),
                OnMetal(s_coating, 0.002 + 1e-18, "paint"), HalfSpace(s_coating), HalfSpace(table), HalfSpace(s_sea),
                HalfSpace(Medium.Constant(4, 0.4 + 1e-16)), HalfSpace(Medium.Constant(4, 0.4, 1 + 1e-15)),
                HalfSpace(Medium.Constant(4, 0.4, 1, 1e-300)), HalfSpace(Medium.PowerLaw(4, 0, 0.1, 0.5, 1e9, 10e9)),
                HalfSpace(Medium.PowerLaw(4, 0, 0.1, 0.5, 1e9, 10e9 + 1e-5)),
                HalfSpace(Medium.PowerLaw(4, 1e-9, 0.1, 0.5, 1e9, 10e9)),
                HalfSpace(Medium.Table(new[] { new MediumSample(8e9, 4, 0.1), new MediumSample(12e9, 4, 0.3) })),
                HalfSpace(Medium.Table(new[] { new MediumSample(8e9, 4, 0.1), new MediumSample(13e9, 4, 0.2) })),
                new SurfaceMaterial("", new[] { new MaterialLayer(s_coating, 0.002) }, s_sea)
            };
            var (first, second) = (All(), All());
            for (int i = 0; i < first.Length; i++)
                for (int j = 0; j < second.Length; j++)
                    Assert.That(first[i].Equals(second[j]), Is.EqualTo(i == j), $"{first[i]} and {second[j]}");
            Assert.That(first.Select(material => material.GetHashCode()),
                Is.EqualTo(second.Select(material => material.GetHashCode())));
        }

        [Test]
        public void Text_InAForeignCulture_IsTheSame()
        {
            using (new ForeignCulture())
                Assert.That(OnMetal(Medium.Constant(-4.5, 0.4), 0.0025, "paint").ToString(),
                    Is.EqualTo("paint: 0.0025 m of e -4.5 - 0.4j mu 1 - 0j on perfect conductor"));
        }

        static SurfaceMaterial HalfSpace(Medium medium) => new SurfaceMaterial("", null, medium);

        static SurfaceMaterial OnMetal(Medium medium, double thickness, string name = "") =>
            new SurfaceMaterial(name, new[] { new MaterialLayer(medium, thickness) });

        static SurfaceMaterial RandomStack(Random random)
        {
            Medium RandomMedium() => Medium.Constant(20 * random.NextDouble() - 5, 3 * random.NextDouble(),
                6 * random.NextDouble() - 2, 2 * random.NextDouble());
            var layers = Enumerable.Range(0, random.Next(5))
                .Select(_ => new MaterialLayer(RandomMedium(), Math.Pow(10, -4 + 4 * random.NextDouble()))).ToArray();
            return new SurfaceMaterial("random", layers, random.Next(2) == 0 ? null : RandomMedium());
        }

        static Complex BetweenInterfaces(SurfaceMaterial material, double cosine, bool isS)
        {
            // Wave impedance across the surface, and wavenumber normal to it over that of free space.
            (Complex z, Complex q) Of(Medium medium)
            {
                var (permittivity, permeability) = medium.At(Frequency);
                var q = Complex.Sqrt(permittivity * permeability - (1 - cosine * cosine));
                q = q.Imaginary > 0 ? -q : q;
                return (isS ? permeability / q : q / permittivity, q);
            }
            Complex Interface(Complex from, Complex to) => (to - from) / (to + from);
            var waves = material.Layers.Select(layer => Of(layer.Medium)).ToArray();
            Complex FromImpedance(int i) => i < 0 ? isS ? 1 / cosine : cosine : waves[i].z;
            var last = FromImpedance(waves.Length - 1);
            var reflection = material.HalfSpace == null ? -1 : Interface(last, Of(material.HalfSpace).z);
            for (int i = waves.Length - 1; i >= 0; i--)
            {
                double electrical = 4 * Math.PI / Wavelength * material.Layers[i].Thickness;
                var returned = reflection * Complex.Exp(-Complex.ImaginaryOne * electrical * waves[i].q);
                var outer = Interface(FromImpedance(i - 1), waves[i].z);
                reflection = (outer + returned) / (1 + outer * returned);
            }
            return reflection;
        }

        static void AssertSame(FresnelCoefficients reflection, FresnelCoefficients expected)
        {
            AssertEqual(reflection.S, expected.S, 1e-12);
            AssertEqual(reflection.P, expected.P, 1e-12);
        }

        static void AssertEqual(Complex value, Complex expected, double tolerance, object subject = null) =>
            Assert.That(Complex.Abs(value - expected), Is.EqualTo(0).Within(tolerance), // NaN is less than any number
                $"{value} instead of {expected} {subject}");
    }
}
