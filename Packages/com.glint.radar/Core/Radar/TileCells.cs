using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Tiles in cells of equal size: the list that the device computes its tiles from. Its length, and the time to make
    /// it, do not grow with the rays of the picture.
    /// </summary>
    public sealed class TileCells
    {
        /// <summary>Maximum number of cells across or down, and in all.</summary>
        public const int MaxAcross = 128, Max = MaxAcross * MaxAcross;

        // Consecutive tiles that stay together when the order is spread over processors: they share BVH nodes.
        const int Run = 32;

        /// <summary>The cells that outlines touch.</summary>
        /// <param name="outlines">First and last tile of each.</param>
        /// <param name="end">One past the last column and row of the region's tiles.</param>
        /// <param name="spread">
        /// Interleave all parts of the picture, so that every long section of the list has the same cost: a software
        /// device gives each processor one section. Otherwise cells go from the top of the picture down: distant tiles
        /// take longest, and a GPU that begins them last ends with most of its groups idle.
        /// </param>
        internal TileCells(List<(int2 from, int2 to)> outlines, int2 end, bool spread)
        {
            Corners = Array.Empty<uint>();
            Size = 1;
            if (outlines.Count == 0)
                return;
            int2 first = int.MaxValue, last = 0;
            foreach (var (from, to) in outlines)
            {
                first = math.min(first, from);
                last = math.max(last, to);
            }
            Size = (last - first) / MaxAcross + 1;
            Corners = Cover(outlines, first, (last - first) / Size + 1);
            foreach (uint corner in Corners)
            {
                int2 size = math.min(Size, end - new int2((int)(corner & 0xffff), (int)(corner >> 16)));
                TilesInRegion += (long)size.x * size.y;
            }
            if (spread)
                Corners = Spread(Corners, math.max(1, Run / (Size.x * Size.y)));
            else
                Array.Reverse(Corners);
        }

        /// <summary>First tile of each cell: column | row shifted by 16 bits.</summary>
        public uint[] Corners { get; private set; }

        /// <summary>Tiles across and down a cell.</summary>
        public int2 Size { get; }

        /// <summary>
        /// Tiles of all cells. Those at the right and upper edge may extend past the region; the device skips rays
        /// outside of it.
        /// </summary>
        public int TileCount => Corners.Length * Size.x * Size.y;

        /// <summary>The tiles that are in the region.</summary>
        public long TilesInRegion { get; }

        // From the bottom up, by 2-D differences of the number of outlines over each cell.
        uint[] Cover(List<(int2 from, int2 to)> outlines, int2 first, int2 count)
        {
            int stride = count.x + 1;
            var steps = new int[stride * (count.y + 1)];
            foreach (var (from, to) in outlines)
            {
                int2 a = (from - first) / Size, b = (to - first) / Size + 1;
                steps[a.y * stride + a.x]++;
                steps[a.y * stride + b.x]--;
                steps[b.y * stride + a.x]--;
                steps[b.y * stride + b.x]++;
            }
            var corners = new uint[count.x * count.y];
            var above = new int[count.x];
            int taken = 0;
            for (int row = 0; row < count.y; row++)
            {
                int covered = 0;
                for (int column = 0; column < count.x; column++)
                {
                    above[column] += steps[row * stride + column];
                    covered += above[column];
                    if (covered > 0)
                        corners[taken++] = (uint)(first.x + column * Size.x) | (uint)(first.y + row * Size.y) << 16;
                }
            }
            Array.Resize(ref corners, taken);
            return corners;
        }

        // Runs of neighbouring cells, taken with a stride of about 0.6 of their number that is coprime to it.
        static uint[] Spread(uint[] cells, int run)
        {
            int runs = (cells.Length + run - 1) / run;
            int stride = math.max(1, (int)(0.6 * runs));
            while (Divisor(stride, runs) != 1)
                stride++;
            var spread = new uint[cells.Length];
            int count = 0;
            for (int i = 0, next = 0; i < runs; i++, next = (next + stride) % runs)
            {
                int length = math.min(run, cells.Length - next * run);
                Array.Copy(cells, next * run, spread, count, length);
                count += length;
            }
            return spread;
        }

        static int Divisor(int a, int b) => b == 0 ? a : Divisor(b, a % b);
    }
}
