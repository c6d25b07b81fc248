using System;
using System.Threading;

namespace Glint.Core
{
    /// <summary>
    /// Which triangles share an edge. Edge 3t + k of triangle t runs from its corner k to the next one;
    /// edges and corners have the same numbers.
    /// </summary>
    static class TriangleEdges
    {
        public const int None = -1;

        // Maximum number of edges that are sorted by insertion.
        const int MaxInsertionSort = 24;

        /// <summary>The corner that edge <paramref name="edge"/> runs to.</summary>
        public static int End(int edge) => edge % 3 == 2 ? edge - 2 : edge + 1;

        /// <summary>The corner that edge <paramref name="edge"/> does not touch.</summary>
        public static int Opposite(int edge) => edge % 3 == 0 ? edge + 2 : edge - 1;

        /// <summary>
        /// For each edge the edge of another triangle between the same vertices, or <see cref="None"/>.
        /// Where more than two triangles meet, edges are matched two by two.
        /// </summary>
        /// <param name="corners">
        /// Vertex of each corner, three a triangle; vertices at the same position have the same number.
        /// </param>
        /// <param name="vertexCount">Number of vertices.</param>
        /// <param name="used">Triangles that take part. Each must have three different corners.</param>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public static int[] Match(int[] corners, int vertexCount, bool[] used, CancellationToken cancel = default)
        {
            // A counting sort of the edges by the lower of their vertices, in linear time.
            var starts = new int[vertexCount + 1];
            for (int edge = 0; edge < corners.Length; edge++)
                if (used[edge / 3])
                    starts[LowerVertex(corners, edge)]++;
            cancel.ThrowIfCancellationRequested();
            for (int vertex = 0; vertex < vertexCount; vertex++)
                starts[vertex + 1] += starts[vertex];
            var gathered = new int[starts[vertexCount]];
            for (int edge = corners.Length - 1; edge >= 0; edge--)
                if (used[edge / 3])
                    gathered[--starts[LowerVertex(corners, edge)]] = edge;

            var across = new int[corners.Length];
            Blocks.For(across.Length, (from, to) => Array.Fill(across, None, from, to - from), cancel);
            Blocks.For(vertexCount, (from, to) =>
            {
                var keys = new ulong[MaxInsertionSort];
                for (int vertex = from; vertex < to; vertex++)
                    MatchAround(corners, gathered, starts[vertex],
                        starts[vertex + 1] - starts[vertex], ref keys, across);
            }, cancel);
            return across;
        }

        static int LowerVertex(int[] corners, int edge) => Math.Min(corners[edge], corners[End(edge)]);

        // Sorts the edges of one vertex by their other vertex and matches equal neighbours.
        static void MatchAround(int[] corners, int[] gathered, int first, int count, ref ulong[] keys, int[] across)
        {
            if (keys.Length < count)
                keys = new ulong[Math.Max(count, 2 * keys.Length)];
            for (int i = 0; i < count; i++)
            {
                int edge = gathered[first + i];
                keys[i] = (ulong)Math.Max(corners[edge], corners[End(edge)]) << 32 | (uint)edge;
            }
            if (count <= MaxInsertionSort)
                SortByInsertion(keys, count);
            else
                Array.Sort(keys, 0, count);
            for (int i = 0; i + 1 < count; i++)
            {
                if (keys[i] >> 32 != keys[i + 1] >> 32)
                    continue;
                int a = (int)(uint)keys[i], b = (int)(uint)keys[i + 1];
                across[a] = b;
                across[b] = a;
                i++;
            }
        }

        static void SortByInsertion(ulong[] keys, int count)
        {
            for (int i = 1; i < count; i++)
            {
                ulong key = keys[i];
                int index = i;
                for (; index > 0 && keys[index - 1] > key; index--)
                    keys[index] = keys[index - 1];
                keys[index] = key;
            }
        }
    }
}
