using System.Threading;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
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
