using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A side of a triangle of an instance.</summary>
    readonly struct EdgeFace
    {
        public EdgeFace(int instance, int side) => (Instance, Side) = (instance, side);

        public int Instance { get; }

        public int Side { get; }

        public int Triangle => Side / 3;
    }

    /// <summary>A straight piece of an edge with all triangles at it.</summary>
    readonly struct EdgePiece
    {
        public EdgePiece(double3 a, double3 b, EdgeFace[] faces) => (A, B, Faces) = (a, b, faces);

        /// <summary>An end, metres, in the scene's frame.</summary>
        public double3 A { get; }

        /// <summary>The other end.</summary>
        public double3 B { get; }

        public EdgeFace[] Faces { get; }

        public double3 Along => math.normalizesafe(B - A);
    }

    /// <summary>
    /// Joins open edges that lie on each other: faces of CAD meshes that share no vertices, and T-junctions. Each edge
    /// is cut where an edge that lies on it begins or ends.
    /// </summary>
    sealed class OpenEdges
    {
        // Minimum length that two edges share and minimum width of their facets, in tolerances. Shorter edges and
        // narrower facets have no direction and no side within the tolerance, and join nothing.
        const double MinLength = 4, MinWidth = 2;

        readonly double _tolerance;
        readonly double3 _centre;
        readonly List<OpenEdge> _edges = new List<OpenEdge>();
        readonly List<Overlap> _overlaps = new List<Overlap>();
        double _gap;

        OpenEdges(PlacedPatches[] placed, double tolerance, double3 centre)
        {
            _tolerance = tolerance;
            _centre = centre;
            for (int i = 0; i < placed.Length; i++)
                for (int side = 0; side < placed[i].Welded.EdgeOf.Length; side++)
                    if (IsOpen(placed[i].Welded, side))
                        Add(placed[i], i, side);
        }

        /// <summary>The open edges of all instances, in pieces that have the same triangles all along.</summary>
        /// <param name="placed">The instances.</param>
        /// <param name="tolerance">Maximum distance of edges that lie on each other, metres.</param>
        /// <param name="centre">Centre of the scene.</param>
        /// <param name="gap">Largest distance of edges that were joined, metres.</param>
        public static List<EdgePiece> Join(PlacedPatches[] placed, double tolerance, double3 centre, out double gap)
        {
            var open = new OpenEdges(placed, tolerance, centre);
            open.FindOverlaps();
            gap = open._gap;
            return open.Cut();
        }

        static bool IsOpen(WeldedMesh welded, int side) =>
            welded.EdgeOf[side] != WeldedMesh.None && welded.SideCount(welded.EdgeOf[side]) == 1;

        void Add(in PlacedPatches placed, int instance, int side)
        {
            double3 from = placed.Point(side), to = placed.Point(WeldedMesh.EndOf(side));
            double length = math.distance(from, to);
            if (length > 0)
                _edges.Add(new OpenEdge
                {
                    Face = new EdgeFace(instance, side), From = from, To = to, Length = length,
                    CanJoin = length > MinLength * _tolerance && placed.Width(side) > MinWidth * _tolerance,
                });
        }

        void FindOverlaps()
        {
            var leaves = new List<BvhLeaf>();
            for (int i = 0; i < _edges.Count; i++)
                if (_edges[i].CanJoin)
                    leaves.Add(new BvhLeaf { Box = BoxOf(_edges[i]), Item = i });
            if (leaves.Count < 2)
                return;
            var bvh = BinaryBvhBuilder.Build(leaves.ToArray(), leaves.Count);
            var pending = new Stack<int>();
            foreach (var leaf in bvh.Leaves)
            {
                pending.Push(bvh.Root);
                while (pending.Count > 0)
                {
                    int node = pending.Pop();
                    var box = bvh.BoxOf(node);
                    if (math.any(box.Min > leaf.Box.Max) || math.any(box.Max < leaf.Box.Min))
                        continue;
                    if (node < 0)
                    {
                        if (bvh.Leaves[~node].Item > leaf.Item)
                            AddOverlap(leaf.Item, bvh.Leaves[~node].Item);
                        continue;
                    }
                    pending.Push(bvh.Left(node));
                    pending.Push(bvh.Right(node));
                }
            }
        }

        // Counted from the scene's centre, so that float32 is much finer than the tolerance.
        Box BoxOf(in OpenEdge edge)
        {
            double3 from = edge.From - _centre, to = edge.To - _centre;
            return new Box((float3)(math.min(from, to) - _tolerance), (float3)(math.max(from, to) + _tolerance));
        }

        void AddOverlap(int i, int j)
        {
            OpenEdge edge = _edges[i], other = _edges[j];
            if (edge.Face.Instance == other.Face.Instance && edge.Face.Triangle == other.Face.Triangle)
                return;
            double3 along = edge.Along;
            double from = math.dot(other.From - edge.From, along), to = math.dot(other.To - edge.From, along);
            double min = math.max(0, math.min(from, to)), max = math.min(edge.Length, math.max(from, to));
            if (max - min <= MinLength * _tolerance)
                return;
            double3 first = edge.From + min * along, last = edge.From + max * along;
            double otherFirst = other.Project(first), otherLast = other.Project(last);
            double gap = math.max(math.distance(first, other.At(otherFirst)), math.distance(last, other.At(otherLast)));
            if (gap > _tolerance)
                return;
            _gap = math.max(_gap, gap);
            _overlaps.Add(new Overlap { Edge = i, Other = j, Min = min, Max = max });
            _overlaps.Add(new Overlap
            {
                Edge = j, Other = i, Min = math.min(otherFirst, otherLast), Max = math.max(otherFirst, otherLast),
            });
        }

        List<EdgePiece> Cut()
        {
            _overlaps.Sort((a, b) => a.Edge != b.Edge ? a.Edge.CompareTo(b.Edge) : a.Other.CompareTo(b.Other));
            var pieces = new List<EdgePiece>();
            for (int edge = 0, first = 0; edge < _edges.Count; edge++)
            {
                int end = first;
                while (end < _overlaps.Count && _overlaps[end].Edge == edge)
                    end++;
                CutEdge(edge, _overlaps.GetRange(first, end - first), pieces);
                first = end;
            }
            return pieces;
        }

        // The edge with the lowest number owns what several share.
        void CutEdge(int number, List<Overlap> overlaps, List<EdgePiece> pieces)
        {
            var edge = _edges[number];
            if (overlaps.Count == 0)
            {
                pieces.Add(new EdgePiece(edge.From, edge.To, new[] { edge.Face }));
                return;
            }
            var cuts = CutsOf(edge, overlaps);
            overlaps.Sort((a, b) => a.Min.CompareTo(b.Min));
            var others = new List<Overlap>();
            for (int i = 0, next = 0; i + 1 < cuts.Count; i++)
            {
                double centre = (cuts[i].at + cuts[i + 1].at) / 2;
                while (next < overlaps.Count && overlaps[next].Min < centre)
                    others.Add(overlaps[next++]);
                others.RemoveAll(overlap => overlap.Max <= centre);
                if (others.Exists(overlap => overlap.Other < number))
                    continue;
                var faces = new EdgeFace[others.Count + 1];
                faces[0] = edge.Face;
                for (int k = 0; k < others.Count; k++)
                    faces[k + 1] = _edges[others[k].Other].Face;
                pieces.Add(new EdgePiece(cuts[i].point, cuts[i + 1].point, faces));
            }
        }

        // Places along the edge, ascending and at least a tolerance apart, from its beginning to its end. The points
        // are corners of meshes if these are on the edge, so that pieces of different edges end at the same point.
        List<(double at, double3 point)> CutsOf(in OpenEdge edge, List<Overlap> overlaps)
        {
            var all = new List<(double at, double3 point)>();
            foreach (var overlap in overlaps)
            {
                var other = _edges[overlap.Other];
                all.Add(edge.PointNear(other.From));
                all.Add(edge.PointNear(other.To));
            }
            all.Sort((a, b) => a.at.CompareTo(b.at));
            var cuts = new List<(double at, double3 point)> { (0, edge.From) };
            foreach (var cut in all)
                if (cut.at > cuts[cuts.Count - 1].at + _tolerance && cut.at < edge.Length - _tolerance)
                    cuts.Add(cut);
            cuts.Add((edge.Length, edge.To));
            return cuts;
        }

        struct OpenEdge
        {
            public EdgeFace Face;
            public double3 From, To;
            public double Length;
            public bool CanJoin;

            public readonly double3 Along => (To - From) / Length;

            // Distance from the beginning of the edge's nearest point, metres.
            public readonly double Project(double3 point) =>
                math.clamp(math.dot(point - From, Along), 0, Length);

            public readonly (double at, double3 point) PointNear(double3 corner)
            {
                double at = Project(corner);
                double3 point = At(at);
                bool isOn = math.distance(point, corner) <= FacetNormals.Straightness(math.cmax(math.abs(corner)));
                return (at, isOn ? corner : point);
            }

            public readonly double3 At(double distance) => From + distance * Along;
        }

        // The part of an edge that another one lies on, metres from its beginning.
        struct Overlap
        {
            public int Edge, Other;
            public double Min, Max;
        }
    }
}
