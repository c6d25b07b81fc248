using System.Collections.Generic;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// No ray escapes from a closed body: neither between triangles with a common edge or corner, nor through the
    /// triangle that it has just left.
    /// </summary>
    [Category("Slow")]
    public sealed class WatertightTests
    {
        // Six pictures of 90 degrees in all directions.
        static readonly (double3 right, double3 up, double3 forward)[] s_views =
        {
            (double3(1, 0, 0), double3(0, 1, 0), double3(0, 0, 1)),
            (double3(-1, 0, 0), double3(0, 1, 0), double3(0, 0, -1)),
            (double3(0, 0, -1), double3(0, 1, 0), double3(1, 0, 0)),
            (double3(0, 0, 1), double3(0, 1, 0), double3(-1, 0, 0)),
            (double3(1, 0, 0), double3(0, 0, -1), double3(0, 1, 0)),
            (double3(1, 0, 0), double3(0, 0, 1), double3(0, -1, 0)),
        };

        [Test]
        [Timeout(600000)]
        public void RaysAtCornersAndAlongEdges_NoneEscapes(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var (side, min) = asSoftware ? (100, 500_000) : (72, 200_000);
            var escapes = new Escapes(side, 1);
            escapes.LookAt(asSoftware, new[] { 1, 7, 64 }, areSomeDented: true);
            escapes.Check(min);
        }

        // The bodies are turned, so that rays hit them anywhere. Few triangles take the least time a ray.
        [Test]
        [Timeout(600000)]
        public void RaysAnywhere_NoneEscapes(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var (side, min) = asSoftware ? (300, 5_000_000) : (104, 500_000);
            var escapes = new Escapes(side, 1);
            escapes.LookAt(asSoftware, new[] { 1, 2, 7 }, areSomeDented: true,
                Affine.FromTransform(0, double4(0.1, 0.2, 0.3, 0.9), 1));
            escapes.Check(min);
        }

        // Millimetres to 100 km, at 1,000 km from the origin, stretched and mirrored.
        [Test]
        public void RaysInBodiesOfAllSizesAndPlaces_NoneEscapes(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var escapes = new Escapes(128, 1);
            using (var tracer = new RayTracer(TestKernels.Trace, "test", asSoftware))
                foreach (var scale in new[] { double3(1e-3), double3(1e5), double3(1, -2, 0.5), double3(-1, 30, 1) })
                    foreach (var position in new[] { double3(0), double3(1e6, -1e6, 12345.678) })
                        escapes.Look(tracer, $"jagged body times {scale} at {position}",
                            ClosedBodies.Jagged(16, 128, 3),
                            Affine.FromTransform(position, double4(0.1, 0.2, 0.3, 0.9), scale));
            escapes.Check(500_000);
        }

        // Without dented bodies: their walls lie in the rays' planes, and a ray along a wall is on neither side of it.
        [Test]
        [Timeout(600000)]
        public void ReflectedRays_NoneEscapes(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var escapes = new Escapes(64, 4);
            escapes.LookAt(asSoftware, new[] { 2, 7, 64 }, areSomeDented: false);
            escapes.Check(200_000);
        }

        sealed class Escapes
        {
            readonly int _side, _bounces;
            readonly List<string> _escapes = new List<string>();
            long _rays;

            public Escapes(int side, int bounces)
            {
                _side = side;
                _bounces = bounces;
            }

            // Bodies of each number of cells across a face.
            public void LookAt(bool asSoftware, int[] numbers, bool areSomeDented, Affine? transform = null)
            {
                using (var tracer = new RayTracer(TestKernels.Trace, "test", asSoftware))
                    foreach (int cells in numbers)
                    {
                        Look(tracer, $"sphere of {cells}", ClosedBodies.Sphere(cells, _side), transform);
                        Look(tracer, $"skewed body of {cells}", ClosedBodies.Skewed(cells, _side), transform);
                        Look(tracer, $"jagged body of {cells}", ClosedBodies.Jagged(cells, _side, cells), transform);
                        if (areSomeDented && cells > 2)
                            Look(tracer, $"dented body of {cells}", ClosedBodies.Dented(cells, _side, cells), transform);
                    }
            }

            public void Look(RayTracer tracer, string name, TriangleMesh mesh, Affine? transform = null)
            {
                var toWorld = transform ?? Affine.Identity;
                var settings = TestRadar.Settings(_side, _side, _bounces);
                foreach (var (right, up, forward) in s_views)
                {
                    // The receiver is outside: a ray that hits it has escaped.
                    var view = new RadarView
                    {
                        Position = toWorld.Origin, Right = right, Up = up, Forward = forward, VerticalFovDegrees = 90,
                        ReceiverCentre = toWorld.Origin - 1e6 * forward, ReceiverRight = right,
                        ReceiverUp = up, ReceiverForward = forward, ReceiverSize = 1,
                    };
                    var result = tracer.Trace(new RadarPose(
                            new RadarScene(new MeshInstance { Mesh = mesh, ToWorld = toWorld }), settings, view),
                        RayReadback.None);
                    long missing = _bounces * result.RaysEmitted - result.Bounces;
                    if (missing > 0)
                        _escapes.Add($"{name}, {mesh.TriangleCount} triangles, towards {forward}: "
                            + $"{result.RaysEmitted - result.RaysHit} rays at once, {missing} bounces missing");
                    _rays += result.RaysEmitted;
                }
            }

            public void Check(long min)
            {
                Assert.That(_escapes, Is.Empty);
                Assert.That(_rays, Is.GreaterThan(min));
            }
        }
    }
}
