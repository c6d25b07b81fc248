using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Measures of a ship's mesh.</summary>
    static class ShipMesh
    {
        /// <summary>
        /// With welded positions each edge is used once in each direction, and each body has a positive volume, so its
        /// outer side faces outwards.
        /// </summary>
        public static void AssertClosed(TriangleMesh mesh)
        {
            var welded = Welded(mesh);
            var edges = new HashSet<(int, int)>();
            for (int i = 0; i < welded.Length; i++)
                if (!edges.Add((welded[i], welded[i % 3 == 2 ? i - 2 : i + 1])))
                    Assert.Fail($"an edge of triangle {i / 3} is walked twice the same way, "
                        + $"at {mesh.Vertices[welded[i]]}");
            Assert.That(edges.Count(edge => !edges.Contains((edge.Item2, edge.Item1))), Is.Zero,
                "edges of one triangle only");
            Assert.That(BodyVolumes(mesh, welded), Is.All.GreaterThan(0.001), "m3");
        }

        /// <summary>For each corner the first vertex at the same position, three for each triangle.</summary>
        public static int[] Welded(TriangleMesh mesh)
        {
            var first = new Dictionary<float3, int>();
            var welded = new int[mesh.Vertices.Length];
            for (int i = 0; i < welded.Length; i++)
                if (!first.TryGetValue(mesh.Vertices[i], out welded[i]))
                    first.Add(mesh.Vertices[i], welded[i] = i);
            return Array.ConvertAll(mesh.Indices, index => welded[index]);
        }

        /// <summary>Volume of each connected body: a sixth of the sum of triple products.</summary>
        public static IEnumerable<double> BodyVolumes(TriangleMesh mesh, int[] welded)
        {
            var parents = Enumerable.Range(0, mesh.Vertices.Length).ToArray();
            int Root(int vertex)
            {
                while (parents[vertex] != vertex)
                    vertex = parents[vertex] = parents[parents[vertex]];
                return vertex;
            }
            for (int i = 0; i < welded.Length; i += 3)
            {
                parents[Root(welded[i + 1])] = Root(welded[i]);
                parents[Root(welded[i + 2])] = Root(welded[i]);
            }
            return Enumerable.Range(0, mesh.TriangleCount).GroupBy(t => Root(welded[3 * t]), t =>
            {
                mesh.GetTriangle(t, out var a, out var b, out var c);
                return math.dot((double3)a, math.cross((double3)b, (double3)c)) / 6;
            }).Select(body => body.Sum()).ToArray();
        }

        /// <summary>
        /// Volume below y = 0 of a mesh closed there: the flux of (0, y, 0), to which the plane y = 0 adds nothing.
        /// </summary>
        public static double VolumeUnderWater(TriangleMesh mesh)
        {
            double volume = 0;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out var a, out var b, out var c);
                var below = CutBelowWater(new double3[] { a, b, c });
                for (int i = 2; i < below.Count; i++)
                {
                    double3 p = below[0], q = below[i - 1], r = below[i];
                    volume += math.cross(q - p, r - p).y / 2 * (p.y + q.y + r.y) / 3;
                }
            }
            return volume;
        }

        static List<double3> CutBelowWater(double3[] polygon)
        {
            var below = new List<double3>();
            for (int i = 0; i < polygon.Length; i++)
            {
                double3 here = polygon[i], next = polygon[(i + 1) % polygon.Length];
                if (here.y <= 0)
                    below.Add(here);
                if (here.y < 0 != next.y < 0 && here.y != 0 && next.y != 0)
                    below.Add(here + here.y / (here.y - next.y) * (next - here));
            }
            return below;
        }
    }
}
