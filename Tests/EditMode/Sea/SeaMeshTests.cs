using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class SeaMeshTests
    {
        static TriangleMesh Mesh(int cells, double tile = 64, double choppiness = 1.6,
            double height = 6, double direction = 33)
        {
            var settings = SeaFields.Settings(16, cells);
            (settings.TileSize, settings.Choppiness, settings.SignificantWaveHeight, settings.WindDirectionDegrees) =
                (tile, choppiness, height, direction);
            return new SeaSurface(settings).Mesh(7);
        }

        [Test]
        public void Mesh_OfCells_HasTheirCornersAndTwoTrianglesEach()
        {
            var mesh = Mesh(24);
            Assert.That(mesh.Vertices.Length, Is.EqualTo(25 * 25));
            Assert.That(mesh.TriangleCount, Is.EqualTo(2 * 24 * 24));
            Assert.That(mesh.Indices.Distinct().Count(), Is.EqualTo(25 * 25), "every vertex belongs to a triangle");
        }

        // Adjacent tiles join, so tiles repeat; bit for bit where float32 represents the sum.
        [TestCase(24, 64)]
        [TestCase(32, 64)]
        [TestCase(24, 100.099609375)]
        [TestCase(24, 3000)]
        [TestCase(7, 8191.9990234375)]
        public void Mesh_AtOppositeEdges_IsTheSame(int cells, double tile)
        {
            var mesh = Mesh(cells, tile);
            int side = cells + 1;
            for (int i = 0; i < side; i++)
            {
                Assert.That((double3)mesh.Vertices[i * side + cells],
                    Is.EqualTo(mesh.Vertices[i * side] + new double3(tile, 0, 0)), $"row {i}");
                Assert.That((double3)mesh.Vertices[cells * side + i],
                    Is.EqualTo(mesh.Vertices[i] + new double3(0, 0, tile)), $"column {i}");
            }
        }

        [Test]
        public void Mesh_WithoutDisplacement_IsAGridAboutTheOrigin()
        {
            var mesh = Mesh(24, choppiness: 0);
            for (int z = 0; z <= 24; z++)
                for (int x = 0; x <= 24; x++)
                {
                    var position = (double3)mesh.Vertices[25 * z + x];
                    Assert.That(math.distance(position.xz, new double2(64 * (x / 24.0 - 0.5), 64 * (z / 24.0 - 0.5))),
                        Is.LessThan(1.1e-5), "half a step of 2^-16 m each way");
                }
        }

        [Test]
        public void Mesh_Heights_HaveMeanZero([Values(24, 32)] int cells) =>
            Assert.That(SeaFields.Heights(Mesh(cells), cells).Average(), Is.EqualTo(0).Within(1e-5));

        [Test]
        public void Mesh_OfALowSea_FacesUp()
        {
            var mesh = Mesh(24, height: 0.5);
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out var a, out var b, out var c);
                Assert.That(math.cross(b - a, c - a).y, Is.GreaterThan(0), $"triangle {t}");
            }
        }

        [Test]
        public void Mesh_Coordinates_AreWholeStepsOfTwoToTheMinus16()
        {
            foreach (var vertex in Mesh(24).Vertices)
                Assert.That(math.all((double3)vertex * 65536 == math.floor((double3)vertex * 65536)), $"{vertex}");
        }

        [Test]
        public void Mesh_OfOneCell_IsThere() => Assert.That(Mesh(1).TriangleCount, Is.EqualTo(2));
    }
}
