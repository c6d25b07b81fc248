using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Closed solids with their outer side outwards, and measures of read meshes.</summary>
    static class Solid
    {
        /// <summary>The eight corners of a box from 0 to its size.</summary>
        public static float3[] BoxVertices(float x, float y, float z)
        {
            var vertices = new float3[8];
            for (int i = 0; i < 8; i++)
                vertices[i] = new float3((i & 1) * x, (i >> 1 & 1) * y, (i >> 2) * z);
            return vertices;
        }

        /// <summary>Twelve triangles; (b - a) x (c - a) points out of the box.</summary>
        public static readonly int[] BoxIndices =
        {
            0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, // x = 0, x = 1
            0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, // y = 0, y = 1
            0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6 // z = 0, z = 1
        };

        /// <summary>Volume by the divergence theorem; positive if the outer sides face outwards.</summary>
        public static double Volume(MeshFile mesh)
        {
            double sum = 0;
            foreach (var (a, b, c) in Triangles(mesh))
                sum += a.x * ((double)b.y * c.z - (double)b.z * c.y) + a.y * ((double)b.z * c.x - (double)b.x * c.z)
                    + a.z * ((double)b.x * c.y - (double)b.y * c.x);
            return sum / 6;
        }

        public static IEnumerable<(float3, float3, float3)> Triangles(MeshFile mesh) =>
            Triangles(mesh.Vertices, mesh.Indices);

        public static IEnumerable<(float3, float3, float3)> Triangles(float3[] vertices, int[] indices)
        {
            for (int i = 0; i < indices.Length; i += 3)
                yield return (vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]]);
        }
    }
}
