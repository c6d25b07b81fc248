using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Culling, caching and tiling never change a result.</summary>
    public sealed class TracerTests
    {
        static readonly RadarSettings s_settings = TestRadar.Settings(333, 187);
        static readonly RadarView s_view = TestRadar.LookAt(double3(9, 10, 11), 0, fov: 40);

        // A corner reflector among clutter, and a wall behind the receiver: rays that return, rays that are lost, and
        // sky.
        static TriangleMesh Scene =>
            TestRadar.Join(TestRadar.Trihedral(0, 4), TestRadar.Clutter(300, seed: 5, halfSide: 4, largest: 0.3f),
                TestRadar.Plate(float3(10, 12, 25), float3(20, 0, 0), float3(0, 20, 0)));

        static RayTracer Tracer(bool asSoftware = TestKernels.HasWide) =>
            new RayTracer(TestKernels.Trace, "test", asSoftware);

        static RadarPose PoseOf(RadarScene scene) => new RadarPose(scene, s_settings, s_view);

        static RadarResult Pose(Action<RayTracer> change = null, RayReadback readback = RayReadback.None,
            bool asSoftware = TestKernels.HasWide, RadarSettings? settings = null)
        {
            using (var tracer = Tracer(asSoftware))
            {
                change?.Invoke(tracer);
                return tracer.Trace(new RadarPose(new RadarScene(Scene), settings ?? s_settings, s_view), readback);
            }
        }

        static void AssertSame(RadarResult actual, RadarResult expected)
        {
            Assert.That(BitConverter.DoubleToInt64Bits(actual.InPhase),
                Is.EqualTo(BitConverter.DoubleToInt64Bits(expected.InPhase)), "I");
            Assert.That(BitConverter.DoubleToInt64Bits(actual.Quadrature),
                Is.EqualTo(BitConverter.DoubleToInt64Bits(expected.Quadrature)), "Q");
            Assert.That(BitConverter.DoubleToInt64Bits(actual.PathLengthMeters),
                Is.EqualTo(BitConverter.DoubleToInt64Bits(expected.PathLengthMeters)), "path length");
            Assert.That(actual.RaysHit, Is.EqualTo(expected.RaysHit));
            Assert.That(actual.RaysReceived, Is.EqualTo(expected.RaysReceived));
            Assert.That(actual.Bounces, Is.EqualTo(expected.Bounces));
            Assert.That(actual.Segments, Is.EqualTo(expected.Segments));
            Assert.That(actual.PhaseHistogram, Is.EqualTo(expected.PhaseHistogram));
            Assert.That(actual.SamplingError, Is.EqualTo(expected.SamplingError), "sampling error");
            Assert.That(actual.LargestPathStep, Is.EqualTo(expected.LargestPathStep));
        }

        [Test]
        public void Trace_WithAnyShortcutSwitchedOff_SumsAreTheSameBitForBit(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var all = Pose(asSoftware: asSoftware);
            Assert.That(all.RaysReceived, Is.GreaterThan(100));
            Assert.That(all.Statistics.TilesSkipped, Is.GreaterThan(100));
            foreach (var off in new[]
            {
                Culling.Reach, Culling.LastSegment, Culling.Tiles, Culling.EntryPoints, Culling.All
            })
                AssertSame(Pose(tracer => tracer.Culling = Culling.All & ~off, asSoftware: asSoftware), all);
        }

        // All but the entry points, which counting kernels do not use: see EntryPointsTests.
        [Test]
        public void Culling_EachSaveWork()
        {
            long Visits(Culling off) => Pose(tracer =>
            {
                tracer.CountVisits = true;
                tracer.Culling = Culling.All & ~off;
            }).Statistics is var work ? work.NodesVisited + work.PairsTested + work.TilesTraced : 0;
            long all = Visits(Culling.None);
            Assert.That(all, Is.GreaterThan(0));
            foreach (var off in new[] { Culling.Reach, Culling.LastSegment, Culling.Tiles })
                Assert.That(Visits(off), Is.GreaterThan(all), off.ToString());
        }

        /// <summary>
        /// Sums cleared; rays, their number, refine pass; pixels chosen, their number; sub-rays, their number, refine
        /// pass; lengths forgotten.
        /// </summary>
        public const int DispatchesOfAPose = 10;

#if GLINT_HOST
        [Test]
        public void Trace_OnADeviceWithoutIndirectDispatch_GivesTheSameInMoreRoundTrips()
        {
            var expected = Pose(tracer => tracer.TilesADispatch = int.MaxValue);
            Host.GraphicsDevice.HasIndirectArguments = false;
            try
            {
                var result = Pose(tracer => tracer.TilesADispatch = int.MaxValue);
                AssertSame(result, expected);
                Assert.That(result.SamplingError, Is.EqualTo(expected.SamplingError), "by pixels chosen here");
                Assert.That(result.Statistics.SubRays, Is.EqualTo(expected.Statistics.SubRays));
                Assert.That((expected.Statistics.RoundTrips, result.Statistics.RoundTrips), Is.EqualTo((1, 4)));
            }
            finally
            {
                Host.GraphicsDevice.HasIndirectArguments = true;
            }
        }

        [Test]
        public void Trace_OnADeviceWithoutAsyncReadback_GivesTheSame()
        {
            var expected = Pose();
            Host.GraphicsDevice.HasAsyncReadback = false;
            try
            {
                var result = Pose();
                AssertSame(result, expected);
                Assert.That(result.SamplingError, Is.EqualTo(expected.SamplingError));
            }
            finally
            {
                Host.GraphicsDevice.HasAsyncReadback = true;
            }
        }
#endif

        [Test]
        public void Trace_InManyDispatches_SumsAndRaysAreThoseOfOne()
        {
            var inOne = Pose(tracer => tracer.TilesADispatch = int.MaxValue, RayReadback.Received);
            var inMany = Pose(tracer => tracer.TilesADispatch = 37, RayReadback.Received);
            // A GPU does not search entry points for this few tiles.
            int entryPoints = TestKernels.HasWide ? 1 : 0;
            Assert.That(inOne.Statistics.Dispatches, Is.EqualTo(DispatchesOfAPose + entryPoints));
            Assert.That(inOne.Statistics.RoundTrips, Is.EqualTo(2), "sums, and the rays kept");
            long slices = (inMany.Statistics.TilesTraced + 36) / 37;
            // Sums cleared, rays, their number, refine pass; the same for the sub-rays of pixels chosen at the end.
            Assert.That(inMany.Statistics.Dispatches, Is.EqualTo((4 + entryPoints) * slices + 4));
            Assert.That(inMany.Statistics.RoundTrips, Is.InRange(slices + 2, 2 * slices + 1));
            Assert.That(inMany.Statistics.RaysRefined, Is.EqualTo(inOne.Statistics.RaysRefined));
            Assert.That(inMany.Statistics.SubRays, Is.EqualTo(inOne.Statistics.SubRays));
            AssertSame(inMany, inOne);
            Assert.That(inMany.Rays, Is.EqualTo(inOne.Rays));
        }

        [Test]
        public void Trace_InGroupsOfOtherSizes_SumsAreTheSameBitForBit()
        {
            var scene = new RadarScene(Scene);
            var pair = new RadarScene(scene.Instances[0], new MeshInstance
            {
                Mesh = TestRadar.FacingPlate(3, 0),
                ToWorld = Affine.FromTransform(double3(-6, 1, 2), double4(0.1, 0.2, 0.3, 1), 1)
            });
            foreach (var some in new[] { scene, pair })
                using (var tracer = Tracer(asSoftware: false))
                using (var other = new RayTracer(TestKernels.OtherGroups, "test", false))
                {
                    var result = other.Trace(PoseOf(some), RayReadback.None);
                    Assert.That(result.RaysReceived, Is.GreaterThan(100));
                    AssertSame(result, tracer.Trace(PoseOf(some), RayReadback.None));
                }
        }

        // Traversed in turn, and through a BVH over them.
        [Test]
        public void Trace_InstancesInAnotherOrder_SumsAreTheSameBitForBit([Values(3, 12)] int count,
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var random = new System.Random(count);
            double Next() => 2 * random.NextDouble() - 1;
            var instances = new List<MeshInstance>
            {
                new MeshInstance { Mesh = TestRadar.Trihedral(0, 4), ToWorld = Affine.Identity }
            };
            for (int i = 1; i < count; i++)
                instances.Add(new MeshInstance
                {
                    Mesh = TestRadar.Clutter(40, seed: (uint)i, halfSide: 2, largest: 0.4f),
                    ToWorld = Affine.FromTransform(4 * double3(Next(), Next(), Next()),
                        double4(Next(), Next(), Next(), Next()), double3(1, Next() < 0 ? -1 : 1, 1.3)),
                });
            RadarResult Sums()
            {
                using (var tracer = Tracer(asSoftware))
                    return tracer.Trace(PoseOf(new RadarScene(instances.ToArray())), RayReadback.None);
            }
            var expected = Sums();
            Assert.That(expected.RaysReceived, Is.GreaterThan(100));
            for (int turn = 0; turn < 3; turn++)
            {
                instances = instances.OrderBy(instance => random.Next()).ToList();
                AssertSame(Sums(), expected);
            }
        }

        [Test]
        public void Trace_KeepingAllRaysInManyDispatches_HasThemInOrderOfTheirPixel()
        {
            var rays = Pose(tracer => tracer.TilesADispatch = 37, RayReadback.All).Rays;
            Assert.That(rays.Select(ray => ray.Pixel), Is.EqualTo(Enumerable.Range(0, 333 * 187).Select(i => (uint)i)));
        }

        [Test]
        public void Trace_KeepingNoneReceivedOrAll_SumsAreTheSameBitForBit()
        {
            void InOneDispatch(RayTracer tracer) => tracer.TilesADispatch = int.MaxValue;
            var none = Pose(InOneDispatch);
            var received = Pose(InOneDispatch, RayReadback.Received);
            AssertSame(received, none);
            AssertSame(Pose(readback: RayReadback.All), none);
            Assert.That(none.Rays, Is.Empty);
            Assert.That(received.Rays.Length, Is.EqualTo(none.RaysReceived));
            long mayReturn = none.Statistics.RaysRefined;
            Assert.That(mayReturn, Is.InRange(none.RaysReceived, 1.1 * none.RaysReceived + 1e-3 * none.RaysEmitted),
                "few more than are received: those that pass an edge");
            Assert.That((none.Statistics.RoundTrips, none.Statistics.BytesReadBack),
                Is.EqualTo((1, 4L * WorkCounts.ReceivedRays + 8 * 4096)),
                "sums, and a list with pixel and length of what is received");
            Assert.That(received.Statistics.BytesReadBack - none.Statistics.BytesReadBack,
                Is.EqualTo(48 * none.RaysReceived), "and these rays only");
        }

        [Test]
        public void Sums_AreThoseOfTheRaysThatWereKept()
        {
            var result = Pose(readback: RayReadback.All);
            var received = result.Rays.Where(ray => ray.IsReceived).ToArray();
            // Integers in units of 2^-24: at most half a unit for each ray.
            Assert.That(result.InPhase,
                Is.EqualTo(received.Sum(ray => (double)ray.InPhase)).Within(received.Length * 3e-8));
            Assert.That(result.Quadrature,
                Is.EqualTo(received.Sum(ray => (double)ray.Quadrature)).Within(received.Length * 3e-8));
            Assert.That(result.Bounces, Is.EqualTo(result.Rays.Sum(ray => (long)ray.Bounces)));
            Assert.That(result.RaysHit, Is.EqualTo(result.Rays.Count(ray => ray.Bounces > 0)));
            Assert.That(result.PhaseHistogram.Sum(), Is.EqualTo(received.Length));
            double lost = result.Rays.Where(ray => !ray.IsReceived).Sum(ray => (double)ray.PathLength);
            Assert.That(result.PathLengthMeters, Is.GreaterThan(lost));
        }

        [Test]
        public void Trace_Region_GivesThePartOfThePictureThatItIs(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var region = new RayRegion { Left = 101, Bottom = 53, Width = 77, Height = 91 };
            var settings = s_settings;
            settings.Region = region;
            var part = Pose(readback: RayReadback.All, settings: settings, asSoftware: asSoftware);
            var whole = Pose(readback: RayReadback.All, asSoftware: asSoftware).Rays;
            var expected = whole.Where(ray => ray.Pixel % 333 >= 101 && ray.Pixel % 333 < 178 && ray.Pixel / 333 >= 53
                && ray.Pixel / 333 < 144).ToArray();
            Assert.That(part.Rays, Is.EqualTo(expected));
            Assert.That(part.RaysEmitted, Is.EqualTo(77 * 91));
            Assert.That(part.RaysHit, Is.EqualTo(expected.Count(ray => ray.Bounces > 0)));
            AssertSame(Pose(settings: settings, asSoftware: asSoftware), part);
        }

#if GLINT_HOST
        [Test]
        public void Trace_KernelsForGpuAndForSoftware_FindTheSame()
        {
            var wide = Pose(readback: RayReadback.All);
            var binary = Pose(readback: RayReadback.All, asSoftware: false);
            // Both test the same triangles with the same arithmetic; only ties between equally close triangles may
            // differ.
            Assert.That(binary.Rays, Is.EqualTo(wide.Rays));
            AssertSame(binary, wide);
        }
#endif

        [Test]
        public void Trace_InstancesTurnedMirroredAndStretched_EqualTheReference(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var plate = TestRadar.FacingPlate(4, 0);
            var clutter = TestRadar.Clutter(50, seed: 3, halfSide: 1, largest: 0.5f);
            var instances = new List<MeshInstance>();
            var random = new System.Random(9);
            for (int i = 0; i < 40; i++)
            {
                double Next() => 2 * random.NextDouble() - 1;
                instances.Add(new MeshInstance
                {
                    Mesh = i % 3 == 0 ? plate : clutter,
                    ToWorld = Affine.FromTransform(5 * double3(Next(), Next(), Next()),
                        double4(Next(), Next(), Next(), Next()),
                        double3(Next() + 1.2, i % 2 == 0 ? 1 : -1, Next() + 1.5)),
                });
            }
            var scene = new RadarScene(instances.ToArray());
            var view = TestRadar.LookAt(double3(3, 8, -14), 0);
            RayData[] rays;
            using (var tracer = Tracer(asSoftware))
                rays = tracer.Trace(new RadarPose(scene, s_settings, view), RayReadback.All).Rays;
            var expected = new ReferenceTracer(new RadarPose(scene, s_settings, view)).TraceAll();
            int others = Enumerable.Range(0, rays.Length).Count(i => rays[i].Bounces != expected[i].Bounces
                || rays[i].IsReceived != expected[i].Received
                || abs(rays[i].PathLength
                    - (expected[i].Received ? expected[i].PathLength : expected[i].LengthToLastHit)) > 1e-3);
            Assert.That(others, Is.LessThan(rays.Length / 4000), "rays that took another way");
            Assert.That(expected.Count(ray => ray.Bounces > 1), Is.GreaterThan(1000));
        }

        [Test]
        public void Trace_MeshThatMovedOrStayed_BuildsNothing()
        {
            var mesh = Scene;
            using (var tracer = Tracer())
            {
                tracer.TilesADispatch = int.MaxValue;
                var first = tracer.Trace(PoseOf(new RadarScene(mesh)), RayReadback.None);
                Assert.That(first.Statistics.BvhsBuilt, Is.EqualTo(1));
                Assert.That(first.Statistics.TrianglesBuilt, Is.EqualTo(mesh.TriangleCount));

                var second = tracer.Trace(PoseOf(new RadarScene(mesh)), RayReadback.None);
                AssertSame(second, first);
                Assert.That(second.Statistics.BvhsBuilt, Is.Zero);
                Assert.That(second.Statistics.BytesUploaded, Is.EqualTo(4 * second.Statistics.TilesTraced),
                    "cells of one tile each");

                var turned = Affine.FromTransform(0, double4(0, sin(0.1), 0, cos(0.1)), 1);
                var third = tracer.Trace(
                    PoseOf(new RadarScene(new MeshInstance { Mesh = mesh, ToWorld = turned })), RayReadback.None);
                Assert.That(third.Statistics.BvhsBuilt, Is.Zero);
                Assert.That(third.InPhase, Is.Not.EqualTo(first.InPhase));
            }
        }

        [Test]
        public void Trace_MeshesThatComeAndGo_LeaveNothingBehind()
        {
            using (var tracer = Tracer())
            {
                long lowest = 0;
                for (int i = 0; i < 8; i++)
                {
                    var mesh = TestRadar.Join(Scene, TestRadar.Clutter(200 + 31 * i % 97, seed: (uint)i));
                    var result = tracer.Trace(PoseOf(new RadarScene(mesh)), RayReadback.None);
                    AssertSame(result, TestKernels.TraceOnce(mesh, s_settings, s_view, RayReadback.None));
                    lowest = i == 0 ? result.Statistics.BytesOnDevice : lowest;
                    Assert.That(result.Statistics.BytesOnDevice, Is.LessThan(2 * lowest));
                }
            }
        }

        // The kernels' inputs belong to the shader, an asset that all radars of a scene share.
        [TestCase(0, RayReadback.None)]
        [TestCase(50, RayReadback.None)]
        [TestCase(0, RayReadback.Received)]
        public void Finish_AfterAnotherTracerHasTraced_IsThatOfThePose(int tilesADispatch, RayReadback readback)
        {
            using (RayTracer tracer = Tracer(), other = Tracer())
            {
                tracer.TilesADispatch = tilesADispatch;
                var pose = PoseOf(new RadarScene(Scene));
                var expected = tracer.Trace(pose, readback);
                var inFlight = tracer.Start(pose, readback);
                var elsewhere = TestRadar.LookAt(double3(9, 10, 11), double3(3, 0, 0), fov: 60);
                other.Trace(new RadarPose(new RadarScene(TestRadar.Trihedral(0, 1)), s_settings, elsewhere), RayReadback.None);
                AssertSame(tracer.Finish(inFlight), expected);
            }
        }

        // A plate that returns 345,600 rays, more than a dispatch refines and than the list holds for those whose triangles are
        // known, and the next pose of a sweep, which has few tiles and a short list.
        [Test]
        [Timeout(600000)]
        public void Finish_AfterASmallPoseHasStarted_HasAllRays()
        {
            var settings = RadarSettings.Default;
            (settings.RaysAcross, settings.RaysDown, settings.SkipSamplingError) = (720, 480, true);
            var plate = new TriangleMesh(
                new[] { float3(-9, -9, 0), float3(9, -9, 0), float3(9, 9, 0), float3(-9, 9, 0) }, new[] { 0, 2, 1, 0, 3, 2 });
            RadarPose At(double distance)
            {
                var view = TestRadar.LookAt(double3(0, 0, -distance), double3(0, 0, 0), fov: 30);
                view.ReceiverSize = 1000;
                return new RadarPose(new RadarScene(plate), settings, view);
            }
            RadarPose large = At(10), small = At(3000);
            using (var tracer = Tracer())
            {
                tracer.TilesADispatch = 720 * 480 / PictureTiles.Rays; // a single slice
                var expected = tracer.Trace(large, RayReadback.None);
                Assert.That(expected.RaysReceived, Is.EqualTo(720 * 480));
                var small1 = tracer.Trace(small, RayReadback.None);
                var inFlight = tracer.Start(large, RayReadback.None);
                var next = tracer.Start(small, RayReadback.None);
                AssertSame(tracer.Finish(inFlight), expected);
                AssertSame(tracer.Finish(next), small1);
            }
        }

        [Test]
        public void Trace_Progress_RisesToOne()
        {
            var parts = new Parts();
            using (var tracer = Tracer())
            {
                tracer.TilesADispatch = 50;
                tracer.Trace(PoseOf(new RadarScene(Scene)), RayReadback.None, parts);
            }
            Assert.That(parts.Reported, Is.Ordered.And.Count.GreaterThan(3));
            Assert.That(parts.Reported.Last(), Is.EqualTo(1));
        }

        [Test]
        public void Trace_Cancelled_StopsAndTheNextPoseIsRight()
        {
            using (var cancel = new CancellationTokenSource())
            using (var tracer = Tracer())
            {
                tracer.TilesADispatch = 50;
                var parts = new Parts { After = cancel.Cancel };
                Assert.Throws<OperationCanceledException>(
                    () => tracer.Trace(PoseOf(new RadarScene(Scene)), RayReadback.None, parts, cancel.Token));
                Assert.That(parts.Reported, Has.Count.EqualTo(1));
                AssertSame(tracer.Trace(PoseOf(new RadarScene(Scene)), RayReadback.None), Pose());
            }
        }

        [Test]
        public void Trace_KeepingMoreRaysThanTheComputerHolds_SaysHowMuchTheyTake()
        {
            using (var tracer = Tracer())
            {
                var problem = Assert.Throws<GlintException>(
                    () => tracer.Trace(
                        new RadarPose(new RadarScene(TestRadar.Empty), TestRadar.Settings(65536, 65535), s_view),
                        RayReadback.All));
                Assert.That(problem.Message, Does.Contain("4294901760 rays").And.Contain("196605 MiB"));
            }
        }

        sealed class Parts : IProgress<double>
        {
            public readonly List<double> Reported = new List<double>();
            public Action After;

            public void Report(double part)
            {
                Reported.Add(part);
                After?.Invoke();
            }
        }
    }
}
