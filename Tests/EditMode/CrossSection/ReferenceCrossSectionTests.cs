using System;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// The double-precision cross section against closed forms, Mie's series and symmetries of physics.
    /// </summary>
    [Category("Slow")]
    public sealed class ReferenceCrossSectionTests
    {
        const double TenGigahertz = 1e10;

        // Of integrals that are the same but for their rounding, relative.
        const double Rounding = 1e-8;

        // The fringe field moves the angle from a wedge's first face by this, radians; which face is the first hangs on
        // the order of the triangles.
        const double FringeAngle = 1e-5;

        // Enough for the rows of plane faces.
        static readonly TubeSettings s_fine =
            new TubeSettings { CellsPerWavelength = 2, MaxDepth = 6, MaxPhaseError = 0.03 };

        // Enough for those of curved faces, and for integrals that must be equal however fine the tubes.
        static readonly TubeSettings s_coarse =
            new TubeSettings { CellsPerWavelength = 1, MaxDepth = 3, MaxPhaseError = 0.1 };

        // Columns: PublishedRow.
        static readonly string[] Rows =
        {
            // Closed form of physical optics.
            "plate_0p3_0p2 1e10 90 0 90 0 0 5 - 0 VV 17.0187 0.05",
            "plate_0p3_0p2 1e10 90 5 90 5 0 5 - 0 VV -0.6480 0.06",
            "plate_0p3_0p2 1e10 90 25 90 25 0 5 - 0 HH -12.3994 0.08",
            "plate_0p3_0p2 1e10 90 60 90 60 0 5 - 0 VV -24.9847 0.16",
            "plate_0p3_0p2 1e10 80 7 80 7 0 5 - 0 VV -19.9170 0.11",
            "plate_0p3_0p2 1e10 65 20 65 20 0 5 - 0 HH -40.4671 0.70",
            // The same, bistatic.
            "plate_0p3_0p2 1e10 90 30 90 -70 0 5 - 0 VV -7.4788 0.06",
            "plate_0p3_0p2 1e10 90 30 90 -70 0 5 - 0 HH -15.5484 0.09",
            "plate_0p3_0p2 1e10 90 30 90 -30 0 5 - 0 VV 15.7693 0.05",
            "plate_0p3_0p2 1e10 90 30 70 -35 0 5 - 0 VH -18.7577 0.10",
            "plate_0p3_0p2 1e10 90 30 45 -30 0 5 - 0 VV -26.1758 0.18",
            // The same, behind the plate: the lobe of its shadow.
            "plate_0p3_0p2 1e10 90 30 90 210 0 5 - 0 VV 15.7693 0.05",
            "plate_0p3_0p2 1e10 90 30 90 205 0 5 - 0 HH 4.7140 0.06",
            "plate_0p3_0p2 1e10 90 30 85 210 0 5 - 0 HH 10.2436 0.05",
            // Fresnel integrals.
            "plate_0p5_0p5 1e10 90 0 90 0 40 5 - 0 VV 29.3316 0.05",
            "plate_0p5_0p5 1e10 90 0 90 0 10 5 - 0 VV 28.0753 0.05",
            "plate_0p5_0p5 1e10 90 0 90 0 5 5 - 0 HH 23.8884 0.05",
            // Closed form of single and double bounces.
            "dihedral_0p3_0p2 1e10 90 0 90 0 0 3 - 0 VV 17.0187 0.05",
            "dihedral_0p3_0p2 1e10 90 7.5 90 7.5 0 3 - 0 HH 4.8187 0.05",
            "dihedral_0p3_0p2 1e10 90 22.5 90 22.5 0 3 - 0 HH 14.5234 0.05",
            "dihedral_los_22p5 1e10 90 0 90 0 0 3 - 0 VV 16.9054 0.05",
            "dihedral_los_22p5 1e10 90 0 90 0 0 3 - 0 VH 17.0187 0.05",
            "dihedral_los_45 1e10 90 0 90 0 0 3 - 0 VV -19.6870 0.11",
            "two_plates 1e10 90 0 90 0 0 3 - 0 VV 16.7892 0.05",
            "two_plates 1e10 90 0 90 0 0 3 - 0 HH 16.2157 0.05",
            "hidden_plate 1e10 90 8 90 8 0 1 - 0 VV 5.1649 0.06",
            // Area that the triple bounce sees.
            "trihedral_triangular_0p3 1e10 54.7356 45 54.7356 45 0 only-3 - 0 VV 15.7693 0.03",
            "trihedral_triangular_0p3 1e10 48 45 48 45 0 only-3 - 0 VV 15.4634 0.05",
            // Closed form of physical optics times Fresnel's coefficient.
            "plate_0p3_0p2 1e10 90 0 90 0 0 5 metal,4,0.4,1,0,0.002 0 VV 16.7658 0.05",
            "plate_0p3_0p2 1e10 90 45 90 45 0 5 metal,4,0.4,1,0,0.002 0 VV -25.8936 0.17",
            "plate_0p3_0p2 1e10 90 45 90 45 0 5 metal,17,0.34,1.5,1.8,0.0015 0 HH -35.1407 0.40",
            "plate_0p3_0p2 1e10 90 45 90 45 0 5 open,4,0,1,0,0 0 HH -39.5245 0.63",
            "plate_0p3_0p2 1e10 90 45 90 45 0 5 open,55.062,37.514,1,0,0 0 HH -28.5955 0.22",
            // Another double-precision program.
            "trihedral_triangular_0p3 1e10 54.7356 10 54.7356 10 0 3 - 0 VH -13.6543 0.08",
            "dihedral_100deg 1e10 90 10 90 10 0 5 - 0 VV 17.3063 0.05",
            "dihedral_0p3_0p2 1e10 88 20 88 20 0 3 - 0 VH -11.2896 0.07",
            "dihedral_0p3_0p2 1e10 80 40 100 40 0 3 - 0 VV 17.4586 0.05",
            // The same, with fringe fields of edges.
            "plate_0p3_0p2 1e10 90 12 90 12 0 1 - 1 VV -11.0918 0.07",
            "plate_0p3_0p2 1e10 90 40 90 40 0 1 - 1 HH -17.9135 0.10",
            "plate_0p3_0p2 1e10 75 20 75 20 0 1 - 1 VV -30.5545 0.26",
        };

        static readonly string[] CurvedRows =
        {
            // Mie's series.
            "sphere_1 4.77134516e9 90 17 90 17 0 1 - 0 VV 4.9673 0.30",
            "sphere_1 4.77134516e9 90 17 90 92 0 1 - 0 HH 4.9728 0.30",
            // Two-dimensional series for a cylinder.
            "cylinder_0p1_0p5 1e10 90 3 90 3 0 1 - 0 HH 7.1824 0.25",
            // 8 pi r h^2 cos(grazing) / wavelength.
            "top_hat 1e10 45 10 45 10 0 only-2 - 0 VV 3.7496 0.15",
        };

        [TestCaseSource(nameof(Rows))]
        public void Reference_PublishedValue_IsMet(string text) => AssertIsMet(text, s_fine);

        [TestCaseSource(nameof(CurvedRows))]
        public void Reference_PublishedValueOfACurvedBody_IsMet(string text) => AssertIsMet(text, s_coarse);

        static void AssertIsMet(string text, in TubeSettings settings)
        {
            var row = new PublishedRow(text);
            Assert.That(ScatteringMatrix.Dbsm(row.Polarisation.Of(Compute(row.Pose(), settings))),
                Is.EqualTo(row.Dbsm).Within(row.ToleranceDb));
        }

        [Test]
        public void Plate_SeenFromItsNormal_HasThePhaseOfMinusJ()
        {
            // S = -(j k / sqrt(4 pi)) 2 A about the plate's centre.
            var s = Compute(Pose(CrossSectionTargets.Plate(0.25, 0.5), 90, 0));
            double expected = ReferenceCrossSection.Wavenumber(TenGigahertz) * 0.125 / Math.Sqrt(PI_DBL);
            Assert.That(Complex.Abs(s.VV - new Complex(0, -expected)), Is.LessThan(1e-4 * expected));
            Assert.That(Complex.Abs(s.HH - new Complex(0, -expected)), Is.LessThan(1e-4 * expected));
        }

        [Test]
        public void Dihedral_TurnedAboutTheSight_SendsEqualPowerBackInBothPolarisations()
        {
            // The component of E along the edge t returns, that across it returns negative. Turned by x from the
            // vertical z towards -y of right-handed axes, t = cos x V - sin x H, H being right: VV = cos 2x,
            // HH = -cos 2x, VH = HV = -sin 2x.
            var pose = Pose(CrossSectionTargets.DihedralAboutSight(0.3, 0.2, 22.5), 90, 0);
            (pose.MaxBounces, pose.OnlyBounce) = (2, 2);
            var s = Compute(pose);
            double tolerance = 1e-4 * s.VV.Magnitude;
            Assert.That(s.VV.Magnitude, Is.EqualTo(Math.Pow(10, 17.0187 / 20)).Within(1e-3 * s.VV.Magnitude));
            Assert.That(Complex.Abs(s.HH + s.VV), Is.LessThan(tolerance));
            Assert.That(Complex.Abs(s.VH + s.VV), Is.LessThan(tolerance));
            Assert.That(Complex.Abs(s.HV + s.VV), Is.LessThan(tolerance));
        }

        [Test]
        public void Dihedral_OffTheSpecularDirection_IsNotReciprocal()
        {
            // rcs.md: -25.00 in VH and nothing in HV, as physical optics gives it.
            var s = Compute(Pose(CrossSectionTargets.Dihedral(0.3, 0.2), 80, 33));
            Assert.That(ScatteringMatrix.Dbsm(s.VV), Is.EqualTo(-8.88).Within(0.05));
            Assert.That(ScatteringMatrix.Dbsm(s.HH), Is.EqualTo(-8.66).Within(0.05));
            Assert.That(ScatteringMatrix.Dbsm(s.VH), Is.EqualTo(-25).Within(0.1));
            Assert.That(ScatteringMatrix.Dbsm(s.HV), Is.LessThan(-60));
        }

        // Plate: the direction of the mirror. Dihedral: 80 and 100 degrees, mirrored in the plane across its edge.
        [TestCase(false, 70, 30, 110, -30)]
        [TestCase(false, 105, -20, 75, 20)]
        [TestCase(true, 80, 40, 100, 40)]
        public void SpecularDirection_RadarAndReceiverExchanged_IsTheSame(bool isDihedral, double theta, double phi,
            double toTheta, double toPhi)
        {
            var mesh = isDihedral ? CrossSectionTargets.Dihedral(0.3, 0.2) : CrossSectionTargets.Plate(0.3, 0.2);
            var there = Pose(mesh, theta, phi, toTheta, toPhi);
            var back = Pose(mesh, toTheta, toPhi, theta, phi);
            // On the dihedral single bounces are far from their specular direction.
            there.OnlyBounce = back.OnlyBounce = isDihedral ? 2 : 0;
            ScatteringMatrix s = Compute(there), reversed = Compute(back);
            double tolerance = 1e-3 * Largest(s);
            Assert.That(Largest(s), Is.GreaterThan(3), "the mirror's lobe");
            Assert.That(Complex.Abs(s.VV - reversed.VV), Is.LessThan(tolerance));
            Assert.That(Complex.Abs(s.HH - reversed.HH), Is.LessThan(tolerance));
            Assert.That(Complex.Abs(s.VH - reversed.HV), Is.LessThan(tolerance));
            Assert.That(Complex.Abs(s.HV - reversed.VH), Is.LessThan(tolerance));
        }

        [Test]
        public void Target_Moved_ChangesThePhaseOnly()
        {
            var pose = Pose(CrossSectionTargets.Dihedral(0.25, 0.5), 83, 31, 77, 12);
            pose.HasEdges = true;
            var s = Compute(pose, s_coarse);
            double3 move = double3(0.37, -0.21, 1.3);
            var moved = Affine.Identity;
            moved.Origin = move;
            pose.Scene = Placed(pose.Scene, moved);
            // The field reaches the target earlier by s.x and the receiver earlier by s_r.x.
            double phase = ReferenceCrossSection.Wavenumber(TenGigahertz)
                * dot(pose.Radar.ToRadar + pose.Receivers[0].ToRadar, move);
            AssertSame(Compute(pose, s_coarse), Complex.FromPolarCoordinates(1, phase) * s);
        }

        [Test]
        public void TargetAndRadar_TurnedTogether_AreTheSame()
        {
            var turn = Affine.FromTransform(0, double4(0.3, -0.2, 0.5, 0.8), 1);
            var pose = Pose(CrossSectionTargets.Dihedral(0.25, 0.5), 83, 31, 77, 12);
            pose.HasEdges = true;
            var s = Compute(pose, s_coarse);
            RadarAspect Turned(RadarAspect at) =>
                new RadarAspect(turn.Vector(at.ToRadar), turn.Vector(at.Up), turn.Vector(at.Right));
            pose.Scene = Placed(pose.Scene, turn);
            pose.Radar = Turned(pose.Radar);
            pose.Receivers = Array.ConvertAll(pose.Receivers, Turned);
            AssertSame(Compute(pose, s_coarse), s);
        }

        [Test]
        public void Triangles_Split_AreTheSame()
        {
            // The sizes are powers of 2, so that the middles of the edges are exact.
            var mesh = CrossSectionTargets.Dihedral(0.25, 0.5);
            var pose = Pose(mesh, 83, 31, 77, 12);
            pose.HasEdges = true;
            var s = Compute(pose, s_coarse);
            pose.Scene = new RadarScene(Split(Split(mesh)));
            AssertSame(Compute(pose, s_coarse), s, FringeAngle);
        }

        [Test]
        public void Frequencies_TracedTogether_AreAsAlone()
        {
            var pose = Pose(CrossSectionTargets.Dihedral(0.3, 0.2), 85, 30);
            pose.HasEdges = true;
            pose.Frequencies = new[] { 9.5e9, 9.8e9, TenGigahertz };
            var reference = new ReferenceCrossSection(pose.Scene);
            var together = reference.Compute(pose, s_fine);
            for (int f = 0; f < pose.Frequencies.Length; f++)
            {
                var alone = Pose(pose.Scene.Instances[0].Mesh, 85, 30);
                alone.Scene = pose.Scene;
                alone.HasEdges = true;
                alone.Frequencies = new[] { pose.Frequencies[f] };
                var s = reference.Compute(alone, s_fine)[0, 0];
                Assert.That(Complex.Abs(together[0, f].VV - s.VV), Is.LessThan(1e-3), $"VV, frequency {f}");
                Assert.That(Complex.Abs(together[0, f].HH - s.HH), Is.LessThan(1e-3), $"HH, frequency {f}");
            }
        }

        [Test]
        public void SameTarget_ComputedAgain_IsTheSameBitForBit()
        {
            var pose = Pose(CrossSectionTargets.Trihedral(0.3, CrossSectionTargets.TrihedralFace.Triangular), 60, 35);
            Assert.That(Compute(pose, s_coarse), Is.EqualTo(Compute(pose, s_coarse)));
        }

        [Test]
        public void Range_VeryLarge_IsTheFarField()
        {
            var pose = Pose(CrossSectionTargets.Dihedral(0.3, 0.2), 83, 31, 77, 12);
            pose.HasEdges = true;
            var s = Compute(pose, s_coarse);
            // The wave's curvature changes phases by k (0.2 m)^2 / R = 8e-5 at the rim.
            pose.Range = 1e5;
            AssertSame(Compute(pose, s_coarse), s, 1e-3);
        }

        // Radii of the wavefront; negative: it diverges.
        [TestCase(3, 5, 2, 0)]
        [TestCase(3, 5, 4, 1)]
        [TestCase(3, 5, 6, 2)]
        [TestCase(3, 3, 6, 2)]
        [TestCase(3, -5, 6, 1)]
        [TestCase(-3, -5, 6, 0)]
        [TestCase(3, double.PositiveInfinity, 6, 1)]
        [TestCase(double.PositiveInfinity, double.PositiveInfinity, 6, 0)]
        public void Wavefront_AfterItsCentresOfCurvature_HasPassedCaustics(double radiusU, double radiusV,
            double distance, int expected)
        {
            var ray = new TubeRay
            {
                Direction = double3(0, 0, 1), Pu = double3(1, 0, 0), Pv = double3(0, 1, 0),
                Du = double3(-1 / radiusU, 0, 0), Dv = double3(0, -1 / radiusV, 0)
            };
            Assert.That(ray.CausticsWithin(distance), Is.EqualTo(expected));
        }

        [Test]
        public void Radar_WithinTheTarget_IsRefused()
        {
            var pose = Pose(CrossSectionTargets.Sphere(1, 8), 90, 0);
            pose.Range = 0.5;
            var error = Assert.Throws<GlintException>(() => Compute(pose));
            Assert.That(error.Message, Does.Contain("0.5 m").And.Contain("greater range"));
        }

        static CrossSectionPose Pose(TriangleMesh mesh, double theta, double phi) =>
            Pose(mesh, theta, phi, theta, phi);

        static CrossSectionPose Pose(TriangleMesh mesh, double theta, double phi, double toTheta, double toPhi) =>
            new CrossSectionPose
            {
                Scene = new RadarScene(mesh), Radar = PublishedRow.Aspect(theta, phi),
                Receivers = new[] { PublishedRow.Aspect(toTheta, toPhi) }, Frequencies = new[] { TenGigahertz },
                MaxBounces = 3, HasEdges = false
            };

        static ScatteringMatrix Compute(CrossSectionPose pose) => Compute(pose, s_fine);

        static ScatteringMatrix Compute(CrossSectionPose pose, in TubeSettings settings) =>
            new ReferenceCrossSection(pose.Scene).Compute(pose, settings)[0, 0];

        static RadarScene Placed(RadarScene scene, in Affine toWorld) =>
            new RadarScene(new MeshInstance { Mesh = scene.Instances[0].Mesh, ToWorld = toWorld });

        /// <summary>Every triangle becomes four.</summary>
        internal static TriangleMesh Split(TriangleMesh mesh)
        {
            var corners = new float3[12 * mesh.TriangleCount];
            for (int i = 0; i < mesh.TriangleCount; i++)
            {
                mesh.GetTriangle(i, out var a, out var b, out var c);
                float3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
                new[] { a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca }.CopyTo(corners, 12 * i);
            }
            var indices = new int[corners.Length];
            for (int i = 0; i < indices.Length; i++)
                indices[i] = i;
            return new TriangleMesh(corners, indices);
        }

        static double Largest(in ScatteringMatrix s) => Math.Max(Math.Max(s.VV.Magnitude, s.HH.Magnitude),
            Math.Max(s.VH.Magnitude, s.HV.Magnitude));

        static void AssertSame(in ScatteringMatrix s, in ScatteringMatrix expected, double relative = Rounding)
        {
            double tolerance = relative * Largest(expected);
            Assert.That(Largest(expected), Is.GreaterThan(0.01));
            Assert.That(Complex.Abs(s.VV - expected.VV), Is.LessThan(tolerance), "VV");
            Assert.That(Complex.Abs(s.HV - expected.HV), Is.LessThan(tolerance), "HV");
            Assert.That(Complex.Abs(s.VH - expected.VH), Is.LessThan(tolerance), "VH");
            Assert.That(Complex.Abs(s.HH - expected.HH), Is.LessThan(tolerance), "HH");
        }
    }
}
