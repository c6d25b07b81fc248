using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// Plate, dihedral and trihedral at any range. The radar's mirror image sends every ray straight to the receiver,
    /// in any order of the bounces.
    /// </summary>
    public sealed class ClosedFormTests
    {
        const double ReferenceTolerance = 1e-9, KernelTolerance = 1e-5; // m

        // Half the picture's height at the target, m.
        const double HalfPicture = 2.5;

        public enum Target
        {
            FacingPlate,
            TiltedPlate,
            Dihedral,
            Trihedral,
        }

        [Test]
        public void Reference_EveryReceivedRay_IsAsLongAsFromTheImage([Values] Target target,
            [Values(50, 1e4, 1e5)] double range, [Values] bool isParallel)
        {
            var setting = new Setting(target, range, isParallel);
            var rays = new ReferenceTracer(new RadarPose(setting.Scene, setting.Settings, setting.View)).TraceAll();
            int compared = 0;
            for (int pixel = 0; pixel < rays.Length; pixel++)
            {
                var ray = rays[pixel];
                if (!ray.Received || ray.Bounces != setting.Bounces)
                    continue;
                compared++;
                var expected = setting.Path(pixel);
                Assert.That(ray.PathLength, Is.EqualTo(expected.Length).Within(ReferenceTolerance), $"pixel {pixel}");
                Assert.That(distance(ray.Direction, expected.Direction), Is.LessThan(1e-14),
                    $"pixel {pixel}: direction");
                double3 fromImage = ray.LastHit - expected.Image;
                Assert.That(length(fromImage - dot(fromImage, expected.Direction) * expected.Direction),
                    Is.LessThan(ReferenceTolerance), $"pixel {pixel}: the last hit is on the line from the image");
                Assert.That(ray.LengthToLastHit,
                    Is.EqualTo(dot(fromImage, expected.Direction)).Within(ReferenceTolerance),
                    $"pixel {pixel}: to the last hit");
            }
            Assert.That(compared, Is.GreaterThan(40));
        }

        [Test]
        public void Kernel_EveryReceivedRay_IsAsLongAsFromTheImage([Values] Target target,
            [Values(50, 1e4, 1e5)] double range, [Values] bool isParallel)
        {
            var setting = new Setting(target, range, isParallel);
            RayData[] rays;
            using (var tracer = new RayTracer(TestKernels.Trace))
            {
                rays = tracer.Trace(new RadarPose(setting.Scene, setting.Settings, setting.View), RayReadback.Received)
                    .Rays.Where(ray => ray.Bounces == setting.Bounces).ToArray();
            }
            foreach (var ray in rays)
            {
                var expected = setting.Path((int)ray.Pixel);
                Assert.That(ray.RefinedPathLength,
                    Is.EqualTo(expected.Length).Within(KernelTolerance), $"pixel {ray.Pixel}");
                double phase = Signal.Phase(expected.Length, setting.Settings.Wavelength);
                Assert.That(abs(System.Math.IEEERemainder(ray.Phase - phase, 2 * PI_DBL)), Is.LessThan(0.0025),
                    $"pixel {ray.Pixel}: phase");
            }
            Assert.That(rays.Length, Is.GreaterThan(40));
        }

        /// <summary>A ray unfolded at the mirrors: one straight line.</summary>
        struct Line
        {
            public double3 Image, Direction;
            public double Length; // to the receiver's plane, m
        }

        sealed class Setting
        {
            // Rotated so that no normal is exact in float32.
            static readonly Affine s_transform =
                Affine.FromTransform(double3(117.5, -31.25, 43), double4(0.3, -0.2, 0.5, 0.8), 1);

            readonly double3[] _mirrors;

            public Setting(Target target, double range, bool isParallel)
            {
                double3 x = s_transform.X, y = s_transform.Y, z = s_transform.Z, vertex = s_transform.Origin, toRadar;
                switch (target)
                {
                    case Target.FacingPlate:
                        (Mesh, _mirrors, toRadar) = (TestRadar.FacingPlate(4, 0), new[] { z }, -z);
                        break;
                    case Target.TiltedPlate:
                        (Mesh, _mirrors, toRadar) =
                            (TestRadar.FacingPlate(4, 0), new[] { z }, normalize(0.3 * x + 0.4 * y - z));
                        break;
                    case Target.Dihedral:
                        var floor = TestRadar.Plate(float3(-2, 0, 0), float3(4, 0, 0), float3(0, 0, -4));
                        var wall = TestRadar.Plate(float3(-2, 0, 0), float3(4, 0, 0), float3(0, 4, 0));
                        (Mesh, _mirrors, toRadar) =
                            (TestRadar.Join(floor, wall), new[] { y, z }, normalize(4 * y - 5 * z));
                        break;
                    default:
                        (Mesh, _mirrors, toRadar) =
                            (TestRadar.Trihedral(0, 4), new[] { x, y, z }, normalize(9 * x + 10 * y + 11 * z));
                        break;
                }
                View = TestRadar.LookAt(vertex + range * toRadar, vertex, degrees(2 * atan(HalfPicture / range)));
                if (isParallel)
                    View.ApertureHeight = 2 * HalfPicture;
                if (target == Target.TiltedPlate)
                {
                    var mirrored = TestRadar.LookAt(vertex + range * (2 * dot(toRadar, z) * z - toRadar), vertex);
                    View.ReceiverCentre = mirrored.ReceiverCentre;
                    (View.ReceiverRight, View.ReceiverUp, View.ReceiverForward) =
                        (mirrored.Right, mirrored.Up, mirrored.Forward);
                }
            }

            TriangleMesh Mesh { get; }

            public RadarScene Scene => new RadarScene(new MeshInstance { Mesh = Mesh, ToWorld = s_transform });

            // Offsets that are odd over even numbers, so that rays miss edges and diagonals.
            public RadarSettings Settings { get; } = TestRadar.Settings(46, 37);

            public readonly RadarView View;

            public int Bounces => _mirrors.Length;

            public Line Path(int pixel)
            {
                var line = new Line
                {
                    Image = TestRadar.Start(Settings, View, pixel),
                    Direction = TestRadar.Direction(Settings, View, pixel)
                };
                foreach (var normal in _mirrors)
                {
                    line.Image -= 2 * dot(line.Image - s_transform.Origin, normal) * normal;
                    line.Direction -= 2 * dot(line.Direction, normal) * normal;
                }
                line.Length = dot(View.ReceiverCentre - line.Image, View.ReceiverForward)
                    / dot(line.Direction, View.ReceiverForward);
                return line;
            }
        }
    }
}
