using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Finds which of the parts of a merged mesh a triangle comes from, by its corners:
    /// the BVHs do not keep triangles' numbers.
    /// </summary>
    sealed class PartFinder
    {
        readonly Dictionary<(float3, float3, float3), int> _parts = new Dictionary<(float3, float3, float3), int>();

        /// <param name="trianglesOf">Triangles of each part; they stand in the mesh one part after the other.</param>
        public PartFinder(TriangleMesh mesh, IReadOnlyList<int> trianglesOf)
        {
            int triangle = 0;
            for (int part = 0; part < trianglesOf.Count; part++)
                for (int i = 0; i < trianglesOf[part]; i++)
                {
                    mesh.GetTriangle(triangle++, out var a, out var b, out var c);
                    _parts.TryAdd(Key(a, b, c), part); // of equal triangles the first
                }
        }

        /// <summary>The part; -1 if there is no such triangle.</summary>
        public int PartOf(float3 a, float3 b, float3 c) => _parts.TryGetValue(Key(a, b, c), out int part) ? part : -1;

        // The corners in an order of their own, as a BVH may begin with any of them. A zero has no sign.
        static (float3, float3, float3) Key(float3 a, float3 b, float3 c)
        {
            a += 0f;
            b += 0f;
            c += 0f;
            if (IsLess(b, a))
                (a, b) = (b, a);
            if (IsLess(c, b))
                (b, c) = (c, b);
            if (IsLess(b, a))
                (a, b) = (b, a);
            return (a, b, c);
        }

        static bool IsLess(float3 a, float3 b) => a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    }
}
