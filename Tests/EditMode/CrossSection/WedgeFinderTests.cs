using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class WedgeFinderTests
    {
        [Test]
        public void Box_HasTwelveWedges_OfThreeQuarters_WithAirOutside()
        {
            var set = Find(CrossSectionTargets.Box(0.3, 0.2, 0.01));
            AssertWedges(set, (1.5, 12, 4 * 0.51));
            foreach (var wedge in set.Wedges)
            {
                // Normals of the faces point away from the box's centre.
                double3 centre = (wedge.A + wedge.B) / 2;
                Assert.That(math.dot(centre, wedge.First.Normal), Is.GreaterThan(0));
                Assert.That(math.dot(centre, wedge.Second.Normal), Is.GreaterThan(0));
            }
        }

        [Test]
        public void HalfSpace_OfAnOpenSurface_IsFound()
        {
            var wood = PublishedMaterial.Find("itu_wood").ToSurface("wood");
            var coated = new SurfaceMaterial("coated", new[] { new MaterialLayer(wood.HalfSpace, 0.001) });
            TriangleMesh plate = CrossSectionTargets.Plate(0.3, 0.2), box = CrossSectionTargets.Box(0.3, 0.2, 0.01);
            Assert.That(FindOpen(plate, wood), Is.EqualTo(wood));
            Assert.That(FindOpen(box, wood), Is.Null, "closed");
            Assert.That(FindOpen(plate, coated), Is.Null, "a coated conductor has two sides");
            var withoutFace = new TriangleMesh(box.Vertices, box.Indices.Skip(6).ToArray());
            Assert.That(FindOpen(withoutFace, wood), Is.EqualTo(wood), "a box without a face");
        }

        static SurfaceMaterial FindOpen(TriangleMesh mesh, SurfaceMaterial material)
        {
            var scene = new RadarScene(new MeshInstance
            {
                Mesh = mesh, ToWorld = Affine.Identity, Ranges = new[] { new MeshRange(0, 0, 1) }
            })
            { Surfaces = new[] { SurfaceMaterial.PerfectConductor, material } };
            return WedgeFinder.FindOpenDielectric(scene,
                new[] { SurfacePatches.Find(mesh, scene.Instances[0].Ranges) });
        }

        [Test]
        public void Plate_HasFourHalfPlanes()
        {
            var set = Find(CrossSectionTargets.Plate(0.3, 0.2));
            AssertWedges(set, (2, 4, 1));
            foreach (var wedge in set.Wedges)
            {
                Assert.That(math.distance(wedge.First.Into, wedge.Second.Into), Is.LessThan(1e-12));
                Assert.That(math.distance(wedge.First.Normal, -wedge.Second.Normal), Is.LessThan(1e-12));
                Assert.That(math.dot(wedge.First.Into, wedge.A), Is.LessThan(0), "into the plate");
            }
        }

        [Test]
        public void Dihedral_OfThinPlates_HasAWedgeOnEitherSide([Values(60, 90, 100, 150)] double degrees)
        {
            var set = Find(CrossSectionTargets.Dihedral(0.3, 0.2, degrees));
            AssertWedges(set, (2, 6, 1.6), (degrees / 180, 1, 0.2), (2 - degrees / 180, 1, 0.2));
            foreach (var wedge in set.Wedges.Where(wedge => wedge.N < 2))
                Assert.That(wedge.IsConcave, Is.EqualTo(wedge.N < 1));
        }

        // A plate of 0.2 m in the plane x = 0 and one of 0.3 m in z = 0, whose edges overlap by 0.15 m and are 5
        // micrometres apart; the scene's size is 0.5 m.
        [TestCase(false)]
        [TestCase(true)]
        public void Dihedral_OfSeparateFaces_HasWedgesWhereEdgesLieOnEachOther(bool instances)
        {
            TriangleMesh first = TestRadar.Plate(0, new float3(0, 0.2f, 0), new float3(0, 0, 0.3f)),
                second = TestRadar.Plate(new float3(5e-6f, 0.05f, 0), new float3(0, 0.3f, 0), new float3(0.3f, 0, 0));
            var set = instances ? Find(first, second) : Find(TestRadar.Join(first, second));
            AssertWedges(set,
                (2, 8, 0.05 + 0.15 + 2 * 0.3 + 0.2 + 2 * 0.3 + 0.3), (0.5, 1, 0.15), (1.5, 1, 0.15));
        }

        [Test]
        public void Dihedral_OfFacesThatAreFartherApart_IsTwoPlates() => AssertWedges(Find(TestRadar.Join(
            TestRadar.Plate(0, new float3(0, 0.2f, 0), new float3(0, 0, 0.3f)),
            TestRadar.Plate(new float3(2e-5f, 0, 0), new float3(0, 0.2f, 0), new float3(0.3f, 0, 0)))), (2, 8, 2));

        // A wall of one facet beside a floor of eight: each vertex of the floor's edge is a T-junction.
        [Test]
        public void Dihedral_OfFinelyAndCoarselyCutFaces_IsOneDihedral() => AssertWedges(Find(TestRadar.Join(
            SameSurface.Subdivided(TestRadar.Plate(0, new float3(0, 0.2f, 0), new float3(0, 0, 0.3f)), 3),
            TestRadar.Plate(0, new float3(0, 0.2f, 0), new float3(0.3f, 0, 0)))),
            (2, 6, 1.6), (0.5, 1, 0.2), (1.5, 1, 0.2));

        [Test]
        public void Plates_InAPlaneThatShareAnEdge_AreOnePlate([Values(false, true)] bool instances)
        {
            TriangleMesh first = TestRadar.Plate(0, new float3(0, 0.2f, 0), new float3(0, 0, 0.3f)),
                second = TestRadar.Plate(0, new float3(0, 0, 0.3f), new float3(0, -0.1f, 0));
            AssertWedges(instances ? Find(first, second) : Find(TestRadar.Join(first, second)), (2, 4, 1.2));
        }

        // Three plates on one line, two of them in a plane, so that their upper and lower edges are one each; front and
        // back of a plate as two sheets.
        [Test]
        public void Sheets_ThatMeetOrCoincide()
        {
            float3 up = new float3(0, 0.2f, 0);
            AssertWedges(Find(TestRadar.Join(TestRadar.Plate(0, up, new float3(0.1f, 0, 0)),
                TestRadar.Plate(0, up, new float3(0, 0, 0.1f)), TestRadar.Plate(0, up, new float3(-0.1f, 0, 0)))),
                (2, 7, 3 * 0.4), (0.5, 2, 0.4));
            AssertWedges(Find(TestRadar.Join(TestRadar.Plate(0, up, new float3(0.1f, 0, 0)),
                TestRadar.Plate(0, new float3(0.1f, 0, 0), up))), (2, 4, 0.6));
        }

        // Side by side: the edges outside are those of one box of twice the length, since tops are one plane.
        [Test]
        public void Boxes_ThatShareAFace_AreABoxOutside()
        {
            var box = new TriangleMesh(Solid.BoxVertices(1, 1, 1), Solid.BoxIndices);
            var set = Find(TestRadar.Join(box, SameSurface.Moved(box, Moved(new double3(1, 0, 0)))));
            var convex = set.Wedges.Where(wedge => !wedge.IsConcave).ToArray();
            Assert.That(convex.Select(wedge => wedge.N), Is.EqualTo(Enumerable.Repeat(1.5, 12)).Within(1e-6));
            Assert.That(convex.Sum(wedge => wedge.Length), Is.EqualTo(4 * (2 + 1 + 1)).Within(1e-6));
        }

        // Diagonally: the air is in two quadrants around the common edge.
        [Test]
        public void Boxes_ThatShareAnEdge_AreTwoBoxes()
        {
            var box = new TriangleMesh(Solid.BoxVertices(1, 1, 1), Solid.BoxIndices);
            AssertWedges(Find(TestRadar.Join(box, SameSurface.Moved(box, Moved(new double3(1, 1, 0))))),
                (1.5, 22, 22), (0.5, 2, 2));
        }

        [Test]
        public void FinelyCutBodies_HaveTheirCoarseEdges([Values(1, 2, 3)] int seed)
        {
            var random = new System.Random(seed);
            foreach (var mesh in new[]
                     {
                         CrossSectionTargets.Plate(0.3, 0.2), CrossSectionTargets.Box(0.3, 0.2, 0.1),
                         CrossSectionTargets.Dihedral(0.3, 0.2, 100),
                         CrossSectionTargets.Trihedral(0.3, CrossSectionTargets.TrihedralFace.Triangular),
                     })
            {
                var turn = SameSurface.Rotation(random);
                var fine = SameSurface.Rewound(SameSurface.Shuffled(
                    SameSurface.Moved(SameSurface.Subdivided(mesh, 4), turn), random, out _), random, out _);
                AssertSame(Find(fine), Find(mesh), turn);
            }
        }

        [Test]
        public void RotatedAndShuffledBodies_HaveTheSameEdges([Values(1, 2, 3)] int seed)
        {
            var random = new System.Random(seed);
            foreach (var mesh in new[]
                     {
                         CrossSectionTargets.Cylinder(0.1, 0.5, 96, true),
                         CrossSectionTargets.TopHat(0.1, 0.2, 0.6, 96),
                         CrossSectionTargets.Trihedral(0.3, CrossSectionTargets.TrihedralFace.Circular, 64),
                         CrossSectionTargets.TwoPlates(0.2, 0.2, 0.3),
                     })
            {
                var turn = SameSurface.Rotation(random);
                turn.Origin = 3 * new double3(random.NextDouble(), random.NextDouble(), random.NextDouble());
                var other = SameSurface.Rewound(SameSurface.Shuffled(
                    SameSurface.Moved(mesh, turn), random, out _), random, out _);
                AssertSame(Find(other), Find(mesh), turn);
            }
        }

        [Test]
        public void Sphere_HasNone() => AssertWedges(Find(CrossSectionTargets.Sphere(1, 32)));

        // Rims of equal pieces; nothing along the smooth side.
        [Test]
        public void Cylinder_WithCaps_HasTwoRims()
        {
            const int Sides = 96;
            double rim = 2 * Sides * 0.1 * math.sin(math.PI_DBL / Sides);
            var set = Find(CrossSectionTargets.Cylinder(0.1, 0.5, Sides, true));
            AssertWedges(set, (1.5, 2 * Sides, 2 * rim));
            Assert.That(set.Wedges, Is.All.Matches<Wedge>(wedge => math.abs(math.abs(wedge.A.y) - 0.25) < 1e-7));
            AssertWedges(Find(CrossSectionTargets.Cylinder(0.1, 0.5, Sides, false)), (2, 2 * Sides, 2 * rim));
        }

        // Fewer than 18 sides are bent by more than 20 degrees.
        [Test]
        public void Prism_HasEdgesAlongItsSide() => AssertWedges(Find(CrossSectionTargets.Cylinder(0.1, 0.5, 6, true)),
            (1.5, 12, 12 * 0.1), (4 / 3.0, 6, 6 * 0.5));

        [Test]
        public void TopHat_HasTwoFreeRims_AndACorner()
        {
            const int Sides = 720;
            double Rim(double radius) => 2 * Sides * radius * math.sin(math.PI_DBL / Sides);
            AssertWedges(Find(CrossSectionTargets.Named("top_hat")),
                (2, 2 * Sides, Rim(0.1) + Rim(0.6)), (0.5, Sides, Rim(0.1)), (1.5, Sides, Rim(0.1)));
        }

        [TestCase(CrossSectionTargets.TrihedralFace.Triangular, 3)]
        [TestCase(CrossSectionTargets.TrihedralFace.Square, 6)]
        [TestCase(CrossSectionTargets.TrihedralFace.Circular, 768)]
        public void Trihedral_HasThreeCorners(CrossSectionTargets.TrihedralFace face, int ends)
        {
            double arc = 6 * 256 * 0.3 * math.sin(math.PI_DBL / 1024);
            double length = ends == 3 ? 0.9 * math.sqrt(2.0) : ends == 6 ? 1.8 : arc;
            AssertWedges(Find(CrossSectionTargets.Trihedral(0.3, face)),
                (2, ends, length), (0.5, 3, 0.9), (1.5, 3, 0.9));
        }

        [Test]
        public void SeparatePlates_HaveTheirOwnEdges()
        {
            AssertWedges(Find(CrossSectionTargets.TwoPlates(0.2, 0.2, 0.3)), (2, 8, 1.6));
            AssertWedges(Find(CrossSectionTargets.HiddenPlate(0.2, 0.4, 0.5)), (2, 8, 2.4));
        }

        // The winding number of the surface around a point is 1 inside and 0 outside: a computation of its own. The
        // random body has edges of all kinds; triangles are wound by chance afterwards.
        [Test]
        public void Wedges_OfARandomBody_HaveAirWithinTheOuterAngleAlone([Values(1, 2, 3, 4, 5)] int seed)
        {
            var random = new System.Random(seed);
            var sphere = CrossSectionTargets.Sphere(1, 4);
            var body = new TriangleMesh(
                Array.ConvertAll(sphere.Vertices, vertex => (float)(0.6 + 0.4 * random.NextDouble()) * vertex),
                sphere.Indices);
            var set = Find(SameSurface.Rewound(SameSurface.Shuffled(body, random, out _), random, out _));
            Assert.That(set.Wedges.Count, Is.GreaterThan(100));
            Assert.That(set.Wedges.Any(wedge => wedge.IsConcave));
            foreach (var wedge in set.Wedges)
            {
                double3 At(double angle) => (wedge.A + wedge.B) / 2
                    + 1e-3 * (math.cos(angle) * wedge.First.Into + math.sin(angle) * wedge.First.Normal);
                double solid = 2 * math.PI_DBL - wedge.OuterAngle;
                foreach (double part in new[] { 0.01, 0.5, 0.99 })
                {
                    Assert.That(WindingNumber(body, At(part * wedge.OuterAngle)), Is.EqualTo(0).Within(1e-6));
                    Assert.That(WindingNumber(body, At(-part * solid)), Is.EqualTo(1).Within(1e-6));
                }
                AssertFrames(wedge);
            }
        }

        // Each face is a mesh of its own; the same edges, also mirrored and scaled.
        [Test]
        public void Box_OfSixInstances_IsABox()
        {
            var box = new TriangleMesh(Solid.BoxVertices(1, 2, 3), Solid.BoxIndices);
            foreach (var place in new[]
                     {
                         Affine.Identity, Affine.FromTransform(5, new double4(1, 2, 3, 4), new double3(2, 2, -2)),
                     })
            {
                var instances = Enumerable.Range(0, 6).Select(face => new MeshInstance
                {
                    Mesh = new TriangleMesh(box.Vertices, box.Indices.Skip(6 * face).Take(6).ToArray()),
                    ToWorld = place,
                }).ToArray();
                var set = Find(new RadarScene(instances));
                double scale = math.length(place.X);
                AssertWedges(set, (1.5, 12, 24 * scale));
                double3 centre = place.Point(new double3(0.5, 1, 1.5));
                foreach (var wedge in set.Wedges)
                    Assert.That(math.dot(wedge.A - centre, wedge.First.Normal), Is.GreaterThan(0));
            }
        }

        // A CAD body: each face has vertices of its own, cut as finely as it likes, off by 2 micrometres of 0.37 m.
        [Test]
        public void Box_OfFacesCutDifferently_IsABox([Values(0, 2e-6)] double offset)
        {
            var box = CrossSectionTargets.Box(0.3, 0.2, 0.1);
            var faces = Enumerable.Range(0, 6).Select(face => SameSurface.Moved(SameSurface.Subdivided(
                new TriangleMesh(box.Vertices, box.Indices.Skip(6 * face).Take(6).ToArray()), face % 4),
                Moved(offset * new double3(face % 2, face % 3 - 1, 0)))).ToArray();
            AssertWedges(Find(TestRadar.Join(faces)), (1.5, 12, 2.4));
            AssertWedges(Find(faces), (1.5, 12, 2.4));
        }

        // The plate's lower half is coated: its edges, and the border in the plane, are left out.
        [Test]
        public void CoatedFaces_AreLeftOutAndCounted()
        {
            TriangleMesh metal = TestRadar.Plate(0, new float3(0, 0.2f, 0), new float3(0, 0, 0.3f)),
                coated = TestRadar.Plate(0, new float3(0, 0, 0.3f), new float3(0, -0.1f, 0));
            var scene = new RadarScene(new MeshInstance
            {
                Mesh = TestRadar.Join(metal, coated), ToWorld = Affine.Identity,
                Ranges = new[] { new MeshRange(0, 0, 0), new MeshRange(2, 0, 1) },
            })
            {
                Surfaces = new[] { SurfaceMaterial.PerfectConductor, new SurfaceMaterial("paint") },
            };
            var patches = new[] { SurfacePatches.Find(scene.Instances[0].Mesh, scene.Instances[0].Ranges) };

            var set = WedgeFinder.Find(scene, patches, surface => surface.Name != "paint");
            AssertWedges(set, (2, 3, 0.7));
            // Three edges of the coated half; the border seen from both sides.
            Assert.That(set.CoatedCount, Is.EqualTo(5));
            Assert.That(set.CoatedLength, Is.EqualTo(0.5 + 2 * 0.3).Within(1e-6));

            var both = WedgeFinder.Find(scene, patches);
            AssertWedges(both, (2, 4, 1.2));
            Assert.That(both.CoatedCount, Is.Zero);
        }

        // Of a dihedral all edges but the inside of its corner: that behind it, and three of each face.
        [Test]
        public void CoatedCorner_IsNotCountedOnItsInside()
        {
            var scene = new RadarScene(CrossSectionTargets.Dihedral(0.3, 0.2));
            var set = WedgeFinder.Find(scene, new[] { SurfacePatches.Find(scene.Instances[0].Mesh) }, _ => false);
            Assert.That(set.CoatedCount, Is.EqualTo(7));
            Assert.That(set.CoatedLength, Is.EqualTo(3 * 0.2 + 4 * 0.3).Within(1e-6));
        }

        // Bodies that intersect are closed each. The ship is the same on both sides, and turned by right angles.
        [Test]
        public void Ship_IsClosed_WithTheSameWedgesOnBothSides()
        {
            var mesh = ShipModel.Build(ShipSettings.Default);
            var set = Find(mesh);
            Assert.That(set.Wedges, Is.All.Matches<Wedge>(wedge => wedge.N < 1.99), "no thin sheet");
            Assert.That(set.Wedges.Count, Is.InRange(1000, 3000));
            double Length(Func<Wedge, bool> which) => set.Wedges.Where(which).Sum(wedge => wedge.Length);
            double starboard = Length(wedge => wedge.A.x + wedge.B.x > 1e-6),
                port = Length(wedge => wedge.A.x + wedge.B.x < -1e-6);
            Assert.That(port, Is.EqualTo(starboard).Within(1e-3).Percent);

            var mirror = new Affine { X = new double3(-1, 0, 0), Y = new double3(0, 0, 1), Z = new double3(0, 1, 0) };
            var shuffled = SameSurface.Shuffled(SameSurface.Moved(mesh, mirror), new System.Random(1), out _);
            AssertSame(Find(shuffled), set, mirror);
        }

        [Test]
        public void EmptyScene_HasNone() => AssertWedges(Find(new TriangleMesh(new float3[0], new int[0])));

        // The limit is twice what is asked of idle cores, whose caches tests share.
        [Test]
        public void HalfAMillionTriangles_TakeASecond()
        {
            var mesh = TestMeshes.Sea(500, 500);
            var patches = new[] { SurfacePatches.Find(mesh) };
            var set = ProcessorTime.Within(1, () => WedgeFinder.Find(new RadarScene(mesh), patches));
            Assert.That(set.Wedges.Count, Is.InRange(4, 2000));
        }

        static WedgeSet Find(params TriangleMesh[] meshes) => Find(new RadarScene(Array.ConvertAll(meshes,
            mesh => new MeshInstance { Mesh = mesh, ToWorld = Affine.Identity })));

        static WedgeSet Find(RadarScene scene) => WedgeFinder.Find(scene,
            Array.ConvertAll(scene.Instances, instance => SurfacePatches.Find(instance.Mesh, instance.Ranges)));

        static Affine Moved(double3 by)
        {
            var move = Affine.Identity;
            move.Origin = by;
            return move;
        }

        // The wedges by outer angle in half turns: how many, and their length.
        static void AssertWedges(WedgeSet set, params (double n, int count, double length)[] expected)
        {
            string text = string.Join(", ", set.Wedges.GroupBy(wedge => math.round(wedge.N * 1000) / 1000)
                .Select(group => $"{group.Count()} of {group.Key}, {group.Sum(wedge => wedge.Length)} m"));
            foreach (var (n, count, length) in expected)
            {
                var wedges = set.Wedges.Where(wedge => math.abs(wedge.N - n) < 1e-3).ToArray();
                Assert.That(wedges.Length, Is.EqualTo(count), text);
                Assert.That(wedges.Sum(wedge => wedge.Length), Is.EqualTo(length).Within(1e-4 * length), text);
            }
            Assert.That(set.Wedges.Count, Is.EqualTo(expected.Sum(group => group.count)), text);
            foreach (var wedge in set.Wedges)
                AssertFrames(wedge);
        }

        // Direction, first face and its normal are a frame; the second face is at the outer angle.
        static void AssertFrames(Wedge wedge)
        {
            double sin = math.sin(wedge.OuterAngle), cos = math.cos(wedge.OuterAngle);
            WedgeFace first = wedge.First, second = wedge.Second;
            Assert.That(math.distance(first.Normal, math.cross(wedge.Direction, first.Into)), Is.LessThan(1e-6));
            Assert.That(math.distance(second.Into, cos * first.Into + sin * first.Normal), Is.LessThan(1e-5));
            Assert.That(math.distance(second.Normal, sin * first.Into - cos * first.Normal), Is.LessThan(1e-5));
        }

        // Each wedge of one set, moved, is one of the other, from either end.
        static void AssertSame(WedgeSet actual, WedgeSet original, Affine transform)
        {
            const double Tolerance = 1e-4;
            bool mirrors = transform.Determinant < 0;
            Assert.That(actual.Wedges.Count, Is.EqualTo(original.Wedges.Count));
            var left = new List<Wedge>(actual.Wedges);
            foreach (var wedge in original.Wedges)
            {
                double3 a = transform.Point(wedge.A), b = transform.Point(wedge.B),
                    first = transform.Vector(wedge.First.Into), second = transform.Vector(wedge.Second.Into);
                // A mirror exchanges the two ways around the edge.
                if (mirrors)
                    (a, b) = (b, a);
                bool IsSame(double3 from, double3 to, WedgeFace one, WedgeFace other) =>
                    math.distance(from, a) + math.distance(to, b) < Tolerance
                    && math.distance(one.Into, first) + math.distance(other.Into, second) < 2e-3;
                int at = left.FindIndex(other => math.abs(other.N - wedge.N) < 1e-3
                    && (IsSame(other.A, other.B, other.First, other.Second)
                        || IsSame(other.B, other.A, other.Second, other.First)));
                Assert.That(at, Is.Not.EqualTo(-1), $"n = {wedge.N} from {a} to {b}");
                left.RemoveAt(at);
            }
        }

        // Sum of the solid angles of the triangles over 4 pi (van Oosterom and Strackee 1983).
        static double WindingNumber(TriangleMesh mesh, double3 point)
        {
            double sum = 0;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out var p, out var q, out var r);
                double3 a = p - point, b = q - point, c = r - point;
                double la = math.length(a), lb = math.length(b), lc = math.length(c);
                sum += 2 * math.atan2(math.dot(a, math.cross(b, c)),
                    la * lb * lc + math.dot(a, b) * lc + math.dot(b, c) * la + math.dot(c, a) * lb);
            }
            return math.abs(sum / (4 * math.PI_DBL));
        }
    }
}
