using System;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The curved surfaces that facets stand for: normals and heights over them.</summary>
    public sealed class CurvedFacetTests : CrossSectionFixture
    {
        // Of a sphere of 1 m radius at 10 GHz: Mie's series, and what faded shadows change of physical optics.
        const double MieDbsm = 4.967, FadedDb = 0.02;

        // Arcs rise by 1/7 wavelength above the 1,728 facets, by 1/19 above the 4,800. The facets alone have 3.6 to 5.9 dBsm.
        [TestCase(12, 0.06)]
        [TestCase(20, 0.03)]
        [Timeout(60000)]
        public void Trace_SphereOfFewFacets_HasTheCrossSectionOfASphere(int cuts, double toleranceDb)
        {
            var scene = new RadarScene(CrossSectionTargets.Sphere(1, cuts));
            foreach (double azimuth in new[] { 3.0, 20, 47, 80 })
            {
                var result = Tracer.Trace(PoseOf(scene, azimuth, 10, 0.05));
                Assert.That(ScatteringMatrix.Dbsm(result.S[0, 0].VV),
                    Is.EqualTo(MieDbsm).Within(toleranceDb + FadedDb), $"azimuth {azimuth}");
                Assert.That(result.IsMet, $"azimuth {azimuth}");
            }
        }

        // The frame of the mesh is scaled, so that its normals do not transform as its vectors do.
        [Test, Timeout(60000)]
        public void Trace_ScaledSphere_IsThatOfTheReferenceTracer([Values(90, 130)] double receiverAzimuth,
            [Values(double.PositiveInfinity, 2)] double range)
        {
            var scene = new RadarScene(new MeshInstance
            {
                Mesh = CrossSectionTargets.Sphere(0.05, 12),
                ToWorld = new Affine
                {
                    X = new double3(2, 0.3, 0), Y = new double3(0, 0.8, -0.2), Z = new double3(0.4, 0, 1.5),
                    Origin = new double3(0.3, -0.2, 0.1)
                }
            });
            var pose = PoseOf(scene, 90, 25, 0.05);
            pose.Receivers = new[] { RadarAspect.At(receiverAzimuth, 25) };
            pose.Range = range;
            var result = Tracer.Trace(pose);
            var expected = new ReferenceCrossSection(scene).Compute(pose, TubeSettings.Default)[0, 0];
            double allowed = CrossSectionAccuracy.AllowedBy(pose.ToleranceDb) * expected.VV.Magnitude;
            Assert.That((result.S[0, 0].VV - expected.VV).Magnitude, Is.LessThan(allowed));
            Assert.That((result.S[0, 0].HH - expected.HH).Magnitude, Is.LessThan(allowed));
        }

        // A dish along its axis: all rays pass its focus, where both caustics are one, before they meet a wall and the dish
        // again. Where rounding hid the caustics, VV differed by a quarter.
        [Test, Timeout(60000)]
        public void Trace_OfADishAndAWallBeyondItsFocus_IsThatOfTheReferenceTracer()
        {
            const double focus = 0.25, radius = 0.25, toWall = 1.3 * focus, wall = 0.08;
            var radar = RadarAspect.At(30, 20);
            float3 At(double u, double v, double height) => (float3)(u * radar.Right + v * radar.Up + height * radar.ToRadar);
            var dish = Square(24, radius, (u, v) => At(u, v, (u * u + v * v) / (4 * focus)));
            var scene = new RadarScene(TestRadar.Join(dish, Square(1, wall, (u, v) => At(u, v, toWall))));
            var pose = PoseOf(scene, 30, 20, 0.05);
            (pose.OnlyBounce, pose.HasEdges, pose.Frequencies) = (3, false, new[] { 3e9 });
            var result = Tracer.Trace(pose).S[0, 0];
            var expected = new ReferenceCrossSection(scene).Compute(pose, TubeSettings.Default)[0, 0];
            Assert.That((result.VV - expected.VV).Magnitude, Is.LessThan(0.02 * expected.VV.Magnitude));
            Assert.That((result.HH - expected.HH).Magnitude, Is.LessThan(0.02 * expected.HH.Magnitude));
        }

        // A square of cells about the origin, half a side wide.
        static TriangleMesh Square(int cells, double half, Func<double, double, float3> at) => TestMeshes.Grid(cells, cells,
            (column, row) => at(half * (2.0 * column / cells - 1), half * (2.0 * row / cells - 1)));

        // Rays that meet a facet of a sphere: their way to the sphere itself is a root.
        [Test]
        public void LeadOf_RaysThatMeetASphere_IsTheirWayToIt()
        {
            const double radius = 2;
            const int cuts = 20;
            // Between facets, in radians. The mean normals at the corners are not quite the sphere's.
            const double bend = Math.PI / 2 / cuts, part = 0.05;
            var scene = new RadarScene(CrossSectionTargets.Sphere(radius, cuts));
            var bvh = new ReferenceBvh(scene);
            var surface = new SmoothedSurface(bvh, scene, Array.ConvertAll(scene.Instances,
                instance => SurfacePatches.Find(instance.Mesh, instance.Ranges)));
            const double sagitta = radius * bend * bend / 4;
            var random = new System.Random(1);
            for (int i = 0; i < 1000; i++)
            {
                double3 Unit() => math.normalize(new double3(random.NextDouble() - 0.5, random.NextDouble() - 0.5,
                    random.NextDouble() - 0.5));
                double3 direction = Unit(), across = math.normalize(math.cross(direction, Unit()));
                double3 start = 0.95 * radius * random.NextDouble() * across - 3 * radius * direction - bvh.Centre;
                int triangle = bvh.ClosestHit(start, direction, out double distance);
                double3 place = start + distance * direction, seen = place + bvh.Centre;
                double along = math.dot(seen, direction);
                double expected = Math.Sqrt(along * along + radius * radius - math.lengthsq(seen)) + along;
                double lead = surface.LeadOf(triangle, place, direction);
                Assert.That(lead, Is.EqualTo(expected).Within(part * sagitta * radius / -along), $"ray {i}");
                double3 normal = surface.At(triangle, place - lead * direction, direction).Normal;
                Assert.That(math.distance(normal, (seen - lead * direction) / radius), Is.LessThan(part * bend), $"ray {i}");
            }
        }

        static CrossSectionPose PoseOf(RadarScene scene, double azimuth, double elevation, double toleranceDb)
        {
            var radar = RadarAspect.At(azimuth, elevation);
            return new CrossSectionPose
            {
                Scene = scene, Radar = radar, Receivers = new[] { radar }, Frequencies = new[] { 10e9 }, MaxBounces = 4,
                ToleranceDb = toleranceDb
            };
        }
    }
}
