using System;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class SimplifiedMeshTests
    {
        [Test]
        public void SimplifiedMesh_OfFewTriangles_HasThemAllWithin16Bits()
        {
            var mesh = Sheet(10, 200);
            var simplified = SimplifiedMesh.Of(mesh, 200);

            Assert.That(simplified.TriangleCount, Is.EqualTo(200));
            for (int i = 0; i < mesh.Indices.Length; i++)
            {
                double3 exact = (double3)mesh.Vertices[mesh.Indices[i]],
                    drawn = Position(simplified, simplified.Indices[i]);
                // Half a step of each axis.
                Assert.That(math.all(math.abs(drawn - exact) <= 0.51 / 65535 * simplified.Size + 1e-12),
                    $"corner {i}: {drawn} for {exact}");
            }
        }

        [TestCase(100)]
        [TestCase(1000)]
        [TestCase(5000)]
        public void SimplifiedMesh_OfManyTriangles_HasFewerAndCoversTheSameGround(int max)
        {
            var mesh = Sheet(100, 200);
            var simplified = SimplifiedMesh.Of(mesh, max);

            Assert.That(simplified.TriangleCount, Is.InRange(max / 8, max));
            double area = 0;
            for (int i = 0; i < simplified.Indices.Count; i += 3)
            {
                double3 a = Position(simplified, simplified.Indices[i]),
                    b = Position(simplified, simplified.Indices[i + 1]),
                    c = Position(simplified, simplified.Indices[i + 2]);
                area += math.abs(math.cross(b - a, c - a).y) / 2;
            }
            // Seen from above it covers 200 x 200 m without gaps up to its border, so that tiles join, except for the
            // part of each corner that a cube cuts off.
            double cube = 200 / Math.Sqrt(max / 8.0);
            Assert.That(area, Is.InRange(200 * 200 - 4 * cube * cube / 2, 200 * 200 + 1e-3));
            Assert.That(simplified.Indices.Max(), Is.LessThan(simplified.Positions.Count / 3));
        }

        [Test]
        public void SimplifiedMesh_OfNothing_IsEmpty() =>
            Assert.That(SimplifiedMesh.Of(new TriangleMesh(new float3[0], new int[0]), 12).TriangleCount, Is.Zero);

        // A wavy square in cells of two triangles.
        static TriangleMesh Sheet(int cells, float side) => TestMeshes.Grid(cells, cells, (column, row) =>
        {
            float x = column * side / cells, z = row * side / cells;
            return new float3(x, 0.1f * math.sin(x / 20), z);
        });

        static double3 Position(SimplifiedMesh simplified, int point) =>
            simplified.Min + simplified.Size * new double3(simplified.Positions[3 * point],
            simplified.Positions[3 * point + 1],
                simplified.Positions[3 * point + 2]) / 65535;
    }
}
