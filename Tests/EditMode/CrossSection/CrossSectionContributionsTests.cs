using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Contributions of objects, bounces and triangles to a cross section.</summary>
    public sealed class CrossSectionContributionsTests : CrossSectionFixture
    {
        const double TenGigahertz = 1e10;

        /// <summary>Sums are whole units, of which each tube adds the same ones to its parts as to S.</summary>
        [Test, Timeout(60000)]
        public void Objects_AndBounces_AddUpToS()
        {
            var pose = PoseOf(SceneOf(CrossSectionTargets.Trihedral(0.2, CrossSectionTargets.TrihedralFace.Square),
                Moved(CrossSectionTargets.Plate(0.1, 0.15), 0.4), Moved(CrossSectionTargets.Dihedral(0.1, 0.1), -0.4)),
                PublishedRow.Aspect(65, 50));
            pose.Receivers = new[] { pose.Radar, PublishedRow.Aspect(80, 20) };
            pose.Frequencies = new[] { 0.95 * TenGigahertz, TenGigahertz };
            pose.HasEdges = true;
            var result = Tracer.Trace(pose);
            foreach (var (receiver, frequency) in new[] { (0, 0), (1, 0), (0, 1), (1, 1) })
            {
                var s = result.S[receiver, frequency];
                var contributions =
                    Tracer.Contributions(pose, result, receiver, frequency, Polarisation.All);
                Assert.That(contributions.Objects.Select(each => each.Number), Is.EquivalentTo(new[] { 0, 1, 2 }));
                Assert.That(contributions.Bounces.Select(each => each.Number), Is.EqualTo(new[] { 0, 1, 2, 3 }));
                foreach (var parts in new[] { contributions.Objects, contributions.Bounces })
                    foreach (var polarisation in Polarisation.All)
                    {
                        var sum = parts.Aggregate(Complex.Zero, (all, part) => all + polarisation.Of(part.S));
                        Assert.That((sum - polarisation.Of(s)).Magnitude, Is.LessThan(1e-13),
                            $"{polarisation}, receiver {receiver}, frequency {frequency}: double rounds to 1e-16 m");
                    }
            }
        }

        [Test, Timeout(60000)]
        public void CellsOfADispatch_ChangeNoBit()
        {
            var pose = PoseOf(SceneOf(CrossSectionTargets.Trihedral(0.2, CrossSectionTargets.TrihedralFace.Square)),
                PublishedRow.Aspect(60, 40));
            var result = Tracer.Trace(pose);
            var expected = Tracer.Contributions(pose, result, 0, 0, Polarisation.All);
            Tracer.CellsADispatch = 177;
            var divided = Tracer.Contributions(pose, result, 0, 0, Polarisation.All);
            Tracer.CellsADispatch = 0;
            Assert.That(divided.Bounces, Is.EqualTo(expected.Bounces));
            Assert.That(divided.Objects, Is.EqualTo(expected.Objects));
            Assert.That(divided.HotSpots.Select(Text), Is.EqualTo(expected.HotSpots.Select(Text)));
        }

        /// <summary>
        /// A plate seen head-on has |S| = sqrt(4 pi) A / lambda; one that is farther by d lags by 2 k d. They do not
        /// see each other. Each of their two triangles has half.
        /// </summary>
        [Test, Timeout(60000)]
        public void PlatesFarApart_HaveTheirClosedForms()
        {
            const double frequency = 4e10, wavelength = Signal.SpeedOfLight / frequency, farther = 0.1 * wavelength;
            double2 first = new double2(0.3, 0.2), second = new double2(0.24, 0.15);
            var pose = PoseOf(SceneOf(CrossSectionTargets.Plate(first.x, first.y),
                    Moved(CrossSectionTargets.Plate(second.x, second.y), 3, -farther)),
                PublishedRow.Aspect(90, 0));
            pose.Frequencies = new[] { frequency };
            var contributions = Tracer.Contributions(pose, Tracer.Trace(pose), 0, 0, Polarisation.All);
            var s = contributions.Objects.ToDictionary(each => each.Number, each => each.S.VV);
            double Expected(double2 size) => Math.Sqrt(4 * Math.PI) * size.x * size.y / wavelength;
            // The tolerance is 0.02 dB of the sum.
            Assert.That(s[0].Magnitude, Is.EqualTo(Expected(first)).Within(0.0025 * Expected(first)));
            Assert.That(s[1].Magnitude, Is.EqualTo(Expected(second)).Within(0.0025 * Expected(first)));
            var turn = Complex.FromPolarCoordinates(Expected(second) / Expected(first),
                -2 * 2 * Math.PI * farther / wavelength);
            Assert.That((s[1] / s[0] - turn).Magnitude, Is.LessThan(0.005));
            Assert.That(contributions.Objects[0].Number, Is.Zero, "the larger one first");
            Assert.That(contributions.HotSpots.Select(spot => (spot.Object, spot.Triangle)),
                Is.EquivalentTo(new[] { (0, 0), (0, 1), (1, 0), (1, 1) }));
            foreach (var spot in contributions.HotSpots)
                // A tube on the diagonal belongs to one of both as a whole: there are some 40 along it.
                Assert.That(spot.Dbsm[0],
                    Is.EqualTo(20 * Math.Log10(Expected(spot.Object == 0 ? first : second) / 2)).Within(0.3));
        }

        /// <summary>
        /// A ray at 20 degrees above the lower face of a right-angled corner meets the upright one at tan 20 times the
        /// distance from the edge at which it meets, or would meet, the lower one: 36 % of the upright face return, and
        /// all of the lower one. Strips of equal width return the same.
        /// </summary>
        [Test, Timeout(60000)]
        public void HotSpotsOfADihedral_AreTheTrianglesThatSeeTheOtherFace()
        {
            const int strips = 4;
            const double width = 0.8, height = 0.3, grazing = 20;
            var lower = Strips(new double3(1, 0, 0), strips, width, height);
            var upright = Strips(new double3(0, 0, -1), strips, width, height);
            var pose = PoseOf(SceneOf(At(lower), At(upright)), RadarAspect.At(-(90 - grazing), 0));
            pose.OnlyBounce = 2;
            // Footprints on the lower face, up to 6 wavelengths long, must be small beside its strips: one on a border
            // belongs to one strip as a whole.
            pose.Frequencies = new[] { 1e11 };
            var contributions = Tracer.Contributions(pose, Tracer.Trace(pose), 0, 0, Polarisation.All);
            var strip = contributions.HotSpots.ToLookup(spot => spot.Object, spot => spot.Triangle / 2);
            Assert.That(strip[0].Distinct(), Is.EquivalentTo(Enumerable.Range(0, strips)));
            int last = (int)(strips * Math.Tan(math.radians(grazing)));
            Assert.That(last, Is.EqualTo(1), "0.364 x 4");
            Assert.That(strip[1].Distinct(), Is.EquivalentTo(Enumerable.Range(0, last + 1)));
            // A tube on the diagonal belongs to one triangle of the strip as a whole; both are in phase.
            var amplitudes = contributions.HotSpots.Where(spot => spot.Object == 0).GroupBy(spot => spot.Triangle / 2)
                .Select(spots => spots.Sum(spot => Math.Pow(10, spot.Dbsm[0].Value / 20))).ToArray();
            Assert.That(20 * Math.Log10(amplitudes.Max() / amplitudes.Min()), Is.LessThan(1));
            Assert.That(contributions.Bounces.Single().Number, Is.EqualTo(2));
        }

        [Test, Timeout(60000)]
        public void Edges_BelongToTheirObject()
        {
            // Seen along its face a plate returns by its edges only.
            var pose = PoseOf(SceneOf(Moved(CrossSectionTargets.Plate(0.3, 0.2), 3),
                At(CrossSectionTargets.Plate(0.2, 0.2))), PublishedRow.Aspect(90, 89.9));
            pose.HasEdges = true;
            var contributions = Tracer.Contributions(pose, Tracer.Trace(pose), 0, 0, Polarisation.All);
            var edges = contributions.Bounces.Single(each => each.Number == 0).S.VV;
            var both = contributions.Objects.Aggregate(Complex.Zero, (all, each) => all + each.S.VV);
            Assert.That(edges.Magnitude, Is.GreaterThan(10 * (both - edges).Magnitude));
            double ratio = contributions.Objects.Single(each => each.Number == 0).S.VV.Magnitude
                / contributions.Objects.Single(each => each.Number == 1).S.VV.Magnitude;
            Assert.That(ratio, Is.EqualTo(1).Within(0.05), "both edges across the sight are 0.2 m long");
        }

        [Test]
        public void ManyObjects_AreCutToTheStrongest()
        {
            const int count = CrossSectionContributions.MaxObjects + 3;
            var mesh = new TriangleMesh(new float3[3], new[] { 0, 1, 2 });
            var parts = new SceneParts(new RadarScene(Enumerable.Range(0, count).Select(number => new MeshInstance
            {
                Mesh = mesh, ToWorld = Affine.Identity, Ranges = new[] { new MeshRange(0, number, 0) }
            }).ToArray()));
            // Objects 0, 1 and 2 are the weakest.
            var objects = Enumerable.Range(1, count).Select(i => new ScatteringMatrix { VV = i, HH = 1000 - i })
                .ToArray();
            var vv = new[] { Polarisation.All[0] };
            var contributions = CrossSectionContributions.Of(parts, objects, part => default, vv);
            Assert.That(contributions.Objects.Select(each => each.Number), Is.EqualTo(
                Enumerable.Range(3, CrossSectionContributions.MaxObjects).Reverse()
                    .Append(CrossSectionContributions.Others)));
            Assert.That(contributions.Objects.Last().S.VV, Is.EqualTo(new Complex(1 + 2 + 3, 0)));
            Assert.That(contributions.Objects.Last().S.HH.Real, Is.NaN, "not asked for");
            Assert.That(contributions.HotSpots, Is.Empty, "nothing returns");
        }

        [Test]
        public void Triangles_AreNumberedInTheirObject()
        {
            var mesh = new TriangleMesh(new[] { new float3(0, 0, 0), new float3(1, 0, 0), new float3(0, 1, 0),
                new float3(0, 0, 1) }, new[] { 0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3 });
            var moved = Affine.Identity;
            moved.Origin = new double3(10, 0, 0);
            var scene = new RadarScene(
                new MeshInstance
                {
                    Mesh = mesh, ToWorld = Affine.Identity,
                    Ranges = new[] { new MeshRange(0, 5, 0), new MeshRange(1, 2, 0), new MeshRange(3, 5, 0) }
                },
                new MeshInstance { Mesh = mesh, ToWorld = moved, Ranges = new[] { new MeshRange(0, 5, 0) } });
            var parts = new SceneParts(scene);
            Assert.That(parts.Objects, Is.EqualTo(new[] { 2, 5 }));
            Assert.That(Enumerable.Range(0, 8).Select(parts.TriangleOf), Is.EqualTo(new[]
                { (5, 0), (2, 0), (2, 1), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5) }));
            Assert.That(parts.EdgesOf(0, 2), Is.EqualTo(8).And.EqualTo(parts.EdgesOf(2)));
            Assert.That(parts.EdgesOf(1, 0), Is.EqualTo(9));
            Assert.That(parts.FirstBounce, Is.EqualTo(10));
            Assert.That(parts.FirstOf(1), Is.EqualTo(4));
            Assert.That(parts.CornersOf(5, 3),
                Is.EqualTo(new[] { new double3(10, 0, 0), new double3(11, 0, 0), new double3(10, 0, 1) }));
            Assert.That(parts.CornersOf(5, 6), Is.Null);
            Assert.That(parts.CornersOf(7, 0), Is.Null);
        }

        static string Text(HotSpot spot) => $"{spot.Object} {spot.Triangle} {string.Join(" ", spot.Dbsm)}";

        // Rectangles side by side from the y axis along a direction, two triangles each.
        static TriangleMesh Strips(double3 along, int count, double width, double height)
        {
            var vertices = Enumerable.Range(0, 2 * (count + 1)).Select(i => (float3)(
                i / 2 * width / count * along + new double3(0, (i % 2 - 0.5) * height, 0))).ToArray();
            var indices = Enumerable.Range(0, count).SelectMany(i =>
                new[] { 0, 1, 3, 0, 3, 2 }.Select(corner => 2 * i + corner)).ToArray();
            return new TriangleMesh(vertices, indices);
        }

        static MeshInstance At(TriangleMesh mesh) => new MeshInstance { Mesh = mesh, ToWorld = Affine.Identity };

        // Across the sight of a radar on the +x side, and towards it.
        static MeshInstance Moved(TriangleMesh mesh, double across, double towards = 0)
        {
            var instance = At(mesh);
            instance.ToWorld.Origin = new double3(towards, 0, across);
            return instance;
        }

        static RadarScene SceneOf(TriangleMesh mesh, params MeshInstance[] others) =>
            SceneOf(others.Prepend(At(mesh)).ToArray());

        static RadarScene SceneOf(params MeshInstance[] instances)
        {
            for (int i = 0; i < instances.Length; i++)
                instances[i].Ranges = new[] { new MeshRange(0, i, 0) };
            return new RadarScene(instances);
        }

        static CrossSectionPose PoseOf(RadarScene scene, RadarAspect radar) => new CrossSectionPose
        {
            Scene = scene, Radar = radar, Receivers = new[] { radar }, Frequencies = new[] { TenGigahertz },
            ToleranceDb = 0.02, HasEdges = false
        };
    }
}
