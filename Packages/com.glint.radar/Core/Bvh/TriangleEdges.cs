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
            var sorted = Sort(corners, vertexCount, used, out var firsts, cancel);
            var across = new int[corners.Length];
            Blocks.For(across.Length, (from, to) => Array.Fill(across, None, from, to - from), cancel);
            Blocks.For(vertexCount, (from, to) =>
            {
                for (int i = firsts[from]; i + 1 < firsts[to]; i++)
                {
                    int a = sorted[i], b = sorted[i + 1];
                    if (!IsSame(corners, a, b))
                        continue;
                    across[a] = b;
                    across[b] = a;
                    i++;
                }
            }, cancel);
            return across;
        }

        /// <summary>
        /// The edges of the triangles that take part, sorted by the lower of their vertices, the higher one and their
        /// number: edges between the same vertices follow each other.
        /// </summary>
        /// <param name="firsts">For each vertex the place of the first edge whose lower vertex it is.</param>
        /// <inheritdoc cref="Match"/>
        public static int[] Sort(int[] corners, int vertexCount, bool[] used, out int[] firsts,
            CancellationToken cancel = default)
        {
            // A counting sort of the edges by the lower of their vertices, in linear time.
            var places = new int[vertexCount + 1];
            for (int edge = 0; edge < corners.Length; edge++)
                if (used[edge / 3])
                    places[LowerVertex(corners, edge)]++;
            cancel.ThrowIfCancellationRequested();
            for (int vertex = 0; vertex < vertexCount; vertex++)
                places[vertex + 1] += places[vertex];
            var sorted = new int[places[vertexCount]];
            for (int edge = corners.Length - 1; edge >= 0; edge--)
                if (used[edge / 3])
                    sorted[--places[LowerVertex(corners, edge)]] = edge;
            Blocks.For(vertexCount, (from, to) =>
            {
                var keys = new ulong[MaxInsertionSort];
                for (int vertex = from; vertex < to; vertex++)
                    SortAround(corners, sorted, places[vertex], places[vertex + 1] - places[vertex], ref keys);
            }, cancel);
            firsts = places;
            return sorted;
        }

        /// <summary>Whether two edges run between the same vertices.</summary>
        public static bool IsSame(int[] corners, int a, int b) =>
            LowerVertex(corners, a) == LowerVertex(corners, b) && HigherVertex(corners, a) == HigherVertex(corners, b);

        static int LowerVertex(int[] corners, int edge) => Math.Min(corners[edge], corners[End(edge)]);

        static int HigherVertex(int[] corners, int edge) => Math.Max(corners[edge], corners[End(edge)]);

        // Sorts the edges of one vertex by their other vertex.
        static void SortAround(int[] corners, int[] sorted, int first, int count, ref ulong[] keys)
        {
            if (keys.Length < count)
                keys = new ulong[Math.Max(count, 2 * keys.Length)];
            for (int i = 0; i < count; i++)
            {
                int edge = sorted[first + i];
                keys[i] = (ulong)HigherVertex(corners, edge) << 32 | (uint)edge;
            }
            if (count <= MaxInsertionSort)
                SortByInsertion(keys, count);
            else
                Array.Sort(keys, 0, count);
            for (int i = 0; i < count; i++)
                sorted[first + i] = (int)(uint)keys[i];
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
