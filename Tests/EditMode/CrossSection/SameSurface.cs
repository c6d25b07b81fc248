using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The same surface as another mesh.</summary>
    static class SameSurface
    {
        /// <summary>A random rotation about the origin.</summary>
        public static Affine Rotation(System.Random random)
        {
            double4 q;
            do
                q = 2 * new double4(random.NextDouble(), random.NextDouble(), random.NextDouble(),
                    random.NextDouble()) - 1;
            while (math.lengthsq(q) > 1 || math.lengthsq(q) < 0.01);
            return Affine.FromTransform(0, q, 1);
        }

        /// <summary>Moved vertices, rounded to float32.</summary>
        public static TriangleMesh Moved(TriangleMesh mesh, Affine transform) => new TriangleMesh(
            Array.ConvertAll(mesh.Vertices, vertex => (float3)transform.Point(vertex)), mesh.Indices);

        /// <summary>
        /// Vertices and triangles in another order, triangles beginning at another corner;
        /// <paramref name="order"/> has the old number of each triangle.
        /// </summary>
        public static TriangleMesh Shuffled(TriangleMesh mesh, System.Random random, out int[] order)
        {
            var vertexOrder = Permutation(mesh.Vertices.Length, random);
            var triangles = order = Permutation(mesh.TriangleCount, random);
            var numbers = new int[vertexOrder.Length];
            for (int i = 0; i < vertexOrder.Length; i++)
                numbers[vertexOrder[i]] = i;
            var indices = new int[mesh.Indices.Length];
            for (int t = 0; t < order.Length; t++)
            {
                int first = random.Next(3);
                for (int k = 0; k < 3; k++)
                    indices[3 * t + k] = numbers[mesh.Indices[3 * triangles[t] + (first + k) % 3]];
            }
            return new TriangleMesh(Array.ConvertAll(vertexOrder, old => mesh.Vertices[old]), indices);
        }

        /// <summary>Half the triangles, by chance, wound the other way: their corners 1 and 2 exchanged.</summary>
        public static TriangleMesh Rewound(TriangleMesh mesh, System.Random random, out bool[] isRewound)
        {
            isRewound = new bool[mesh.TriangleCount];
            var indices = (int[])mesh.Indices.Clone();
            for (int t = 0; t < isRewound.Length; t++)
                if (isRewound[t] = random.Next(2) == 0)
                    (indices[3 * t + 1], indices[3 * t + 2]) = (indices[3 * t + 2], indices[3 * t + 1]);
            return new TriangleMesh(mesh.Vertices, indices);
        }

        /// <summary>Each triangle cut into four at the centres of its edges, <paramref name="times"/> times.</summary>
        public static TriangleMesh Subdivided(TriangleMesh mesh, int times)
        {
            if (times == 0)
                return mesh;
            var vertices = new List<float3>();
            var indices = new List<int>();
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out var a, out var b, out var c);
                float3 ab = Centre(a, b), bc = Centre(b, c), ca = Centre(c, a);
                foreach (var vertex in new[] { a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca })
                {
                    indices.Add(vertices.Count);
                    vertices.Add(vertex);
                }
            }
            return Subdivided(new TriangleMesh(vertices.ToArray(), indices.ToArray()), times - 1);
        }

        // The same bits from both sides of an edge.
        static float3 Centre(float3 a, float3 b) => (float3)(((double3)a + b) / 2);

        static int[] Permutation(int count, System.Random random) =>
            Enumerable.Range(0, count).OrderBy(i => random.Next()).ToArray();
    }
}
