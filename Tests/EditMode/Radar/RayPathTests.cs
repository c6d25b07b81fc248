using System;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// Paths of single rays against the reference tracer, which is stopped after each bounce in turn.
    /// </summary>
    public sealed class RayPathTests
    {
        const int Bounces = 5;

        // For a scene of 20 m in float32.
        const double Near = 2e-5;

        static readonly RadarSettings s_settings = TestRadar.Settings(64, 36, Bounces);

        static RadarScene Scene => new RadarScene(
            new MeshInstance { Mesh = TestRadar.Clutter(300, seed: 5), ToWorld = Affine.Identity },
            new MeshInstance
            {
                Mesh = TestRadar.Trihedral(0, 6),
                ToWorld = Affine.FromTransform(double3(-1, 2, 3), double4(0.1, 0.7, -0.3, 0.6), double3(1, 1, -1.2))
            });

        [Test]
        public void TracePaths_EveryBounce_IsWhereTheReferenceHasItAndOnItsTriangle(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware,
            [Values] bool isParallel)
        {
            var scene = Scene;
            var view = TestRadar.LookAt(double3(3, 8, -24), 0, fov: 50);
            if (isParallel)
                view.ApertureHeight = 18;
            var pixels = Enumerable.Range(0, (int)s_settings.RayCount)
                .Select(i => (uint)((i * 7919L) % s_settings.RayCount)).ToArray();
            RayPath[] paths;
            RayData[] rays;
            using (var tracer = new RayTracer(TestKernels.Trace, "test", asSoftware))
            {
                paths = tracer.TracePaths(new RadarPose(scene, s_settings, view), pixels);
                rays = tracer.Trace(new RadarPose(scene, s_settings, view), RayReadback.All).Rays;
                Assert.That(tracer.ReceivedPixels(),
                    Is.EqualTo(rays.Where(ray => ray.IsReceived).Select(ray => ray.Pixel)));
            }
            int others = 0, compared = 0;
            for (int bounce = 1; bounce <= Bounces; bounce++)
            {
                var settings = s_settings;
                settings.MaxBounces = bounce;
                var referenceTracer = new ReferenceTracer(new RadarPose(scene, settings, view));
                foreach (var path in paths.Where(path => path.Bounces >= bounce))
                {
                    var reference =
                        referenceTracer.Trace((int)path.Pixel % settings.RaysAcross,
                            (int)path.Pixel / settings.RaysAcross);
                    var hit = path.Hits[bounce - 1];
                    compared++;
                    if (reference.Bounces != bounce || reference.LastTriangle != TestRadar.NumberOf(scene, hit)
                        || distance(reference.LastHit, hit.Position) > Near
                        || distance(reference.Direction, hit.Direction) > Near)
                        others++;
                }
            }
            Assert.That(compared, Is.GreaterThan(1000));
            Assert.That(others, Is.LessThanOrEqualTo(1), "at an edge");
            Assert.That(paths.Select(path => path.Pixel), Is.EqualTo(pixels));
            Assert.That(paths.Max(path => path.Bounces), Is.GreaterThan(2));
            AssertAsTraced(paths, rays, view);
        }

        [Test]
        public void TracePaths_SceneAndReceivedRaysOfACorner_GoToTheReceiversPlane()
        {
            var settings = TestRadar.Settings(96, 54);
            var view = TestRadar.LookAt(double3(12, 11, 13), 0.4, fov: 6);
            using (var tracer = new RayTracer(TestKernels.Trace))
            {
                var pose = new RadarPose(new RadarScene(TestRadar.Trihedral(0, 2)), settings, view);
                long received = tracer.Trace(pose, RayReadback.None).RaysReceived;
                var paths = tracer.TracePaths(pose, tracer.ReceivedPixels());
                Assert.That(received, Is.GreaterThan(100));
                Assert.That(paths.Length, Is.EqualTo(received));
                foreach (var path in paths)
                {
                    Assert.That(path.IsReceived, Is.True);
                    Assert.That(abs(dot(path.End.Value - view.ReceiverCentre, view.ReceiverForward)),
                        Is.LessThan(1e-5));
                    Assert.That(path.Hits.Select(hit => hit.Object), Is.All.EqualTo(MeshRange.NoObject));
                    Assert.That(path.Points(), Has.Length.EqualTo(path.Bounces + 2));
                }
                // A corner reflector: three walls, and back in the direction of incidence.
                Assert.That(paths.Count(path => path.Bounces == 3
                        && distance(path.Hits[2].Direction, -normalize(path.Hits[0].Position - path.Start)) < 1e-5),
                    Is.EqualTo(paths.Count(path => path.Bounces == 3)).And.GreaterThan(100));
            }
        }

        [Test]
        public void TracePaths_PixelBesideThePicture_IsRefused()
        {
            using (var tracer = new RayTracer(TestKernels.Trace))
            {
                var problem = Assert.Throws<GlintException>(
                    () => tracer.TracePaths(new RadarPose(new RadarScene(TestRadar.FacingPlate(4, 10)), s_settings,
                            TestRadar.LookAt(0, double3(0, 0, 1))),
                        new[] { 5u, 64u * 36 }));
                Assert.That(problem.Message, Does.Contain("no pixel 2304").And.Contain("64 x 36"));
                Assert.That(
                    tracer.TracePaths(new RadarPose(new RadarScene(TestRadar.FacingPlate(4, 10)), s_settings,
                        TestRadar.LookAt(0, double3(0, 0, 1))), new uint[0]), Is.Empty);
            }
        }

        [Test]
        public void TracePaths_EmptyScene_HasNoReflections()
        {
            using (var tracer = new RayTracer(TestKernels.Trace))
            {
                var path = tracer.TracePaths(
                    new RadarPose(new RadarScene(TestRadar.Empty), s_settings, TestRadar.LookAt(1, 5)), new[] { 3u })
                    .Single();
                Assert.That((path.Bounces, path.IsReceived, distance(path.Start, 1)), Is.EqualTo((0, false, 0.0)));
            }
        }

        // The same rays as one by one; the fast kernel may differ at an edge.
        static void AssertAsTraced(RayPath[] paths, RayData[] rays, RadarView view)
        {
            var received = paths.Where(path => path.IsReceived).ToArray();
            Assert.That(received.Select(path => path.Pixel).OrderBy(pixel => pixel),
                Is.EqualTo(rays.Where(ray => ray.IsReceived).Select(ray => ray.Pixel)));
            foreach (var path in received)
            {
                var points = path.Points();
                double length = Enumerable.Range(1, points.Length - 1).Sum(i => distance(points[i - 1], points[i]));
                Assert.That(length, Is.EqualTo(rays[path.Pixel].RefinedPathLength).Within(5 * Near));
            }
            foreach (var path in paths)
                Assert.That(distance(path.Start,
                        view.IsParallel ? TestRadar.Start(s_settings, view, (int)path.Pixel) : view.Position),
                    Is.LessThan(1e-12));
            Assert.That(paths.Count(path => path.Bounces != rays[path.Pixel].Bounces), Is.LessThanOrEqualTo(1));
        }

        // A triangle's number over all instances, as in the reference tracer.
    }
}
