using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// Geometry below float32's resolution: what a ray may do there, and that it has no other effect. The cases are
    /// those of method.md, Known limits.
    /// </summary>
    [Category("Slow")]
    public sealed class DegenerateTests
    {
        const double LengthTolerance = 1e-5; // m

        // Position error that RayComparison allows float32 in a scene of this size in metres.
        static double Step(double sceneSize) => sceneSize / (1 << 22);

        [Test]
        public void Trace_RadarInATriangle_MeetsItAtOnceOrNotAtAll(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var wall = TestRadar.FacingPlate(10, 20);
            var scene = new RadarScene(TestRadar.Join(TestRadar.FacingPlate(4, 0), wall));
            var settings = TestRadar.Settings();
            var view = TestRadar.LookAt(double3(0.1, 0.2, 0), double3(3, 1, 2));
            var rays = Trace(scene, settings, view, asSoftware).Rays;
            var expected = new ReferenceTracer(new RadarPose(scene, settings, view)).TraceSame(rays);
            int atOnce = 0;
            for (int i = 0; i < rays.Length; i++)
            {
                AssertFinite(rays[i]);
                double3 direction = TestRadar.Direction(settings, view, (int)rays[i].Pixel);
                if (rays[i].Bounces == expected[i].Bounces)
                {
                    Assert.That(rays[i].RefinedPathLength,
                        Is.EqualTo(expected[i].LengthToEnd).Within(LengthTolerance), $"ray {i}");
                    continue;
                }
                // The reference tracer's ray starts on the triangle and leaves it; this ray is reflected by it at the
                // start.
                atOnce++;
                Assert.That(rays[i].Bounces, Is.EqualTo(1), $"ray {i}");
                Assert.That(distance(rays[i].LastHit, view.Position), Is.LessThan(Step(50)), $"ray {i}");
                Assert.That(distance(rays[i].Direction, direction * double3(1, 1, -1)), Is.LessThan(1e-6), $"ray {i}");
            }
            Assert.That(atOnce, Is.GreaterThan(0), "a limit that is none any more: mend method.md");

            // The remedy: a start a millimetre off the surface.
            view.Position.z += 1e-3;
            var comparison = new RayComparison(new RadarPose(scene, settings, view), LengthTolerance);
            comparison.Add(Trace(scene, settings, view, asSoftware).Rays);
            Assert.That(comparison.Wrong, Is.Zero);
            Assert.That(comparison.KernelSums.RaysHit, Is.GreaterThan(100));
        }

        // A thousand slivers 40 micrometres wide and 4 m high before a wall, each once or twice at the same position.
        [Test]
        public void Trace_CoplanarSlivers_AreMetAgainNowAndThenWhenTheyAreDuplicates([Values(1, 2)] int copies,
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            double maxWrong = copies == 1 ? 0 : 0.2;
            var slivers = Enumerable.Range(0, 1000 * copies).Select(i => -2 + 0.004f * (i / copies)).Select(x =>
                new TriangleMesh(new[] { float3(x, -2.05f, 0.13f * x), float3(x + 4e-5f, -2.05f,
                    0.13f * (x + 4e-5f) + 1e-7f), float3(x + 0.7f, 2.05f, 0.13f * x + 1.3f) }, new[] { 0, 1, 2 }));
            var scene = new RadarScene(TestRadar.Join(slivers.Append(TestRadar.FacingPlate(30, -12)).ToArray()));
            var settings = TestRadar.Settings(320, 180);
            var view = TestRadar.LookAt(double3(0.3, 0.2, -10), 0, fov: 20);
            var result = Trace(scene, settings, view, asSoftware);
            var comparison = new RayComparison(new RadarPose(scene, settings, view), LengthTolerance);
            comparison.Add(result.Rays);
            foreach (var ray in result.Rays)
            {
                AssertFinite(ray);
                Assert.That(ray.Bounces, Is.LessThanOrEqualTo(settings.MaxBounces));
            }
            // The first hit is always right.
            Assert.That(result.RaysHit,
                Is.EqualTo(new ReferenceTracer(new RadarPose(scene, settings, view)).TraceAll()
                    .Count(ray => ray.Bounces > 0)).Within(3));
            Assert.That(result.RaysHit, Is.GreaterThan(100));
            Assert.That(comparison.Wrong, Is.LessThanOrEqualTo(maxWrong * result.RaysHit));
        }

        // A hundred-millionth and a ten-millionth of the distance, before a 130 m wall.
        [Test]
        public void Trace_TriangleSmallerThanAStep_IsMetNearItOrNotAtAll([Values(1e-6f, 1e-5f)] float size,
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            float3 corner = float3(31.7f, 12.3f, 45.1f);
            var tiny = new TriangleMesh(
                new[] { corner, corner + size * float3(1, 0, 0.1f), corner + size * float3(0, 1, 0.2f) },
                new[] { 0, 1, 2 });
            var scene = new RadarScene(TestRadar.Join(tiny, TestRadar.FacingPlate(130, 65)));
            double3 from = double3(-20, 5, -60), to = (double3)corner - from;
            double there = length(to),
                step = Step(2 * new ReferenceTracer(new RadarPose(scene, TestRadar.Settings(), default)).SceneRadius);
            var settings = TestRadar.Settings(100, 100, 1);
            var view = TestRadar.LookAt(from, corner, fov: degrees(4 * step / there));
            int met = 0;
            foreach (var ray in Trace(scene, settings, view, asSoftware).Rays)
            {
                AssertFinite(ray);
                Assert.That(ray.Bounces, Is.EqualTo(1));
                double3 direction = TestRadar.Direction(settings, view, (int)ray.Pixel);
                double toWall = (65 - from.z) / direction.z;
                if (abs(ray.RefinedPathLength - toWall) < 10 * step)
                    continue;
                met++;
                Assert.That(ray.RefinedPathLength, Is.EqualTo(there).Within(10 * step),
                    "neither the triangle nor the wall");
                Assert.That(length(cross(direction, to)), Is.LessThan(2 * size + step), "aside of the triangle");
            }
            // Rays are dense enough for the larger triangle to fill part of the picture.
            Assert.That(met, size > 5e-6f ? Is.GreaterThan(0) : Is.GreaterThanOrEqualTo(0));
        }

        // Ray spacing of 3e-10 m, across the edges of trihedrals of any rotation.
        [Test]
        public void Trace_RaysFarNearerToAnEdgeThanAStep_GoTheWayOfARayBeside(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            const double spacing = 3e-10;
            var random = new System.Random(1);
            double Next() => random.NextDouble();
            var settings = TestRadar.Settings(32, 18);
            long rays = 0, received = 0;
            using (var tracer = new RayTracer(TestKernels.Trace, "test", asSoftware))
                for (int pose = 0; pose < 40; pose++)
                {
                    var transform = Affine.FromTransform(double3(1, -2, 3),
                        double4(Next() - 0.5, Next() - 0.5, Next() - 0.5, Next() - 0.5), 1);
                    double3 onEdge = 0;
                    onEdge[pose % 3] = 0.2 + 3 * Next();
                    double3 at = transform.Point(onEdge),
                        back = transform.Vector(normalize(0.3 + double3(Next(), Next(), Next())));
                    var view = TestRadar.LookAt(at + 10 * back, at);
                    view.ApertureHeight = settings.RaysDown * spacing;
                    view.ReceiverSize = 10;
                    var scene =
                        new RadarScene(new MeshInstance { Mesh = TestRadar.Trihedral(0, 4), ToWorld = transform });
                    var comparison = new RayComparison(new RadarPose(scene, settings, view), LengthTolerance);
                    var result = tracer.Trace(new RadarPose(scene, settings, view), RayReadback.All);
                    foreach (var ray in result.Rays)
                        AssertFinite(ray);
                    comparison.Add(result.Rays);
                    Assert.That(comparison.Wrong, Is.Zero, $"pose {pose}");
                    Assert.That(comparison.LargestLengthDifference, Is.LessThan(1e-7), $"pose {pose}");
                    rays += comparison.Rays;
                    received += comparison.KernelSums.RaysReceived;
                }
            Assert.That(received, Is.GreaterThan(rays / 4));
        }

        // Every triangle twice, and all of them small in their scene: a hit's position has the rounding of the scene.
        [Test]
        public void Trace_PlateThatIsThereTwiceInASceneOfKilometres_IsMetOnce(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware,
            [Values(100, 1e4)] double sceneSize)
        {
            var plate = TestRadar.FacingPlate(10, 0);
            var transform =
                Affine.FromTransform(double3(-0.31, 0.17, 0.23) * sceneSize, double4(0.1, -0.2, 0.05, 0.97), 1);
            var scene = new RadarScene(new MeshInstance { Mesh = TestRadar.Join(plate, plate), ToWorld = transform },
                new MeshInstance
                {
                    Mesh = TestRadar.FacingPlate(1, 0),
                    ToWorld = Affine.FromTransform(sceneSize / 2, double4(0, 0, 0, 1), 1)
                },
                new MeshInstance
                {
                    Mesh = TestRadar.FacingPlate(1, 0),
                    ToWorld = Affine.FromTransform(-sceneSize / 2, double4(0, 0, 0, 1), 1)
                });
            var view = TestRadar.LookAt(transform.Point(double3(0.1, 0.2, -40)), transform.Origin, fov: 10);
            view.ReceiverSize = 30;
            var result = Trace(scene, TestRadar.Settings(), view, asSoftware);
            // At normal incidence every ray returns within twice its distance from the axis.
            Assert.That(result.RaysHit, Is.GreaterThan(8000));
            Assert.That(result.RaysReceived, Is.EqualTo(result.RaysHit));
            Assert.That(result.Bounces, Is.EqualTo(result.RaysHit));
        }

        // Strips a thousand times as long as wide. Their normals must be accurate enough for a receiver 10 km away.
        [Test]
        public void Trace_PlateOfLongStripsFarAway_ReceivesWhatTheReferenceDoes(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            const int strips = 200;
            const float width = 0.1f, side = 100;
            var plates = Enumerable.Range(0, strips).Select(i => TestRadar.Plate(
                float3(-side / 2, width * (i - strips / 2), 0), float3(side, 0, 0), float3(0, width, 0))).ToArray();
            var transform = Affine.FromTransform(double3(3, -2, 1), double4(0.3, -0.5, 0.2, 0.7), 1);
            // Rotated in the mesh itself, so that no coordinate is a short number.
            var joined = TestRadar.Join(plates);
            var scene = new RadarScene(new TriangleMesh(
                System.Array.ConvertAll(joined.Vertices, vertex => (float3)transform.Point(vertex)), joined.Indices));
            double3 forward = normalize(transform.Vector(double3(0, 0, 1)));
            var view = TestRadar.LookAt(transform.Origin - 1e4 * forward, transform.Origin, fov: degrees(20 / 1e4));
            view.ReceiverSize = 4; // rays within 1 m of the axis, except for rounded corners
            var settings = TestRadar.Settings(320, 180);
            var received = Trace(scene, settings, view, asSoftware).Rays.Where(ray => ray.IsReceived)
                .Select(ray => (int)ray.Pixel).ToArray();
            var references = new ReferenceTracer(new RadarPose(scene, settings, view)).TraceAll();
            // 180 rays over 20 m: a spacing of 0.11 m.
            Assert.That(received,
                Is.EqualTo(Enumerable.Range(0, references.Length).Where(i => references[i].Received)));
            Assert.That(received.Length, Is.GreaterThan(200));
        }

        static RadarResult Trace(RadarScene scene, in RadarSettings settings, in RadarView view, bool asSoftware)
        {
            using (var tracer = new RayTracer(TestKernels.Trace, "test", asSoftware))
            {
                var result = tracer.Trace(new RadarPose(scene, TestRadar.WithoutError(settings), view), RayReadback.All);
                Assert.That(double.IsNaN(result.InPhase) || double.IsNaN(result.Quadrature)
                    || double.IsInfinity(result.PathLengthMeters) || double.IsNaN(result.PathLengthMeters), Is.False);
                return result;
            }
        }

        static void AssertFinite(in RayData ray) =>
            Assert.That(all(isfinite(ray.LastHit)) && all(isfinite(ray.Direction)) && isfinite(ray.RefinedPathLength),
                Is.True, "a number that is none");
    }
}
