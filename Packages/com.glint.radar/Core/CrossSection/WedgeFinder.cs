using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The wedges of a scene.</summary>
    public sealed class WedgeSet
    {
        internal WedgeSet(Wedge[] wedges, int coatedCount, double coatedLength, double gap) =>
            (Wedges, CoatedCount, CoatedLength, Gap) = (wedges, coatedCount, coatedLength, gap);

        /// <summary>Wedges whose faces both are perfect conductors.</summary>
        public IReadOnlyList<Wedge> Wedges { get; }

        /// <summary>
        /// Wedges, and borders in a plane, that are left out because a face is no perfect conductor; without the
        /// insides of corners, which add nothing.
        /// </summary>
        public int CoatedCount { get; }

        /// <summary>Their length, metres.</summary>
        public double CoatedLength { get; }

        /// <summary>Largest distance of open edges that were taken as one, metres.</summary>
        public double Gap { get; }
    }

    /// <summary>Finds the edges of a scene that diffract.</summary>
    /// <remarks>
    /// Edges are those between patches and the open ones. All triangles at an edge are sorted by their direction around
    /// it. Each angle between neighbours is a wedge if it is air: outside a closed body, or on either side of a thin
    /// sheet. So two thin plates that meet are two wedges, one within the corner and one behind it; the edge of a box
    /// is one; a plate that ends is one of 2 pi; three plates that meet are three. Angles that differ from pi by no
    /// more than the crease angle are a smooth surface, and none. Open edges of different triangles that lie on each
    /// other within <see cref="RelativeTolerance"/> of the target's size, <see cref="MaxTolerance"/> at most, are one
    /// edge over the length that they share. Tiles of a sea that is no conductor are left out.
    /// An open edge that lies on a face, away from its edges, remains the end of a plate.
    /// </remarks>
    public sealed class WedgeFinder
    {
        /// <summary>Maximum distance of edges that are one, in the diagonal of the box around what is no sea.</summary>
        public const double RelativeTolerance = 2e-5;

        /// <summary>Maximum distance of edges that are one, metres: of a land of kilometres too.</summary>
        public const double MaxTolerance = 5e-3;

        // Faces that are nearer to each other, in radians, are two sides of one sheet.
        const double MinAngle = 1e-3;

        readonly int[] _instances; // of the scene, that may have wedges
        readonly PlacedPatches[] _placed;
        readonly bool[][] _isConductor; // for each instance and triangle
        readonly List<EdgePiece> _pieces;
        readonly double _gap;
        readonly BodySides _sides;
        readonly List<WedgePiece> _wedges = new List<WedgePiece>();
        readonly List<FaceAtEdge> _around = new List<FaceAtEdge>();

        WedgeFinder(RadarScene scene, IReadOnlyList<SurfacePatches> patches, Predicate<SurfaceMaterial> isConductor)
        {
            var placed = PlacedPatches.Of(scene, patches);
            var surfaces = scene.Surfaces.Select(surface => isConductor(surface)).ToArray();
            // Tiles of water, a thousand of one mesh: they end on each other and at the end of the sea.
            var tiles = scene.SeaInstances();
            _instances = Enumerable.Range(0, placed.Length).Where(number => !tiles.Contains(number)
                || scene.Instances[number].Ranges.Any(range => surfaces[range.Surface])).ToArray();
            _placed = Array.ConvertAll(_instances, number => placed[number]);
            _isConductor = Array.ConvertAll(_instances, number => Array.ConvertAll(
                SurfacePatches.SurfacesOf(scene.Instances[number].Mesh, scene.Instances[number].Ranges),
                surface => surfaces[surface]));
            var (boxMin, boxMax) = Bound();
            double3 centre = (boxMin + boxMax) / 2;
            double size = math.distance(boxMin, boxMax);
            var (targetMin, targetMax) = scene.BoundTarget((boxMin, boxMax));
            double tolerance = Math.Min(MaxTolerance, RelativeTolerance * math.distance(targetMin, targetMax));
            _pieces = OpenEdges.Join(_placed, tolerance, centre, out _gap);
            AddCreases();
            _sides = new BodySides(_placed, _pieces, size, centre);
        }

        /// <summary>Finds the wedges of all instances and between them.</summary>
        /// <param name="scene">The scene.</param>
        /// <param name="patches">The patches of each instance's mesh.</param>
        /// <param name="isConductor">Whether a surface is a perfect conductor; null: all are.</param>
        /// <exception cref="GlintException">The patches are not those of the scene's meshes.</exception>
        public static WedgeSet Find(RadarScene scene, IReadOnlyList<SurfacePatches> patches,
            Predicate<SurfaceMaterial> isConductor = null)
        {
            if (scene.TriangleCount == 0)
                return new WedgeSet(Array.Empty<Wedge>(), 0, 0, 0);
            var finder = new WedgeFinder(scene, patches, isConductor ?? (surface => true));
            foreach (var piece in finder._pieces)
                finder.AddWedges(piece);
            var wedges = new List<Wedge>();
            int coated = 0;
            double coatedLength = 0;
            foreach (var piece in WedgeJoiner.Join(finder._wedges))
                if (piece.IsConductor)
                    wedges.Add(piece.Wedge);
                else if (piece.Wedge.OuterAngle > math.PI_DBL - MinAngle)
                {
                    coated++;
                    coatedLength += piece.Wedge.Length;
                }
            return new WedgeSet(wedges.ToArray(), coated, coatedLength, finder._gap);
        }

        /// <summary>
        /// A material that is a half-space and is given to a surface with air on both sides, which bounds none; null if
        /// there is none. Below the tiles of a sea there is water.
        /// </summary>
        /// <inheritdoc cref="Find" path="/param|/exception"/>
        public static SurfaceMaterial FindOpenDielectric(RadarScene scene, IReadOnlyList<SurfacePatches> patches)
        {
            var tiles = scene.SeaInstances();
            int[] candidates = Enumerable.Range(0, scene.Instances.Length).Where(instance => !tiles.Contains(instance)
                && scene.Instances[instance].Ranges.Any(range => scene.Surfaces[range.Surface].HalfSpace != null))
                .ToArray();
            if (candidates.Length == 0)
                return null;
            var finder = new WedgeFinder(scene, patches, surface => surface.HalfSpace == null);
            foreach (int number in candidates)
            {
                int i = Array.BinarySearch(finder._instances, number);
                var welded = finder._placed[i].Welded;
                var surfaces = SurfacePatches.SurfacesOf(welded.Mesh, scene.Instances[number].Ranges);
                for (int triangle = 0; triangle < surfaces.Length; triangle++)
                    if (!finder._isConductor[i][triangle] && !welded.IsDegenerate(triangle)
                        && finder._sides.IsOpen(new EdgeFace(i, 3 * triangle)))
                        return scene.Surfaces[surfaces[triangle]];
            }
            return null;
        }

        (double3, double3) Bound()
        {
            double3 boxMin = double.PositiveInfinity, boxMax = double.NegativeInfinity;
            foreach (var placed in _placed)
                for (int corner = 0; corner < placed.Welded.Corners.Length; corner++)
                {
                    double3 point = placed.Point(corner);
                    (boxMin, boxMax) = (math.min(boxMin, point), math.max(boxMax, point));
                }
            return (boxMin, boxMax);
        }

        void AddCreases()
        {
            for (int i = 0; i < _placed.Length; i++)
            {
                var welded = _placed[i].Welded;
                for (int edge = 0; edge < welded.EdgeCount; edge++)
                {
                    int count = welded.SideCount(edge), side = welded.SideOf(edge, 0);
                    if (count == 1 || _placed[i].Patches.IsSmooth(side))
                        continue;
                    double3 a = _placed[i].Point(side), b = _placed[i].Point(WeldedMesh.EndOf(side));
                    var faces = new EdgeFace[count];
                    for (int k = 0; k < count; k++)
                        faces[k] = new EdgeFace(i, welded.SideOf(edge, k));
                    if (math.distance(a, b) > 0)
                        _pieces.Add(new EdgePiece(a, b, faces));
                }
            }
        }

        void AddWedges(in EdgePiece piece)
        {
            _around.Clear();
            double3 along = piece.Along, reference = 0;
            foreach (var face in piece.Faces)
            {
                double3 into = Into(face, along);
                if (math.lengthsq(into) == 0)
                    continue;
                if (_around.Count == 0)
                    reference = into;
                double angle = math.atan2(math.dot(into, math.cross(along, reference)), math.dot(into, reference));
                _around.Add(new FaceAtEdge
                {
                    Face = face, Into = into, Angle = angle < 0 ? angle + 2 * math.PI_DBL : angle,
                    Outward = _sides.Outward(face),
                });
            }
            _around.Sort((a, b) => a.Angle.CompareTo(b.Angle));
            for (int i = 0; i < _around.Count; i++)
            {
                bool last = i == _around.Count - 1;
                FaceAtEdge first = _around[i], second = _around[last ? 0 : i + 1];
                AddWedge(piece, first, second, second.Angle - first.Angle + (last ? 2 * math.PI_DBL : 0));
            }
        }

        // The direction into a face from its edge, across the edge; by the normal, since needles have no other.
        double3 Into(EdgeFace face, double3 along)
        {
            var placed = _placed[face.Instance];
            double3 into = math.cross(placed.Normal(face.Triangle), placed.Along(face.Side));
            return math.normalizesafe(into - math.dot(into, along) * along);
        }

        void AddWedge(in EdgePiece piece, in FaceAtEdge first, in FaceAtEdge second, double angle)
        {
            double3 along = piece.Along, firstNormal = math.cross(along, first.Into),
                secondNormal = -math.cross(along, second.Into);
            if (angle < MinAngle || math.dot(first.Outward, firstNormal) < 0
                || math.dot(second.Outward, secondNormal) < 0)
                return;
            bool firstConducts = _isConductor[first.Face.Instance][first.Face.Triangle],
                secondConducts = _isConductor[second.Face.Instance][second.Face.Triangle];
            SurfacePatches firstPatches = _placed[first.Face.Instance].Patches,
                secondPatches = _placed[second.Face.Instance].Patches;
            double uncertainty = firstPatches.Normals.Uncertainty(first.Face.Triangle)
                + secondPatches.Normals.Uncertainty(second.Face.Triangle);
            double crease = math.radians(math.max(firstPatches.CreaseDegrees, secondPatches.CreaseDegrees));
            if (math.abs(angle - math.PI_DBL) <= crease + uncertainty && firstConducts == secondConducts)
                return;
            _wedges.Add(new WedgePiece(
                new Wedge(piece.A, piece.B,
                    new WedgeFace(first.Into, firstNormal, _instances[first.Face.Instance], first.Face.Triangle),
                    new WedgeFace(second.Into, secondNormal, _instances[second.Face.Instance], second.Face.Triangle), angle),
                firstConducts, secondConducts, uncertainty));
        }

        struct FaceAtEdge
        {
            public EdgeFace Face;
            public double3 Into, Outward;
            public double Angle;
        }
    }
}
