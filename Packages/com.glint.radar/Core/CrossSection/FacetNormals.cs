using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Unit normals of a mesh's triangles, by their winding: cross(b - a, c - a). A needle, so narrow that the rounding
    /// of float32 coordinates turns its normal, has the normal of the triangle that it touches along its longest edge.
    /// </summary>
    sealed class FacetNormals
    {
        /// <summary>Maximum turn of a triangle's normal by rounding, radians; needles turn more.</summary>
        public const double MaxUncertainty = 0.1;

        // Maximum distance of a corner from its true position: half a unit in the last place along three axes, for
        // coordinates of 1 m.
        const double RelativeRounding = 1.7320508075688772 / (1 << 24);

        readonly WeldedMesh _welded;
        readonly double3[] _normals;
        readonly float[] _uncertainties;
        readonly bool[] _isNeedle;

        /// <summary>The normals of a mesh.</summary>
        public FacetNormals(WeldedMesh welded)
        {
            _welded = welded;
            int count = welded.Mesh.TriangleCount;
            _normals = new double3[count];
            _uncertainties = new float[count];
            _isNeedle = new bool[count];
            Blocks.For(count, (from, to) =>
            {
                for (int t = from; t < to; t++)
                    if (!welded.IsDegenerate(t))
                        Measure(t);
            });
            TakeNeighboursNormals();
        }

        /// <summary>
        /// The normal of a triangle; 0 for a degenerate one, and for a needle without area and neighbour.
        /// </summary>
        public double3 this[int triangle] => _normals[triangle];

        /// <summary>Whether a triangle's own corners do not give its normal.</summary>
        public bool IsNeedle(int triangle) => _isNeedle[triangle];

        /// <summary>Turn of a triangle's normal by the rounding of coordinates, radians.</summary>
        public double Uncertainty(int triangle) => _uncertainties[triangle];

        /// <summary>
        /// Maximum distance, metres, of corners from a line or plane that they are on but for rounding: several times
        /// the rounding of one corner, since the line or plane is found from others.
        /// </summary>
        /// <param name="largest">The largest coordinate, metres.</param>
        public static double Straightness(double largest) => 8 * RelativeRounding * largest;

        /// <summary>
        /// The normal of the triangle of side <paramref name="other"/>, on the side of that of
        /// <paramref name="side"/>: reversed if the two are wound differently.
        /// </summary>
        public double3 OnSideOf(int side, int other) =>
            _welded.AreOpposed(side, other) ? _normals[other / 3] : -_normals[other / 3];

        /// <summary>
        /// The bend at an edge of two triangles, radians from 0 (flat) to pi (folded); pi if a normal is missing.
        /// </summary>
        public double Bend(int side, int other)
        {
            double3 a = _normals[side / 3], b = OnSideOf(side, other);
            return math.lengthsq(a) * math.lengthsq(b) == 0 ? math.PI_DBL
                : math.atan2(math.length(math.cross(a, b)), math.dot(a, b));
        }

        void Measure(int triangle)
        {
            _welded.Mesh.GetTriangle(triangle, out var p, out var q, out var r);
            double3 a = p, b = q, c = r, normal = math.cross(b - a, c - a);
            double twiceArea = math.length(normal);
            double longest = math.max(math.distance(a, b), math.max(math.distance(b, c), math.distance(c, a)));
            double largest = math.cmax(math.max(math.abs(a), math.max(math.abs(b), math.abs(c))));
            if (twiceArea > 0)
                _normals[triangle] = normal / twiceArea;
            // The height turns about the longest edge when its ends move apart.
            double uncertainty = 2 * RelativeRounding * largest * longest / twiceArea;
            _isNeedle[triangle] = !(uncertainty <= MaxUncertainty);
            _uncertainties[triangle] = (float)(_isNeedle[triangle] ? MaxUncertainty : uncertainty);
        }

        // Needles are connected to other triangles along their longest edges first: a forest of paths, each from a
        // needle to a triangle whose normal is certain, across the longest possible edges.
        void TakeNeighboursNormals()
        {
            var sides = SidesOfNeedles();
            if (sides.Count == 0)
                return;
            sides.Sort((a, b) => a.length != b.length ? b.length.CompareTo(a.length) : a.side.CompareTo(b.side));
            var trees = new OrientedSets(_normals.Length);
            var isLink = new bool[3 * _normals.Length];
            var isCertain = Array.ConvertAll(_isNeedle, needle => !needle);
            foreach (var (_, side) in sides)
            {
                int across = _welded.Across(side), a = trees.Find(side / 3, out _), b = trees.Find(across / 3, out _);
                if (a == b || isCertain[a] && isCertain[b])
                    continue;
                bool certain = isCertain[a] || isCertain[b];
                trees.Join(a, b, false);
                isCertain[trees.Find(a, out _)] = certain;
                isLink[side] = isLink[across] = true;
            }
            Spread(isLink);
        }

        List<(double length, int side)> SidesOfNeedles()
        {
            var sides = new List<(double, int)>();
            var vertices = _welded.Mesh.Vertices;
            for (int side = 0; side < _welded.Corners.Length; side++)
            {
                int across = _isNeedle[side / 3] ? _welded.Across(side) : WeldedMesh.None;
                if (across == WeldedMesh.None || _isNeedle[across / 3] && across < side)
                    continue;
                double3 from = vertices[_welded.Corners[side]], to = vertices[_welded.Corners[WeldedMesh.EndOf(side)]];
                sides.Add((math.distance(from, to), side));
            }
            return sides;
        }

        void Spread(bool[] isLink)
        {
            var pending = new Stack<int>();
            for (int side = 0; side < isLink.Length; side++)
                if (isLink[side] && !_isNeedle[side / 3])
                    pending.Push(side);
            while (pending.Count > 0)
            {
                int side = pending.Pop(), across = _welded.Across(side), needle = across / 3;
                isLink[side] = isLink[across] = false;
                _normals[needle] = _welded.AreOpposed(side, across) ? _normals[side / 3] : -_normals[side / 3];
                _uncertainties[needle] = _uncertainties[side / 3];
                for (int next = 3 * needle; next < 3 * needle + 3; next++)
                    if (isLink[next])
                        pending.Push(next);
            }
        }
    }
}
