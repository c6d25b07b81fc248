using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The figures of an inspector against calculations by hand.</summary>
    public sealed class RadarFiguresTests : InspectorFixture
    {
        [Test]
        public void OfAPlate_AreThoseOnPaper()
        {
            var figures = Figures();
            Assert.That(figures.Distance, Is.EqualTo(20).Within(1e-6));
            Assert.That(figures.Footprint.Value.y, Is.EqualTo(40 * tan(radians(30.0))).Within(1e-6));
            Assert.That(figures.Footprint.Value.x, Is.EqualTo(40 * tan(radians(30.0)) * 16 / 9).Within(1e-6));
            Assert.That(figures.RaySpacing.Value, Is.EqualTo(40 * tan(radians(30.0)) / 90).Within(1e-6));
            Assert.That((figures.Objects, figures.Triangles), Is.EqualTo((1L, 2L)));
            Assert.That(figures.TargetSize, Is.EqualTo(4 * sqrt(2.0)).Within(1e-6));
            Assert.That(figures.Rows().Single(row => row.label == "Wavelength").value, Is.EqualTo("29.979 mm"));
            Assert.That(figures.Rows().Single(row => row.label == "Ray spacing").value,
                Is.EqualTo("256.6 mm, 8.56 wavelengths"));
            Assert.That(figures.Rows().Single(row => row.label == "Rays").value,
                Is.EqualTo("160 x 90, 14,400 emitted"));
        }

        [Test]
        public void OfATargetBesideTheAxis_AreThoseInItsPlane()
        {
            _plate.transform.position = new Vector3(15, 0, 20);
            Assert.That(Figures().Distance, Is.EqualTo(25).Within(1e-6));
            Assert.That(Figures().Footprint.Value.y, Is.EqualTo(40 * tan(radians(30.0))).Within(1e-6));
            // A mirror there that faces the radar lies on a circle of 25 m about it,
            // and sends neighbours back 2 x 20 m x 2 tan(30 deg) / 90 apart, under an angle of asin(15 / 25).
            double step = 2 * 40 * tan(radians(30.0)) / 90 * 0.6 * 10e9 / Signal.SpeedOfLight;
            Assert.That(Figures().Forecast.Value.LargestPathStep, Is.EqualTo(step).Within(25).Percent,
                "at the middle of the receiver");
        }

        [Test]
        public void OfParallelRays_AreThoseOfTheAperture()
        {
            _radar.GetComponent<Camera>().orthographic = true;
            _radar.GetComponent<Camera>().orthographicSize = 1.5f;
            var figures = Figures();
            Assert.That(figures.Footprint.Value.y, Is.EqualTo(3).Within(1e-6));
            Assert.That(figures.RaySpacing.Value, Is.EqualTo(3.0 / 90).Within(1e-6));

            (_radar.FitAperture, _radar.RaySpacing) = (true, 0.5);
            figures = Figures();
            Assert.That((figures.Settings.RaysAcross, figures.Settings.RaysDown), Is.EqualTo((8, 8)), "4 m at 0.5 m");
            Assert.That(figures.RaySpacing.Value, Is.EqualTo(0.5).Within(1e-9));
        }

        [Test]
        public void OfARegion_CountItsRays()
        {
            var settings = _radar.Settings;
            settings.Region = new RayRegion { Left = 60, Bottom = 30, Width = 40, Height = 30 };
            _radar.Settings = settings;
            Assert.That((Figures().Settings.RayCount, Figures().Settings.RaysEmitted), Is.EqualTo((14400L, 1200L)));
        }

        [Test]
        public void OfATargetBehindTheRadar_HaveNoFootprint()
        {
            _radar.transform.rotation = Quaternion.Euler(0, 180, 0);
            Assert.That(Figures().Footprint, Is.Null);
            Assert.That(Figures().Rows().Single(row => row.label == "Footprint").value, Is.EqualTo("behind the radar"));
        }

        [TestCase(RayReadback.None)]
        [TestCase(RayReadback.All)]
        public void Memory_OfASmallPose_IsAboutWhatATraceTakes(RayReadback readback)
        {
            _plate.GetComponent<MeshFilter>().sharedMesh = SceneBuilder.Mesh(2000, 3);
            var result = _radar.Trace(readback);
            _radar.RayReadback = readback;
            var memory = Figures().Memory;
            Assert.That(memory.DeviceBytes,
                Is.InRange(0.4 * result.Statistics.BytesOnDevice, 1.5 * result.Statistics.BytesOnDevice));
            Assert.That(memory.HostBytes,
                Is.GreaterThan(2000 * (3 * 12 + 3 * 4) + (readback == RayReadback.All ? 14400 * 48 : 0)));
        }

        RadarFigures Figures()
        {
            _check.Update();
            return _check.Figures;
        }
    }
}
