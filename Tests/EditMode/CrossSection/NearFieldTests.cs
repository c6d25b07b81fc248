using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Cross sections at a finite range, with several receivers from one trace.</summary>
    [Category("Slow")]
    public sealed class NearFieldTests : CrossSectionFixture
    {
        const double TenGigahertz = 1e10, Range = 3;

        // The radar is on the plate's normal, receivers are around it in the plane of its width. To second order the
        // way by a place (x, y) is longer than that by the centre by (x^2 + y^2) / 2R from the radar, and by
        // -x sin(angle) + (x^2 cos^2(angle) + y^2) / 2R to the receiver; the third order is below k x^3 / 5R^2 = 7e-3
        // at the rim.
        [Test]
        public void PlateOnItsNormal_ReceiversAround_IsTheFresnelIntegral()
        {
            const double a = 0.5, b = 0.3, range = 10;
            double[] angles = { 0, 2, 5, 10, 15, 20, 30, 40 };
            var receivers = angles.Select(phi => PublishedRow.Aspect(90, phi)).ToArray();
            var pose = PoseOf(CrossSectionTargets.Plate(a, b), 90, 0, receivers);
            (pose.Range, pose.ToleranceDb) = (range, 0.01);
            var result = Tracer.Trace(pose);
            double k = 2 * PI_DBL / Signal.Wavelength(TenGigahertz), largest = k / Math.Sqrt(PI_DBL) * a * b;
            for (int i = 0; i < angles.Length; i++)
            {
                double sine = sin(radians(angles[i])), cosine = cos(radians(angles[i]));
                double bend = (1 + cosine * cosine) / (2 * range);
                double vv = k / Math.Sqrt(PI_DBL) * Integral(x => k * (x * sine - x * x * bend), a)
                    * Integral(y => -k * y * y / range, b);
                var s = result.S[i, 0];
                Assert.That(s.VV.Magnitude, Is.EqualTo(vv).Within(3e-3 * largest), $"VV at {angles[i]}");
                Assert.That(s.HH.Magnitude, Is.EqualTo(cosine * vv).Within(3e-3 * largest), $"HH at {angles[i]}");
            }
        }

        // Phases bend little over a cell, so that cells stay whole as in the far field. Gradients that lacked the slope of the
        // way from the radar took a hundred times the rays.
        [Test]
        public void PlateAtARange_TakesAboutTheRaysOfTheFarField()
        {
            var radar = PublishedRow.Aspect(90, 0);
            var pose = PoseOf(CrossSectionTargets.Plate(0.5, 0.5), 90, 0, radar);
            (pose.Range, pose.ToleranceDb, pose.HasEdges) = (10, 0.02, false);
            var near = Tracer.Trace(pose);
            pose.Range = double.PositiveInfinity;
            var far = Tracer.Trace(pose);
            Assert.That(near.IsMet && far.IsMet);
            Assert.That(near.Rays, Is.LessThan(3 * far.Rays));
        }

        // Off its normal, where directions, V and H change along the plate.
        [Test]
        public void PlateOffItsNormal_IsTheSumOverItsPlaces()
        {
            const double a = 0.3, b = 0.2;
            var pose = PoseOf(CrossSectionTargets.Plate(a, b), 60, 40, PublishedRow.Aspect(60, 40),
                PublishedRow.Aspect(75, -30), PublishedRow.Aspect(110, 20));
            (pose.Range, pose.ToleranceDb) = (1.5, 0.02);
            var result = Tracer.Trace(pose);
            for (int i = 0; i < pose.Receivers.Length; i++)
            {
                var expected = SumOverPlate(a, b, pose.Range, pose.Radar, pose.Receivers[i]);
                double allowed = CrossSectionAccuracy.AllowedBy(pose.ToleranceDb)
                    * ErrorPose.ScaleOf(expected, result.FloorDbsm);
                AssertWithin(result.S[i, 0], expected, allowed, $"receiver {i}");
            }
        }

        // Currents of physical optics, 2 n x H, in the plane x = 0.
        static ScatteringMatrix SumOverPlate(double a, double b, double range, RadarAspect radar, RadarAspect receiver)
        {
            const int steps = 1000;
            double k = 2 * PI_DBL / Signal.Wavelength(TenGigahertz), area = a * b / (steps * steps);
            double3 normal = double3(1, 0, 0), from = range * radar.ToRadar, to = range * receiver.ToRadar;
            var sum = new ScatteringMatrix();
            for (int i = 0; i < steps; i++)
                for (int j = 0; j < steps; j++)
                {
                    double3 place = double3(0, ((j + 0.5) / steps - 0.5) * b, ((i + 0.5) / steps - 0.5) * a);
                    double way = length(place - from), back = length(to - place);
                    double3 direction = (place - from) / way;
                    var (sentV, sentH) = Across(radar, direction);
                    var (v, h) = Across(receiver, (to - place) / back);
                    double3 currentV = cross(normal, cross(direction, sentV)),
                        currentH = cross(normal, cross(direction, sentH));
                    sum += Complex.FromPolarCoordinates(range * range / (way * back), -k * (way + back - 2 * range))
                        * new ScatteringMatrix
                        {
                            VV = dot(v, currentV), HV = dot(h, currentV), VH = dot(v, currentH), HH = dot(h, currentH)
                        };
                }
            return new Complex(0, -k / Math.Sqrt(PI_DBL) * area) * sum;
        }

        // V and H of unit length across a ray.
        static (double3 V, double3 H) Across(RadarAspect aspect, double3 direction)
        {
            double3 v = normalize(aspect.Up - dot(aspect.Up, direction) * direction);
            double3 h = cross(direction, v);
            return (v, dot(h, aspect.Right) > 0 ? h : -h);
        }

        // Bounces between faces, what they hide, and edges.
        [TestCase(true, Category = "Stress")]
        [TestCase(false)]
        public void Receivers_OfACorner_AreThoseOfTheReference(bool isDihedral)
        {
            var mesh = isDihedral ? CrossSectionTargets.Dihedral(0.15, 0.1)
                : CrossSectionTargets.Trihedral(0.12, CrossSectionTargets.TrihedralFace.Triangular);
            var pose = PoseOf(mesh, 70, 30, PublishedRow.Aspect(70, 30), PublishedRow.Aspect(60, 45),
                PublishedRow.Aspect(75, 10), PublishedRow.Aspect(50, 80));
            (pose.HasEdges, pose.Range) = (isDihedral, 1.5);
            pose.PhaseCentre = new double3(0.02, -0.01, 0.03);
            var result = Tracer.Trace(pose);
            var expected = new ReferenceCrossSection(pose.Scene).Compute(pose,
                new TubeSettings { CellsPerWavelength = 32, MaxDepth = 5, MaxPhaseError = 0.01 });
            Assert.That(result.IsMet);
            double squares = 0;
            int beyond = 0;
            for (int i = 0; i < pose.Receivers.Length; i++)
            {
                double allowed = CrossSectionAccuracy.AllowedBy(pose.ToleranceDb)
                    * ErrorPose.ScaleOf(expected[i, 0], result.FloorDbsm);
                var (s, truth) = (result.S[i, 0], expected[i, 0]);
                beyond += Polarisation.All.Count(polarisation =>
                    (polarisation.Of(s) - polarisation.Of(truth)).Magnitude > allowed);
                double ratio = RootMeanSquare(result.S[i, 0], expected[i, 0]) / result.Errors[i, 0];
                Assert.That(ratio, Is.LessThan(3), $"true over said, receiver {i}");
                squares += ratio * ratio / pose.Receivers.Length;
            }
            // The tolerance is met by 95 % of amplitudes. Of the dihedral HH at receiver 3, in a null, differs by 0.99 to 1.09
            // times what is allowed, where 0.46 is said.
            Assert.That(beyond, Is.LessThanOrEqualTo(1));
            Assert.That(Math.Sqrt(squares), Is.GreaterThan(1 / 3.0));
        }

        // Of the errors of VV and HH.
        static double RootMeanSquare(ScatteringMatrix s, ScatteringMatrix expected) =>
            length(new double2((s.VV - expected.VV).Magnitude, (s.HH - expected.HH).Magnitude)) / Math.Sqrt(2);

        // The phase centre is beside the middle of the plate, so that the plate is not its own image in the swap.
        [Test]
        public void MirrorDirection_OfAPlate_IsReciprocal()
        {
            RadarAspect here = PublishedRow.Aspect(80, 25), there = PublishedRow.Aspect(100, -25),
                aside = PublishedRow.Aspect(85, 5);
            ScatteringMatrix To(RadarAspect from, RadarAspect to)
            {
                var pose = PoseOf(CrossSectionTargets.Plate(0.4, 0.3), 0, 0, aside, to);
                (pose.Radar, pose.Range, pose.PhaseCentre) = (from, Range, new double3(0, 0.03, 0.05));
                return Tracer.Trace(pose).S[1, 0];
            }
            ScatteringMatrix s = To(here, there), back = To(there, here);
            // Directions at the rim are not those of the mirror: the reference differs by 1.5 %.
            double allowed = 0.02 * s.VV.Magnitude;
            Assert.That(s.VV.Magnitude, Is.GreaterThan(3), "the mirror's lobe");
            (back.HV, back.VH) = (back.VH, back.HV);
            AssertWithin(s, back, allowed, "back");
        }

        // Receivers of a trace, each in one of its own; the cylinder has normals that change.
        [TestCase(false)]
        [TestCase(true)]
        public void Receivers_Together_EqualSingleOnes(bool isRound)
        {
            var mesh = isRound ? CrossSectionTargets.Cylinder(0.04, 0.12, 60, true)
                : CrossSectionTargets.Dihedral(0.3, 0.2);
            var receivers = new[] { -110.0, -120, -135, -128 }.Select(at => RadarAspect.At(at, 5)).ToArray();
            var pose = PoseOf(mesh, 90, 30, receivers);
            pose.ToleranceDb = isRound ? 0.2 : 0.05;
            var together = Tracer.Trace(pose);
            for (int i = 0; i < receivers.Length; i++)
            {
                pose.Receivers = new[] { receivers[i] };
                var s = Tracer.Trace(pose).S[0, 0];
                double allowed = 2 * CrossSectionAccuracy.AllowedBy(pose.ToleranceDb)
                    * ErrorPose.ScaleOf(s, together.FloorDbsm);
                AssertWithin(together.S[i, 0], s, allowed, $"receiver {i}");
            }
        }

        // Magnitude of the integral of exp(j phase) over a length about 0.
        static double Integral(Func<double, double> phase, double length)
        {
            const int steps = 4000;
            var sum = Complex.Zero;
            for (int i = 0; i < steps; i++)
                sum += Complex.FromPolarCoordinates(length / steps, phase(((i + 0.5) / steps - 0.5) * length));
            return sum.Magnitude;
        }

        static CrossSectionPose PoseOf(TriangleMesh mesh, double theta, double phi, params RadarAspect[] receivers) =>
            new CrossSectionPose
            {
                Scene = new RadarScene(mesh), Radar = PublishedRow.Aspect(theta, phi), Receivers = receivers,
                Range = Range, Frequencies = new[] { TenGigahertz }, ToleranceDb = 0.05, HasEdges = false,
                MaxBounces = 3
            };

        static void AssertWithin(ScatteringMatrix s, ScatteringMatrix expected, double allowed, string message)
        {
            Assert.That((s.VV - expected.VV).Magnitude, Is.LessThan(allowed), $"VV, {message}");
            Assert.That((s.HV - expected.HV).Magnitude, Is.LessThan(allowed), $"HV, {message}");
            Assert.That((s.VH - expected.VH).Magnitude, Is.LessThan(allowed), $"VH, {message}");
            Assert.That((s.HH - expected.HH).Magnitude, Is.LessThan(allowed), $"HH, {message}");
        }
    }
}
