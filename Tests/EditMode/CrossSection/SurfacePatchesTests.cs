using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class SurfacePatchesTests
    {
        [Test]
        public void Box_HasSixFlatPatches_WithTheirFacesNormals()
        {
            var patches = SurfacePatches.Find(CrossSectionTargets.Box(0.3, 0.2, 0.01));
            Assert.That(patches.PatchCount, Is.EqualTo(6));
            Assert.That(Flat(patches), Is.EqualTo(6));
            for (int corner = 0; corner < 36; corner++)
            {
                Assert.That(patches.PatchOf[corner / 3], Is.EqualTo(patches.PatchOf[corner / 6 * 2]), "two a face");
                Assert.That(math.distance(patches.CornerNormals[corner], FacetNormal(patches, corner / 3)),
                    Is.LessThan(1e-6));
            }
        }

        [Test]
        public void Cylinder_IsASideAndTwoFlatCaps_WithRadialNormals()
        {
            var mesh = CrossSectionTargets.Cylinder(0.1, 0.5, 96, true);
            var patches = SurfacePatches.Find(mesh);
            Assert.That(patches.PatchCount, Is.EqualTo(3));
            Assert.That(patches.IsFlat(patches.PatchOf[0]), Is.False, "the side");
            Assert.That(Flat(patches), Is.EqualTo(2), "caps");
            for (int corner = 0; corner < mesh.Indices.Length; corner++)
            {
                double3 p = mesh.Vertices[mesh.Indices[corner]], radial = math.normalize(new double3(p.x, 0, p.z)),
                    axial = new double3(0, math.sign(p.y), 0);
                bool side = patches.PatchOf[corner / 3] == patches.PatchOf[0];
                Assert.That(math.distance(patches.CornerNormals[corner], side ? radial : axial), Is.LessThan(1e-6));
            }
        }

        // A facet's own normal is off by half the bend at its edges, 0.05 and 0.006.
        [TestCase(16, 0.005)]
        [TestCase(128, 0.001)]
        public void Sphere_IsOnePatch_WithRadialNormals(int cuts, double tolerance)
        {
            var mesh = CrossSectionTargets.Sphere(1, cuts);
            var patches = SurfacePatches.Find(mesh);
            Assert.That(patches.PatchCount, Is.EqualTo(1));
            Assert.That(patches.IsFlat(0), Is.False);
            Assert.That(Enumerable.Range(0, mesh.Indices.Length).Max(corner => math.distance(
                patches.CornerNormals[corner], mesh.Vertices[mesh.Indices[corner]])), Is.LessThan(tolerance));
        }

        [Test]
        public void TopHat_IsATubeAndADisc()
        {
            var patches = SurfacePatches.Find(CrossSectionTargets.Named("top_hat"));
            Assert.That(patches.PatchCount, Is.EqualTo(2));
            Assert.That(patches.IsFlat(patches.PatchOf[0]), Is.False);
            Assert.That(patches.IsFlat(patches.PatchOf[2]));
        }

        [TestCase(20.5, 20, 2)]
        [TestCase(19.5, 20, 1)]
        [TestCase(5.5, 5, 2)]
        [TestCase(4.5, 5, 1)]
        public void Fold_IsACrease_AboveTheCreaseAngle(double bend, double crease, int count)
        {
            var patches = SurfacePatches.Find(CrossSectionTargets.Dihedral(0.3, 0.2, 180 - bend), null, crease);
            Assert.That(patches.PatchCount, Is.EqualTo(count));
            Assert.That(Flat(patches), Is.EqualTo(count == 2 ? 2 : 0));
        }

        [Test]
        public void Surfaces_EndPatches_ObjectsDoNot()
        {
            var plate = SameSurface.Subdivided(CrossSectionTargets.Plate(1, 1), 2);
            Assert.That(SurfacePatches.Find(plate).PatchCount, Is.EqualTo(1));
            MeshRange[] objects = { new MeshRange(0, 0, 0), new MeshRange(16, 1, 0) },
                surfaces = { new MeshRange(0, 0, 0), new MeshRange(16, 0, 1) };
            Assert.That(SurfacePatches.Find(plate, objects).PatchCount, Is.EqualTo(1));
            Assert.That(SurfacePatches.Find(plate, surfaces).PatchOf,
                Is.EqualTo(Enumerable.Range(0, 32).Select(t => t / 16)));
        }

        // Corners are rounded to 4 micrometres at 50 m, so that facets of 1 cm are bent by up to 0.05 degrees.
        [Test]
        public void CoplanarFacets_AreOneFlatPatch_AtAnyCreaseAngle()
        {
            var random = new System.Random(1);
            for (int i = 0; i < 10; i++)
            {
                var move = SameSurface.Rotation(random);
                move.Origin = new double3(30, 40, 20);
                var plate = SameSurface.Moved(SameSurface.Subdivided(CrossSectionTargets.Plate(0.3, 0.2), 5), move);
                var patches = SurfacePatches.Find(plate, null, 0);
                Assert.That(patches.PatchCount, Is.EqualTo(1));
                Assert.That(patches.IsFlat(0));
            }
        }

        [Test]
        public void RotatedAndShuffled_HasTheSamePatchesAndNormals([Values(1, 2, 3)] int seed)
        {
            var random = new System.Random(seed);
            var mesh = ShipModel.Build(ShipSettings.Default);
            var original = SurfacePatches.Find(mesh);
            // Turned by right angles, so that rounding does not decide at the crease angle.
            var turn = new Affine
            {
                X = new double3(0, 0, 1), Y = new double3(0, -1, 0), Z = new double3(1, 0, 0)
            };
            var shuffled = SameSurface.Shuffled(SameSurface.Moved(mesh, turn), random, out var order);
            var patches = SurfacePatches.Find(shuffled);

            Assert.That(patches.PatchCount, Is.EqualTo(original.PatchCount));
            var newOf = new Dictionary<int, int>();
            for (int t = 0; t < order.Length; t++)
            {
                int old = original.PatchOf[order[t]];
                if (!newOf.TryGetValue(old, out int patch))
                    newOf.Add(old, patch = patches.PatchOf[t]);
                Assert.That(patches.PatchOf[t], Is.EqualTo(patch));
                Assert.That(patches.IsFlat(patch), Is.EqualTo(original.IsFlat(old)));
                for (int k = 0; k < 3; k++)
                    Assert.That(Enumerable.Range(3 * order[t], 3).Min(corner => math.distance(
                        turn.Vector(original.CornerNormals[corner]), patches.CornerNormals[3 * t + k])),
                        Is.LessThan(1e-5));
            }
        }

        [Test]
        public void RotatedCylinder_HasTheSamePatchesAndNormals([Values(1, 2, 3, 4)] int seed)
        {
            var random = new System.Random(seed);
            var mesh = CrossSectionTargets.Cylinder(0.1, 0.5, 96, true);
            var turn = SameSurface.Rotation(random);
            SurfacePatches original = SurfacePatches.Find(mesh),
                turned = SurfacePatches.Find(SameSurface.Moved(mesh, turn));
            Assert.That(turned.PatchOf, Is.EqualTo(original.PatchOf));
            Assert.That(Flat(turned), Is.EqualTo(2));
            for (int corner = 0; corner < mesh.Indices.Length; corner++)
                Assert.That(math.distance(turn.Vector(original.CornerNormals[corner]), turned.CornerNormals[corner]),
                    Is.LessThan(1e-3));
        }

        [Test]
        public void RewoundTriangles_KeepPatches_AndTurnTheirNormals([Values(1, 2, 3)] int seed)
        {
            var mesh = CrossSectionTargets.Cylinder(0.1, 0.5, 96, true);
            var rewound = SameSurface.Rewound(mesh, new System.Random(seed), out var isRewound);
            SurfacePatches original = SurfacePatches.Find(mesh), patches = SurfacePatches.Find(rewound);
            Assert.That(patches.PatchOf, Is.EqualTo(original.PatchOf));
            Assert.That(Flat(patches), Is.EqualTo(2));
            for (int t = 0; t < mesh.TriangleCount; t++)
                for (int k = 0; k < 3; k++)
                {
                    float3 expected = isRewound[t] ? -original.CornerNormals[3 * t + (3 - k) % 3]
                        : original.CornerNormals[3 * t + k];
                    Assert.That(math.distance(patches.CornerNormals[3 * t + k], expected), Is.LessThan(1e-6));
                }
        }

        // A tube whose quads are cut by a vertex on their lower edge, which the ring below does not have: the gap is
        // closed by triangles without area. A triangle with a corner twice lies on it too.
        [Test]
        public void TrianglesWithoutArea_ConnectTheirNeighbours_AndLeaveNormalsAlone()
        {
            const int Sides = 48;
            var mesh = TubeWithSlivers(Sides, 0);
            var patches = SurfacePatches.Find(mesh);
            Assert.That(patches.PatchCount, Is.EqualTo(1));
            AssertRadial(patches, 1e-4);
            Assert.That(patches.PatchOf[mesh.TriangleCount - 1], Is.EqualTo(SurfacePatches.NoPatch));
        }

        // The vertex on the edge is off by a rounding of its coordinates, which turns the sliver's own normal anywhere.
        [Test]
        public void Needles_DoNotPoisonNormals([Values(1, 2, 3)] int seed)
        {
            var patches = SurfacePatches.Find(TubeWithSlivers(48, seed));
            Assert.That(patches.PatchCount, Is.EqualTo(1));
            AssertRadial(patches, 1e-4);
        }

        // A sliver along the edge of a box belongs to one of its faces and does not join them.
        [Test]
        public void Needle_AtACrease_JoinsOneFace()
        {
            var vertices = new[]
            {
                new float3(0, 0, 0), new float3(1, 0, 0), new float3(0, 1, 0), new float3(1, 1, 0),
                new float3(0, 0, 1), new float3(1, 0, 1), new float3(0.5f, 2e-8f, 1e-8f),
            };
            // The face y = 0 ends in 0 - 1, the face z = 0 in 0 - 6 - 1, the sliver is between.
            var mesh = new TriangleMesh(vertices,
                new[] { 0, 1, 5, 0, 5, 4, 0, 2, 6, 6, 2, 3, 6, 3, 1, 0, 6, 1 });
            var patches = SurfacePatches.Find(mesh);
            Assert.That(patches.PatchCount, Is.EqualTo(2));
            Assert.That(patches.PatchOf[0], Is.Not.EqualTo(patches.PatchOf[2]));
            foreach (var normal in patches.CornerNormals)
                Assert.That(math.min(math.length(normal.xy - new float2(0, math.sign(normal.y))),
                    math.length(normal.yz - new float2(0, math.sign(normal.z)))), Is.LessThan(1e-6), $"{normal}");
        }

        [Test]
        public void LoneTriangleWithoutArea_HasUnitNormals()
        {
            var patches = SurfacePatches.Find(new TriangleMesh(
                new float3[] { 0, new float3(1, 0, 0), new float3(2, 0, 0) }, new[] { 0, 1, 2 }));
            Assert.That(patches.CornerNormals.Select(normal => math.length(normal)), Is.All.EqualTo(1));
        }

        [TestCase(-1)]
        [TestCase(91)]
        [TestCase(double.NaN)]
        public void CreaseAngle_OutOfItsRange_IsRefused(double degrees) =>
            Assert.That(() => SurfacePatches.Find(CrossSectionTargets.Plate(1, 1), null, degrees),
                Throws.TypeOf<GlintException>().With.Message.StartsWith(FormattableString.Invariant(
                    $"crease angle {degrees} degrees: must be from 0")));

        // The stored ship: sharp parts keep their patches, and smooth ones are one patch each. The hull's port and
        // starboard mirror each other.
        [Test]
        public void Ship_HasTheSamePatchesOnBothSides()
        {
            var mesh = ShipModel.Build(ShipSettings.Default);
            var patches = SurfacePatches.Find(mesh);
            Assert.That(patches.PatchCount, Is.InRange(200, 500));
            Assert.That(patches.PatchOf, Is.All.Not.EqualTo(SurfacePatches.NoPatch));
            var sizes = new double[patches.PatchCount];
            var sides = new double[patches.PatchCount];
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out var a, out var b, out var c);
                double area = math.length(math.cross((double3)b - a, (double3)c - a)) / 2;
                sizes[patches.PatchOf[t]] += area;
                sides[patches.PatchOf[t]] += area * (a.x + b.x + c.x) / 3;
            }
            // Mean x of each patch, and its area: port and starboard.
            var port = new List<(double, double)>();
            var starboard = new List<(double, double)>();
            for (int i = 0; i < sizes.Length; i++)
                if (math.abs(sides[i] / sizes[i]) > 0.01)
                    (sides[i] > 0 ? starboard : port).Add(
                        (math.round(100 * math.abs(sides[i] / sizes[i])), math.round(100 * sizes[i])));
            Assert.That(port.Count, Is.EqualTo(starboard.Count));
            Assert.That(port.Count, Is.GreaterThan(50));
        }

        // The limit is twice what is asked of idle cores, whose caches tests share.
        [Test]
        public void HalfAMillionTriangles_WithoutSharedVertices_TakeThreeSeconds()
        {
            var soup = TestMeshes.Soup(TestMeshes.Sea(500, 500));
            var patches = ProcessorTime.Within(3, () => SurfacePatches.Find(soup));
            Assert.That(patches.PatchCount, Is.EqualTo(1));
        }

        // Two rings of quads about the y axis, 40 m from the origin along x, radius 1; each quad of the upper ring has
        // a vertex in the middle of its lower edge.
        static TriangleMesh TubeWithSlivers(int sides, int seed)
        {
            var random = seed == 0 ? null : new System.Random(seed);
            var vertices = new List<float3>();
            for (int level = -1; level <= 1; level++)
                for (int i = 0; i < sides; i++)
                    vertices.Add((float3)OnTube(2 * math.PI_DBL * i / sides, level));
            for (int i = 0; i < sides; i++)
            {
                float3 centre = (vertices[sides + i] + vertices[sides + (i + 1) % sides]) / 2;
                if (random != null)
                    centre += 4e-6f * (new float3(random.Next(3), random.Next(3), random.Next(3)) - 1);
                vertices.Add(centre);
            }
            var indices = new List<int>();
            for (int i = 0, j = 1; i < sides; i++, j = (i + 1) % sides)
            {
                int low = i, lowNext = j, at = sides + i, next = sides + j, high = 2 * sides + i,
                    highNext = 2 * sides + j, centre = 3 * sides + i;
                indices.AddRange(new[] { low, at, lowNext, lowNext, at, next });
                indices.AddRange(new[] { at, high, centre, high, highNext, centre, highNext, next, centre });
                indices.AddRange(new[] { at, centre, next });
            }
            indices.AddRange(new[] { 0, sides, 0 });
            return new TriangleMesh(vertices.ToArray(), indices.ToArray());
        }

        static double3 OnTube(double angle, double y) => new double3(40 + math.cos(angle), y, math.sin(angle));

        // Corners in the middle of an edge belong to one facet's plane, whose normal is that of the middle.
        static void AssertRadial(SurfacePatches patches, double tolerance)
        {
            var mesh = patches.Welded.Mesh;
            for (int corner = 0; corner < mesh.Indices.Length; corner++)
            {
                if (patches.PatchOf[corner / 3] == SurfacePatches.NoPatch)
                    continue;
                var offset = mesh.Vertices[mesh.Indices[corner]] - new float3(40, 0, 0);
                double3 radial = math.normalize(new double3(offset.x, 0, offset.z));
                double3 normal = patches.CornerNormals[corner];
                // The sliver's own winding is by chance.
                Assert.That(math.min(math.distance(normal, radial), math.distance(normal, -radial)),
                    Is.LessThan(tolerance), $"corner {corner}");
            }
        }

        static int Flat(SurfacePatches patches) => Enumerable.Range(0, patches.PatchCount).Count(patches.IsFlat);

        static double3 FacetNormal(SurfacePatches patches, int triangle)
        {
            patches.Welded.Mesh.GetTriangle(triangle, out var a, out var b, out var c);
            return math.normalize(math.cross((double3)b - a, (double3)c - a));
        }
    }
}
