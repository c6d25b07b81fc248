using System;
using System.Threading;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>
    /// Pairs of a mesh's triangles that share an edge and whose common box is not much larger than their own boxes: the
    /// leaves of its BVH. On a sea or a ship almost all triangles find a partner, which halves leaves and nodes.
    /// </summary>
    sealed class TrianglePairs
    {
        // Square of the minimum cross product of edges, m4, from which float32 can compute a normal:
        // the triangle's area is then half of 1e-16 m2.
        const float MinNormalSquared = 1e-32f;

        // Maximum ratio of a pair's box area to the sum of the box areas of its triangles.
        const float MaxGrowth = 1.3f;

        // Rounds of pairing triangles that are each other's best partner;
        // the rest take the best free partner, in the mesh's order.
        const int Rounds = 3;

        const int Free = -1;
        const int LeftOut = -2;

        readonly TriangleMesh _mesh;
        readonly CancellationToken _cancel;
        readonly int[] _mates; // a triangle's edge to its partner, or Free, or LeftOut
        readonly int[] _across;

        TrianglePairs(TriangleMesh mesh, CancellationToken cancel)
        {
            _mesh = mesh;
            _cancel = cancel;
            int count = mesh.TriangleCount;
            _mates = new int[count];
            var used = new bool[count];
            Blocks.For(count, (from, to) =>
            {
                for (int t = from; t < to; t++)
                {
                    used[t] = Reflects(mesh, t);
                    _mates[t] = used[t] ? Free : LeftOut;
                }
            }, cancel);
            _across = TriangleEdges.Match(WeldedCorners(), mesh.Vertices.Length, used, cancel);
        }

        /// <summary>
        /// The pairs, in the order of their first triangles.
        /// Triangles of less than 5e-17 m2, or so large that their area is not finite,
        /// reflect nothing and are left out.
        /// </summary>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public static TrianglePair[] Find(TriangleMesh mesh, CancellationToken cancel = default)
        {
            var pairs = new TrianglePairs(mesh, cancel);
            pairs.Pair();
            return pairs.All();
        }

        /// <summary>Triangles that are not left out.</summary>
        public static int CountReflecting(TriangleMesh mesh)
        {
            int count = 0;
            Blocks.For(mesh.TriangleCount, (from, to) =>
            {
                int inBlock = 0;
                for (int t = from; t < to; t++)
                    inBlock += Reflects(mesh, t) ? 1 : 0;
                Interlocked.Add(ref count, inBlock);
            });
            return count;
        }

        int[] WeldedCorners()
        {
            var welded = VertexWelder.Weld(_mesh.Vertices, _cancel);
            var corners = new int[3 * _mesh.TriangleCount];
            Blocks.For(corners.Length, (from, to) =>
            {
                for (int corner = from; corner < to; corner++)
                    corners[corner] = welded[_mesh.Indices[corner]];
            }, _cancel);
            return corners;
        }

        static bool Reflects(TriangleMesh mesh, int triangle)
        {
            mesh.GetTriangle(triangle, out var a, out var b, out var c);
            float normalSquared = lengthsq(cross(b - a, c - a));
            return normalSquared >= MinNormalSquared && normalSquared <= float.MaxValue;
        }

        // Two that are each other's best would also meet if all pairs were tried from the best to the worst,
        // but this way no sort is needed and cores can share the work.
        void Pair()
        {
            var best = new int[_mates.Length];
            for (int round = 0; round < Rounds; round++)
            {
                Blocks.For(best.Length, (from, to) =>
                {
                    for (int t = from; t < to; t++)
                        best[t] = BestEdge(t);
                }, _cancel);
                Blocks.For(best.Length, (from, to) =>
                {
                    for (int t = from; t < to; t++)
                        if (best[t] >= 0 && _across[best[t]] / 3 > t && best[_across[best[t]] / 3] == _across[best[t]])
                            Join(best[t]);
                }, _cancel);
            }
            _cancel.ThrowIfCancellationRequested();
            for (int t = 0; t < _mates.Length; t++)
            {
                int edge = BestEdge(t);
                if (edge >= 0)
                    Join(edge);
            }
        }

        void Join(int edge)
        {
            _mates[edge / 3] = edge;
            _mates[_across[edge] / 3] = _across[edge];
        }

        // The edge of a free triangle to the free neighbour with the smallest common box.
        int BestEdge(int triangle)
        {
            if (_mates[triangle] != Free)
                return TriangleEdges.None;
            var box = Box.Empty;
            for (int corner = 3 * triangle; corner < 3 * triangle + 3; corner++)
                box.Add(Corner(corner));

            int best = TriangleEdges.None, bestTie = 0;
            float bestArea = float.PositiveInfinity;
            for (int edge = 3 * triangle; edge < 3 * triangle + 3; edge++)
            {
                int other = _across[edge];
                if (other < 0 || _mates[other / 3] != Free)
                    continue;
                var far = Corner(TriangleEdges.Opposite(other));
                var both = box;
                both.Add(far);
                var partner = new Box(far, far);
                partner.Add(Corner(edge));
                partner.Add(Corner(TriangleEdges.End(edge)));
                float area = both.HalfArea;
                int tie = Math.Min(edge, other); // the same seen from both sides
                if (area <= MaxGrowth * (box.HalfArea + partner.HalfArea)
                    && (area < bestArea || area == bestArea && tie < bestTie))
                    (best, bestArea, bestTie) = (edge, area, tie);
            }
            return best;
        }

        float3 Corner(int corner) => _mesh.Vertices[_mesh.Indices[corner]];

        TrianglePair[] All()
        {
            int count = 0;
            for (int t = 0; t < _mates.Length; t++)
                if (IsFirst(t))
                    count++;
            var pairs = new TrianglePair[count];
            count = 0;
            for (int t = 0; t < _mates.Length; t++)
                if (IsFirst(t))
                    pairs[count++] = PairOf(t);
            return pairs;
        }

        bool IsFirst(int triangle) =>
            _mates[triangle] == Free || _mates[triangle] >= 0 && _across[_mates[triangle]] / 3 > triangle;

        TrianglePair PairOf(int triangle)
        {
            var indices = _mesh.Indices;
            if (_mates[triangle] == Free)
                return new TrianglePair(int4(indices[3 * triangle], indices[3 * triangle + 1],
                    indices[3 * triangle + 2], indices[3 * triangle + 2]), triangle, triangle);
            int edge = _mates[triangle];
            return new TrianglePair(int4(indices[TriangleEdges.End(edge)], indices[TriangleEdges.Opposite(edge)],
                indices[edge], indices[TriangleEdges.Opposite(_across[edge])]), triangle, _across[edge] / 3);
        }
    }

    /// <summary>Two triangles of a mesh that share an edge, or one.</summary>
    readonly struct TrianglePair
    {
        /// <summary>Vertex numbers: triangles (x, y, z) and (x, z, w); w = z where there is only one.</summary>
        public readonly int4 Corners;

        /// <summary>Numbers of the triangles in the mesh.</summary>
        public readonly int First, Second;

        public TrianglePair(int4 corners, int first, int second) => (Corners, First, Second) = (corners, first, second);

        public bool IsSingle => Corners.z == Corners.w;
    }

    /// <summary>
    /// Finds vertices at the same position. Meshes whose triangles share no vertices (STL), or are shaded flat, have
    /// many.
    /// </summary>
    static class VertexWelder
    {
        /// <summary>For each vertex the lowest number of a vertex with the same bits.</summary>
        /// <exception cref="System.OperationCanceledException">Cancelled.</exception>
        public static int[] Weld(float3[] vertices, CancellationToken cancel = default)
        {
            int bits = 4;
            while (bits < 30 && 1L << bits < 2L * vertices.Length)
                bits++;
            // A hash table with linear probing: a slot holds a vertex number + 1, 0 is free.
            // The slot of a position depends on the order of the threads; the lowest number in it does not.
            var table = new int[1 << bits];
            var welded = new int[vertices.Length];
            Blocks.For(vertices.Length, (from, to) =>
            {
                for (int vertex = from; vertex < to; vertex++)
                    welded[vertex] = Enter(vertices, vertex, table, (int)(Hash(vertices[vertex]) >> (32 - bits)));
            }, cancel);
            Blocks.For(vertices.Length, (from, to) =>
            {
                for (int vertex = from; vertex < to; vertex++)
                    welded[vertex] = table[welded[vertex]] - 1;
            }, cancel);
            return welded;
        }

        // Puts a vertex into the table and returns its slot.
        static int Enter(float3[] vertices, int vertex, int[] table, int slot)
        {
            int entry = vertex + 1;
            while (true)
            {
                int held = Volatile.Read(ref table[slot]);
                if (held == 0)
                    held = Interlocked.CompareExchange(ref table[slot], entry, 0);
                if (held == 0)
                    return slot;
                if (SameBits(vertices[held - 1], vertices[vertex]))
                {
                    for (int seen; entry < held; held = seen)
                        if ((seen = Interlocked.CompareExchange(ref table[slot], entry, held)) == held)
                            break;
                    return slot;
                }
                slot = (slot + 1) & (table.Length - 1);
            }
        }

        static bool SameBits(float3 a, float3 b) =>
            asuint(a.x) == asuint(b.x) && asuint(a.y) == asuint(b.y) && asuint(a.z) == asuint(b.z);

        // The high bits of a product depend on all bits of its factors.
        static uint Hash(float3 position)
        {
            uint hash = asuint(position.x) * 0x9e3779b1;
            hash = ((hash ^ (hash >> 15)) + asuint(position.y)) * 0x85ebca77;
            hash = ((hash ^ (hash >> 15)) + asuint(position.z)) * 0xc2b2ae3d;
            return (hash ^ (hash >> 15)) * 0x9e3779b1;
        }
    }
}
