using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Editor;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// Fringe fields of edges against the method of moments, and against the double-precision reference, which has
    /// another form of the same coefficients. Published rows with edges are in <see cref="CrossSectionCaseTests"/>.
    /// </summary>
    public sealed class FringeTests
    {
        const double TenGigahertz = 1e10;

        CrossSectionTracer _tracer;

        [SetUp]
        public void CreateTracer() => _tracer = new CrossSectionTracer(TestKernels.Tubes);

        [TearDown]
        public void DisposeTracer() => _tracer.Dispose();

        // At every fourth of the published angles: degrees from normal.
        [Test]
        public void PlateWithEdges_IsNearTheMethodOfMoments()
        {
            var published = PublishedCrossSections.Read("plate_moments")
                .Where(row => row.Degrees <= 40 && row.Degrees % 2 == 0).ToArray();
            var scene = new RadarScene(CrossSectionTargets.Plate(0.2667, 0.1524));
            double vv = 0, hh = 0, plain = 0;
            int count = published.Length;
            Assert.That(count, Is.EqualTo(21));
            foreach (var row in published)
            {
                var pose = Pose(scene, PublishedRow.Aspect(90, row.Degrees));
                pose.Frequencies = new[] { 5.12e9 };
                var s = _tracer.Trace(pose).S[0, 0];
                pose.HasEdges = false;
                var without = _tracer.Trace(pose).S[0, 0];
                hh += abs(ScatteringMatrix.Dbsm(s.HH) - row.HH) / count;
                vv += abs(ScatteringMatrix.Dbsm(s.VV) - row.VV) / count;
                plain += abs(ScatteringMatrix.Dbsm(without.VV) - row.VV) / count;
            }
            Assert.That(vv, Is.LessThan(0.8));
            Assert.That(hh, Is.LessThan(1.5));
            Assert.That(plain, Is.GreaterThan(2 * vv), "physical optics alone");
        }

        // A prism with a random triangle as its section has edges of three outer angles along it, and of 1.5 pi at its
        // ends; a random triangle has edges of 2 pi. At a finite range the reference has polarisations that are not of
        // unit length away from the phase centre.
        [TestCase(false, double.PositiveInfinity, 1e-4)]
        [TestCase(true, double.PositiveInfinity, 1e-4)]
        [TestCase(false, 10, 3e-4)]
        [TestCase(true, 10, 3e-4)]
        public void EdgesOfRandomBodies_RadiateAsTheReferenceDoes(bool isThin, double range, double tolerance)
        {
            var random = new System.Random(isThin ? 1 : 2);
            double worst = 0;
            for (int i = 0; i < 30; i++)
            {
                var pose = Pose(new RadarScene(isThin ? RandomTriangle(random) : RandomPrism(random)),
                    RandomAspect(random));
                pose.Range = range;
                pose.PhaseCentre = new double3(0.01, 0.02, -0.03);
                if (i % 2 == 0)
                    pose.Receivers = new[] { RandomAspect(random), RandomAspect(random), pose.Radar };
                worst = max(worst, RelativeError(Fringes(pose), ReferenceFringes(pose)));
            }
            Assert.That(worst, Is.LessThan(tolerance));
        }

        // The field of a wedge and that of physical optics grow without bound towards the specular direction of a face,
        // and towards the direction of illumination behind the body. The radar is at 83 and 40 degrees.
        [TestCase(83, -40)]
        [TestCase(97, 220)]
        public void FringesNearABorderOfReflectionOrShadow_AreThoseOfTheReference(double theta, double phi)
        {
            var pose = Pose(new RadarScene(CrossSectionTargets.Box(0.1, 0.08, 0.05)), PublishedRow.Aspect(83, 40));
            pose.Receivers = new[] { 0, 1e-6, -1e-4, 1e-3, 0.02, -0.5 }
                .Select(degrees => PublishedRow.Aspect(theta, phi + degrees)).ToArray();
            Assert.That(RelativeError(Fringes(pose), ReferenceFringes(pose)), Is.LessThan(1e-4));
        }

        [Test]
        public void HiddenEdges_AddNothing()
        {
            var pose = Pose(new RadarScene(CrossSectionTargets.HiddenPlate(0.3, 0.1, 0.2)), PublishedRow.Aspect(87, 4));
            var front = SameSurface.Moved(CrossSectionTargets.Plate(0.3, 0.3), Shift(new double3(0.2, 0, 0)));
            var alone = Pose(new RadarScene(front), pose.Radar);
            var hidden = Fringes(pose)[0, 0];
            var seen = Fringes(alone)[0, 0];
            Assert.That(Largest(seen), Is.GreaterThan(0.01));
            Assert.That(Largest(hidden + -1 * seen), Is.LessThan(1e-5));
        }

        // One plate hides a part of the other's edges. Both tracers find where to 1/256 of a piece.
        [Test]
        public void PartlyHiddenEdges_RadiateOverTheLengthThatIsSeen()
        {
            var mesh = CrossSectionTargets.TwoPlates(0.1, 0.1, 0.12);
            var scene = new RadarScene(mesh);
            RadarScene Plate(int first) =>
                new RadarScene(new TriangleMesh(mesh.Vertices, mesh.Indices.Skip(first).Take(6).ToArray()));
            double worst = 0, hidden = 0;
            foreach (double phi in new[] { 52, 60, 68, 76 })
            {
                var radar = PublishedRow.Aspect(80, phi);
                var expected = ReferenceFringes(Pose(scene, radar))[0, 0];
                var unhidden = Fringes(Pose(Plate(0), radar))[0, 0] + Fringes(Pose(Plate(6), radar))[0, 0];
                worst = max(worst, Difference(Fringes(Pose(scene, radar))[0, 0], expected) / Largest(expected));
                hidden = max(hidden, Difference(unhidden, expected) / Largest(expected));
            }
            Assert.That(worst, Is.LessThan(0.01));
            Assert.That(hidden, Is.GreaterThan(0.05), "edges are hidden in part");
        }

        // The shadow of a strip lies within edges that are shorter than a wavelength: their ends are seen. Both tracers find
        // its borders to 1/512 of a wavelength.
        [TestCase(false)]
        [TestCase(true)]
        public void EdgesHiddenInTheMiddle_RadiateOverBothParts(bool isBistatic)
        {
            var plate = CrossSectionTargets.Plate(0.029, 0.029);
            var strip = SameSurface.Moved(CrossSectionTargets.Plate(0.018, 0.2), Shift(new double3(0.02, 0, 0)));
            ScatteringMatrix Of(Func<CrossSectionPose, ScatteringMatrix[,]> fringes, params TriangleMesh[] meshes)
            {
                var pose = Pose(new RadarScene(Array.ConvertAll(meshes,
                    mesh => new MeshInstance { Mesh = mesh, ToWorld = Affine.Identity })), PublishedRow.Aspect(75, 4));
                if (isBistatic)
                    pose.Receivers = new[] { PublishedRow.Aspect(100, -5) };
                return fringes(pose)[0, 0];
            }
            var expected = Of(ReferenceFringes, plate, strip);
            var unhidden = Of(ReferenceFringes, plate) + Of(ReferenceFringes, strip);
            double largest = Largest(expected);
            Assert.That(Difference(Of(Fringes, plate, strip), expected), Is.LessThan(0.01 * largest));
            Assert.That(Difference(unhidden, expected), Is.GreaterThan(0.05 * largest), "edges are hidden in part");
        }

        [Test]
        public void MovedBody_ChangesThePhaseAlone()
        {
            var random = new System.Random(4);
            var mesh = RandomPrism(random);
            var pose = Pose(new RadarScene(mesh), RandomAspect(random));
            pose.Receivers = new[] { RandomAspect(random) };
            var by = new double3(0.3, -0.7, 1.1);
            var still = Fringes(pose)[0, 0];
            pose.Scene = new RadarScene(SameSurface.Moved(mesh, Shift(by)));
            var moved = Fringes(pose)[0, 0];
            double k = 2 * PI_DBL * TenGigahertz / Signal.SpeedOfLight;
            var phase = Complex.FromPolarCoordinates(1, k * dot(by, pose.Radar.ToRadar + pose.Receivers[0].ToRadar));
            Assert.That(Difference(moved, phase * still), Is.LessThan(1e-4 * Largest(still)));
        }

        [Test]
        public void BodyAndRadarTurned_ChangeNothing()
        {
            var random = new System.Random(5);
            var mesh = RandomPrism(random);
            var pose = Pose(new RadarScene(mesh), RandomAspect(random));
            pose.Receivers = new[] { RandomAspect(random) };
            var still = Fringes(pose)[0, 0];
            var turn = SameSurface.Rotation(random);
            RadarAspect Turned(RadarAspect aspect) =>
                new RadarAspect(turn.Vector(aspect.ToRadar), turn.Vector(aspect.Up), turn.Vector(aspect.Right));
            pose.Scene = new RadarScene(new MeshInstance { Mesh = mesh, ToWorld = turn });
            (pose.Radar, pose.Receivers) = (Turned(pose.Radar), new[] { Turned(pose.Receivers[0]) });
            Assert.That(Difference(Fringes(pose)[0, 0], still), Is.LessThan(1e-4 * Largest(still)));
        }

        [Test]
        public void ManyFrequencies_AreThoseOfSingleOnes()
        {
            var pose = Pose(new RadarScene(CrossSectionTargets.Plate(0.1, 0.07)), PublishedRow.Aspect(80, 35));
            pose.Frequencies = Enumerable.Range(0, 100).Select(i => 9e9 + 1e7 * i).ToArray();
            var together = Fringes(pose);
            foreach (int i in new[] { 0, 37, 99 })
            {
                var alone = Pose(pose.Scene, pose.Radar);
                alone.Frequencies = new[] { pose.Frequencies[i] };
                var expected = Fringes(alone)[0, 0];
                Assert.That(Difference(together[0, i], expected), Is.LessThan(1e-5 * Largest(expected)));
            }
        }

        [Test]
        public void ManyReceivers_AreThoseOfSingleOnes()
        {
            var random = new System.Random(6);
            var pose = Pose(new RadarScene(RandomPrism(random)), RandomAspect(random));
            pose.Receivers = Enumerable.Range(0, TubeKernels.MaxReceivers).Select(i => RandomAspect(random)).ToArray();
            var together = Fringes(pose);
            for (int i = 0; i < together.GetLength(0); i++)
            {
                var alone = Pose(pose.Scene, pose.Radar);
                alone.Receivers = new[] { pose.Receivers[i] };
                // But for rounding: the tubes whose sums cancel are others.
                Assert.That(Difference(Fringes(alone)[0, 0], together[i, 0]), Is.LessThan(1e-12));
            }
        }

        [Test]
        public void EdgesOfACoatedFace_AreLeftOutAndCounted()
        {
            var layer = new SurfaceMaterial("layer", new[] { new MaterialLayer(Medium.Constant(4, 0.4, 1, 0), 0.002) });
            var scene = new RadarScene(CrossSectionTargets.Plate(0.1, 0.1)) { Surfaces = new[] { layer } };
            var pose = Pose(scene, PublishedRow.Aspect(90, 30));
            Assert.That(Largest(Fringes(pose)[0, 0]), Is.Zero);
            Assert.That(_tracer.Trace(pose).WedgesLeftOut, Is.EqualTo(4));
        }

        static CrossSectionPose Pose(RadarScene scene, RadarAspect radar) => new CrossSectionPose
        {
            Scene = scene, Radar = radar, Receivers = new[] { radar }, Frequencies = new[] { TenGigahertz },
            MaxBounces = 1
        };

        // What edges add: the sums of the tubes are the same bit for bit, and cancel.
        ScatteringMatrix[,] Fringes(CrossSectionPose pose)
        {
            _tracer.CellError = 1;
            return WhatEdgesAdd(pose, () => _tracer.Trace(pose).S);
        }

        static ScatteringMatrix[,] ReferenceFringes(CrossSectionPose pose)
        {
            var coarse = new TubeSettings { CellsPerWavelength = 0.002, MaxDepth = 0, MaxPhaseError = 1 };
            var reference = new ReferenceCrossSection(pose.Scene, pose.CreaseDegrees);
            return WhatEdgesAdd(pose, () => reference.Compute(pose, coarse));
        }

        static ScatteringMatrix[,] WhatEdgesAdd(CrossSectionPose pose, Func<ScatteringMatrix[,]> compute)
        {
            pose.HasEdges = true;
            var with = compute();
            pose.HasEdges = false;
            var without = compute();
            pose.HasEdges = true;
            for (int r = 0; r < with.GetLength(0); r++)
                for (int f = 0; f < with.GetLength(1); f++)
                    with[r, f] += -1 * without[r, f];
            return with;
        }

        // Largest difference over the largest amplitude.
        static double RelativeError(ScatteringMatrix[,] got, ScatteringMatrix[,] expected)
        {
            double largest = expected.Cast<ScatteringMatrix>().Max(Largest);
            Assert.That(largest, Is.GreaterThan(1e-4));
            return got.Cast<ScatteringMatrix>().Zip(expected.Cast<ScatteringMatrix>(), Difference).Max() / largest;
        }

        static double Difference(ScatteringMatrix a, ScatteringMatrix b) => Largest(a + -1 * b);

        static double Largest(ScatteringMatrix s) =>
            new[] { s.VV, s.HV, s.VH, s.HH }.Max(amplitude => amplitude.Magnitude);

        static RadarAspect RandomAspect(System.Random random) => PublishedRow.Aspect(
            degrees(acos(2 * random.NextDouble() - 1)), 360 * random.NextDouble());

        static Affine Shift(double3 by) => Affine.FromTransform(by, new double4(0, 0, 0, 1), 1);

        static double3[] RandomCorners(System.Random random) =>
            Enumerable.Range(0, 3).Select(i => 0.03 * (1 + random.NextDouble()) * new double3(
                cos(2 * PI_DBL / 3 * (i + 0.5 * random.NextDouble())), 0,
                sin(2 * PI_DBL / 3 * (i + 0.5 * random.NextDouble())))).ToArray();

        static TriangleMesh RandomTriangle(System.Random random) => Turned(random, RandomCorners(random), 0, 1, 2);

        static TriangleMesh RandomPrism(System.Random random)
        {
            var low = RandomCorners(random);
            var corners = low.Concat(low.Select(corner => corner + new double3(0, 0.05, 0))).ToArray();
            return Turned(random, corners, 0, 1, 2, 3, 5, 4, 0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2, 2, 5, 3, 2, 3, 0);
        }

        static TriangleMesh Turned(System.Random random, double3[] corners, params int[] indices)
        {
            var turn = SameSurface.Rotation(random);
            return new TriangleMesh(corners.Select(corner => (float3)turn.Vector(corner)).ToArray(), indices);
        }
    }
}
