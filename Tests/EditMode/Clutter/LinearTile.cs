using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// A repeated tile of a product's sea without choppiness, and the shadow of its heights under a plane wave. The wind
    /// blows along Z.
    /// </summary>
    sealed class LinearTile
    {
        /// <summary>Cells along a side.</summary>
        public readonly int Cells;

        public readonly SeaClutter Clutter;

        /// <summary>Two a cell of the mesh.</summary>
        public readonly double3[] Normals;

        readonly double _size;
        readonly double[] _heights; // of cells, metres

        public LinearTile(SeaSettings settings)
        {
            (_size, Cells) = (settings.TileSize, settings.Cells);
            settings.Choppiness = 0;
            var clutter = SeaClutterSettings.On;
            clutter.Seed = settings.Seed;
            Clutter = new SeaClutter(new SeaSurface(settings), 0, new double3(0, 0, 1), clutter);
            var mesh = Clutter.LongWaves.Mesh(0);
            Normals = Enumerable.Range(0, mesh.TriangleCount).Select(t => SeaClutterTests.Normal(mesh, t)).ToArray();
            _heights = Enumerable.Range(0, Cells * Cells).Select(cell => Enumerable.Range(6 * cell, 6)
                .Average(i => (double)mesh.Vertices[mesh.Indices[i]].y)).ToArray();
        }

        /// <summary>Cells that the radar sees: their lines, positions along these, and numbers.</summary>
        /// <param name="grazing">deg.</param>
        /// <param name="isCross">The radar looks across the wind, along X; otherwise against it.</param>
        public IEnumerable<(int Line, int Position, int Cell)> Lit(double grazing, bool isCross)
        {
            double tangent = Math.Tan(math.radians(grazing));
            for (int line = 0; line < Cells; line++)
            {
                // The tile repeats; the radar is where the place along the line is largest.
                double top = double.NegativeInfinity;
                for (int place = 2 * Cells - 1; place >= 0; place--)
                {
                    int cell = isCross ? line * Cells + place % Cells : place % Cells * Cells + line;
                    double height = _heights[cell] - place * _size / Cells * tangent;
                    bool isLit = height >= top;
                    top = Math.Max(top, height);
                    if (isLit && place < Cells)
                        yield return (line, place, cell);
                }
            }
        }
    }
}
