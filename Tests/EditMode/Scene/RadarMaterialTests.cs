using System.Collections.Generic;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>Materials as assets.</summary>
    public sealed class RadarMaterialTests
    {
        RadarMaterial _material;

        [SetUp]
        public void MakeMaterial()
        {
            _material = ScriptableObject.CreateInstance<RadarMaterial>();
            _material.name = "hull";
        }

        [TearDown]
        public void RemoveMaterial() => Object.DestroyImmediate(_material);

        [Test]
        public void Surface_OfANewMaterial_IsAConductor() =>
            Assert.That(_material.ToSurface(), Is.EqualTo(new SurfaceMaterial("hull")));

        [TestCase(RadarMaterialKind.Conductor)]
        [TestCase(RadarMaterialKind.Published)]
        public void Surface_HasSlopeAndGamma(RadarMaterialKind kind)
        {
            (_material.Kind, _material.Published) = (kind, "itu_concrete");
            string before = _material.ToSurface().ToString();
            (_material.Slope, _material.GammaDb) = (0.3, -5);
            var surface = _material.ToSurface();
            Assert.That((surface.Slope, surface.GammaDb), Is.EqualTo((0.3, -5.0)));
            // Content hashes of results without them stay.
            Assert.That(surface.ToString(), Is.EqualTo(before + ", slope 0.3, gamma -5 dB"));
        }

        [TestCase(0, -10, "Radar Material 'hull': material 'hull': its slope 0 must be from 0.001 to 1")]
        [TestCase(0.1, 31, "Radar Material 'hull': material 'hull': its gamma in dB 31 must be from -100 to 30")]
        public void SlopeOrGamma_OutOfItsRange_IsRefused(double slope, double gammaDb, string message)
        {
            (_material.Slope, _material.GammaDb) = (slope, gammaDb);
            Assert.That(() => _material.ToSurface(), Throws.InstanceOf<GlintException>().With.Message.EqualTo(message));
        }

        [Test]
        public void Surface_OfLayers_HasThemInOrder()
        {
            _material.Layers.Add(Layer(0.002, new MediumSample(0, 4, 0.4)));
            _material.Layers.Add(new RadarLayer { Medium = new RadarMedium { Published = "ptfe" }, Thickness = 0.01 });
            var layers = new[]
            {
                new MaterialLayer(Medium.Constant(4, 0.4), 0.002),
                new MaterialLayer(PublishedMaterial.Find("ptfe").Medium, 0.01)
            };
            Assert.That(_material.ToSurface(), Is.EqualTo(new SurfaceMaterial("hull", layers)));

            _material.Kind = RadarMaterialKind.HalfSpace;
            Assert.That(_material.ToSurface(),
                Is.EqualTo(new SurfaceMaterial("hull", layers, Medium.Constant(1, 0))));
        }

        [Test]
        public void Surface_OfAHalfSpaceOverFrequency_IsATable()
        {
            var samples = new List<MediumSample> { new MediumSample(8e9, 4, 0.4), new MediumSample(12e9, 5, 0.3) };
            _material.Kind = RadarMaterialKind.HalfSpace;
            _material.HalfSpace.Values = samples;
            Assert.That(_material.ToSurface(), Is.EqualTo(new SurfaceMaterial("hull", null, Medium.Table(samples))));
        }

        [Test]
        public void Surface_OfAPublishedMaterial_IsIts()
        {
            (_material.Kind, _material.Published) = (RadarMaterialKind.Published, "arc_dd_13490");
            Assert.That(_material.ToSurface(), Is.EqualTo(PublishedMaterial.Find("arc_dd_13490").ToSurface("hull")));
        }

        [Test]
        public void Surface_WithARefusedValue_NamesTheMaterial()
        {
            // A new element in Unity's inspector has zeros.
            _material.Layers.Add(Layer(0.002, new MediumSample()));
            Assert.That(Refusal(), Is.EqualTo("Radar Material 'hull': the relative permittivity e' = 0, e'' = 0 is 0: "
                + "give e', which is 1 in free space"));
            _material.Layers[0] = Layer(-1, new MediumSample(0, 4, 0));
            Assert.That(Refusal(),
                Is.EqualTo("Radar Material 'hull': the thickness of a layer is -1 m: give 0 or more"));
            (_material.Kind, _material.Published) = (RadarMaterialKind.Published, "");
            Assert.That(Refusal(),
                Does.StartWith("Radar Material 'hull': no published material is called \"\": give "));

            string Refusal() => Assert.Throws<GlintException>(() => _material.ToSurface()).Message;
        }

        [Test]
        public void Surface_OfAMaterialNamedByAFile_IsTheSame()
        {
            var surface = new SurfaceMaterial("paint", null, Medium.Constant(4, 0));
            var made = RadarMaterial.Of(surface);
            Assert.That(made.ToSurface(), Is.SameAs(surface));
            Assert.That(made.name, Is.EqualTo("paint"));
            Object.DestroyImmediate(made);
        }

        static RadarLayer Layer(double thickness, params MediumSample[] values) => new RadarLayer
        {
            Medium = new RadarMedium { Values = new List<MediumSample>(values) }, Thickness = thickness
        };
    }
}
