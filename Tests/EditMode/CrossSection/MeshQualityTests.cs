using System;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class MeshQualityTests
    {
        // A side of the prism is r (1 - cos(pi/n)) within the cylinder; caps and their edges do not count.
        [TestCase(24)]
        [TestCase(96)]
        [TestCase(1440)]
        public void Cylinder_HasThePrismsSagitta_OnItsSide(int sides)
        {
            const double Radius = 0.5, Height = 0.3;
            var quality = Measure(CrossSectionTargets.Cylinder(Radius, Height, sides, true));
            double sagitta = Radius * (1 - math.cos(math.PI_DBL / sides)), width = math.sin(math.PI_DBL / sides);
            Assert.That(quality.MaxSagitta, Is.EqualTo(sagitta).Within(0.01 * sagitta + 1e-7));
            double side = sides * width * Height, caps = sides * Radius * Radius * math.sin(2 * math.PI_DBL / sides);
            Assert.That(quality.Area, Is.EqualTo(side + caps).Within(1e-5));
            Assert.That(quality.Share(50 * sagitta * 0.9), Is.EqualTo(side / (side + caps)).Within(1e-3));
            Assert.That(quality.Share(50 * sagitta * 1.1), Is.Zero);
            Assert.That(quality.MaxFrequency, Is.EqualTo(299792458 / (50 * sagitta)).Within(2).Percent);
            Assert.That(quality.IsOpen, Is.False);
        }

        // The distance of each facet from the sphere, measured at many points of it.
        [TestCase(16)]
        [TestCase(64)]
        public void Sphere_HasTheDistanceOfItsFacets(int cuts)
        {
            var mesh = CrossSectionTargets.Sphere(1, cuts);
            var quality = Measure(mesh);
            var distances = Enumerable.Range(0, mesh.TriangleCount).Select(t => DistanceFromUnitSphere(mesh, t))
                .OrderBy(distance => distance).ToArray();
            Assert.That(quality.MaxSagitta, Is.EqualTo(distances.Last()).Within(20).Percent);
            double median = distances[distances.Length / 2];
            Assert.That(quality.Share(50 * 0.9 * median), Is.GreaterThan(0.5));
            Assert.That(quality.Share(50 * 1.1 * median), Is.LessThan(0.5));
        }

        // The sphere of the published cases: 0.05 mm, while 1/50 of a wavelength is 0.6 mm.
        [Test]
        public void PublishedSphere_IsGoodAtTenGigahertz()
        {
            var quality = Measure(CrossSectionTargets.Named("sphere_1"));
            Assert.That(quality.MaxSagitta, Is.EqualTo(5e-5).Within(20).Percent);
            Assert.That(quality.Share(0.03), Is.Zero);
            Assert.That(quality.Share(50 * 2e-5), Is.EqualTo(1).Within(0.01));
            Assert.That(quality.MaxFrequency, Is.InRange(100e9, 140e9));
        }

        [TestCase("plate_0p5_0p5", true)]
        [TestCase("dihedral_0p3_0p2", true)]
        [TestCase("trihedral_square_0p3", true)]
        public void FlatFaces_AreGoodAtAnyFrequency(string name, bool isOpen)
        {
            var quality = Measure(SameSurface.Moved(SameSurface.Subdivided(CrossSectionTargets.Named(name), 4),
                SameSurface.Rotation(new System.Random(1))));
            Assert.That(quality.MaxSagitta, Is.Zero);
            Assert.That(quality.MaxFrequency, Is.EqualTo(double.PositiveInfinity));
            Assert.That(quality.Share(1e-6), Is.Zero);
            Assert.That(quality.IsOpen, Is.EqualTo(isOpen));
        }

        // Both facets are 0.3 m wide: bent by 29 degrees they seem to be a curve, by 31 degrees an edge.
        [TestCase(29, 0.3 * 29 * Math.PI / 180 / 8)]
        [TestCase(31, 0)]
        public void Fold_BelowThirtyDegrees_IsACurve(double bend, double sagitta) =>
            Assert.That(Measure(CrossSectionTargets.Dihedral(0.3, 0.2, 180 - bend)).MaxSagitta,
                Is.EqualTo(sagitta).Within(1e-6));

        // A crease below 20 degrees is that of a body which is faceted on purpose; one above 30 makes larger bends
        // curves.
        [TestCase(16, 15, false)]
        [TestCase(14, 15, true)]
        [TestCase(19, 15, false)]
        [TestCase(19, 19.5, true)]
        [TestCase(20, 20, true)]
        [TestCase(29, 25, true)]
        [TestCase(40, 30, false)]
        [TestCase(40, 45, true)]
        public void Fold_IsACurve_BelowTheCreaseThatTheUserChose(double bend, double crease, bool isCurve)
        {
            var mesh = CrossSectionTargets.Dihedral(0.3, 0.2, 180 - bend);
            var quality = MeshQuality.Find(new RadarScene(mesh),
                new[] { SurfacePatches.Find(mesh, creaseDegrees: crease) });
            Assert.That(quality.MaxSagitta, Is.EqualTo(isCurve ? 0.3 * math.radians(bend) / 8 : 0).Within(1e-6));
        }

        // A plate of 10 m that ends in a strip of 1 cm, bent by 20 degrees: the strip, and as much of the plate.
        [Test]
        public void WidePlate_BesideANarrowStrip_CountsWithTheStripsWidth()
        {
            double turn = math.radians(20.0);
            var strip = new float3((float)(0.01 * math.cos(turn)), (float)(0.01 * math.sin(turn)), 0);
            var mesh = TestRadar.Join(
                TestRadar.Plate(new float3(-10, 0, 0), new float3(10, 0, 0), new float3(0, 0, 1)),
                TestRadar.Plate(0, strip, new float3(0, 0, 1)));
            var quality = Measure(mesh);
            double sagitta = 0.01 * turn / 8;
            Assert.That(quality.MaxSagitta, Is.EqualTo(sagitta).Within(1).Percent);
            // Each facet is two triangles, of which one touches the fold.
            Assert.That(quality.Share(49 * sagitta) * quality.Area, Is.EqualTo(0.01).Within(2).Percent);
        }

        [Test]
        public void ScaledInstance_HasAScaledSagitta_AndCountsInTheScene()
        {
            var mesh = CrossSectionTargets.Cylinder(0.5, 0.3, 96, false);
            var patches = SurfacePatches.Find(mesh);
            var scaled = new MeshInstance
            {
                Mesh = mesh, ToWorld = Affine.FromTransform(7, new double4(1, 2, 3, 4), -3)
            };
            MeshQuality alone = MeshQuality.Find(new RadarScene(mesh), new[] { patches }),
                both = MeshQuality.Find(new RadarScene(
                    new MeshInstance { Mesh = mesh, ToWorld = Affine.Identity }, scaled), new[] { patches, patches });
            Assert.That(both.MaxSagitta, Is.EqualTo(3 * alone.MaxSagitta).Within(1e-4).Percent);
            Assert.That(both.Area, Is.EqualTo(10 * alone.Area).Within(1e-4).Percent);
            Assert.That(both.OpenEdgeCount, Is.EqualTo(4 * 96));
            Assert.That(both.Share(75 * alone.MaxSagitta), Is.EqualTo(0.9).Within(1e-3));
        }

        [Test]
        public void PatchesOfAnotherMesh_AreRefused()
        {
            var patches = SurfacePatches.Find(CrossSectionTargets.Plate(1, 1));
            var scene = new RadarScene(CrossSectionTargets.Box(1, 1, 1));
            Assert.That(() => MeshQuality.Find(scene, new[] { patches }),
                Throws.TypeOf<GlintException>().With.Message.Contains("2 triangles").And.Message.Contains("of 12"));
            Assert.That(() => MeshQuality.Find(scene, new[] { patches, patches }),
                Throws.TypeOf<GlintException>().With.Message.Contains("give one for each"));
        }

        static MeshQuality Measure(TriangleMesh mesh) =>
            MeshQuality.Find(new RadarScene(mesh), new[] { SurfacePatches.Find(mesh) });

        static double DistanceFromUnitSphere(TriangleMesh mesh, int triangle)
        {
            mesh.GetTriangle(triangle, out var a, out var b, out var c);
            double nearest = 1;
            for (int i = 0; i <= 12; i++)
                for (int j = 0; i + j <= 12; j++)
                    nearest = math.min(nearest,
                        math.length(i * (double3)a + j * (double3)b + (12 - i - j) * (double3)c) / 12);
            return 1 - nearest;
        }
    }
}
