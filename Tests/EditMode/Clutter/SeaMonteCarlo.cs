using Glint.Core;

namespace Glint.Tests
{
    /// <summary>
    /// Mean echo of a product's sea of 512 m in facets of 0.5 m: its facets by their table, its breakers by the formula
    /// of breaking waves, and the shadow of its heights under a plane wave.
    /// </summary>
    sealed class SeaMonteCarlo
    {
        readonly LinearTile _tile;
        readonly FacetTable _table;

        public SeaMonteCarlo(double wind, double frequency, int seed)
        {
            var settings = SeaClutterTests.Waves(wind, 512, 1024);
            settings.Seed = seed;
            _tile = new LinearTile(settings);
            _table = _tile.Clutter.TableAt(frequency);
        }

        /// <summary>Sigma0 and the fraction of the surface that is lit.</summary>
        /// <inheritdoc cref="LinearTile.Lit"/>
        public (Sigma0 Sigma, double Lit) At(double grazing, bool isCross)
        {
            var radar = SeaTestBed.Radar(90 - grazing, isCross ? 90 : 0);
            double breaker = SeaScattering.Breaking(radar.y), cells = (double)_tile.Cells * _tile.Cells;
            var breaking = new Sigma0(breaker, breaker, 0);
            var sum = default(Sigma0);
            int lit = 0;
            foreach (var (_, _, cell) in _tile.Lit(grazing, isCross))
            {
                lit++;
                for (int t = 2 * cell; t < 2 * cell + 2; t++)
                    sum += _tile.Clutter.BreakingFacets[t] ? breaking : 1 / _tile.Normals[t].y
                        * _table.Read(_tile.Normals[t], radar, _tile.Clutter.Wind);
            }
            return (1 / (2 * cells) * sum, lit / cells);
        }
    }
}
