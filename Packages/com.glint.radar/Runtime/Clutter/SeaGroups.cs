using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// How many facets of a sea stand for others: those of tiles far from the radar are taken in square groups of cells, of
    /// which one facet counts for all that do not break. The mean of all sums stays, whatever the waves.
    /// </summary>
    static class SeaGroups
    {
        // Side of a group over its distance from the radar: three to a beam of one degree.
        const double Angle = 1.0 / 200;

        // Of a range cell, and of a cell whose echo is summed apart.
        const double PartOfRangeCell = 0.5, PartOfCell = 0.25;

        // Least number of groups of a sea: its mean echo is then within some percent even where few of them are lit.
        public const long MinGroups = 1 << 18;

        const int MaxSide = 64;

        /// <summary>Cells along a side of a group in each tile: a power of 2; 1: no groups.</summary>
        /// <param name="grid">Cells that are summed apart.</param>
        /// <param name="minGroups">Least number of groups of the sea.</param>
        public static int[] SidesOf(CrossSectionPose pose, RadarSea sea, ClutterGrid grid, long minGroups = MinGroups)
        {
            var waves = sea.Clutter.LongWaves.Settings;
            double cell = waves.TileSize / waves.Cells, reach = waves.TileSize / Math.Sqrt(2),
                largest = Math.Min(PartOfRangeCell * pose.RangeCell, grid.Count == 1 ? double.PositiveInfinity
                    : PartOfCell / Math.Max(math.length(grid.X), math.length(grid.Y)));
            int SideOf(SeaTileInstance tile)
            {
                if (pose.IsFar)
                    return 1;
                double3 radar = pose.PhaseCentre + pose.Range * pose.Radar.ToRadar;
                double distance = math.distance(pose.Scene.Instances[tile.Instance].ToWorld.Origin, radar) - reach,
                    limit = Math.Min(largest, Angle * distance);
                int side = 1;
                while (side < MaxSide && 2 * side * cell <= limit && waves.Cells % (2 * side) == 0)
                    side *= 2;
                return side;
            }
            int[] sides = sea.Tiles.Select(SideOf).ToArray();
            while (sides.Max() > 1 && sides.Sum(side => CountOf(waves.Cells, side)) < minGroups)
                sides = Array.ConvertAll(sides, side => Math.Max(1, side / 2));
            return sides;
        }

        /// <summary>Groups of a tile; facets if a group is one cell.</summary>
        /// <param name="cells">Along a side of the tile.</param>
        /// <param name="side">Cells along a side of a group.</param>
        public static long CountOf(int cells, int side) =>
            side == 1 ? 2L * cells * cells : (long)(cells / side) * (cells / side);
    }
}
