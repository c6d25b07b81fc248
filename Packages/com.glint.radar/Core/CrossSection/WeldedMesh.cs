using System;
using System.Collections.Generic;
using System.Threading;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// A mesh whose corners at equal positions are one vertex, and its edges with the triangles at each.
    /// Side 3t + k of triangle t runs from its corner k to the next one; sides and corners have the same numbers.
    /// </summary>
    public sealed class WeldedMesh
    {
        /// <summary>The edge of a side of a degenerate triangle.</summary>
        public const int None = TriangleEdges.None;

        int[] _sides;  // grouped by edge
        int[] _firsts; // for each edge its first place in _sides, and the end
        readonly bool[] _used;

        /// <summary>Welds a mesh and finds its edges.</summary>
        /// <param name="mesh">Kept, not copied.</param>
        /// <param name="cancel">Ends the work early.</param>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public WeldedMesh(TriangleMesh mesh, CancellationToken cancel = default)
        {
            Mesh = mesh;
            Corners = Weld(mesh, cancel);
            _used = new bool[mesh.TriangleCount];
            Blocks.For(_used.Length, (from, to) =>
            {
                for (int t = from; t < to; t++)
                    _used[t] = !IsFlat(t);
            }, cancel);
            EdgeOf = new int[Corners.Length];
            FindEdges(cancel);
            if (LeaveOutRepeats())
                FindEdges(cancel);
            for (int edge = 0; edge < EdgeCount; edge++)
                OpenEdgeCount += SideCount(edge) == 1 ? 1 : 0;
        }

        void FindEdges(CancellationToken cancel)
        {
            _sides = TriangleEdges.Sort(Corners, Mesh.Vertices.Length, _used, out _, cancel);
            EdgeCount = 0;
            Array.Fill(EdgeOf, None);
            var firsts = new int[_sides.Length + 1];
            for (int i = 0; i < _sides.Length; i++)
            {
                if (i == 0 || !TriangleEdges.IsSame(Corners, _sides[i - 1], _sides[i]))
                    firsts[EdgeCount++] = i;
                EdgeOf[_sides[i]] = EdgeCount - 1;
            }
            firsts[EdgeCount] = _sides.Length;
            Array.Resize(ref firsts, EdgeCount + 1);
            _firsts = firsts;
        }

        // Of triangles with the same corners, as of an object that is twice in one place, rays hit the first.
        bool LeaveOutRepeats()
        {
            bool hasRepeats = false;
            var opposites = new HashSet<int>();
            for (int edge = 0; edge < EdgeCount; edge++)
            {
                opposites.Clear();
                for (int i = 0, count = SideCount(edge); count > 2 && i < count; i++)
                    if (!opposites.Add(Corners[Opposite(SideOf(edge, i))]))
                    {
                        _used[SideOf(edge, i) / 3] = false;
                        hasRepeats = true;
                    }
            }
            return hasRepeats;
        }

        /// <summary>The mesh.</summary>
        public TriangleMesh Mesh { get; }

        /// <summary>
        /// Vertex of each corner, three a triangle: the lowest number of a vertex of the mesh at that position.
        /// </summary>
        public int[] Corners { get; }

        /// <summary>Number of edges.</summary>
        public int EdgeCount { get; private set; }

        /// <summary>Edges of one triangle: borders of an open mesh.</summary>
        public int OpenEdgeCount { get; }

        /// <summary>The edge of each side; <see cref="None"/> for sides of degenerate triangles.</summary>
        public int[] EdgeOf { get; }

        /// <summary>
        /// Number of sides that are an edge, each of another triangle: one at an open edge, more than two at a
        /// non-manifold one.
        /// </summary>
        public int SideCount(int edge) => _firsts[edge + 1] - _firsts[edge];

        /// <summary>One of the sides that are an edge; they ascend with <paramref name="number"/>.</summary>
        public int SideOf(int edge, int number) => _sides[_firsts[edge] + number];

        /// <summary>
        /// The side of the only other triangle at this one's edge; <see cref="None"/> at open and non-manifold edges
        /// and for degenerate triangles.
        /// </summary>
        public int Across(int side)
        {
            int edge = EdgeOf[side];
            if (edge == None || SideCount(edge) != 2)
                return None;
            int first = SideOf(edge, 0);
            return first == side ? SideOf(edge, 1) : first;
        }

        /// <summary>
        /// Whether two corners of a triangle are one vertex, or an earlier triangle has the same corners. Such
        /// triangles have no edges.
        /// </summary>
        public bool IsDegenerate(int triangle) => !_used[triangle];

        bool IsFlat(int triangle)
        {
            int a = Corners[3 * triangle], b = Corners[3 * triangle + 1], c = Corners[3 * triangle + 2];
            return a == b || b == c || c == a;
        }

        /// <summary>The corner that a side runs to.</summary>
        public static int EndOf(int side) => TriangleEdges.End(side);

        /// <summary>The corner that a side does not touch.</summary>
        public static int Opposite(int side) => TriangleEdges.Opposite(side);

        /// <summary>
        /// Whether two sides of an edge run in opposite directions: the triangles are then wound the same way.
        /// </summary>
        public bool AreOpposed(int side, int other) => Corners[side] != Corners[other];

        static int[] Weld(TriangleMesh mesh, CancellationToken cancel)
        {
            // -0 becomes 0: the same position, but other bits.
            var positions = new float3[mesh.Vertices.Length];
            for (int i = 0; i < positions.Length; i++)
                positions[i] = mesh.Vertices[i] + 0f;
            var welded = VertexWelder.Weld(positions, cancel);
            return Array.ConvertAll(mesh.Indices, index => welded[index]);
        }
    }
}
