using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// Texture of the echo of a product's sea in cells of 15 x 30 m, with gusts and breakers: its facets by their table,
    /// and the shadow of its heights under a plane wave. The wind blows along Z.
    /// </summary>
    sealed class TextureMonteCarlo
    {
        public const double Tile = 512, Frequency = 10e9, Down = 15, Across = 30;

        readonly SeaClutter _clutter;
        readonly FacetTable _table;
        readonly double3[] _normals; // two a cell of the mesh
        readonly double[] _heights; // of these cells, metres
        readonly int _cells;

        public TextureMonteCarlo(SeaSettings settings)
        {
            (settings.TileSize, settings.Choppiness, settings.WindDirectionDegrees) = (Tile, 0, 0);
            _cells = settings.Cells;
            _clutter = new SeaClutter(new SeaSurface(settings), 0, new double3(0, 0, 1), SeaClutterSettings.On);
            _table = _clutter.TableAt(Frequency);
            var mesh = _clutter.LongWaves.Mesh(0);
            _normals = Enumerable.Range(0, mesh.TriangleCount).Select(t => SeaClutterTests.Normal(mesh, t)).ToArray();
            _heights = Enumerable.Range(0, _cells * _cells).Select(cell => Enumerable.Range(6 * cell, 6)
                .Average(i => (double)mesh.Vertices[mesh.Indices[i]].y)).ToArray();
        }

        /// <summary>Shapes of the texture.</summary>
        /// <param name="grazing">deg.</param>
        /// <param name="isCross">The radar looks across the wind, along X; otherwise against it.</param>
        public (double HH, double VV) At(double grazing, bool isCross)
        {
            var radar = SeaTestBed.Radar(90 - grazing, isCross ? 90 : 0);
            double breaker = SeaScattering.Breaking(radar.y), tangent = Math.Tan(math.radians(grazing)),
                facet = Tile / _cells;
            int down = (int)(Tile / Down), across = (int)(Tile / Across);
            double[] cellsHH = new double[down * across], cellsVV = new double[down * across];
            for (int line = 0; line < _cells; line++)
            {
                // The tile repeats; the radar is where the place along the line is largest.
                double top = double.NegativeInfinity;
                for (int place = 2 * _cells - 1; place >= 0; place--)
                {
                    int cell = isCross ? line * _cells + place % _cells : place % _cells * _cells + line;
                    double height = _heights[cell] - place * facet * tangent;
                    bool isLit = height >= top;
                    top = Math.Max(top, height);
                    int row = (int)(place * facet / Down), column = (int)(line * facet / Across);
                    if (!isLit || place >= _cells || row >= down || column >= across)
                        continue;
                    for (int t = 2 * cell; t < 2 * cell + 2; t++)
                    {
                        var sigma = _clutter.BreakingFacets[t] ? new Sigma0(breaker, breaker, 0)
                            : 1 / _normals[t].y
                                * _table.Read(_normals[t], radar, _clutter.Wind, _clutter.LogWinds[cell]);
                        cellsHH[row * across + column] += sigma.HH;
                        cellsVV[row * across + column] += sigma.VV;
                    }
                }
            }
            return (ClutterStatistics.ShapeOfTexture(cellsHH), ClutterStatistics.ShapeOfTexture(cellsVV));
        }
    }
}
