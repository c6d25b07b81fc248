using System;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class CrossSectionTargetsTests
    {
        // Areas of the bodies on paper; inscribed polygons have n/2 sin(2 pi/n) r^2 and 2 n sin(pi/n) r h.
        static readonly object[][] Areas =
        {
            new object[] { "plate_0p3_0p2", 0.06 },
            new object[] { "dihedral_0p3_0p2", 0.12 },
            new object[] { "dihedral_los_22p5", 0.12 },
            new object[] { "dihedral_100deg", 0.12 },
            new object[] { "trihedral_triangular_0p3", 0.135 },
            new object[] { "trihedral_square_0p3", 0.27 },
            new object[] { "trihedral_circular_0p3", 3 * 128 * Math.Sin(Math.PI / 512) * 0.09 },
            new object[]
            {
                "cylinder_0p1_0p5", 1440 * (Math.Sin(Math.PI / 720) * 0.01 + Math.Sin(Math.PI / 1440) * 0.1)
            },
            new object[] { "two_plates", 0.08 },
            new object[] { "hidden_plate", 0.2 },
            new object[] { "top_hat", 360 * Math.Sin(Math.PI / 360) * 0.35 + 1440 * Math.Sin(Math.PI / 720) * 0.02 },
        };

        [TestCaseSource(nameof(Areas))]
        public void Area_IsTheOneOnPaper(string name, double area)
        {
            var mesh = CrossSectionTargets.Named(name);
            Assert.That(Enumerable.Range(0, mesh.TriangleCount).Sum(t => math.length(Normal(mesh, t)) / 2),
                Is.EqualTo(area).Within(1e-6 * area));
        }

        [TestCase("sphere_1", 4 * Math.PI / 3, 1e-4)]
        [TestCase("cylinder_0p5_0p3", Math.PI * 0.075, 1e-5)]
        public void Volume_OfClosedTargets_IsPositive(string name, double volume, double relative) =>
            AssertVolume(CrossSectionTargets.Named(name), volume, relative);

        [Test]
        public void Volume_OfTheBox_IsPositive() => AssertVolume(CrossSectionTargets.Box(0.3, 0.2, 0.01), 6e-4, 1e-6);

        // x stays, y and z are exchanged; what is seen from the open side is the outer side.
        [Test]
        public void Faces_LookWhereTheirDescriptionSays()
        {
            AssertNormals(CrossSectionTargets.Plate(0.3, 0.2), new double3(1, 0, 0));
            AssertNormals(CrossSectionTargets.Dihedral(0.3, 0.2), new double3(0, 0, 1), new double3(1, 0, 0));
            AssertNormals(CrossSectionTargets.DihedralAboutSight(0.3, 0.2, 0),
                math.normalize(new double3(1, 0, 1)), math.normalize(new double3(1, 0, -1)));
            // Turned from z-hat to -y-hat about x, by the right-hand rule: y-hat turns to z-hat.
            AssertNormals(CrossSectionTargets.DihedralAboutSight(0.3, 0.2, 90),
                math.normalize(new double3(1, 1, 0)), math.normalize(new double3(1, -1, 0)));
            AssertNormals(CrossSectionTargets.TwoPlates(0.2, 0.2, 0.3),
                math.normalize(new double3(1, 0, 1)), math.normalize(new double3(1, 0, -1)));
            AssertNormals(CrossSectionTargets.Trihedral(0.3, CrossSectionTargets.TrihedralFace.Square),
                new double3(1, 0, 0), new double3(0, 1, 0), new double3(0, 0, 1));
        }

        [Test]
        public void Bounds_AreTheSizes_InUnitysAxes()
        {
            var box = CrossSectionTargets.Box(0.3, 0.2, 0.01).Bound();
            Assert.That(math.cmax(math.abs(box.Max - new float3(0.005f, 0.1f, 0.15f))), Is.LessThan(1e-7));
            var hat = CrossSectionTargets.TopHat(0.1, 0.2, 0.6, 720).Bound();
            Assert.That(math.cmax(math.abs(hat.Max - new float3(0.6f, 0.2f, 0.6f))), Is.LessThan(1e-7));
            Assert.That(hat.Min.y, Is.Zero);
        }

        [Test]
        public void Named_OfAnUnknownTarget_IsRefusedWithItsName() =>
            Assert.That(() => CrossSectionTargets.Named("teapot"),
                Throws.ArgumentException.With.Message.Contains("'teapot'"));

        static void AssertVolume(TriangleMesh mesh, double volume, double relative) =>
            Assert.That(ShipMesh.BodyVolumes(mesh, ShipMesh.Welded(mesh)).Single(),
                Is.EqualTo(volume).Within(relative * volume));

        static void AssertNormals(TriangleMesh mesh, params double3[] expected)
        {
            var normals = Enumerable.Range(0, mesh.TriangleCount)
                .Select(t => math.normalize(Normal(mesh, t))).ToArray();
            foreach (var normal in normals)
                Assert.That(expected.Count(e => math.distance(e, normal) < 1e-6), Is.EqualTo(1), $"{normal}");
            foreach (var e in expected)
                Assert.That(normals.Any(normal => math.distance(e, normal) < 1e-6), $"{e}");
        }

        static double3 Normal(TriangleMesh mesh, int triangle)
        {
            mesh.GetTriangle(triangle, out var a, out var b, out var c);
            return math.cross((double3)b - a, (double3)c - a);
        }
    }
}
