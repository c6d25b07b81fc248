using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class SeaAndShipTests
    {
        [TestCase(35000, 44000)]
        [TestCase(1000, 1000)]
        [TestCase(200000, 100000)]
        public void Triangles_OfSeaAndShip_AreAboutAsManyAsAskedFor(int sea, int ship)
        {
            var scene = new SeaAndShip(1, sea, ship);

            // Steps of a square grid, and of four bodies' rings.
            Assert.That(scene.Sea.TriangleCount, Is.EqualTo(sea).Within(3 * Math.Sqrt(sea)));
            Assert.That(scene.Ship.TriangleCount, Is.EqualTo(ship).Within(4 * Math.Sqrt(ship)));
        }

        [TestCase(1000)]
        [TestCase(44000)]
        public void Ship_IsClosed(int triangles)
        {
            var ship = new SeaAndShip(1, 1000, triangles).Ship;
            var edges = Edges(ship);

            // Each edge is used once in each direction: two triangles share it and agree on the outer side.
            Assert.That(edges.GroupBy(edge => edge).All(group => group.Count() == 1));
            Assert.That(edges.Select(edge => (edge.Item2, edge.Item1)).ToHashSet().SetEquals(edges));
            Assert.That(SignedVolume(ship), Is.GreaterThan(1000), "m3, outwards as Unity winds triangles");
        }

        [Test]
        public void Ship_HasNoFlatTriangles() =>
            Assert.That(Areas(new SeaAndShip(1, 1000, 44000).Ship).Min(), Is.GreaterThan(1e-10));

        [Test]
        public void Sea_IsRough_AndFacesUp()
        {
            var sea = new SeaAndShip(1, 35000, 1000).Sea;
            double mean = sea.Vertices.Average(v => (double)v.y);
            double deviation = Math.Sqrt(sea.Vertices.Average(v => (v.y - mean) * (v.y - mean)));

            Assert.That(mean, Is.EqualTo(0).Within(0.1));
            Assert.That(deviation, Is.InRange(0.2, 0.8), "m");
            Assert.That(sea.Vertices.Min(v => v.x), Is.EqualTo(-64));
            Assert.That(sea.Vertices.Max(v => v.z), Is.EqualTo(64));
            for (int t = 0; t < sea.TriangleCount; t++)
            {
                sea.GetTriangle(t, out var a, out var b, out var c);
                Assert.That(math.cross(b - a, c - a).y, Is.GreaterThan(0), $"triangle {t}");
            }
        }

        // The height at a vertex does not depend on the grid's resolution.
        [Test]
        public void Sea_OfMoreTriangles_IsTheSameSea()
        {
            TriangleMesh coarse = new SeaAndShip(5, 2 * 32 * 32, 1000).Sea,
                fine = new SeaAndShip(5, 2 * 64 * 64, 1000).Sea;
            for (int z = 0; z <= 32; z++)
                for (int x = 0; x <= 32; x++)
                    Assert.That(fine.Vertices[2 * z * 65 + 2 * x].y,
                        Is.EqualTo(coarse.Vertices[z * 33 + x].y).Within(1e-5));
        }

        [Test]
        public void Seed_TheSame_IsTheSameScene_AnotherIsAnother()
        {
            Assert.That(new SeaAndShip(3, 2000, 1000).Sea.Vertices,
                Is.EqualTo(new SeaAndShip(3, 2000, 1000).Sea.Vertices));
            Assert.That(new SeaAndShip(3, 2000, 1000).Sea.Vertices,
                Is.Not.EqualTo(new SeaAndShip(4, 2000, 1000).Sea.Vertices));
        }

        [Test]
        public void BinaryScene_OfTwoInstances_HasTheirPlacesInTheWorld()
        {
            var plate = new TriangleMesh(new[] { new float3(0, 0, 0), new float3(1, 0, 0), new float3(0, 1, 0) },
                new[] { 0, 1, 2 });
            var moved = Affine.Identity;
            moved.Origin = new double3(10, 20, 30);
            var scene = new RadarScene(new MeshInstance { Mesh = plate, ToWorld = Affine.Identity },
                new MeshInstance { Mesh = plate, ToWorld = moved });
            var stream = new MemoryStream();
            BinaryScene.Write(stream, WorldMesh.Of(scene));

            var bytes = stream.ToArray();
            Assert.That(bytes.Length, Is.EqualTo(8 + 6 * 12 + 2 * 12));
            Assert.That(new[] { BitConverter.ToInt32(bytes, 0), BitConverter.ToInt32(bytes, 4) },
                Is.EqualTo(new[] { 6, 2 }));
            var positions = Enumerable.Range(0, 18).Select(i => BitConverter.ToSingle(bytes, 8 + 4 * i));
            Assert.That(positions,
                Is.EqualTo(new float[] { 0, 0, 0, 1, 0, 0, 0, 1, 0, 10, 20, 30, 11, 20, 30, 10, 21, 30 }));
            Assert.That(Enumerable.Range(0, 6).Select(i => BitConverter.ToInt32(bytes, 80 + 4 * i)),
                Is.EqualTo(new[] { 0, 1, 2, 3, 4, 5 }));
        }

        static List<(int, int)> Edges(TriangleMesh mesh)
        {
            var edges = new List<(int, int)>();
            for (int i = 0; i < mesh.Indices.Length; i += 3)
                for (int side = 0; side < 3; side++)
                    edges.Add((mesh.Indices[i + side], mesh.Indices[i + (side + 1) % 3]));
            return edges;
        }

        // A sixth of the sum of triple products: the volume of the solid whose triangles' normals point outwards.
        static double SignedVolume(TriangleMesh mesh) => Enumerable.Range(0, mesh.TriangleCount).Sum(t =>
        {
            mesh.GetTriangle(t, out var a, out var b, out var c);
            return math.dot((double3)a, math.cross((double3)b, (double3)c)) / 6;
        });

        static IEnumerable<double> Areas(TriangleMesh mesh) => Enumerable.Range(0, mesh.TriangleCount).Select(t =>
        {
            mesh.GetTriangle(t, out var a, out var b, out var c);
            return math.length(math.cross((double3)b - a, (double3)c - a)) / 2;
        });
    }
}
