using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Symmetries, closed forms and promises of the kernels' cross sections.</summary>
    [Category("Slow")]
    public sealed class CrossSectionTracerTests : CrossSectionFixture
    {
        const double TenGigahertz = 1e10;

        [Test, Timeout(60000)]
        public void Trace_CellsOfADispatch_ChangeNoBit()
        {
            var pose = PoseOf(CrossSectionTargets.Trihedral(0.2, CrossSectionTargets.TrihedralFace.Square), 35, 30);
            var expected = Trace(pose);
            foreach (int cells in new[] { 1000, 177, 64 })
            {
                Tracer.CellsADispatch = cells;
                var s = Trace(pose);
                Tracer.CellsADispatch = 0;
                Assert.That(new[] { s.VV, s.HV, s.VH, s.HH },
                    Is.EqualTo(new[] { expected.VV, expected.HV, expected.VH, expected.HH }), $"{cells} cells");
            }
        }

        // Which cells earlier attempts reveal does not depend on slices, and a slice that is traced again does not meet what it has
        // revealed itself: the contributions of a pose, in slices of their own, are those of the same tubes.
        [Test, Timeout(60000)]
        public void Trace_RevealedCells_AreTheSameInAnySlices()
        {
            var pose = ErrorPose.Of("ship", ErrorPose.SceneOf("ship"), 17);
            var expected = Tracer.Trace(pose);
            Assert.That(expected.Attempts.Count, Is.GreaterThan(1));
            Tracer.CellsADispatch = 50;
            var result = Tracer.Trace(pose);
            var contributions = Tracer.Contributions(pose, result, 0, 0, Polarisation.All);
            Tracer.CellsADispatch = 0;
            Assert.That(result.S, Is.EqualTo(expected.S));
            Assert.That((result.Tubes, result.CrossErrors[0, 0]), Is.EqualTo((expected.Tubes, expected.CrossErrors[0, 0])));
            var sum = contributions.Objects.Aggregate(Complex.Zero, (all, part) => all + part.S.HV);
            Assert.That((sum - expected.S[0, 0].HV).Magnitude, Is.LessThan(1e-13), "of the same tubes");
        }

        // Poses of one dispatch share its lists, marks and sums, and end after different numbers of attempts. The fourth has
        // another number of receivers, and is traced alone.
        [Test, Timeout(60000)]
        public void Trace_ManyPoses_AreThoseOfSingleOnesBitForBit([Values(0, 500)] int cells)
        {
            var mesh = CrossSectionTargets.Trihedral(0.2, CrossSectionTargets.TrihedralFace.Square);
            var poses = new[] { (35.0, 30.0), (0, 0), (-70, 12), (20, 5), (44, 44) }
                .Select(at => PoseOf(mesh, at.Item1, at.Item2)).ToArray();
            foreach (var pose in poses)
                (pose.Scene, pose.ToleranceDb) = (poses[0].Scene, 0.02);
            poses[3].Receivers = new[] { poses[3].Radar, poses[4].Radar };
            var expected = poses.Select(pose => Tracer.Trace(pose)).ToArray();
            Assert.That(expected.Select(result => result.Attempts.Last().CellError).Distinct().Count(), Is.GreaterThan(1), "attempts");
            (Tracer.PosesTogether, Tracer.CellsADispatch) = (4, cells);
            var results = Tracer.Trace(poses);
            (Tracer.PosesTogether, Tracer.CellsADispatch) = (1, 0);
            for (int i = 0; i < poses.Length; i++)
            {
                Assert.That(results[i].S, Is.EqualTo(expected[i].S), $"pose {i}");
                Assert.That(results[i].Errors, Is.EqualTo(expected[i].Errors), $"pose {i}");
                Assert.That((results[i].Tubes, results[i].IsMet), Is.EqualTo((expected[i].Tubes, expected[i].IsMet)), $"pose {i}");
                Assert.That(results[i].Attempts, Is.EqualTo(expected[i].Attempts), $"pose {i}");
                if (cells == 0)
                    Assert.That(results[i].Rays, Is.EqualTo(expected[i].Rays), $"pose {i}");
            }
        }

        [Test, Timeout(60000)]
        public void Trace_Bounces_AreTheMostOfATube()
        {
            int BouncesOf(TriangleMesh mesh) => Tracer.Trace(PoseOf(mesh, 35, 30)).Bounces;
            Assert.That(BouncesOf(CrossSectionTargets.Plate(0.3, 0.2)), Is.EqualTo(1));
            Assert.That(BouncesOf(CrossSectionTargets.Dihedral(0.3, 0.2)), Is.EqualTo(2));
            Assert.That(BouncesOf(CrossSectionTargets.Trihedral(0.2, CrossSectionTargets.TrihedralFace.Square)),
                Is.EqualTo(3));
        }

        // The component of E along the edge t returns, that across it returns negative. t is turned by 22.5 degrees from V
        // towards -H: VV = cos 45, HH = -cos 45, VH = HV = -sin 45, times that of the double bounce.
        [Test, Timeout(60000)]
        public void Trace_DihedralTurnedAboutTheSight_HasItsSigns()
        {
            var pose = PoseOf(CrossSectionTargets.DihedralAboutSight(0.3, 0.2, 22.5), 0, 0);
            (pose.MaxBounces, pose.OnlyBounce) = (2, 2);
            var s = Trace(pose);
            Assert.That(s.VV.Magnitude, Is.EqualTo(Math.Pow(10, 17.0187 / 20)).Within(AllowedOf(pose, s.VV)));
            foreach (var other in new[] { s.HH, s.VH, s.HV })
                Assert.That((other + s.VV).Magnitude, Is.LessThan(AllowedOf(pose, s.VV)));
        }

        // S = -j k / sqrt(4 pi) 2 A, down to a thousandth of a wavelength: sums have units of a cell, not of a wavelength.
        [TestCase(1e6)]
        [TestCase(1e7)]
        [TestCase(1e8)]
        [Timeout(60000)]
        public void Trace_PlateBelowAWavelength_HasItsClosedForm(double frequency)
        {
            var pose = PoseOf(CrossSectionTargets.Plate(0.3, 0.2), 0, 0);
            (pose.Frequencies, pose.FloorDbsm) = (new[] { frequency }, -120);
            double expected = 2 * Math.PI / Signal.Wavelength(frequency) / Math.Sqrt(Math.PI) * 0.3 * 0.2;
            foreach (var s in new[] { Trace(pose).VV, Trace(pose).HH })
                Assert.That(s.Magnitude, Is.EqualTo(expected).Within(CrossSectionAccuracy.AllowedBy(pose.ToleranceDb) * expected));
        }

        [Test, Timeout(60000)]
        public void Trace_MovedTarget_TurnsThePhaseOnly([Values(0.013, -1.7)] double along)
        {
            var mesh = CrossSectionTargets.Dihedral(0.3, 0.2);
            var pose = PoseOf(mesh, 30, 10);
            var still = Trace(pose);
            double3 move = along * new double3(0.6, 0.48, -0.64);
            var toWorld = Affine.Identity;
            toWorld.Origin = move;
            pose.Scene = new RadarScene(new MeshInstance { Mesh = mesh, ToWorld = toWorld });
            var moved = Trace(pose);
            double k = 2 * Math.PI / Signal.Wavelength(TenGigahertz);
            var turn = Complex.FromPolarCoordinates(1, 2 * k * math.dot(pose.Radar.ToRadar, move));
            Assert.That((moved.VV - turn * still.VV).Magnitude, Is.LessThan(AllowedOf(pose, still.VV)));
            Assert.That((moved.HH - turn * still.HH).Magnitude, Is.LessThan(AllowedOf(pose, still.HH)));
        }

        [Test, Timeout(60000)]
        public void Trace_RadarAndTargetTurnedTogether_IsTheSame()
        {
            var mesh = CrossSectionTargets.TwoPlates(0.2, 0.2, 0.3);
            var pose = PoseOf(mesh, 8, 5);
            var expected = Trace(pose);
            var turned = Affine.FromTransform(0, math.normalize(new double4(0.3, -0.7, 0.2, 0.5)), 1);
            pose.Scene = new RadarScene(new MeshInstance { Mesh = mesh, ToWorld = turned });
            pose.Radar = new RadarAspect(turned.Vector(pose.Radar.ToRadar), turned.Vector(pose.Radar.Up),
                turned.Vector(pose.Radar.Right));
            pose.Receivers = new[] { pose.Radar };
            var s = Trace(pose);
            Assert.That((s.VV - expected.VV).Magnitude, Is.LessThan(AllowedOf(pose, expected.VV)));
            Assert.That((s.HH - expected.HH).Magnitude, Is.LessThan(AllowedOf(pose, expected.HH)));
        }

        // The target is turned and moved, its triangles are divided and in another order; the radar turns with it.
        [Test, Timeout(60000)]
        public void Trace_SameTargetInAnotherPlaceAndMesh_IsTheSame([Range(1, 6)] int seed)
        {
            var random = new System.Random(seed);
            double Within(double from, double to) => from + (to - from) * random.NextDouble();
            var mesh = new[]
            {
                CrossSectionTargets.Dihedral(0.25, 0.125), CrossSectionTargets.TwoPlates(0.2, 0.2, 0.3),
                CrossSectionTargets.Trihedral(0.25, CrossSectionTargets.TrihedralFace.Triangular)
            }[seed % 3];
            var pose = PoseOf(mesh, Within(15, 75), Within(10, 60));
            (pose.HasEdges, pose.ToleranceDb) = (true, CrossSectionPose.DefaultToleranceDb);
            if (seed % 2 == 0)
                pose.Receivers = new[] { PublishedRow.Aspect(Within(30, 80), Within(15, 75)) };
            var expected = Trace(pose);
            var placed = Affine.FromTransform(new double3(Within(-3, 3), Within(-3, 3), Within(-3, 3)),
                math.normalize(new double4(Within(-1, 1), Within(-1, 1), Within(-1, 1), Within(0.1, 1))), 1);
            RadarAspect Turned(RadarAspect at) =>
                new RadarAspect(placed.Vector(at.ToRadar), placed.Vector(at.Up), placed.Vector(at.Right));
            pose.Scene = new RadarScene(new MeshInstance
            { Mesh = Shuffled(ReferenceCrossSectionTests.Split(mesh), random), ToWorld = placed });
            (pose.Radar, pose.Receivers) = (Turned(pose.Radar), Array.ConvertAll(pose.Receivers, Turned));
            pose.PhaseCentre = placed.Origin;
            var s = Trace(pose);
            Assert.That((s.VV - expected.VV).Magnitude, Is.LessThan(AllowedOf(pose, expected.VV)));
            Assert.That((s.HH - expected.HH).Magnitude, Is.LessThan(AllowedOf(pose, expected.HH)));
            Assert.That(s.VV.Magnitude, Is.GreaterThan(0));
        }

        // Plate: the direction of the mirror. Dihedral: 80 and 100 degrees, mirrored in the plane across its edge; its
        // single bounces are far from their specular direction.
        [TestCase(false, 70, 30, 110, -30)]
        [TestCase(false, 105, -20, 75, 20)]
        [TestCase(true, 80, 40, 100, 40)]
        public void Trace_SpecularDirection_IsReciprocal(bool isDihedral, double theta, double phi, double toTheta,
            double toPhi)
        {
            var mesh = isDihedral ? CrossSectionTargets.Dihedral(0.3, 0.2) : CrossSectionTargets.Plate(0.3, 0.2);
            ScatteringMatrix From(double theta1, double phi1, double theta2, double phi2)
            {
                var pose = PoseOf(mesh, phi1, 90 - theta1);
                pose.Receivers = new[] { PublishedRow.Aspect(theta2, phi2) };
                pose.OnlyBounce = isDihedral ? 2 : 0;
                Assert.That(Trace(pose).VV.Magnitude, Is.GreaterThan(3), "the mirror's lobe");
                return Trace(pose);
            }
            ScatteringMatrix s = From(theta, phi, toTheta, toPhi), back = From(toTheta, toPhi, theta, phi);
            double allowed = AllowedOf(PoseOf(mesh, phi, 0), s.VV);
            Assert.That((s.VV - back.VV).Magnitude, Is.LessThan(allowed));
            Assert.That((s.HH - back.HH).Magnitude, Is.LessThan(allowed));
            Assert.That((s.VH - back.HV).Magnitude, Is.LessThan(allowed));
            Assert.That((s.HV - back.VH).Magnitude, Is.LessThan(allowed));
        }

        [Test, Timeout(60000)]
        public void Trace_ManyFrequencies_EqualSingleOnes()
        {
            var pose = PoseOf(CrossSectionTargets.Dihedral(0.3, 0.2), 25, 12);
            pose.Frequencies = Enumerable.Range(0, 21).Select(i => TenGigahertz + 25e6 * i).ToArray();
            var together = Tracer.Trace(pose);
            for (int i = 0; i < together.S.GetLength(1); i += 5)
            {
                var single = PoseOf(CrossSectionTargets.Dihedral(0.3, 0.2), 25, 12);
                single.Frequencies = new[] { pose.Frequencies[i] };
                var s = Trace(single);
                Assert.That((together.S[0, i].VV - s.VV).Magnitude, Is.LessThan(AllowedOf(pose, s.VV)));
            }
        }

        // A band is summed by blocks, with the shapes of tubes from three frequencies of each. Two frequencies are summed each
        // by itself, and the last of the band gives them the band's tubes. Float32 holds the phases to 5e-6.
        [TestCase(0, double.PositiveInfinity)]
        [TestCase(0.02, double.PositiveInfinity)]
        [TestCase(0.02, 1.5)]
        [Timeout(60000)]
        public void Trace_Band_IsThatOfFrequenciesByThemselves(double time, double range)
        {
            double[] frequencies = EchoBand.Frequencies(TenGigahertz, 600e6, 70);
            var pose = BandOf(frequencies, time, range);
            Tracer.CellError = 0.002;
            var band = Tracer.Trace(pose);
            Tracer.CellsADispatch = 177;
            Assert.That(Tracer.Trace(pose).S, Is.EqualTo(band.S), "cells of a dispatch change no bit");
            Tracer.CellsADispatch = 0;
            double largest = band.S.Cast<ScatteringMatrix>().Max(s => Math.Max(s.VV.Magnitude, s.HH.Magnitude));
            for (int i = 0; i < 69; i += 17)
            {
                var alone = Tracer.Trace(BandOf(new[] { frequencies[i], frequencies[69] }, time, range));
                for (int pulse = 0; pulse < 2; pulse++)
                {
                    var (s, expected) = (band.S[0, pose.SampleOf(pulse, i)], alone.S[0, 2 * pulse]);
                    Assert.That(Polarisation.All.Max(each => (each.Of(s) - each.Of(expected)).Magnitude),
                        Is.LessThan(1e-5 * largest), $"{i}, {pulse}");
                    Assert.That(band.Errors[0, pose.SampleOf(pulse, i)],
                        Is.EqualTo(alone.Errors[0, 2 * pulse]).Within(5).Percent, $"{i}, {pulse}");
                }
            }
            Tracer.CellError = 0;
        }

        // A trihedral that moves, at two times.
        static CrossSectionPose BandOf(double[] frequencies, double time, double range)
        {
            var pose = PoseOf(CrossSectionTargets.Trihedral(0.3, CrossSectionTargets.TrihedralFace.Triangular), 35, 20);
            pose.Scene = pose.Scene.MovingBy(new RigidMotion
            { Velocity = new double3(3, 1, -2), AngularVelocity = new double3(0.1, -0.4, 0.2) });
            (pose.Frequencies, pose.Times, pose.HasEdges, pose.Range) = (frequencies, new[] { 0, time }, true, range);
            return pose;
        }

        [Test, Timeout(60000)]
        public void Trace_SeveralReceivers_EqualSingleOnes()
        {
            var pose = PoseOf(CrossSectionTargets.Dihedral(0.3, 0.2), 30, 0);
            pose.Receivers = new[] { -110.0, -120, -135, -150 }.Select(a => RadarAspect.At(a, 5)).ToArray();
            var together = Tracer.Trace(pose);
            for (int i = 0; i < pose.Receivers.Length; i++)
            {
                var single = PoseOf(CrossSectionTargets.Dihedral(0.3, 0.2), 30, 0);
                single.Receivers = new[] { pose.Receivers[i] };
                var s = Trace(single);
                Assert.That((together.S[i, 0].HH - s.HH).Magnitude, Is.LessThan(AllowedOf(pose, s.HH)));
            }
        }

        [Test, Timeout(60000)]
        public void Trace_LowerTolerance_TakesMoreRaysAndSaysLess()
        {
            var pose = PoseOf(CrossSectionTargets.Trihedral(0.3, CrossSectionTargets.TrihedralFace.Square), 40, 30);
            pose.ToleranceDb = 1;
            var coarse = Tracer.Trace(pose);
            pose.ToleranceDb = 0.001;
            var fine = Tracer.Trace(pose);
            Assert.That(coarse.IsMet && fine.IsMet);
            Assert.That(fine.Rays, Is.GreaterThan(coarse.Rays));
            Assert.That(fine.Errors[0, 0], Is.LessThan(coarse.Errors[0, 0]));
            Assert.That((fine.S[0, 0].VV - coarse.S[0, 0].VV).Magnitude, Is.LessThan(3 * coarse.Errors[0, 0]));
        }

        // Of a dihedral's second bounces a receiver behind a face sees those beside its outline, a strip that begins with no
        // width. The corners of cells on either side of it meet things that nobody sees.
        [Test, Timeout(60000)]
        public void Trace_StripSeenPastAFace_IsFound()
        {
            var scene = new RadarScene(CrossSectionTargets.Dihedral(0.2, 0.15));
            var pose = new CrossSectionPose
            {
                Scene = scene, Radar = Towards(0.23, -0.46, 0.86), Receivers = new[] { Towards(-0.92, 0.24, 0.3) },
                Frequencies = new[] { 9.6e9, 10.4e9, 11.2e9 }, ToleranceDb = 0.3, HasEdges = false, OnlyBounce = 2
            };
            var settings = new TubeSettings { CellsPerWavelength = 16, MaxDepth = 6, MaxPhaseError = 0.02 };
            var expected = new ReferenceCrossSection(scene).Compute(pose, settings);
            double[] frequencies = pose.Frequencies;
            for (int f = 0; f < frequencies.Length; f++)
            {
                pose.Frequencies = new[] { frequencies[f] };
                var result = Tracer.Trace(pose);
                Assert.That((result.S[0, 0].VV - expected[0, f].VV).Magnitude, Is.LessThan(3 * result.Errors[0, 0]),
                    $"{frequencies[f]} Hz");
                Assert.That((result.S[0, 0].HH - expected[0, f].HH).Magnitude, Is.LessThan(3 * result.Errors[0, 0]),
                    $"{frequencies[f]} Hz");
            }
        }

        // 256 plates of a square millimetre, whose 1,024 corners lie in a few cells of 30 mm, and one of the same area half a
        // metre away. From their normal all are in phase: S = 2 sqrt(pi) A / wavelength.
        [Test, Timeout(60000)]
        public void Trace_ManyCornersInACell_MeetsTheTolerance()
        {
            const double small = 0.001;
            MeshInstance PlateAt(double side, double y, double z) => new MeshInstance
            {
                Mesh = CrossSectionTargets.Plate(side, side),
                ToWorld = new Affine
                {
                    X = new double3(1, 0, 0), Y = new double3(0, 1, 0), Z = new double3(0, 0, 1),
                    Origin = new double3(0, y, z)
                }
            };
            var plates = Enumerable.Range(0, 256).Select(i => PlateAt(small, 1.5 * small * (i % 16), 1.5 * small * (i / 16)))
                .Append(PlateAt(16 * small, 0.3, 0.4));
            var pose = PoseOf(CrossSectionTargets.Plate(1, 1), 0, 0);
            pose.Scene = new RadarScene(plates.ToArray());
            var result = Tracer.Trace(pose);
            double expected = 2 * Math.Sqrt(Math.PI) * 512 * small * small / Signal.Wavelength(TenGigahertz);
            Assert.That(result.S[0, 0].VV.Magnitude, Is.EqualTo(expected).Within(AllowedOf(pose, result.S[0, 0].VV)));
            Assert.That(result.IsMet);
        }

        [Test, Timeout(60000)]
        public void Trace_ToleranceOutOfReach_IsSaid()
        {
            var pose = PoseOf(CrossSectionTargets.Plate(0.3, 0.2), 37, 21);
            pose.ToleranceDb = 1e-7;
            pose.FloorDbsm = -200;
            Assert.That(Tracer.Trace(pose).IsMet, Is.False);
        }

        [Test, Timeout(60000)]
        public void Trace_EmptyScene_ReturnsNothing()
        {
            var pose = PoseOf(new TriangleMesh(new float3[0], new int[0]), 0, 0);
            Assert.That(Tracer.Trace(pose).S[0, 0].VV, Is.EqualTo(Complex.Zero));
        }

        static RadarAspect Towards(double x, double y, double z) =>
            RadarAspect.At(math.degrees(Math.Atan2(-x, -z)), math.degrees(Math.Asin(y / Math.Sqrt(x * x + y * y + z * z))));

        static CrossSectionPose PoseOf(TriangleMesh mesh, double phi, double elevation)
        {
            var radar = PublishedRow.Aspect(90 - elevation, phi);
            return new CrossSectionPose
            {
                Scene = new RadarScene(mesh), Radar = radar, Receivers = new[] { radar },
                Frequencies = new[] { TenGigahertz }, ToleranceDb = 0.02, HasEdges = false
            };
        }

        // The triangles in another order, each beginning with another corner.
        static TriangleMesh Shuffled(TriangleMesh mesh, System.Random random)
        {
            var order = Enumerable.Range(0, mesh.TriangleCount).OrderBy(_ => random.Next());
            return new TriangleMesh(mesh.Vertices, order.SelectMany(triangle =>
            {
                int turn = random.Next(3);
                return Enumerable.Range(0, 3).Select(i => mesh.Indices[3 * triangle + (i + turn) % 3]);
            }).ToArray());
        }

        ScatteringMatrix Trace(CrossSectionPose pose) => Tracer.Trace(pose).S[0, 0];

        // Twice what the tolerance allows: both amplitudes have errors.
        static double AllowedOf(CrossSectionPose pose, Complex s)
        {
            double floor = Math.Pow(10, CrossSectionFloor.Of(-0.2, 0.2) / 20);
            return 2 * (Math.Pow(10, pose.ToleranceDb / 20) - 1) * Math.Max(s.Magnitude, floor);
        }
    }
}
