using System;
using System.Collections.Concurrent;
using System.Linq;
using System.Threading;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The reference tracer against answers on paper and against a loop over all triangles.</summary>
    public sealed class ReferenceTracerTests
    {
        const double Nanometre = 1e-9;

        [Test]
        public void Trace_FacingPlate_PathLengthIsThatFromTheMirrorImageOfTheCamera()
        {
            const float distance = 20;
            var settings = TestRadar.Settings();
            var view = TestRadar.LookAt(0, double3(0, 0, 1));
            var rays = new ReferenceTracer(
                new RadarPose(new RadarScene(TestRadar.FacingPlate(4, distance)), settings, view)).TraceAll();

            int expected = 0;
            for (int pixel = 0; pixel < rays.Length; pixel++)
            {
                double3 d = TestRadar.Direction(settings, view, pixel);
                double2 onPlate = distance * d.xy / d.z;
                // The mirror image is at 2 x 20 m; the receiver plane is 0.2 m behind the camera.
                double2 onReceiver = (2 * distance + TestRadar.ReceiverBehindCamera) * d.xy / d.z;
                bool hits = all(abs(onPlate) <= 2), returns = hits && all(abs(onReceiver) <= 1.5);
                Assert.That(rays[pixel].Bounces, Is.EqualTo(hits ? 1 : 0), $"pixel {pixel}");
                Assert.That(rays[pixel].Received, Is.EqualTo(returns), $"pixel {pixel}");
                if (!returns)
                    continue;
                expected++;
                Assert.That(rays[pixel].PathLength,
                    Is.EqualTo((2 * distance + TestRadar.ReceiverBehindCamera) / d.z).Within(Nanometre),
                    $"pixel {pixel}");
            }
            Assert.That(expected, Is.GreaterThan(10));
        }

        [Test]
        public void Trace_Trihedral_RayReturnsAlongItselfFromThePointMirroredInTheVertex()
        {
            double3 vertex = double3(1, -2, 3);
            var settings = TestRadar.Settings();
            var view = TestRadar.LookAt(vertex + double3(9, 10, 11), vertex, fov: 20);
            var rays = new ReferenceTracer(
                new RadarPose(new RadarScene(TestRadar.Trihedral((float3)vertex, 4)), settings, view)).TraceAll();

            double3 image = 2 * vertex - view.Position;
            var triple = Enumerable.Range(0, rays.Length)
                .Where(pixel => rays[pixel].Received && rays[pixel].Bounces == 3).ToArray();
            Assert.That(triple, Is.Not.Empty);
            foreach (int pixel in triple)
            {
                double3 back = -TestRadar.Direction(settings, view, pixel);
                double length = dot(view.ReceiverCentre - image, view.Forward) / dot(back, view.Forward);
                Assert.That(rays[pixel].PathLength, Is.EqualTo(length).Within(Nanometre), $"pixel {pixel}");
            }
        }

        [Test]
        public void Trace_DihedralWithLevelEdge_RayReturnsAtTheElevationItCame()
        {
            // Floor and wall intersect in the x axis; viewed from straight ahead at 30 degrees elevation.
            var scene = TestRadar.Join(
                TestRadar.Plate(float3(-5, 0, 0), float3(10, 0, 0), float3(0, 0, -5)),
                TestRadar.Plate(float3(-5, 0, 0), float3(10, 0, 0), float3(0, 5, 0)));
            var settings = TestRadar.Settings();
            var view = TestRadar.LookAt(20 * double3(0, 0.5, -sqrt(0.75)), 0, fov: 20);
            var rays = new ReferenceTracer(new RadarPose(new RadarScene(scene), settings, view)).TraceAll();

            // Reflected in floor and wall, the camera is at (x, -y, -z).
            double3 image = view.Position * double3(1, -1, -1);
            var twice = Enumerable.Range(0, rays.Length)
                .Where(pixel => rays[pixel].Received && rays[pixel].Bounces == 2).ToArray();
            Assert.That(twice, Is.Not.Empty);
            foreach (int pixel in twice)
            {
                double3 back = TestRadar.Direction(settings, view, pixel) * double3(1, -1, -1);
                double length = dot(view.ReceiverCentre - image, view.Forward) / dot(back, view.Forward);
                Assert.That(rays[pixel].PathLength, Is.EqualTo(length).Within(Nanometre), $"pixel {pixel}");
            }
        }

        [Test]
        public void TraceAll_Instances_AreTheTrianglesAtTheirPlacesCountedInOrder()
        {
            // One rotated and stretched, one mirrored.
            var clutter = TestRadar.Clutter(60, 3);
            var transform = new Affine
            {
                X = double3(0, -2, 0), Y = double3(1, 0, 0), Z = double3(0, 0, 2), Origin = double3(4, -3, 7)
            };
            Assert.That(transform.Determinant, Is.EqualTo(4));
            var mirror = new Affine
            {
                X = double3(-1, 0, 0), Y = double3(0, 1, 0), Z = double3(0, 0, 1), Origin = double3(0, 16, 0)
            };
            var scene = new RadarScene(new MeshInstance { Mesh = clutter, ToWorld = transform },
                new MeshInstance { Mesh = clutter, ToWorld = mirror });
            var settings = TestRadar.Settings();
            var view = TestRadar.LookAt(double3(3, 14, -45), 0);
            var rays = new ReferenceTracer(new RadarPose(scene, settings, view)).TraceAll();

            var flat = TestRadar.Join(Placed(clutter, transform), Placed(clutter, mirror));
            int hits = 0;
            for (int pixel = 0; pixel < rays.Length; pixel++)
            {
                if (rays[pixel].Bounces != 1)
                    continue;
                hits++;
                int expected = BruteForce.ClosestHit(flat, view.Position,
                    TestRadar.Direction(settings, view, pixel), out double distance);
                Assert.That(rays[pixel].LastTriangle, Is.EqualTo(expected), $"pixel {pixel}");
                // The corners of the flat mesh are rounded to float32.
                Assert.That(rays[pixel].LengthToLastHit, Is.EqualTo(distance).Within(1e-4), $"pixel {pixel}");
            }
            Assert.That(hits, Is.GreaterThan(100));
            Assert.That(rays.Max(ray => ray.LastTriangle), Is.GreaterThanOrEqualTo(60));
        }

        [Test]
        public void TraceAll_Region_IsThatPartOfThePicture()
        {
            var scene = new RadarScene(TestRadar.Clutter(100, 3));
            var settings = TestRadar.Settings();
            var view = TestRadar.LookAt(double3(3, 14, -25), 0);
            var whole = new ReferenceTracer(new RadarPose(scene, settings, view)).TraceAll();
            settings.Region = new RayRegion { Left = 70, Bottom = 31, Width = 40, Height = 17 };
            var referenceTracer = new ReferenceTracer(new RadarPose(scene, settings, view));
            var part = referenceTracer.TraceAll();
            Assert.That(referenceTracer.Sum(part).RaysEmitted, Is.EqualTo(40 * 17));
            Assert.That(referenceTracer.Sum(part).RaysHit, Is.GreaterThan(100));
            for (int i = 0; i < part.Length; i++)
                Assert.That(part[i], Is.EqualTo(whole[(31 + i / 40) * 160 + 70 + i % 40]), $"ray {i}");
        }

        [Test]
        public void Trace_BetweenTheMiddlesOfPixels_IsTheRayOfAFinerPicture([Values] bool isParallel)
        {
            var scene = new RadarScene(TestRadar.Clutter(100, 3));
            var view = TestRadar.LookAt(double3(3, 14, -25), 0);
            view.ApertureHeight = isParallel ? 20 : 0;
            var referenceTracer = new ReferenceTracer(new RadarPose(scene, TestRadar.Settings(160, 90), view));
            var finer = new ReferenceTracer(new RadarPose(scene, TestRadar.Settings(480, 270), view)).TraceAll();
            Assert.That(finer.Count(ray => ray.Bounces > 0), Is.GreaterThan(1000));
            for (int pixel = 0; pixel < finer.Length; pixel++)
            {
                var ray = referenceTracer.Trace((pixel % 480 - 1) / 3.0, (pixel / 480 - 1) / 3.0);
                Assert.That(ray.PathHash, Is.EqualTo(finer[pixel].PathHash), $"ray {pixel}");
                Assert.That(ray.LengthToLastHit,
                    Is.EqualTo(finer[pixel].LengthToLastHit).Within(Nanometre), $"ray {pixel}");
            }
        }

        [Test]
        public void Trace_ParallelRays_StartInTheMiddlesOfTheCellsOfTheAperture()
        {
            // 3 x 2 cells of 2 m without a hit.
            var view = TestRadar.LookAt(double3(1, 2, 3), double3(1, 2, 103));
            view.ApertureHeight = 4;
            var referenceTracer =
                new ReferenceTracer(new RadarPose(new RadarScene(TestRadar.Empty), TestRadar.Settings(3, 2), view));
            var rays = referenceTracer.TraceAll();
            Assert.That(rays.Select(ray => ray.LastHit), Is.EqualTo(new[] { double3(-1, 1, 3), double3(1, 1, 3),
                double3(3, 1, 3), double3(-1, 3, 3), double3(1, 3, 3), double3(3, 3, 3) }));
            Assert.That(rays.Select(ray => ray.Direction), Is.All.EqualTo(double3(0, 0, 1)));
            Assert.That(referenceTracer.Sum(rays).RayArea, Is.EqualTo(4));
        }

        [Test]
        public void Trace_OfTheSameSceneFarAway_IsTheSame()
        {
            // The sums of coordinates have an error of 2e-10 m at a thousand kilometres.
            var clutter = TestRadar.Clutter(200, 3);
            double3 far = double3(1e6, -3e5, 2e6);
            var moved = Affine.Identity;
            moved.Origin = far;
            var near = new ReferenceTracer(new RadarPose(new RadarScene(clutter), TestRadar.Settings(),
                TestRadar.LookAt(double3(3, 14, -25), 0))).TraceAll();
            var away =
                new ReferenceTracer(new RadarPose(new RadarScene(new MeshInstance { Mesh = clutter, ToWorld = moved }),
                    TestRadar.Settings(), TestRadar.LookAt(far + double3(3, 14, -25), far))).TraceAll();
            Assert.That(near.Count(ray => ray.Bounces > 1), Is.GreaterThan(100));
            for (int pixel = 0; pixel < near.Length; pixel++)
            {
                Assert.That(away[pixel].PathHash, Is.EqualTo(near[pixel].PathHash), $"pixel {pixel}");
                Assert.That(away[pixel].LengthToLastHit,
                    Is.EqualTo(near[pixel].LengthToLastHit).Within(1e-8), $"pixel {pixel}");
            }
        }

        [Test]
        public void TraceAll_WithProgress_EndsAtOneAndCanBeCancelled()
        {
            var referenceTracer = new ReferenceTracer(new RadarPose(new RadarScene(TestRadar.Clutter(100, 3)),
                TestRadar.Settings(), TestRadar.LookAt(double3(3, 14, -25), 0)));
            var progress = new Reports();
            referenceTracer.TraceAll(progress);
            Assert.That(progress.Values.Max(), Is.EqualTo(1));
            Assert.That(progress.Values.Count, Is.EqualTo(90));
            using (var cancel = new CancellationTokenSource())
            {
                progress.OnReport = cancel.Cancel;
                Assert.That(() => referenceTracer.TraceAll(progress, cancel.Token),
                    Throws.InstanceOf<OperationCanceledException>());
            }
        }

        [Test]
        public void Sum_EmptyScene_EmitsEveryRayAndHitsNothing()
        {
            var referenceTracer =
                new ReferenceTracer(new RadarPose(new RadarScene(TestRadar.Empty), TestRadar.Settings(),
                    TestRadar.LookAt(0, double3(0, 0, 1))));
            var result = referenceTracer.Sum(referenceTracer.TraceAll());
            Assert.That(result.RaysEmitted, Is.EqualTo(160 * 90));
            Assert.That(result.Segments, Is.EqualTo(160 * 90));
            Assert.That(result.RaysHit, Is.Zero);
            Assert.That(result.Ratio, Is.Zero);
        }

        static TriangleMesh Placed(TriangleMesh mesh, Affine transform) =>
            new TriangleMesh(Array.ConvertAll(mesh.Vertices, v => (float3)transform.Point(v)), mesh.Indices);

        sealed class Reports : IProgress<double>
        {
            public readonly ConcurrentBag<double> Values = new ConcurrentBag<double>();
            public Action OnReport = () => { };

            public void Report(double value)
            {
                Values.Add(value);
                OnReport();
            }
        }
    }
}
