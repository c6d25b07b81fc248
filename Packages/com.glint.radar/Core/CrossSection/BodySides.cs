using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// On which sides of its triangles a scene has air. Triangles that meet two at an edge are one surface and get the
    /// same orientation, whatever their windings. A surface without borders that encloses a volume has air outside
    /// only; any other one, and one with a single side (a Moebius strip), has air on both sides. Bodies that share
    /// whole faces of a mesh count as sheets too: their edges outside are the same, and rays do not reach those inside.
    /// </summary>
    sealed class BodySides
    {
        // Minimum mean thickness of a body in its size: twice the volume over the area. Sheets modelled as two
        // coincident ones have none.
        const double MinThickness = 1e-6;

        readonly PlacedPatches[] _placed;
        readonly int[] _firsts; // number of each instance's first triangle in the scene
        readonly OrientedSets _surfaces;
        readonly bool[] _hasBorder; // for each surface, at its number
        readonly double[] _volumes;

        /// <summary>Finds the bodies.</summary>
        /// <param name="placed">The instances.</param>
        /// <param name="pieces">All edges of other than two triangles of one instance, and more.</param>
        /// <param name="size">Size of the scene, metres.</param>
        /// <param name="centre">Its centre.</param>
        public BodySides(PlacedPatches[] placed, List<EdgePiece> pieces, double size, double3 centre)
        {
            _placed = placed;
            _firsts = new int[placed.Length + 1];
            for (int i = 0; i < placed.Length; i++)
                _firsts[i + 1] = _firsts[i] + placed[i].Welded.Mesh.TriangleCount;
            int count = _firsts[placed.Length];
            _surfaces = new OrientedSets(count);
            _hasBorder = new bool[count];
            _volumes = new double[count];
            var oneSided = new List<int>();
            JoinWithin(oneSided);
            JoinAcross(pieces, oneSided);
            foreach (int triangle in oneSided)
                _hasBorder[_surfaces.Find(triangle, out _)] = true;
            foreach (var piece in pieces)
                if (piece.Faces.Length != 2)
                    MarkBorders(piece);
            Measure(size, centre);
        }

        /// <summary>
        /// The unit normal of a face that points to air, in the scene's frame; 0 if there is air on both sides.
        /// </summary>
        public double3 Outward(EdgeFace face)
        {
            int root = _surfaces.Find(_firsts[face.Instance] + face.Triangle, out bool flipped);
            if (_hasBorder[root])
                return 0;
            double3 normal = _placed[face.Instance].Normal(face.Triangle);
            return flipped == _volumes[root] > 0 ? -normal : normal;
        }

        /// <summary>Whether there is air on both sides of a face.</summary>
        public bool IsOpen(EdgeFace face) =>
            _hasBorder[_surfaces.Find(_firsts[face.Instance] + face.Triangle, out _)];

        void JoinWithin(List<int> oneSided)
        {
            for (int i = 0; i < _placed.Length; i++)
            {
                var welded = _placed[i].Welded;
                for (int side = 0; side < welded.EdgeOf.Length; side++)
                {
                    int across = welded.Across(side), triangle = _firsts[i] + side / 3;
                    if (across > side
                        && !_surfaces.Join(triangle, _firsts[i] + across / 3, !welded.AreOpposed(side, across)))
                        oneSided.Add(triangle);
                }
            }
        }

        void JoinAcross(List<EdgePiece> pieces, List<int> oneSided)
        {
            foreach (var piece in pieces)
                if (piece.Faces.Length == 2)
                {
                    EdgeFace a = piece.Faces[0], b = piece.Faces[1];
                    if (!_surfaces.Join(_firsts[a.Instance] + a.Triangle, _firsts[b.Instance] + b.Triangle,
                            Sign(a, piece) == Sign(b, piece)))
                        oneSided.Add(_firsts[a.Instance] + a.Triangle);
                }
        }

        // A surface continues at an edge of many triangles if as many of its triangles run along it in each direction.
        void MarkBorders(in EdgePiece piece)
        {
            foreach (var face in piece.Faces)
            {
                int root = _surfaces.Find(_firsts[face.Instance] + face.Triangle, out _), sum = 0;
                foreach (var other in piece.Faces)
                    if (_surfaces.Find(_firsts[other.Instance] + other.Triangle, out bool flipped) == root)
                        sum += flipped ? -Sign(other, piece) : Sign(other, piece);
                _hasBorder[root] |= sum != 0;
            }
        }

        int Sign(EdgeFace face, in EdgePiece piece) =>
            math.dot(_placed[face.Instance].Along(face.Side), piece.Along) > 0 ? 1 : -1;

        void Measure(double size, double3 centre)
        {
            var areas = new double[_volumes.Length];
            for (int i = 0; i < _placed.Length; i++)
                for (int t = 0; t < _placed[i].Welded.Mesh.TriangleCount; t++)
                {
                    double3 a = _placed[i].Point(3 * t) - centre, b = _placed[i].Point(3 * t + 1) - centre,
                        c = _placed[i].Point(3 * t + 2) - centre;
                    double volume = math.dot(a, math.cross(b, c)) / 6;
                    int root = _surfaces.Find(_firsts[i] + t, out bool flipped);
                    _volumes[root] += flipped ? -volume : volume;
                    areas[root] += _placed[i].TwiceArea(t) / 2;
                }
            for (int root = 0; root < areas.Length; root++)
                _hasBorder[root] |= math.abs(_volumes[root]) <= MinThickness * size * areas[root] / 2;
        }
    }
}
