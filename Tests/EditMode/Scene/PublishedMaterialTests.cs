using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>The library of published materials.</summary>
    public sealed class PublishedMaterialTests
    {
        static IEnumerable<string> Names => PublishedMaterial.All.Select(material => material.Name);

        [Test]
        public void Names_AreUniqueAndHaveASource()
        {
            Assert.That(Names, Is.Unique);
            Assert.That(PublishedMaterial.All.Select(material => material.Source), Has.All.Not.Empty);
            foreach (string name in Names)
                Assert.That(PublishedMaterial.Find(name).Name, Is.EqualTo(name));
        }

        [TestCaseSource(nameof(Names))]
        public void Surface_ReflectsAPartAtEveryFrequencyOfItsRange(string name)
        {
            var published = PublishedMaterial.Find(name);
            var surface = published.ToSurface("wall");
            Assert.That(surface.Name, Is.EqualTo("wall"));
            int tested = 0;
            for (double frequency = 1e6; frequency < 1e12; frequency *= 1.25)
            {
                if (!published.Medium.Frequencies.Contains(frequency))
                    continue;
                tested++;
                foreach (double cosine in new[] { 0.1, 0.6, 1 })
                {
                    var reflection = surface.Reflection(cosine, frequency);
                    Assert.That(Complex.Abs(reflection.S), Is.InRange(0.09, 0.99999), $"at {frequency} Hz");
                    Assert.That(Complex.Abs(reflection.P), Is.InRange(0, 0.99999), $"at {frequency} Hz");
                }
            }
            Assert.That(tested, Is.GreaterThan(2));
        }

        [Test]
        public void Metal_OfTheItu_IsNearlyAPerfectConductor()
        {
            var reflection = PublishedMaterial.Find("itu_metal").ToSurface("").Reflection(1, 10e9);
            // Surface impedance of a good conductor of 1e7 S/m over that of free space, with the skin depth.
            double skinDepth = Math.Sqrt(2 / (2 * Math.PI * 10e9 * 4e-7 * Math.PI * 1e7));
            var z = new Complex(1, 1) / (1e7 * skinDepth * 376.730);
            Assert.That(Complex.Abs(reflection.S - (z - 1) / (z + 1)), Is.EqualTo(0).Within(1e-9));
        }

        // A sheet that is thin in waves reflects as the metal behind it; a thicker one may absorb nine tenths.
        [Test]
        public void Absorber_OnMetal_IsACoatingThatAbsorbs()
        {
            var absorber = PublishedMaterial.Find("arc_dd_13490").ToSurface("");
            Assert.That(absorber.Layers.Single().Thickness, Is.EqualTo(0.0015));
            Assert.That(absorber.HalfSpace, Is.Null);
            var amplitudes = Enumerable.Range(1, 10).Select(gigahertz =>
                Complex.Abs(absorber.Reflection(1, gigahertz * 1e9).S)).ToArray();
            Assert.That(amplitudes[0], Is.GreaterThan(0.8), "thin in waves at 1 GHz");
            Assert.That(amplitudes.Min(), Is.InRange(0, 0.32));
        }

        [Test]
        public void Find_OfAnotherName_ListsTheNames()
        {
            string message = Assert.Throws<GlintException>(() => PublishedMaterial.Find("concrete")).Message;
            Assert.That(message, Does.StartWith(
                "no published material is called concrete: give one of itu_concrete, itu_brick, "));
            foreach (string name in Names)
                Assert.That(message, Does.Contain(name));
        }
    }
}
