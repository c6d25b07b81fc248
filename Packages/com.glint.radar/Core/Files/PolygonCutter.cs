using System.Collections.Generic;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>
    /// Triangulates a polygon, seen along its normal, into triangles of its own orientation, which cover the inside of
    /// its outline and nothing else. For a convex polygon this is the fan about the first corner; other polygons are
    /// triangulated by ear clipping.
    /// </summary>
    sealed class PolygonCutter
    {
        /// <summary>Maximum corners of a concave polygon: the time grows with their square.</summary>
        public const int MaxCorners = 4096;

        // Fraction of the largest coordinate: eight times the rounding of a corner to float.
        const double Tolerance = 1.0 / (1 << 21);

        readonly IReadOnlyList<float3> _vertices;
        readonly List<int> _ring = new List<int>();
        double3 _normal;
        double _tolerance;

        public PolygonCutter(IReadOnlyList<float3> vertices) => _vertices = vertices;

        /// <summary>
        /// Replaces a fan that reaches out of its polygon; false if the polygon has no triangulation.
        /// </summary>
        /// <param name="indices">Holds the fan.</param>
        /// <param name="first">First index of the fan.</param>
        /// <param name="count">Triangles of the fan.</param>
        public bool TryCut(List<int> indices, int first, int count)
        {
            double reach = 0, largest = 0, size = 0, reversed = 0;
            _normal = 0;
            for (int i = first; i < first + 3 * count; i += 3)
            {
                int a = indices[i], b = indices[i + 1], c = indices[i + 2];
                var cross = Cross(a, b, c);
                _normal += cross;
                largest = max(largest, math.length(cross));
                reach = max(reach, max(Distance(a, b), Distance(a, c)));
                size = max(size, max(Size(a), max(Size(b), Size(c))));
            }
            for (int i = first; i < first + 3 * count; i += 3)
                reversed += max(0, -Turn(indices[i], indices[i + 1], indices[i + 2]));

            _tolerance = Tolerance * size;
            double speck = _tolerance * reach, length = math.length(_normal);
            // A polygon without area, which is allowed, or a valid fan.
            if (largest <= speck || length > speck && reversed <= speck * length)
                return true;
            if (length <= speck || count > MaxCorners - 2)
                return false;

            _normal /= length;
            _ring.Clear();
            _ring.Add(indices[first]);
            _ring.Add(indices[first + 1]);
            for (int i = first; i < first + 3 * count; i += 3)
                _ring.Add(indices[i + 2]);
            return TryClip(indices, first);
        }

        bool TryClip(List<int> indices, int at)
        {
            for (int ear = 0; _ring.Count > 3; at += 3)
            {
                ear = FindEar(ear);
                if (ear < 0)
                    return false;
                Put(indices, at, Before(ear), _ring[ear], After(ear));
                _ring.RemoveAt(ear);
            }
            Put(indices, at, _ring[0], _ring[1], _ring[2]);
            return Turn(_ring[0], _ring[1], _ring[2]) > 0 || IsFlat(_ring[0], _ring[1], _ring[2]);
        }

        // The next ear in the ring; if there is none, a corner on the line between its neighbours.
        int FindEar(int start)
        {
            int flat = -1;
            for (int i = 0; i < _ring.Count; i++)
            {
                int corner = (start + i) % _ring.Count;
                int a = Before(corner), b = _ring[corner], c = After(corner);
                if (IsFlat(a, b, c))
                    flat = flat < 0 ? corner : flat;
                else if (Turn(a, b, c) > 0 && !HoldsACorner(a, b, c))
                    return corner;
            }
            return flat;
        }

        // Only reflex corners can lie inside an ear. The ends of a cut to a hole occur twice and coincide with its
        // corners.
        bool HoldsACorner(int a, int b, int c)
        {
            for (int i = 0; i < _ring.Count; i++)
            {
                int p = _ring[i];
                if (Turn(a, b, p) >= 0 && Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0 && !IsSame(p, a) && !IsSame(p, b)
                    && !IsSame(p, c) && Turn(Before(i), p, After(i)) <= 0)
                    return true;
            }
            return false;
        }

        bool IsFlat(int a, int b, int c) =>
            math.length(Cross(a, b, c)) <= _tolerance * max(Distance(a, b), max(Distance(b, c), Distance(c, a)));

        bool IsSame(int a, int b) => a == b || _vertices[a].Equals(_vertices[b]);

        int Before(int corner) => _ring[corner == 0 ? _ring.Count - 1 : corner - 1];

        int After(int corner) => _ring[corner == _ring.Count - 1 ? 0 : corner + 1];

        /// <summary>
        /// Twice the signed area of a triangle along the polygon's normal; above 0 if it has the polygon's orientation.
        /// </summary>
        double Turn(int a, int b, int c) => dot(Cross(a, b, c), _normal);

        double Distance(int a, int b) => math.length(Position(b) - Position(a));

        double3 Cross(int a, int b, int c) => cross(Position(b) - Position(a), Position(c) - Position(a));

        double Size(int vertex)
        {
            var position = Position(vertex);
            return max(abs(position.x), max(abs(position.y), abs(position.z)));
        }

        double3 Position(int vertex) => _vertices[vertex];

        static void Put(List<int> indices, int at, int a, int b, int c) =>
            (indices[at], indices[at + 1], indices[at + 2]) = (a, b, c);
    }
}
