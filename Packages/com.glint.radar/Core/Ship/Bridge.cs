using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// An upright box on the deckhouse, windows set into its front and sides, below a roof that overhangs.
    /// </summary>
    sealed class Bridge
    {
        // Sill and head of the windows above the foot, as fractions of the storey's height;
        // the wall between two windows, as a fraction of a window's width.
        const double Sill = 0.42, Head = 0.78, Post = 0.25;

        // Width of the wall at the corners, metres; larger than the depth of the other wall's windows.
        const double Corner = 0.15;

        // Row of the walls' cells that holds the windows.
        const int WindowRow = 1;

        readonly ShipSettings _settings;
        readonly double[] _x, _y, _z;

        public Bridge(in ShipSettings settings, Deckhouse house)
        {
            _settings = settings;
            HalfWidth = house.UpperHalfWidth + 0.4;
            Front = house.UpperFront + 1;
            Aft = Front + 2.2 * HalfWidth;
            Roof = house.UpperRoof + settings.StoreyHeight;
            _x = WindowEdges(-HalfWidth, HalfWidth, settings.Windows, settings.WindowDepth + Corner);
            _z = WindowEdges(Front, Aft, (2 * settings.Windows + 2) / 3, settings.WindowDepth + Corner);
            _y = new[]
            {
                house.UpperRoof - Deckhouse.Overlap, house.UpperRoof + Sill * settings.StoreyHeight,
                house.UpperRoof + Head * settings.StoreyHeight, Roof
            };
        }

        public double HalfWidth { get; }

        public double Front { get; }

        public double Aft { get; }

        public double Roof { get; }

        public ShipPart Build()
        {
            double[] xBack = Reversed(_x), zBack = Reversed(_z);
            double depth = _settings.WindowDepth;
            var part = new ShipPart();
            // The four walls, then the lids, all with the same orientation.
            AddWindowWall(part, Grid(_y, _x, (y, x) => new double3(x, y, Front)), new double3(0, 0, depth));
            AddWindowWall(part, Grid(_y, _z, (y, z) => new double3(HalfWidth, y, z)), new double3(-depth, 0, 0));
            part.AddPatch(Grid(_y, xBack, (y, x) => new double3(x, y, Aft)));
            AddWindowWall(part, Grid(_y, zBack, (y, z) => new double3(-HalfWidth, y, z)), new double3(depth, 0, 0));
            part.AddPatch(Grid(_z, _x, (z, x) => new double3(x, Roof, z)));
            part.AddPatch(Grid(_z, xBack, (z, x) => new double3(x, _y[0], z)));
            return part;
        }

        /// <summary>A slab that overhangs the windows.</summary>
        public ShipPart BuildRoof() => ShipPart.Box(
            new double3(-HalfWidth - 0.3, Roof - Deckhouse.Overlap, Front - 0.4),
            new double3(HalfWidth + 0.3, Roof + 0.15, Aft + 0.2));

        // Every second cell of the window row is a recess: four reveals and a pane.
        static void AddWindowWall(ShipPart part, double3[][] wall, double3 inward)
        {
            for (int row = 0; row + 1 < wall.Length; row++)
                for (int i = 0; i + 1 < wall[row].Length; i++)
                {
                    double3[] cell = { wall[row][i], wall[row + 1][i], wall[row + 1][i + 1], wall[row][i + 1] };
                    if (row != WindowRow || i % 2 == 0)
                    {
                        AddQuad(part, cell[0], cell[1], cell[2], cell[3]);
                        continue;
                    }
                    var pane = Array.ConvertAll(cell, corner => corner + inward);
                    for (int j = 0, next = 1; j < 4; j++, next = (j + 1) % 4)
                        AddQuad(part, cell[j], cell[next], pane[next], pane[j]);
                    AddQuad(part, pane[0], pane[1], pane[2], pane[3]);
                }
        }

        static void AddQuad(ShipPart part, double3 a, double3 b, double3 c, double3 d) =>
            part.AddPatch(new[] { new[] { a, d }, new[] { b, c } });

        static double3[][] Grid(double[] rows, double[] columns, Func<double, double, double3> position) =>
            Array.ConvertAll(rows, row => Array.ConvertAll(columns, column => position(row, column)));

        // Borders of a wall's cells: wall, window, wall, ..., window, wall.
        static double[] WindowEdges(double from, double to, int windows, double corner)
        {
            double width = (to - from - 2 * corner) / (windows + Post * (windows - 1));
            var edges = new double[2 * windows + 2];
            for (int i = 0; i < windows; i++)
            {
                edges[2 * i + 1] = from + corner + i * (1 + Post) * width;
                edges[2 * i + 2] = edges[2 * i + 1] + width;
            }
            (edges[0], edges[edges.Length - 1]) = (from, to);
            return edges;
        }

        static double[] Reversed(double[] values)
        {
            var reversed = (double[])values.Clone();
            Array.Reverse(reversed);
            return reversed;
        }
    }
}
