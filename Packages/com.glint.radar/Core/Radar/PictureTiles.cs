using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The tiles of 8 x 8 rays that may see the scene: those of the cells (<see cref="TileCells"/>) that the outlines
    /// of its boxes touch. The rays of other tiles hit nothing and are not traced.
    /// </summary>
    public sealed class PictureTiles
    {
        /// <summary>Rays along the side of a tile, and in a tile; a tile is one thread group.</summary>
        public const int Side = 8, Rays = Side * Side;

        // Rays by which the outline of a box is widened: many times the rounding of the kernel's directions.
        const double Margin = 0.05;

        // Up to this number of tiles a mesh is outlined as a whole: outlines of its parts would cost more than they
        // save, and there may be thousands of such meshes.
        const int FewTiles = 64;

        readonly RadarSettings _settings;
        readonly RadarView _view;
        readonly double2 _halfSize; // of the picture
        readonly int2 _first, _end; // tiles of the region, first and one past the last
        readonly double3[] _corners = new double3[8];
        // first and last tile of each outline in the region
        readonly List<(int2 from, int2 to)> _outlines = new List<(int2 from, int2 to)>();

        /// <summary>The tiles of a picture; none is taken.</summary>
        /// <param name="settings">Rays and region.</param>
        /// <param name="view">In the frame of the boxes that are added.</param>
        public PictureTiles(in RadarSettings settings, in RadarView view)
        {
            _settings = settings;
            _view = view;
            _halfSize = view.HalfSize(settings);
            Range(settings, out _first, out _end);
        }

        /// <summary>Tiles of the region.</summary>
        public long Count => (long)(_end.x - _first.x) * (_end.y - _first.y);

        /// <summary>Tiles of the region of any view.</summary>
        public static long CountIn(in RadarSettings settings)
        {
            Range(settings, out var first, out var end);
            return (long)(end.x - first.x) * (end.y - first.y);
        }

        /// <summary>Whether the outline of a box covers any tile; takes none.</summary>
        /// <param name="toWorld">From the box's axes to the world.</param>
        public bool CanSee(in Box box, in Affine toWorld) =>
            FindOutline(box.Min, box.Max, toWorld, out var from, out var to) && math.all(from < _end & to >= _first);

        /// <summary>Takes every tile.</summary>
        public void AddAll() => Cover(_first, _end - 1);

        /// <summary>Takes the tiles that may see a box.</summary>
        /// <param name="toWorld">From the box's axes to the world.</param>
        public void Add(float3 boxMin, float3 boxMax, in Affine toWorld)
        {
            if (FindOutline(boxMin, boxMax, toWorld, out var from, out var to))
                Cover(from, to);
        }

        /// <summary>Takes the tiles that may see a mesh.</summary>
        /// <param name="toWorld">From the mesh's axes to the world.</param>
        public void Add(MeshBvh mesh, in Affine toWorld)
        {
            if (mesh.CoverMin.Length == 0 || !FindOutline(mesh.Min, mesh.Max, toWorld, out var from, out var to))
                return;
            int2 size = math.min(to, _end - 1) - math.max(from, _first) + 1;
            if (size.x <= 0 || size.y <= 0)
                return;
            if ((long)size.x * size.y <= FewTiles)
            {
                Cover(from, to);
                return;
            }
            for (int box = 0; box < mesh.CoverMin.Length; box++)
                Add(mesh.CoverMin[box], mesh.CoverMax[box], toWorld);
        }

        static void Range(in RadarSettings settings, out int2 first, out int2 end)
        {
            var region = settings.TracedRegion;
            first = new int2(region.Left, region.Bottom) / Side;
            end = (new int2(region.Left + region.Width, region.Bottom + region.Height) + Side - 1) / Side;
        }

        // First and last tile that a box's outline touches, in the picture or beside it;
        // false if the box is behind the camera.
        bool FindOutline(float3 boxMin, float3 boxMax, in Affine toWorld, out int2 from, out int2 to)
        {
            var corners = _corners;
            for (int i = 0; i < corners.Length; i++)
                corners[i] = Seen(toWorld.Point(new Box(boxMin, boxMax).Corner(i)));
            double size = 0;
            foreach (var corner in corners)
                size = math.max(size, math.cmax(math.abs(corner)));

            // Of a box that extends behind the camera only the part before it counts: its corners, and the points at
            // which its edges cross a plane just before the camera.
            double nearest = 1e-9 * size;
            double2 min = double.PositiveInfinity, max = double.NegativeInfinity;
            void Include(double3 p)
            {
                double2 position = _view.IsParallel ? p.xy : p.xy / p.z; // -1 to 1 over the picture
                min = math.min(min, position);
                max = math.max(max, position);
            }
            for (int i = 0; i < corners.Length; i++)
            {
                if (corners[i].z >= nearest)
                    Include(corners[i]);
                for (int bit = 1; bit < 8; bit *= 2)
                    if ((i & bit) == 0 && corners[i].z >= nearest != corners[i | bit].z >= nearest)
                    {
                        double3 a = corners[i], b = corners[i | bit];
                        double3 crossing = a + (nearest - a.z) / (b.z - a.z) * (b - a);
                        Include(new double3(crossing.xy, nearest));
                    }
            }
            bool isSeen = min.x <= max.x;
            from = isSeen ? TileOf(min, -Margin) : 0;
            to = isSeen ? TileOf(max, Margin) : 0;
            return isSeen;
        }

        /// <summary>The cells of the tiles taken.</summary>
        /// <param name="spread">Their order: see <see cref="TileCells"/>.</param>
        public TileCells ToCells(bool spread) => new TileCells(_outlines, _end, spread);

        // Camera axes: x and y so that the picture reaches from -1 to 1, at z = 1 in perspective.
        double3 Seen(double3 point)
        {
            double3 v = point - _view.Position;
            return new double3(new double2(math.dot(v, _view.Right), math.dot(v, _view.Up)) / _halfSize,
                math.dot(v, _view.Forward));
        }

        // The tile of the nearest ray, clamped to the range of int.
        int2 TileOf(double2 position, double margin)
        {
            double2 ray = 0.5 * (position + 1) * new double2(_settings.RaysAcross, _settings.RaysDown) - 0.5 + margin;
            return (int2)math.floor(math.clamp(ray / Side, -1, 1e6));
        }

        void Cover(int2 from, int2 to)
        {
            from = math.max(from, _first);
            to = math.min(to, _end - 1);
            if (math.all(from <= to))
                _outlines.Add((from, to));
        }
    }
}
