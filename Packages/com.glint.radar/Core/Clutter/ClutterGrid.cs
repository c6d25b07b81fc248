using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Rectangular cells of the sea whose echoes are summed apart.</summary>
    public sealed class ClutterGrid
    {
        /// <summary>One cell that holds everything.</summary>
        public static readonly ClutterGrid Whole = new ClutterGrid(0, 0, 0, 1);

        ClutterGrid(double3 corner, double3 x, double3 y, int2 cells) =>
            (Corner, X, Y, Cells) = (corner, x, y, cells);

        /// <summary>Cells on the ground.</summary>
        /// <param name="corner">Of the first cell, in the scene's frame, metres.</param>
        /// <param name="alongX">Unit vector along a row of cells.</param>
        /// <param name="alongY">Unit vector from row to row.</param>
        /// <param name="size">Of a cell, metres.</param>
        /// <param name="cells">Cells of a row, and rows.</param>
        public ClutterGrid(double3 corner, double3 alongX, double3 alongY, double2 size, int2 cells)
            : this(corner, alongX / size.x, alongY / size.y, cells)
        {
        }

        /// <summary>Corner of the first cell, metres.</summary>
        public double3 Corner { get; }

        /// <summary>A place in cells is the product of this and the way from the corner, 1/m.</summary>
        public double3 X { get; }

        /// <inheritdoc cref="X"/>
        public double3 Y { get; }

        /// <summary>Cells of a row, and rows.</summary>
        public int2 Cells { get; }

        /// <summary>Number of cells.</summary>
        public int Count => Cells.x * Cells.y;
    }
}
