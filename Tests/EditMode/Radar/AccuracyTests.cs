using System;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// The kernel against the reference tracer, ray by ray, near and far: lengths, phases, and the few rays that pass
    /// an edge on its other side.
    /// </summary>
    [Category("Slow")]
    public sealed class AccuracyTests
    {
        const double CornerTolerance = 1e-5, RoughTolerance = 5e-5; // m

        // Half the height of the published experiment's view at the reflector, m.
        static readonly double SeenHalf = tan(radians(30.0)) * CornerReflector.Distance;

        static readonly RadarSettings s_settings = TestRadar.Settings(960, 540),
            // Of scenes of 80,000 triangles. No ray passes the ridge of a wall exactly, as with 270 rows.
            s_coarserSettings = TestRadar.Settings(512, 288);

        [TestCase(50, true)]
        [TestCase(50, false, Category = "Stress")]
        [TestCase(1e5, true, Category = "Stress")]
        [TestCase(1e5, false)]
        public void Trace_CornerReflector_LengthsAreTheReferences(double range, bool isParallel)
        {
            var total = new Total(CornerTolerance, amplitude: 1e-3);
            foreach (double angle in new[] { 0, 9, 23, 35 })
            {
                var view = CornerView(range);
                if (isParallel)
                    view.ApertureHeight = 2 * SeenHalf;
                total.Add(CornerReflector.Turned(angle), s_settings, view);
            }
            total.Check(minReceived: 300);
        }

        [Test]
        public void Trace_CornerReflectorAtTenKilometres_LengthsSpreadAsTheReferencesDo()
        {
            // Field of view of the published check. Rays to the vertex, 6 m off the axis, differ by 2 R t dt: t = 6e-4
            // rad, dt = 1.5e-4 rad.
            var settings = TestRadar.Settings(1920, 1080);
            var view = CornerView(1e4);
            view.VerticalFovDegrees = 0.3;
            var scene = CornerReflector.Turned(0);
            double[] kernel = Trace(scene, settings, view, RayReadback.Received)
                .Rays.Select(ray => ray.RefinedPathLength).ToArray();
            double[] references = new ReferenceTracer(new RadarPose(scene, settings, view)).TraceAll()
                .Where(ray => ray.Received)
                .Select(ray => ray.PathLength).ToArray();
            Assert.That(kernel.Length, Is.GreaterThan(300));
            Assert.That(Spread(references), Is.GreaterThan(1e-3));
            Assert.That(Spread(kernel), Is.EqualTo(Spread(references)).Within(CornerTolerance));
        }

        [TestCase(50, true)]
        [TestCase(1e4, false)]
        public void Trace_FurrowedWallOf80000Triangles_LengthsAreTheReferences(double range, bool isParallel)
        {
            // Furrows at right angles return rays for any tilt across them; a larger tilt along them misses a 30 m
            // receiver. Every ray bounces twice between ridges 1.3 m apart, at 45 degrees, and passes some ten edges a
            // metre; a sea's ray passes three.
            double tilt = 10 / range;
            var view = TestRadar.LookAt(range * normalize(double3(0.3, 0, 1)), double3(0.0173, 0.0311, 0),
                degrees(2 * atan(30 / range)));
            view.ApertureHeight = isParallel ? 60 : 0;
            view.ReceiverSize = 30;
            var turned = Affine.FromTransform(0, double4(0.2, 0.1, -0.3, 0.9), 1);
            var total = new Total(RoughTolerance, amplitude: 1e-2);
            total.Add(new RadarScene(new MeshInstance { Mesh = FurrowedWall(200, 130, tilt), ToWorld = turned }),
                s_coarserSettings, Turned(view, turned));
            total.Check(minReceived: 5000);
        }

        [TestCase(true)]
        [TestCase(false, Category = "Stress")]
        [Timeout(600000)]
        public void Trace_SmallFurrowedWallInTheMiddleOfALargeScene_LengthsAreTheReferences(bool isParallel)
        {
            // Hit positions at 60 m have the usual rounding, but coordinates at the reflection are small and ridges
            // are 2 cm apart.
            var view = TestRadar.LookAt(50 * normalize(double3(0.3, 0, 1)), 0, degrees(2 * atan(0.5 / 50)));
            view.ApertureHeight = isParallel ? 1 : 0;
            view.ReceiverSize = 30;
            var turned = Affine.FromTransform(0, double4(0.2, 0.1, -0.3, 0.9), 1);
            MeshInstance Corner(double position) => new MeshInstance
            {
                Mesh = FurrowedWall(1, 1, 0), ToWorld = Affine.FromTransform(position, double4(0, 0, 0, 1), 1)
            };
            var total = new Total(RoughTolerance, amplitude: 1e-2);
            total.Add(new RadarScene(new MeshInstance { Mesh = FurrowedWall(200, 2, 0.2), ToWorld = turned },
                Corner(-40), Corner(40)), s_coarserSettings, Turned(view, turned));
            total.Check(minReceived: 5000);
        }

        [Test]
        [Timeout(600000)]
        public void Trace_SeaAndShipOf80000Triangles_LengthsAreTheReferences([Values(50, 1e4)] double range)
        {
            // From high above, where waves return rays.
            var made = new SeaAndShip(1, 36000, 44000);
            var view = TestRadar.LookAt(range * normalize(double3(0.01, 1, -0.02)), 0, degrees(2 * atan(45 / range)));
            view.ReceiverSize = 150;
            var total = new Total(RoughTolerance, amplitude: 1e-2);
            total.Add(new RadarScene(new MeshInstance { Mesh = made.Sea, ToWorld = Affine.Identity },
                    new MeshInstance { Mesh = made.Ship, ToWorld = Affine.FromTransform(0, double4(0, 0.3, 0, 1), 1) }),
                s_coarserSettings, view);
            total.Check(minReceived: 100);
        }

        // At any range, with the field of view narrowed to the published experiment's view.
        static RadarView CornerView(double range)
        {
            var view = AccuracyScene.PublishedView(range, CornerReflector.PitchDegrees);
            view.VerticalFovDegrees = degrees(2 * atan(SeenHalf / range));
            return view;
        }

        // A wall across the z axis: furrows along y, 45 degrees steep. Ridges and floors are rough, so that facets
        // tilt by about this angle in radians.
        static TriangleMesh FurrowedWall(int cells, float side, double tilt)
        {
            var random = new System.Random(1);
            int points = cells + 1;
            float step = side / cells;
            var vertices = new float3[points * points];
            for (int i = 0; i < vertices.Length; i++)
                vertices[i] = float3(step * (i % points) - side / 2, step * (i / points) - side / 2,
                    (float)(step * (i % points % 2 + tilt * (random.NextDouble() - 0.5))));
            var indices = Enumerable.Range(0, cells * cells).Select(i => i / cells * points + i % cells)
                .SelectMany(a => new[] { a, a + 1, a + points, a + 1, a + 1 + points, a + points }).ToArray();
            return new TriangleMesh(vertices, indices);
        }

        static RadarView Turned(RadarView view, in Affine by)
        {
            (view.Position, view.ReceiverCentre) = (by.Point(view.Position), by.Point(view.ReceiverCentre));
            (view.Right, view.Up, view.Forward) = (by.Vector(view.Right), by.Vector(view.Up), by.Vector(view.Forward));
            (view.ReceiverRight, view.ReceiverUp, view.ReceiverForward) = (view.Right, view.Up, view.Forward);
            return view;
        }

        static double Spread(double[] lengths) => lengths.Max() - lengths.Min();

        static RadarResult Trace(RadarScene scene, in RadarSettings settings, in RadarView view, RayReadback readback)
        {
            using (var tracer = new RayTracer(TestKernels.Trace))
            {
                return tracer.Trace(new RadarPose(scene, TestRadar.WithoutError(settings), view), readback);
            }
        }

        /// <summary>Totals of several poses.</summary>
        sealed class Total
        {
            readonly double _lengthTolerance, _amplitudeTolerance;
            long _rays, _received, _atEdge;

            /// <param name="lengthTolerance">Maximum error of a length, metres.</param>
            /// <param name="amplitude">
            /// Tolerance of a pose's amplitude, relative to the square root of the number of rays received.
            /// </param>
            public Total(double lengthTolerance, double amplitude)
            {
                _lengthTolerance = lengthTolerance;
                _amplitudeTolerance = amplitude;
            }

            public void Add(RadarScene scene, in RadarSettings settings, in RadarView view)
            {
                var comparison = new RayComparison(new RadarPose(scene, settings, view), _lengthTolerance);
                comparison.Add(Trace(scene, settings, view, RayReadback.All).Rays);
                string message = FormattableString.Invariant(
                    $"{comparison.Rays} rays, {comparison.KernelSums.RaysReceived} received, {comparison.AtEdge} at edges, {comparison.Wrong} wrong; lengths differ by {1e6 * comparison.LargestLengthDifference:g3} um, rms {1e6 * comparison.RmsLengthDifference:g3}, phases by {comparison.LargestPhaseDifference:g3} rad, amplitudes {comparison.KernelSums.Amplitude:r} and {comparison.ReferenceSums.Amplitude:r}");
                TestContext.WriteLine(message);
                Assert.That(comparison.Wrong, Is.Zero, message);
                Assert.That(comparison.LargestPhaseDifference,
                    Is.LessThan(2 * PI_DBL * _lengthTolerance / settings.Wavelength + 4e-4), message);
                Assert.That(comparison.KernelSums.Amplitude, Is.EqualTo(comparison.ReferenceSums.Amplitude)
                    .Within(_amplitudeTolerance * sqrt(comparison.KernelSums.RaysReceived)), message);
                _rays += comparison.Rays;
                _received += comparison.KernelSums.RaysReceived;
                _atEdge += comparison.AtEdge;
            }

            public void Check(long minReceived)
            {
                Assert.That(_received, Is.GreaterThanOrEqualTo(minReceived), "rays received: too few show little");
                Assert.That(_atEdge, Is.LessThanOrEqualTo(1e-5 * _rays), "rays that took other triangles");
            }
        }
    }
}
