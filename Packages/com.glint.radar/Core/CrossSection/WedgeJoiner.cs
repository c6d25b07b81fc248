using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A wedge before collinear ones are joined.</summary>
    readonly struct WedgePiece
    {
        readonly bool _firstConducts, _secondConducts;

        public WedgePiece(Wedge wedge, bool firstConducts, bool secondConducts, double uncertainty) =>
            (Wedge, _firstConducts, _secondConducts, Uncertainty) =
                (wedge, firstConducts, secondConducts, uncertainty);

        public Wedge Wedge { get; }

        /// <summary>Turn of the faces by rounding, radians.</summary>
        public double Uncertainty { get; }

        public bool IsConductor => _firstConducts && _secondConducts;

        /// <summary>The same wedge, seen from its other end.</summary>
        public WedgePiece Reversed() => new WedgePiece(
            new Wedge(Wedge.B, Wedge.A, Wedge.Second, Wedge.First, Wedge.OuterAngle), _secondConducts, _firstConducts,
            Uncertainty);

        /// <summary>Another wedge with the same surfaces.</summary>
        public WedgePiece With(Wedge wedge) => new WedgePiece(wedge, _firstConducts, _secondConducts, Uncertainty);

        /// <summary>Whether another wedge along the same direction has the same faces.</summary>
        public bool HasFacesOf(in WedgePiece other, double tolerance)
        {
            double turn = tolerance + Uncertainty + other.Uncertainty;
            return _firstConducts == other._firstConducts && _secondConducts == other._secondConducts
                && math.distance(Wedge.First.Into, other.Wedge.First.Into) <= turn
                && math.distance(Wedge.Second.Into, other.Wedge.Second.Into) <= turn
                && math.abs(Wedge.OuterAngle - other.Wedge.OuterAngle) <= turn;
        }
    }

    /// <summary>
    /// Joins wedges that continue each other in a straight line with the same faces, as along the side of a plate of
    /// many triangles.
    /// </summary>
    sealed class WedgeJoiner
    {
        // Maximum turn of faces and edges that are joined, besides what rounding makes of them, radians: 0.06 degrees.
        const double MaxTurn = 1e-3;

        const int None = -1;

        readonly List<WedgePiece> _pieces;
        readonly List<WedgePiece> _joined = new List<WedgePiece>();
        readonly List<WedgePiece> _chain = new List<WedgePiece>();
        readonly int[] _links; // the end that each end continues at; wedge w has ends 2w (A) and 2w + 1 (B)
        readonly bool[] _isDone;

        WedgeJoiner(List<WedgePiece> pieces)
        {
            _pieces = pieces;
            _links = new int[2 * pieces.Count];
            _isDone = new bool[pieces.Count];
            Array.Fill(_links, None);
        }

        /// <summary>The wedges after joining.</summary>
        public static List<WedgePiece> Join(List<WedgePiece> pieces)
        {
            var joiner = new WedgeJoiner(pieces);
            joiner.Link();
            // Chains with ends first, then rings.
            for (int end = 0; end < joiner._links.Length; end++)
                if (joiner._links[end] == None)
                    joiner.Follow(end);
            for (int end = 0; end < joiner._links.Length; end += 2)
                joiner.Follow(end);
            return joiner._joined;
        }

        void Link()
        {
            var endsAt = new Dictionary<double3, List<int>>();
            for (int end = 0; end < _links.Length; end++)
            {
                double3 point = end % 2 == 0 ? _pieces[end / 2].Wedge.A : _pieces[end / 2].Wedge.B;
                if (!endsAt.TryGetValue(point, out var ends))
                    endsAt.Add(point, ends = new List<int>());
                int other = ends.FindIndex(candidate => Continues(candidate, end));
                if (other == None)
                {
                    ends.Add(end);
                    continue;
                }
                _links[end] = ends[other];
                _links[ends[other]] = end;
                ends.RemoveAt(other);
            }
        }

        // From end to end through the point that they share.
        bool Continues(int end, int other)
        {
            WedgePiece before = From(end ^ 1), after = From(other);
            return math.distance(before.Wedge.Direction, after.Wedge.Direction)
                <= MaxTurn + before.Uncertainty + after.Uncertainty && before.HasFacesOf(after, MaxTurn);
        }

        // The wedge as it begins at one of its ends.
        WedgePiece From(int end) => end % 2 == 0 ? _pieces[end / 2] : _pieces[end / 2].Reversed();

        void Follow(int end)
        {
            _chain.Clear();
            while (end != None && !_isDone[end / 2])
            {
                _isDone[end / 2] = true;
                _chain.Add(From(end));
                end = _links[end ^ 1];
            }
            Store(0, _chain.Count);
        }

        // Joins a part of the chain if it is straight; otherwise divides it where it is farthest from the line.
        void Store(int first, int end)
        {
            var pending = new Stack<(int first, int end)>();
            if (end > first)
                pending.Push((first, end));
            while (pending.Count > 0)
            {
                (first, end) = pending.Pop();
                int cut = end - first == 1 ? end : Division(first, end);
                if (cut == end)
                {
                    _joined.Add(Merge(first, end));
                    continue;
                }
                pending.Push((cut, end));
                pending.Push((first, cut));
            }
        }

        // The end, if all are one wedge.
        int Division(int first, int end)
        {
            double3 a = _chain[first].Wedge.A, b = _chain[end - 1].Wedge.B;
            double largest = math.max(math.cmax(math.abs(a)), math.cmax(math.abs(b))), farthest = 0;
            double3 along = math.normalizesafe(b - a);
            int cut = end;
            for (int i = first + 1; i < end; i++)
            {
                double3 offset = _chain[i].Wedge.A - a;
                double distance = math.length(offset - math.dot(offset, along) * along);
                largest = math.max(largest, math.cmax(math.abs(_chain[i].Wedge.A)));
                if (distance > farthest)
                    (farthest, cut) = (distance, i);
            }
            if (farthest > FacetNormals.Straightness(largest))
                return cut;
            int centre = (first + end) / 2;
            for (int i = first; i < end; i++)
                if (!_chain[i].HasFacesOf(_chain[centre], MaxTurn))
                    return centre;
            return end;
        }

        // The faces are those of the longest one, turned to be across the joined edge.
        WedgePiece Merge(int first, int end)
        {
            if (end - first == 1)
                return _chain[first];
            var longest = _chain[first];
            for (int i = first + 1; i < end; i++)
                if (_chain[i].Wedge.Length > longest.Wedge.Length)
                    longest = _chain[i];
            Wedge of = longest.Wedge;
            double3 a = _chain[first].Wedge.A, b = _chain[end - 1].Wedge.B, along = math.normalize(b - a);
            WedgeFace Across(WedgeFace face, int sign)
            {
                double3 into = math.normalize(face.Into - math.dot(face.Into, along) * along);
                return new WedgeFace(into, sign * math.cross(along, into), face.Instance, face.Triangle);
            }
            return longest.With(new Wedge(a, b, Across(of.First, 1), Across(of.Second, -1), of.OuterAngle));
        }
    }
}
