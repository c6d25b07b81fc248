using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// The narrow side face of a box, which the wave meets at grazing incidence after a mirror: its strip of the grid is far
    /// narrower than a cell, and its phase is constant along it. What the box returns has a closed form.
    /// </summary>
    [Category("Slow")]
    public sealed class MirroredOutlineTests : CrossSectionFixture
    {
        const double Width = 0.4, Height = 0.5, TenGigahertz = 1e10, ToleranceDb = 0.1;

        // The radar is in the direction 0 of the plane across the upright edges of the box; the mirror illuminates it from Beta.
        const double BetaDegrees = 60, RollDegrees = 20, MirrorDistance = 3;

        static readonly RadarAspect s_radar = RadarAspect.At(25, 0);

        // m
        [TestCase(0.003, Category = "Stress")]
        [TestCase(0.01)]
        [TestCase(0.03, Category = "Stress")]
        [Timeout(600000)]
        public void Trace_OfABoxBeforeAMirror_IsWithinTheTolerance(double thickness)
        {
            var excesses = new List<double>();
            foreach (double turn in new[] { -20, -23, -26, -28, -29, -29.6 })
            {
                var result = Tracer.Trace(PoseOf(turn, thickness));
                Assert.That(result.IsMet);
                var expected = Expected(turn, thickness);
                foreach (var polarisation in Polarisation.All)
                {
                    var s = polarisation.Of(expected);
                    excesses.Add((polarisation.Of(result.S[0, 0]) - s).Magnitude / (CrossSectionAccuracy.AllowedBy(ToleranceDb)
                        * CrossSectionAccuracy.ScaleOf(s, result.FloorDbsm)));
                }
            }
            int beyond = excesses.Count(excess => excess > 1);
            TestContext.WriteLine(FormattableString.Invariant(
                $"{beyond} of {excesses.Count} above the tolerance, by up to {excesses.Max():0.00} times"));
            // Without rays beside the images of outlines 16 of 72, of the three thicknesses, were above it, by up to 57 times.
            Assert.That(beyond, Is.LessThanOrEqualTo(0.05 * excesses.Count));
            Assert.That(excesses.Max(), Is.LessThan(2));
        }

        static double3 Upright => Turned(s_radar.Up, s_radar.Right, -RollDegrees);

        static double3 Turned(double3 from, double3 towards, double degrees) =>
            Math.Cos(math.radians(degrees)) * from + Math.Sin(math.radians(degrees)) * towards;

        // Unit vector in the plane.
        static double3 InPlane(double degrees) => Turned(s_radar.ToRadar, Turned(s_radar.Right, s_radar.Up, RollDegrees), degrees);

        // Halfway between the radar and the box, as the mirror sees them.
        static double3 MirrorNormal => InPlane(BetaDegrees / 2 - 90);

        // Physical optics: of the faces of the box that the mirrored wave meets, towards the radar.
        static ScatteringMatrix Expected(double turn, double thickness)
        {
            double k = 2 * Math.PI / Signal.Wavelength(TenGigahertz);
            double3 m = MirrorNormal, from = MirrorDistance * InPlane(BetaDegrees), sight = -s_radar.ToRadar;
            double3 Mirrored(double3 v) => v - 2 * math.dot(v, m) * m;
            double3 onto = Mirrored(sight), thin = InPlane(turn), wide = InPlane(turn + 90), w = k * (s_radar.ToRadar - onto);
            Complex Face(double3 centre, double3 side) => Height * math.length(side)
                * TubeField.Sinc(math.dot(w, side) / 2) * TubeField.Sinc(Height * math.dot(w, Upright) / 2)
                * Complex.Exp(new Complex(0, math.dot(w, centre) - 2 * k * math.dot(sight, m) * math.dot(from, m)));
            Complex thinFace = Face(Width / 2 * thin, thickness * wide), wideFace = Face(thickness / 2 * wide, Width * thin);
            Complex Received(double3 received, double3 sent) => new Complex(0, -k / Math.Sqrt(Math.PI))
                * (Current(received, -Mirrored(sent), thin) * thinFace + Current(received, -Mirrored(sent), wide) * wideFace);
            double Current(double3 received, double3 arriving, double3 normal) =>
                math.dot(received, math.cross(normal, math.cross(onto, arriving)));
            return new ScatteringMatrix
            {
                VV = Received(s_radar.Up, s_radar.Up), HV = Received(s_radar.Right, s_radar.Up),
                VH = Received(s_radar.Up, s_radar.Right), HH = Received(s_radar.Right, s_radar.Right)
            };
        }

        static CrossSectionPose PoseOf(double turn, double thickness) => new CrossSectionPose
        {
            Scene = new RadarScene(BoxAt(0, InPlane(turn), Width, thickness, Height),
                BoxAt(MirrorDistance * InPlane(BetaDegrees) - 0.01 * MirrorNormal, MirrorNormal, 0.02, 1.6, 0.9)),
            Radar = s_radar, Receivers = new[] { s_radar }, Frequencies = new[] { TenGigahertz }, HasEdges = false,
            MaxBounces = 2, OnlyBounce = 2, ToleranceDb = ToleranceDb, Polarisations = Polarisation.All
        };

        // A box whose upright edges are across the plane, with a face along a normal.
        static MeshInstance BoxAt(double3 centre, double3 normal, double depth, double across, double height) => new MeshInstance
        {
            Mesh = CrossSectionTargets.Box(across, height, depth),
            ToWorld = new Affine { X = normal, Y = Upright, Z = math.cross(normal, Upright), Origin = centre }
        };
    }
}
