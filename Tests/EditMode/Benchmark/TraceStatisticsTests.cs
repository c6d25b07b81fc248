using System;
using System.Linq;
using System.Threading;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// A benchmark that counts work instead of time, so that machines agree. A bound is the measured number plus 5 %
    /// for another compiler's rounding. A test that exceeds it has found a slower tracer.
    /// </summary>
    [Category("Slow")]
    public sealed class TraceStatisticsTests
    {
        // Sums, counts and a list of 4,096 received rays.
        const int OutputBytes = 4 * WorkCounts.ReceivedRays + 8 * 4096;

        // A row with the centre, a node of three and two leaves of three.
        const int InstanceBvhBytes = 16 * (1 + 3 + 2 * 3);
        const double Tolerance = 1.05;
        const int MaxBytesPerTriangle = 120;

        static readonly RadarSettings s_settings = TestRadar.Settings(480, 270);

        // The published experiment's camera: 50 m from the ship, 10 degrees above the sea.
        static readonly RadarView s_view =
            TestRadar.LookAt(50 * double3(0, sin(radians(10.0)), -cos(radians(10.0))), 0);

        SeaAndShip _made;

        SeaAndShip Made => _made ??= new SeaAndShip(1, 35000, 44000);

        [OneTimeTearDown]
        public void LetGo() => _made = null;

        static RadarScene Scene(SeaAndShip made, double shipDegrees = 0)
        {
            double half = radians(shipDegrees) / 2;
            return new RadarScene(
                new MeshInstance
                {
                    Mesh = made.Ship, ToWorld = Affine.FromTransform(0, double4(0, sin(half), 0, cos(half)), 1)
                },
                new MeshInstance { Mesh = made.Sea, ToWorld = Affine.Identity });
        }

        static RayTracer Tracer(bool asSoftware, long maxRowsPerPage = long.MaxValue) =>
            new RayTracer(TestKernels.Trace, "test", asSoftware, maxRowsPerPage) { TilesADispatch = int.MaxValue };

        static RadarResult Counted(RayTracer tracer, RadarScene scene)
        {
            tracer.CountVisits = true;
            var result = tracer.Trace(new RadarPose(scene, s_settings, s_view), RayReadback.None);
            tracer.CountVisits = false;
            return result;
        }

        // Without the lists of rays.
        static void AssertFewBytesATriangle(RadarResult result, in RadarSettings settings, RayReadback readback)
        {
            double lists = SlicePass.Bytes(settings, PictureTiles.Rays * result.Statistics.TilesTraced, readback);
            Assert.That((result.Statistics.BytesOnDevice - lists) / result.Statistics.Triangles,
                Is.InRange(1, MaxBytesPerTriangle));
        }

        static double NodesASegment(RadarResult result) => (double)result.Statistics.NodesVisited / result.Segments;

        static double PairsASegment(RadarResult result) => (double)result.Statistics.PairsTested / result.Segments;

        [Test]
        public void Trace_SeaAndShip_VisitsNoMoreThanMeasured(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            // Starts at the root of a BVH over both instances.
            var (nodes, pairs) = asSoftware ? (8.476, 1.177) : (15.637, 1.139);
            using (var tracer = Tracer(asSoftware))
            {
                var result = Counted(tracer, Scene(Made));
                // Each bounce is off a tested pair.
                Assert.That(result.Statistics.PairsTested, Is.GreaterThanOrEqualTo(result.Bounces));
                Assert.That(NodesASegment(result), Is.LessThan(Tolerance * nodes));
                Assert.That(PairsASegment(result), Is.LessThan(Tolerance * pairs));
                Assert.That(result.Statistics.TilesSkipped, Is.GreaterThanOrEqualTo(781));
            }
        }

        // Four binary levels more, each visited by half a segment and a little more, since boxes overlap; two wide
        // levels.
        // Without a BVH it would be 16 times as many.
        [Test]
        public void Trace_SixteenTimesTheTriangles_VisitsAFewMoreNodesAndTakesNoMoreBytesATriangle(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            double moreNodes = asSoftware ? 2.439 : 4.681;
            using (var tracer = Tracer(asSoftware))
            {
                var few = Counted(tracer, Scene(new SeaAndShip(1, 8750, 11000)));
                var many = Counted(tracer, Scene(new SeaAndShip(1, 140000, 176000)));
                Assert.That(NodesASegment(many) - NodesASegment(few), Is.LessThan(Tolerance * moreNodes));
                Assert.That(PairsASegment(many), Is.LessThan(Tolerance * PairsASegment(few)));
                foreach (var result in new[] { few, many })
                    AssertFewBytesATriangle(result, s_settings, RayReadback.None);
            }
        }

        [Test]
        public void Trace_SecondPose_BuildsNothingAndMovesOnlyTilesPlacesAndSums(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            using (var tracer = Tracer(asSoftware))
            {
                tracer.TilesADispatch = int.MaxValue;
                var first = tracer.Trace(new RadarPose(Scene(Made), s_settings, s_view), RayReadback.None).Statistics;
                Assert.That(first.BvhsBuilt, Is.EqualTo(2));
                Assert.That(first.TrianglesBuilt, Is.EqualTo(Scene(Made).TriangleCount));

                var second = tracer.Trace(new RadarPose(Scene(Made, shipDegrees: 1), s_settings, s_view),
                    RayReadback.None).Statistics;
                Assert.That(second.BvhsBuilt, Is.Zero);
                Assert.That(second.TrianglesBuilt, Is.Zero);
                Assert.That(second.RaysRefined, Is.InRange(1, 5e-3 * s_settings.RayCount),
                    "rays that may be received or pass an edge");
                // A software device finds the tiles' entry points first.
                Assert.That(second.Dispatches, Is.EqualTo(TracerTests.DispatchesOfAPose + (asSoftware ? 1 : 0)));
                Assert.That(second.RoundTrips, Is.EqualTo(1));
                Assert.That(second.BytesReadBack, Is.EqualTo(OutputBytes));
                // Cells of one tile each, as the picture is less than 128 tiles across.
                // Two records of 144 bytes with a range of triangles each,
                // and a node of the BVH over them with its leaves.
                Assert.That(second.BytesUploaded,
                    Is.EqualTo(4 * second.TilesTraced + 2 * (144 + 16) + InstanceBvhBytes));
                Assert.That(second.TilesTraced + second.TilesSkipped, Is.EqualTo(60 * 34));
                Assert.That(second.BytesOnDevice,
                    Is.EqualTo(first.BytesOnDevice).Within((4 + 4 * 16 + 64 * 8) * 60 * 34));
            }
        }

        [Test]
        [Timeout(600000)]
        public void Trace_MeshOfTwoAndAHalfMillionTriangles_InSeveralBvhsAndBuffers_EqualsTheReference()
        {
            var scene = new RadarScene(new SeaAndShip(2, 2_500_000, 1000).Sea);
            var settings = s_settings;
            settings.Region = new RayRegion { Left = 200, Bottom = 20, Width = 16, Height = 100 };
            var expected = new ReferenceTracer(new RadarPose(scene, settings, s_view)).TraceAll();
            Assert.That(expected.Count(ray => ray.Bounces > 0), Is.GreaterThan(1000));
            // No BVH exceeds 48 (wide) and 96 MiB (binary).
            foreach (bool asSoftware in TestKernels.AsSoftware)
                using (var tracer = Tracer(asSoftware, (asSoftware ? 48 : 96) << 20 >> 4))
                {
                    var result = tracer.Trace(new RadarPose(scene, settings, s_view), RayReadback.All);
                    Assert.That(result.Statistics.BvhsBuilt, Is.EqualTo(1));
                    Assert.That(tracer.PageCount, Is.GreaterThan(1));
                    AssertFewBytesATriangle(result, settings, RayReadback.All);
                    int others = Enumerable.Range(0, expected.Length)
                        .Count(i => result.Rays[i].Bounces != expected[i].Bounces
                            || abs(result.Rays[i].PathLength - (expected[i].Received
                                ? expected[i].PathLength
                                : expected[i].LengthToLastHit)) > 1e-3);
                    // Rays that barely touch a crest.
                    Assert.That(others, Is.LessThanOrEqualTo(expected.Length / 1000));
                }
        }

        [Test]
        public void Trace_SmallMeshesAfterALargeOne_GiveItsBuffersBack(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            // A buffer has the size of the larger BVH, not of both.
            using (var tracer = Tracer(asSoftware, (asSoftware ? 4 : 8) << 20 >> 4))
            {
                long large = tracer.Trace(new RadarPose(Scene(new SeaAndShip(1, 100_000, 100_000)), s_settings, s_view),
                    RayReadback.None).Statistics.BytesOnDevice;
                Assert.That(tracer.PageCount, Is.GreaterThan(1));
                var small = Scene(new SeaAndShip(1, 1000, 1000));
                var result = tracer.Trace(new RadarPose(small, s_settings, s_view), RayReadback.None);
                Assert.That(tracer.PageCount, Is.EqualTo(1));
                // Lists of cells, rays and sub-rays.
                double lists = 4 * 60 * 34 + SlicePass.Bytes(s_settings, 64 * 60 * 34, RayReadback.None);
                Assert.That(result.Statistics.BytesOnDevice - lists, Is.LessThan((large - lists) / 10));
            }
        }

        [Test]
        public void Trace_Cancelled_StopsAndTheNextSceneIsRight()
        {
            var scene = Scene(Made);
            using (var cancel = new CancellationTokenSource())
            using (var tracer = Tracer(TestKernels.HasWide))
            using (var other = Tracer(TestKernels.HasWide))
            {
                cancel.Cancel();
                Assert.Throws<OperationCanceledException>(() =>
                    tracer.Trace(new RadarPose(scene, s_settings, s_view), RayReadback.None, null, cancel.Token));
                RadarResult result = tracer.Trace(new RadarPose(scene, s_settings, s_view), RayReadback.None),
                    expected = other.Trace(new RadarPose(scene, s_settings, s_view), RayReadback.None);
                Assert.That(result.PathLengthMeters, Is.EqualTo(expected.PathLengthMeters));
                Assert.That(result.Statistics.BvhsBuilt, Is.EqualTo(2));
            }
        }

        [Test]
        public void Trace_MoreTrianglesThanTheDeviceHolds_SaysHowMuchTheyTakeBeforeItBuilds(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            using (var tracer = Tracer(asSoftware, 1 << 13))
            {
                var problem = Assert.Throws<GlintException>(() =>
                    tracer.Trace(new RadarPose(Scene(Made), s_settings, s_view), RayReadback.None));
                // 79,000 triangles of at least 32 bytes in wide BVHs and 48 in binary ones, plus 5 and 4 bytes for
                // their numbers, and 8 buffers of 128 KiB.
                Assert.That(problem.Message,
                    Does.Match($@"test: the BVHs over its meshes take at least {(asSoftware ? "2.8" : "3.9")} MiB, "
                        + @"and .* holds 1 MiB of them in buffers of 0\.1 MiB"));
            }
        }
    }
}
