using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// A sea without end under a plane wave: the echo of one tile, shaded by the copies of it towards the radar.
    /// </summary>
    public sealed class EndlessSea
    {
        // Of the rounding of places, relative to the tile.
        const double Rounding = 1e-6;

        readonly RadarScene _scene;
        readonly MeshInstance _tile;
        readonly double3 _x, _z; // unit vectors along the tile's sides
        readonly double _size; // metres
        // Of the waves, and of the mesh over the sides of the tile, metres; only poses and cells need them.
        readonly Lazy<(double Height, double2 Overhang)> _box;

        /// <summary>The sea of a scene.</summary>
        public EndlessSea(RadarScene scene, RadarSea sea)
        {
            (_scene, Clutter) = (scene, sea.Clutter);
            _tile = scene.Instances[sea.Tiles[0].Instance];
            // A tile on a curved earth is tilted.
            (_x, _z) = (Level(_tile.ToWorld.X), Level(_tile.ToWorld.Z));
            _tile.ToWorld = new Affine { X = _x, Y = new double3(0, 1, 0), Z = _z };
            _size = Clutter.LongWaves.Settings.TileSize;
            _box = new Lazy<(double, double2)>(BoxOf);
        }

        /// <summary>Its echo.</summary>
        public SeaClutter Clutter { get; }

        /// <summary>The pose of a far radar, with as many tiles as its shadows are long.</summary>
        /// <param name="azimuthDegrees">As of <see cref="RadarAspect.At"/>.</param>
        /// <param name="grazingDegrees">Above 0.</param>
        public CrossSectionPose PoseOf(double azimuthDegrees, double grazingDegrees, double frequency)
        {
            var radar = RadarAspect.At(azimuthDegrees, grazingDegrees);
            var instances = ShadingTiles(radar, grazingDegrees).Select(tile =>
            {
                var instance = _tile;
                instance.ToWorld.Origin = _size * (tile.x * _x + tile.y * _z);
                return instance;
            }).Prepend(_tile).ToArray();
            var sea = new RadarSea(Clutter, new[] { new SeaTileInstance(0, 0) });
            return new CrossSectionPose
            {
                Scene = new RadarScene(instances) { Surfaces = _scene.Surfaces, Seas = new[] { sea } },
                Radar = radar, Receivers = new[] { radar }, Frequencies = new[] { frequency }
            };
        }

        /// <summary>Cells that cover the tile, in rows across the direction of the radar.</summary>
        /// <param name="size">Of a cell in metres: along the direction of the radar, and across.</param>
        /// <returns>The cells, and whether each lies in the tile as a whole.</returns>
        /// <exception cref="GlintException">There are too many cells.</exception>
        public (ClutterGrid Grid, bool[] AreWhole) CellsOf(double azimuthDegrees, double2 size)
        {
            const int maxCells = 1 << 16;
            var radar = RadarAspect.At(azimuthDegrees, 0);
            double3 across = radar.Right, along = -radar.ToRadar;
            double2 step = size.yx, half = _size / 2 * new double2(Reach(across), Reach(along)),
                before = math.ceil(math.length(_box.Value.Overhang) / step),
                count = 2 * before + math.ceil(2 * half / step - Rounding);
            if (!(count.x * count.y <= maxCells))
                throw new GlintException(FormattableString.Invariant(
                    $"sea clutter: a tile of {_size:g6} m has {count.x * count.y:g6} cells of {size.x:g6} x {size.y:g6} m, at most {maxCells} are possible: give larger cells"));
            double2 corner = -half - before * step;
            var cells = new int2((int)count.x, (int)count.y);
            var areWhole = Enumerable.Range(0, cells.x * cells.y).Select(cell =>
                IsInTile(corner + new double2(cell % cells.x, cell / cells.x) * step, step, across, along)).ToArray();
            return (new ClutterGrid(corner.x * across + corner.y * along, across, along, step, cells), areWhole);
        }

        static double3 Level(double3 v) => math.normalize(new double3(v.x, 0, v.z));

        (double, double2) BoxOf()
        {
            var box = _tile.Mesh.Bound();
            double3 min = box.Min, max = box.Max;
            return (max.y - min.y, math.max(0, math.max(max, -min).xz - _size / 2));
        }

        // Tiles that a shadow ray from the middle one meets below the highest crest: boxes that the moving box touches.
        IEnumerable<int2> ShadingTiles(RadarAspect radar, double grazingDegrees)
        {
            double length = _box.Value.Height / Math.Tan(math.radians(grazingDegrees)) / _size;
            double3 towards = new double3(radar.ToRadar.x, 0, radar.ToRadar.z);
            double2 way = math.lengthsq(towards) == 0 ? 0
                : length * new double2(math.dot(_x, towards), math.dot(_z, towards)) / math.length(towards);
            double2 width = 1 + 2 * _box.Value.Overhang / _size - Rounding;
            int2 first = (int2)math.floor(math.min(0, way) - width), last = (int2)math.ceil(math.max(0, way) + width);
            for (int z = first.y; z <= last.y; z++)
                for (int x = first.x; x <= last.x; x++)
                {
                    var (fromX, toX) = Meeting(way.x, x, width.x);
                    var (fromZ, toZ) = Meeting(way.y, z, width.y);
                    if ((x != 0 || z != 0) && Math.Max(0, Math.Max(fromX, fromZ)) <= Math.Min(1, Math.Min(toX, toZ)))
                        yield return new int2(x, z);
                }
        }

        // The part of a movement during which two boxes overlap in one coordinate; from above to if never.
        static (double From, double To) Meeting(double movement, int position, double width)
        {
            if (movement == 0)
                return Math.Abs(position) < width ? (0, 1) : (1, 0);
            double one = (position - width) / movement, other = (position + width) / movement;
            return (Math.Min(one, other), Math.Max(one, other));
        }

        double Reach(double3 direction) => Math.Abs(math.dot(direction, _x)) + Math.Abs(math.dot(direction, _z));

        bool IsInTile(double2 corner, double2 step, double3 across, double3 along) =>
            Enumerable.Range(0, 4).All(i =>
            {
                double2 place = corner + step * new double2(i & 1, i >> 1);
                double3 point = place.x * across + place.y * along;
                return Math.Max(Math.Abs(math.dot(point, _x)), Math.Abs(math.dot(point, _z)))
                    <= _size * (0.5 + Rounding);
            });
    }
}
