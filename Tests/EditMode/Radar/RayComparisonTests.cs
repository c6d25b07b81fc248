using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// Which rays count as equal, as passing the other side of an edge, and as wrong. The kernel's rays are the
    /// reference tracer's, modified.
    /// </summary>
    public sealed class RayComparisonTests
    {
        const double Tolerance = 1e-5; // m

        // Moves the left edge of a 4 m plate at 20 m to the column of rays 13.5 ray spacings left of the centre.
        const double EdgeToColumn = 2 - 13.5 * 2 * 11.547005383792515 / 90;

        static readonly RadarSettings s_settings = TestRadar.Settings();
        static readonly RadarView s_view = TestRadar.LookAt(0, double3(0, 0, 1));

        static RadarScene Plate(double aside = 0)
        {
            var transform = Affine.Identity;
            transform.Origin.x = aside;
            return new RadarScene(new MeshInstance { Mesh = TestRadar.FacingPlate(4, 20), ToWorld = transform });
        }

        static RayData[] Rays(RadarScene scene) =>
            new ReferenceTracer(new RadarPose(scene, s_settings, s_view)).TraceAll().Select((ray, pixel) =>
            {
                double length = ray.LengthToEnd, phase = Signal.Phase(length, s_settings.Wavelength);
                var data = new RayData
                {
                    Pixel = (uint)pixel, Bounces = (uint)ray.Bounces,
                    LastHit = (float3)ray.LastHit, Direction = (float3)ray.Direction,
                    PathLength = (float)length, PathLengthLo = (float)(length - (float)length),
                };
                data.IsReceived = ray.Received;
                if (ray.Received)
                    (data.InPhase, data.Quadrature) = ((float)cos(phase), (float)sin(phase));
                return data;
            }).ToArray();

        static RayComparison Compare(RadarScene reference, RayData[] rays)
        {
            var comparison = new RayComparison(new RadarPose(reference, s_settings, s_view), Tolerance);
            comparison.Add(rays);
            Assert.That(comparison.Rays, Is.EqualTo(rays.Length));
            Assert.That(comparison.Same + comparison.AtEdge + comparison.Wrong, Is.EqualTo(rays.Length));
            return comparison;
        }

        [Test]
        public void Add_TheReferenceTracersOwnRays_AreTheSame()
        {
            var comparison = Compare(Plate(), Rays(Plate()));
            Assert.That(comparison.Same, Is.EqualTo(160 * 90));
            Assert.That(comparison.KernelSums.RaysReceived, Is.GreaterThan(10));
            Assert.That(comparison.KernelSums.RaysReceived, Is.EqualTo(comparison.ReferenceSums.RaysReceived));
            Assert.That(comparison.KernelSums.Amplitude, Is.EqualTo(comparison.ReferenceSums.Amplitude).Within(1e-5));
            Assert.That(comparison.LargestLengthDifference, Is.LessThan(1e-12));
            Assert.That(comparison.LargestPhaseDifference, Is.LessThan(1e-6));
        }

        [TestCase(5e-6, 0)]
        [TestCase(2e-5, 1)]
        public void Add_ReceivedRayOfAnotherLength_IsWrongBeyondTheTolerance(double difference, int wrong)
        {
            var rays = Rays(Plate());
            // The first ray hits the common edge of the plate's two triangles.
            uint received = rays.Where(ray => ray.IsReceived).ElementAt(1).Pixel;
            rays[received].PathLengthLo += (float)difference;
            var comparison = Compare(Plate(), rays);
            Assert.That(comparison.Wrong, Is.EqualTo(wrong));
            if (wrong > 0)
                Assert.That(comparison.WrongRays.Single().Kernel.Pixel, Is.EqualTo(received));
            else
                Assert.That(comparison.LargestLengthDifference, Is.EqualTo(difference).Within(1e-9));
        }

        [TestCase(5e-7, 0)]
        [TestCase(1e-4, 16)]
        public void Add_RaysThatPassAnEdgeOnItsOtherSide_AreWrongIfTheyPassItFarOff(double off, int wrong)
        {
            // Float32 positions have errors of some micrometres here. The column's 16 rays pass between the reference
            // tracer's edge and the kernel's.
            var comparison = Compare(Plate(EdgeToColumn + off), Rays(Plate(EdgeToColumn - off)));
            Assert.That(comparison.AtEdge, Is.EqualTo(16 - wrong));
            Assert.That(comparison.Wrong, Is.EqualTo(wrong));
        }

        [Test]
        public void Add_RayThatLeftAnotherWay_IsWrong()
        {
            var rays = Rays(Plate());
            uint lost = rays.Last(ray => ray.Bounces == 1 && !ray.IsReceived).Pixel;
            rays[lost].PathLength += 0.1f;
            Assert.That(Compare(Plate(), rays).Wrong, Is.EqualTo(1));
        }

        [Test]
        public void Add_RayThatBouncedOffNothing_IsWrong()
        {
            var rays = Rays(Plate());
            rays[0].Bounces = 1;
            Assert.That(Compare(Plate(), rays).Wrong, Is.EqualTo(1));
        }
    }
}
