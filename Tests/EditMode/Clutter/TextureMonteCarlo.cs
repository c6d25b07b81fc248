using Glint.Core;

namespace Glint.Tests
{
    /// <summary>
    /// Texture of the echo of a product's sea in cells of 15 x 30 m, with gusts and breakers: its facets by their table,
    /// and the shadow of its heights under a plane wave. The wind blows along Z.
    /// </summary>
    sealed class TextureMonteCarlo
    {
        public const double Tile = 512, Frequency = 10e9, Down = 15, Across = 30;

        readonly LinearTile _tile;
        readonly FacetTable _table;

        public TextureMonteCarlo(SeaSettings settings)
        {
            (settings.TileSize, settings.WindDirectionDegrees) = (Tile, 0);
            _tile = new LinearTile(settings);
            _table = _tile.Clutter.TableAt(Frequency);
        }

        /// <summary>Shapes of the texture.</summary>
        /// <inheritdoc cref="LinearTile.Lit"/>
        public (double HH, double VV) At(double grazing, bool isCross)
        {
            var (clutter, normals) = (_tile.Clutter, _tile.Normals);
            var radar = SeaTestBed.Radar(90 - grazing, isCross ? 90 : 0);
            double breaker = SeaScattering.Breaking(radar.y), facet = Tile / _tile.Cells;
            int down = (int)(Tile / Down), across = (int)(Tile / Across);
            double[] cellsHH = new double[down * across], cellsVV = new double[down * across];
            foreach (var (line, place, cell) in _tile.Lit(grazing, isCross))
            {
                int row = (int)(place * facet / Down), column = (int)(line * facet / Across);
                if (row >= down || column >= across)
                    continue;
                for (int t = 2 * cell; t < 2 * cell + 2; t++)
                {
                    var sigma = clutter.BreakingFacets[t] ? new Sigma0(breaker, breaker, 0)
                        : 1 / normals[t].y * _table.Read(normals[t], radar, clutter.Wind, clutter.LogWinds[cell]);
                    cellsHH[row * across + column] += sigma.HH;
                    cellsVV[row * across + column] += sigma.VV;
                }
            }
            return (ClutterStatistics.ShapeOfTexture(cellsHH), ClutterStatistics.ShapeOfTexture(cellsVV));
        }
    }
}
