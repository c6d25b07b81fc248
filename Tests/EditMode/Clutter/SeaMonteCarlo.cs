using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// Mean echo of a product's sea of 512 m in facets of 0.5 m: its facets by their table, its breakers by the formula
    /// of breaking waves, and the shadow of its heights under a plane wave.
    /// </summary>
    sealed class SeaMonteCarlo
    {
        const double Tile = 512;
        const int Cells = 1024;

        readonly SeaClutter _clutter;
        readonly FacetTable _table;
        readonly double3[] _normals; // two a cell
        readonly double[] _heights; // of cells, metres

        public SeaMonteCarlo(double wind, double frequency, int seed)
        {
            var settings = SeaClutterTests.Waves(wind, Tile, Cells);
            (settings.Seed, settings.Choppiness) = (seed, 0);
            _clutter = new SeaClutter(new SeaSurface(settings), 0, new double3(0, 0, 1), SeaClutterSettings.On);
            _table = _clutter.TableAt(frequency);
            var mesh = _clutter.LongWaves.Mesh(0);
            _normals = Enumerable.Range(0, mesh.TriangleCount).Select(t => SeaClutterTests.Normal(mesh, t)).ToArray();
            _heights = Enumerable.Range(0, Cells * Cells).Select(cell => Enumerable.Range(6 * cell, 6)
                .Average(i => (double)mesh.Vertices[mesh.Indices[i]].y)).ToArray();
        }

        /// <summary>Sigma0 and the fraction of the surface that is lit.</summary>
        /// <param name="grazing">deg.</param>
        /// <param name="isCross">The radar looks across the wind, along X; otherwise against it.</param>
        public (Sigma0 Sigma, double Lit) At(double grazing, bool isCross)
        {
            var radar = SeaTestBed.Radar(90 - grazing, isCross ? 90 : 0);
            double breaker = SeaScattering.Breaking(radar.y), tangent = Math.Tan(math.radians(grazing));
            var breaking = new Sigma0(breaker, breaker, 0);
            var sum = default(Sigma0);
            int lit = 0;
            for (int line = 0; line < Cells; line++)
            {
                // The tile repeats; the radar is where the place along the line is largest.
                double top = double.NegativeInfinity;
                for (int place = 2 * Cells - 1; place >= 0; place--)
                {
                    int cell = isCross ? line * Cells + place % Cells : place % Cells * Cells + line;
                    double height = _heights[cell] - place * Tile / Cells * tangent;
                    bool isLit = height >= top;
                    top = Math.Max(top, height);
                    if (!isLit || place >= Cells)
                        continue;
                    lit++;
                    for (int t = 2 * cell; t < 2 * cell + 2; t++)
                        sum += _clutter.BreakingFacets[t] ? breaking : 1 / _normals[t].y
                            * _table.Read(_normals[t], radar, _clutter.Wind);
                }
            }
            return (1.0 / (2 * Cells * Cells) * sum, (double)lit / (Cells * Cells));
        }
    }
}
