using System;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The kernel on scenes with known answers, and against the reference tracer.</summary>
    public sealed class KernelTests
    {
        // Float32 lengths of some 50 m: a few steps of 4 micrometres for each segment.
        const double LengthTolerance = 5e-5;

        static readonly double3 Ahead = double3(0, 0, 1);

        [Test]
        public void Trace_EmptyScene_HitsNothing()
        {
            var result = TestKernels.TraceOnce(TestRadar.Empty, TestRadar.Settings(), TestRadar.LookAt(0, Ahead));
            Assert.That(result.RaysEmitted, Is.EqualTo(160 * 90));
            Assert.That(result.RaysHit, Is.Zero);
            Assert.That(result.RaysReceived, Is.Zero);
            Assert.That(result.Amplitude, Is.Zero);
            Assert.That(result.Segments, Is.EqualTo(160 * 90));
        }

        [Test]
        public void Trace_TargetBehindTheCamera_HitsNothing()
        {
            var result =
                TestKernels.TraceOnce(TestRadar.FacingPlate(4, -10), TestRadar.Settings(), TestRadar.LookAt(0, Ahead));
            Assert.That(result.RaysHit, Is.Zero);
        }

        [Test]
        public void Trace_FacingPlate_HitsItsShareOfThePictureAndReceivesWhatMirrorsIntoTheReceiver()
        {
            // Pixels on a 4 m plate at 20 m, and those whose reflection hits the 3 m receiver 40.2 m behind the image.
            var settings = TestRadar.Settings();
            var view = TestRadar.LookAt(0, Ahead);
            var slopes = Enumerable.Range(0, 160 * 90).Select(pixel => TestRadar.Direction(settings, view, pixel))
                .Select(d => cmax(abs(d.xy / d.z))).ToArray();
            var result = TestKernels.TraceOnce(TestRadar.FacingPlate(4, 20), settings, view);
            Assert.That(result.RaysHit, Is.EqualTo(slopes.Count(slope => slope * 20 <= 2)));
            Assert.That(result.RaysReceived, Is.EqualTo(slopes.Count(slope => slope * 40.2 <= 1.5)));
            Assert.That(result.Bounces, Is.EqualTo(result.RaysHit));
        }

        [Test]
        public void Trace_PlateAtTheUpperRight_IsMetByPixelsOfHighColumnsAndRows()
        {
            // The picture in the axes of Unity's cameras: x to the right, y up.
            var scene = TestRadar.Plate(float3(1, 1, 20), float3(4, 0, 0), float3(0, 4, 0));
            var rays =
                TestKernels.TraceOnce(scene, TestRadar.Settings(), TestRadar.LookAt(0, Ahead), RayReadback.All).Rays;
            var pixels = rays.Where(ray => ray.Bounces == 1).Select(ray => (int)ray.Pixel).ToArray();
            Assert.That(pixels, Is.Not.Empty);
            Assert.That(pixels.Select(pixel => pixel % 160), Is.All.GreaterThan(80), "columns");
            Assert.That(pixels.Select(pixel => pixel / 160), Is.All.GreaterThan(45), "rows");
        }

        [Test]
        public void Trace_TiltedPlatesOfTenKilometres_AreLeftWithoutMeetingThemAgain()
        {
            // Floor and wall, tilted so that no normal is exact in float32; the radar is 10 m from their edge.
            double c = cos(0.3), s = sin(0.3);
            float3 Turned(double x, double y, double z) =>
                (float3)double3(c * x - s * y, c * (s * x + c * y) - s * z, s * (s * x + c * y) + c * z);
            var scene = TestRadar.Join(
                TestRadar.Plate(Turned(-5000, 0, 0), Turned(10000, 0, 0), Turned(0, 0, -10000)),
                TestRadar.Plate(Turned(-5000, 0, 0), Turned(10000, 0, 0), Turned(0, 10000, 0)));
            var settings = TestRadar.Settings(320, 180);
            var view = TestRadar.LookAt(Turned(0, 5, -8.7), 0);
            var rays = TestKernels.TraceOnce(scene, settings, view, RayReadback.All).Rays;
            var expected = new ReferenceTracer(new RadarPose(new RadarScene(scene), settings, view)).TraceAll();
            Assert.That(Enumerable.Range(0, rays.Length).Count(i => rays[i].Bounces != expected[i].Bounces),
                Is.LessThanOrEqualTo(rays.Length / 4000));
        }

        [Test]
        public void Trace_SizesGrowingByPowersOfTwo_FindsWhatALoopOverAllFinds()
        {
            var scene = TestRadar.PowersOfTwo(600, sizes: 30);
            var settings = TestRadar.Settings(61, 47, 1);
            var view = TestRadar.LookAt(double3(0.5, 0.5, -3), double3(0.5, 0.5, 0));
            var rays = TestKernels.TraceOnce(scene, settings, view, RayReadback.All).Rays;
            int others = Enumerable.Range(0, rays.Length).Count(pixel =>
                rays[pixel].Bounces != (BruteForce.ClosestHit(scene, view.Position,
                    TestRadar.Direction(settings, view, pixel), out _) >= 0 ? 1 : 0));
            Assert.That(rays.Count(ray => ray.Bounces == 1), Is.GreaterThan(20));
            Assert.That(others, Is.LessThanOrEqualTo(3), "rays at edges may go either way");
        }

        [Test]
        public void Trace_PoseWithoutAScene_IsAWrongCall()
        {
            using (var tracer = new RayTracer(TestKernels.Trace))
                Assert.Throws<ArgumentException>(() => tracer.Trace(
                    new RadarPose(null, TestRadar.Settings(), TestRadar.LookAt(0, Ahead)), RayReadback.Received));
        }

        [Test]
        public void Trace_PlateBetweenTargetAndReceiver_BlocksWhatWouldReturn()
        {
            // A plate between the camera and the receiver: it blocks only the returning rays.
            var scene = TestRadar.Join(TestRadar.FacingPlate(4, 20), TestRadar.FacingPlate(4, -0.1f));
            var open = TestKernels.TraceOnce(TestRadar.FacingPlate(4, 20), TestRadar.Settings(bounces: 1),
                TestRadar.LookAt(0, Ahead));
            var blocked = TestKernels.TraceOnce(scene, TestRadar.Settings(bounces: 1), TestRadar.LookAt(0, Ahead));
            Assert.That(open.RaysReceived, Is.GreaterThan(0));
            Assert.That(blocked.RaysHit, Is.EqualTo(open.RaysHit));
            Assert.That(blocked.RaysReceived, Is.Zero);
        }

        [Test]
        public void Trace_ReceiverFacingAway_ReceivesNothing()
        {
            var view = TestRadar.LookAt(0, Ahead);
            view.ReceiverForward = -view.ReceiverForward;
            Assert.That(
                TestKernels.TraceOnce(TestRadar.FacingPlate(4, 20), TestRadar.Settings(), view).RaysReceived, Is.Zero);
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(7)]
        [TestCase(16)]
        public void Trace_RayBetweenTwoFacingMirrors_StopsAtMaxBounces(int limit)
        {
            // Camera between two large facing plates, with the receiver behind one of them: no ray ever escapes.
            var scene = TestRadar.Join(TestRadar.FacingPlate(1e4f, 5), TestRadar.FacingPlate(1e4f, -0.15f));
            var result =
                TestKernels.TraceOnce(scene, TestRadar.Settings(8, 8, limit), TestRadar.LookAt(0, Ahead, fov: 1));
            Assert.That(result.Bounces, Is.EqualTo(64 * limit));
            Assert.That(result.RaysReceived, Is.Zero);
        }

        [Test]
        public void Trace_Trihedral_PathLengthsAreThoseFromThePointMirroredInTheVertex()
        {
            double3 vertex = double3(1, -2, 3);
            var settings = TestRadar.Settings();
            var view = TestRadar.LookAt(vertex + double3(9, 10, 11), vertex, fov: 20);
            var result = TestKernels.TraceOnce(TestRadar.Trihedral((float3)vertex, 4), settings, view);
            double3 image = 2 * vertex - view.Position;
            var triple = result.Rays.Where(ray => ray.Bounces == 3).ToArray();
            Assert.That(triple, Is.Not.Empty);
            foreach (var ray in triple)
            {
                double3 back = -TestRadar.Direction(settings, view, (int)ray.Pixel);
                double length = dot(view.ReceiverCentre - image, view.Forward) / dot(back, view.Forward);
                Assert.That((double)ray.PathLength, Is.EqualTo(length).Within(LengthTolerance), $"pixel {ray.Pixel}");
                Assert.That(distance((float3)back, ray.Direction), Is.LessThan(1e-5f), $"pixel {ray.Pixel}");
            }
        }

        [TestCase(1)]
        [TestCase(3)]
        [TestCase(997)]
        public void Trace_OneBounce_MeetsTheNearestOfAllTriangles(int triangles)
        {
            // One triangle: the root is a leaf. The loop over all is in double.
            var scene = TestRadar.Clutter(triangles, seed: 11, halfSide: 6, largest: 3);
            var settings = TestRadar.Settings(61, 47, 1);
            var view = TestRadar.LookAt(double3(-4, 6, -20), 0);
            var rays = TestKernels.TraceOnce(scene, settings, view, RayReadback.All).Rays;
            int hits = 0, others = 0;
            for (int pixel = 0; pixel < rays.Length; pixel++)
            {
                int hit = BruteForce.ClosestHit(scene, view.Position,
                    TestRadar.Direction(settings, view, pixel), out double there);
                hits += hit >= 0 ? 1 : 0;
                double length = BruteForce.ToLastHit(view.Position, rays[pixel]);
                others += rays[pixel].Bounces == (hit >= 0 ? 1 : 0)
                    && (hit < 0 || abs(length - there) < LengthTolerance) ? 0 : 1;
            }
            Assert.That(hits, Is.GreaterThan(20));
            Assert.That(others, Is.LessThanOrEqualTo(3), "rays at edges may go either way");
        }

        [TestCase(1u, 100)]
        [TestCase(2u, 400)]
        [TestCase(3u, 5000)]
        public void Trace_RandomTriangles_EqualsTheReferenceRayByRay(uint seed, int triangles)
        {
            var scene = TestRadar.Clutter(triangles, seed);
            // Prime sizes: the groups of 8 x 8 at the edges are partial.
            var settings = TestRadar.Settings(211, 127, 3);
            var view = TestRadar.LookAt(double3(3, 14, -25), 0);
            var rays = TestKernels.TraceOnce(scene, settings, view, RayReadback.All).Rays;
            var expected = new ReferenceTracer(new RadarPose(new RadarScene(scene), settings, view)).TraceAll();

            // Rays that hit an edge within rounding may take either path.
            int others = Enumerable.Range(0, rays.Length).Count(i => rays[i].Bounces != expected[i].Bounces
                || rays[i].IsReceived != expected[i].Received
                || abs(rays[i].PathLength
                    - (expected[i].Received ? expected[i].PathLength : expected[i].LengthToLastHit)) > 1e-3);
            Assert.That(others, Is.LessThan(rays.Length / 4000), "rays that took another way");
            Assert.That(expected.Count(ray => ray.Bounces > 1), Is.GreaterThan(100),
                "the scene asks for more than one bounce");
        }

        [Test]
        public void Trace_Twice_SumsAreTheSameBitForBit()
        {
            var scene = TestRadar.Trihedral(0, 4);
            var view = TestRadar.LookAt(double3(9, 10, 11), 0, fov: 30);
            var results = Enumerable.Range(0, 3)
                .Select(_ => TestKernels.TraceOnce(scene, TestRadar.Settings(640, 360), view)).ToArray();
            Assert.That(results[0].RaysReceived, Is.GreaterThan(100));
            foreach (var again in results.Skip(1))
            {
                Assert.That(BitConverter.DoubleToInt64Bits(again.InPhase),
                    Is.EqualTo(BitConverter.DoubleToInt64Bits(results[0].InPhase)));
                Assert.That(BitConverter.DoubleToInt64Bits(again.Quadrature),
                    Is.EqualTo(BitConverter.DoubleToInt64Bits(results[0].Quadrature)));
                Assert.That(BitConverter.DoubleToInt64Bits(again.PathLengthMeters),
                    Is.EqualTo(BitConverter.DoubleToInt64Bits(results[0].PathLengthMeters)));
            }
        }

        [Test]
        public void Trace_KeepingAllOrReceivedRays_GivesTheSameSums()
        {
            var view = TestRadar.LookAt(double3(9, 10, 11), 0, fov: 30);
            var received = TestKernels.TraceOnce(TestRadar.Trihedral(0, 4), TestRadar.Settings(), view);
            var all = TestKernels.TraceOnce(TestRadar.Trihedral(0, 4), TestRadar.Settings(), view, RayReadback.All);
            Assert.That(all.Rays.Length, Is.EqualTo(160 * 90));
            Assert.That(all.Rays.Where(ray => ray.IsReceived), Is.EqualTo(received.Rays));
            Assert.That(all.InPhase, Is.EqualTo(received.InPhase));
            Assert.That(all.PathLengthMeters, Is.EqualTo(received.PathLengthMeters));
        }

        [Test]
        public void Trace_MoreReceivedRaysThanFirstRoomWasMadeFor_AreAllThere()
        {
            // A plate that fills the view, and a receiver of the same size: every ray returns.
            var view = TestRadar.LookAt(0, Ahead);
            view.ReceiverSize = 1000;
            var result = TestKernels.TraceOnce(TestRadar.FacingPlate(1000, 5), TestRadar.Settings(400, 300), view);
            Assert.That(result.RaysReceived, Is.EqualTo(120000));
            Assert.That(result.Rays.Select(ray => ray.Pixel),
                Is.EqualTo(Enumerable.Range(0, 120000).Select(i => (uint)i)));
            Assert.That(result.PhaseHistogram.Sum(), Is.EqualTo(120000));
        }

        [Test]
        public void RayTracer_WithoutKernel_SaysWhichToAssign() =>
            Assert.That(Assert.Throws<GlintException>(() => new RayTracer(null)).Message,
                Does.Contain("Shaders/Trace.compute"));
    }
}
