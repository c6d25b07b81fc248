using System.Linq;
using Glint.Editor;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>The figures of a material in its inspector.</summary>
    public sealed class RadarMaterialFiguresTests
    {
        RadarMaterial _material;

        [SetUp]
        public void MakeMaterial() => _material = ScriptableObject.CreateInstance<RadarMaterial>();

        [TearDown]
        public void RemoveMaterial() => Object.DestroyImmediate(_material);

        [Test]
        public void Rows_OfAConductor_AreNone()
        {
            Assert.That(RadarMaterialFigures.Rows(_material), Is.Empty);
            Assert.That(RadarMaterialFigures.Check(_material), Is.Null);
        }

        [Test]
        public void Rows_OfAPublishedMaterial_NameRangeAndSource()
        {
            (_material.Kind, _material.Published) = (RadarMaterialKind.Published, "itu_brick");
            Assert.That(RadarMaterialFigures.Names, Does.Contain("itu_brick"));
            Assert.That(RadarMaterialFigures.Rows(_material).Select(row => row.value), Is.EqualTo(new[]
            {
                "half-space", "from 1e9 to 4e10 Hz", "Recommendation ITU-R P.2040-3 (08/2023), table 3"
            }));
            _material.Published = "arc_dd_13490";
            Assert.That(RadarMaterialFigures.Rows(_material).First().value, Is.EqualTo("1.5 mm on metal"));
        }

        [Test]
        public void Check_OfAMaterialThatIsRefused_IsItsMessage()
        {
            (_material.Kind, _material.Published) = (RadarMaterialKind.Published, "brick");
            var finding = RadarMaterialFigures.Check(_material);
            Assert.That(finding.Severity, Is.EqualTo(Severity.Error));
            Assert.That(finding.Text, Does.Contain("no published material is called brick: give one of itu_concrete"));
            Assert.That(RadarMaterialFigures.Rows(_material), Is.Empty);
        }
    }
}
