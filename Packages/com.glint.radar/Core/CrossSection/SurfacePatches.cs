using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Smooth patches of a mesh, and normals at its corners that are smooth within a patch. A patch ends at edges bent
    /// by more than the crease angle, at open and non-manifold edges, and where the surface changes. Triangles that are
    /// wound differently may share a patch.
    /// </summary>
    public sealed class SurfacePatches
    {
        /// <summary>The crease angle that is usual for hulls, degrees.</summary>
        public const double DefaultCreaseDegrees = 20;

        /// <summary>The patch of a degenerate triangle.</summary>
        public const int NoPatch = -1;

        const double MaxCreaseDegrees = 90;

        readonly int[] _smoothAcross; // the side across a smooth edge, for each side
        readonly sbyte[] _signs;      // whether a triangle is wound as the first one of its patch
        bool[] _isFlat;
        int[] _outlines;
        int[][] _flatPatches;
        float3[] _corners;

        SurfacePatches(TriangleMesh mesh, MeshRange[] ranges, double creaseDegrees)
        {
            CreaseDegrees = creaseDegrees;
            Welded = new WeldedMesh(mesh);
            Normals = new FacetNormals(Welded);
            _smoothAcross = new int[3 * mesh.TriangleCount];
            FindSmoothEdges(SurfacesOf(mesh, ranges));
            PatchOf = new int[mesh.TriangleCount];
            _signs = new sbyte[mesh.TriangleCount];
            PatchCount = FindPatches();
            FindFlatPatches();
            CornerNormals = new CornerNormalFinder(Welded, Normals, _smoothAcross).Find();
        }

        /// <summary>Finds the patches of a mesh.</summary>
        /// <param name="mesh">Kept, not copied.</param>
        /// <param name="ranges">Its ranges, of which the surfaces matter; null: one surface.</param>
        /// <param name="creaseDegrees">
        /// Edges bent by more than this angle are sharp, 0 to 90 degrees. Facets that differ by no more than the
        /// rounding of float32 coordinates are one patch at any angle.
        /// </param>
        /// <exception cref="GlintException">The crease angle is out of its range.</exception>
        public static SurfacePatches Find(TriangleMesh mesh, MeshRange[] ranges = null,
            double creaseDegrees = DefaultCreaseDegrees)
        {
            if (!(creaseDegrees >= 0 && creaseDegrees <= MaxCreaseDegrees))
                throw new GlintException("crease angle " + creaseDegrees.ToString(CultureInfo.InvariantCulture)
                    + " degrees: must be from 0 (every edge is sharp) to 90");
            return new SurfacePatches(mesh, ranges, creaseDegrees);
        }

        /// <summary>The mesh with its edges.</summary>
        public WeldedMesh Welded { get; }

        /// <summary>The crease angle, degrees.</summary>
        public double CreaseDegrees { get; }

        /// <summary>
        /// The patch of each triangle, from 0 in the order of their first triangles; <see cref="NoPatch"/> for a
        /// degenerate triangle.
        /// </summary>
        public int[] PatchOf { get; }

        /// <summary>Number of patches.</summary>
        public int PatchCount { get; }

        /// <summary>
        /// Unit normals, three a triangle: at each corner the mean over the patch's triangles around it, weighted by
        /// their angles, on the side of the triangle's own normal, cross(b - a, c - a).
        /// </summary>
        public float3[] CornerNormals { get; }

        /// <summary>Normals of the triangles.</summary>
        internal FacetNormals Normals { get; }

        /// <summary>
        /// Whether all triangles of a patch are in one plane, but for the rounding of float32 coordinates.
        /// </summary>
        public bool IsFlat(int patch) => _isFlat[patch];

        /// <summary>Whether two triangles of one patch meet at a side, with no crease between them.</summary>
        public bool IsSmooth(int side) => _smoothAcross[side] != WeldedMesh.None;

        /// <summary>The sides of triangles on the outlines of patches: no triangle of the same patch is at the other side.</summary>
        public IReadOnlyList<int> Outlines => _outlines ??= Enumerable.Range(0, Welded.Corners.Length)
            .Where(side => Welded.EdgeOf[side] != WeldedMesh.None && !IsSmooth(side)).ToArray();

        /// <summary>The triangles of each flat patch.</summary>
        public IReadOnlyList<int[]> FlatPatches => _flatPatches ??= Enumerable.Range(0, PatchOf.Length)
            .Where(triangle => PatchOf[triangle] != NoPatch && IsFlat(PatchOf[triangle]))
            .GroupBy(triangle => PatchOf[triangle], (patch, triangles) => triangles.ToArray()).ToArray();

        /// <summary>The places where outlines turn, in the mesh's frame.</summary>
        public IReadOnlyList<float3> Corners => _corners ??= PatchCorners.Of(this);

        /// <summary>The surface of each triangle.</summary>
        internal static int[] SurfacesOf(TriangleMesh mesh, MeshRange[] ranges)
        {
            var surfaces = new int[mesh.TriangleCount];
            for (int i = 0; i < (ranges?.Length ?? 0); i++)
            {
                int first = ranges[i].FirstTriangle,
                    end = i + 1 < ranges.Length ? ranges[i + 1].FirstTriangle : surfaces.Length;
                Array.Fill(surfaces, ranges[i].Surface, first, end - first);
            }
            return surfaces;
        }

        void FindSmoothEdges(int[] surfaces)
        {
            double crease = math.radians(CreaseDegrees);
            Blocks.For(_smoothAcross.Length, (from, to) =>
            {
                for (int side = from; side < to; side++)
                {
                    int across = Welded.Across(side), a = side / 3, b = across / 3;
                    bool smooth = across != WeldedMesh.None && surfaces[a] == surfaces[b]
                        && Normals.Bend(side, across) <= crease + Normals.Uncertainty(a) + Normals.Uncertainty(b);
                    _smoothAcross[side] = smooth ? across : WeldedMesh.None;
                }
            });
        }

        int FindPatches()
        {
            int count = 0;
            var pending = new Stack<int>();
            Array.Fill(PatchOf, NoPatch);
            for (int seed = 0; seed < PatchOf.Length; seed++)
            {
                if (PatchOf[seed] != NoPatch || Welded.IsDegenerate(seed))
                    continue;
                PatchOf[seed] = count;
                _signs[seed] = 1;
                pending.Push(seed);
                while (pending.Count > 0)
                    Grow(pending.Pop(), pending);
                count++;
            }
            return count;
        }

        void Grow(int triangle, Stack<int> pending)
        {
            for (int side = 3 * triangle; side < 3 * triangle + 3; side++)
            {
                int across = _smoothAcross[side];
                if (across == WeldedMesh.None || PatchOf[across / 3] != NoPatch)
                    continue;
                PatchOf[across / 3] = PatchOf[triangle];
                _signs[across / 3] = Welded.AreOpposed(side, across) ? _signs[triangle] : (sbyte)-_signs[triangle];
                pending.Push(across / 3);
            }
        }

        // The plane has the direction of the patch's vector area, which depends on its border alone, and goes through
        // the mean of its corners.
        void FindFlatPatches()
        {
            var planes = new Plane[PatchCount];
            var mesh = Welded.Mesh;
            for (int t = 0; t < PatchOf.Length; t++)
                if (PatchOf[t] != NoPatch)
                {
                    mesh.GetTriangle(t, out var a, out var b, out var c);
                    planes[PatchOf[t]].Add(a, b, c, _signs[t]);
                }
            for (int patch = 0; patch < planes.Length; patch++)
                planes[patch].Finish();
            _isFlat = new bool[PatchCount];
            Array.Fill(_isFlat, true);
            for (int t = 0; t < PatchOf.Length; t++)
                if (PatchOf[t] != NoPatch)
                {
                    mesh.GetTriangle(t, out var a, out var b, out var c);
                    ref var plane = ref planes[PatchOf[t]];
                    _isFlat[PatchOf[t]] &= plane.Holds(a) && plane.Holds(b) && plane.Holds(c);
                }
        }

        struct Plane
        {
            // Minimum part of the area that the vector area of a plane has; a tube or a sphere has none.
            const double MinVectorArea = 0.999;

            double3 _normal, _point;
            double _area, _corners, _largest;
            bool _isPlane;

            public void Add(double3 a, double3 b, double3 c, int sign)
            {
                double3 vectorArea = sign * math.cross(b - a, c - a);
                _normal += vectorArea;
                _area += math.length(vectorArea);
                _point += a + b + c;
                _corners += 3;
                _largest = math.max(_largest, math.cmax(math.max(math.abs(a), math.max(math.abs(b), math.abs(c)))));
            }

            public void Finish()
            {
                _isPlane = math.length(_normal) >= MinVectorArea * _area;
                _normal = math.normalizesafe(_normal);
                _point /= _corners;
            }

            public readonly bool Holds(double3 p) => _isPlane &&
                math.abs(math.dot(_normal, p - _point)) <= FacetNormals.Straightness(_largest);
        }
    }

    /// <summary>Mean normals of the fans of triangles around corners.</summary>
    sealed class CornerNormalFinder
    {
        readonly WeldedMesh _welded;
        readonly FacetNormals _normals;
        readonly int[] _smoothAcross;
        readonly float3[] _means;
        readonly bool[] _visited;
        readonly List<(int corner, int sign)> _fan = new List<(int, int)>();

        public CornerNormalFinder(WeldedMesh welded, FacetNormals normals, int[] smoothAcross)
        {
            (_welded, _normals, _smoothAcross) = (welded, normals, smoothAcross);
            _means = new float3[smoothAcross.Length];
            _visited = new bool[smoothAcross.Length];
        }

        /// <summary>A unit vector for each corner.</summary>
        public float3[] Find()
        {
            for (int corner = 0; corner < _means.Length; corner++)
            {
                if (_visited[corner])
                    continue;
                _fan.Clear();
                _fan.Add((corner, 1));
                _visited[corner] = true;
                Walk(corner);
                Walk(PreviousSide(corner));
                Store();
            }
            return _means;
        }

        // From triangle to triangle around the first corner of the fan, out through a side that touches it.
        void Walk(int side)
        {
            int vertex = _welded.Corners[_fan[0].corner], sign = 1;
            for (int across; (across = _smoothAcross[side]) != WeldedMesh.None;)
            {
                sign *= _welded.AreOpposed(side, across) ? 1 : -1;
                bool begins = _welded.Corners[across] == vertex;
                int corner = begins ? across : WeldedMesh.EndOf(across);
                if (_visited[corner])
                    return;
                _visited[corner] = true;
                _fan.Add((corner, sign));
                side = begins ? PreviousSide(corner) : corner;
            }
        }

        static int PreviousSide(int corner) => corner % 3 == 0 ? corner + 2 : corner - 1;

        void Store()
        {
            double3 weighted = 0, plain = 0;
            foreach (var (corner, sign) in _fan)
            {
                var normal = sign * _normals[corner / 3];
                plain += normal;
                if (!_normals.IsNeedle(corner / 3))
                    weighted += Angle(corner) * normal;
            }
            var mean = math.normalizesafe(math.lengthsq(weighted) > 0 ? weighted : plain);
            foreach (var (corner, sign) in _fan)
            {
                var own = _normals[corner / 3];
                var normal = math.dot(sign * mean, own) > 0 ? sign * mean : own;
                _means[corner] = (float3)math.normalizesafe(normal, new double3(0, 1, 0));
            }
        }

        double Angle(int corner)
        {
            var vertices = _welded.Mesh.Vertices;
            double3 here = vertices[_welded.Corners[corner]],
                a = vertices[_welded.Corners[WeldedMesh.EndOf(corner)]] - here,
                b = vertices[_welded.Corners[PreviousSide(corner)]] - here;
            return math.atan2(math.length(math.cross(a, b)), math.dot(a, b));
        }
    }
}
