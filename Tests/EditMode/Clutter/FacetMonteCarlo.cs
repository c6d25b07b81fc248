using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// Clutter of a tile of linear waves in facets of 0.5 m, at 10 GHz against the wind: every facet scatters what the
    /// table says if a plane wave lights it, and the fraction of facets with the largest downward acceleration breaks.
    /// </summary>
    sealed class FacetMonteCarlo
    {
        const double FacetSide = 0.5;

        // A cell is 15 m in range and 30 m across.
        const int CellDown = 30, CellAcross = 60;

        readonly SeaTestBed _bed;
        readonly FacetTable _table;
        readonly double _breaking;
        readonly int _cells;
        readonly List<Tile> _tiles = new List<Tile>();
        readonly Dictionary<double, Figures> _figures = new Dictionary<double, Figures>();

        public FacetMonteCarlo(double wind, int cells, int seeds)
        {
            _bed = new SeaTestBed(wind);
            double cut = Math.PI / FacetSide;
            _table = new FacetTable(_bed.Scattering, _bed.Spectrum.SlopeVariance(SeaTestBed.LongestWave, cut),
                _bed.Slopes(cut));
            _breaking = WhitecapLaw.Default.Fraction(wind);
            _cells = cells;
            for (int seed = 1; seed <= seeds; seed++)
                _tiles.Add(new Tile(_bed.Spectrum, cells, seed));
        }

        /// <summary>All figures at a grazing angle.</summary>
        public Figures At(double grazing)
        {
            if (!_figures.TryGetValue(grazing, out var figures))
                _figures.Add(grazing, figures = Compute(grazing));
            return figures;
        }

        Figures Compute(double grazing)
        {
            var sums = new Figures();
            var horizontal = new List<double>();
            var vertical = new List<double>();
            foreach (var tile in _tiles)
                Add(tile, grazing, sums, horizontal, vertical);
            sums.Divide(_tiles.Count * _cells * _cells);
            sums.ShapeHH = ClutterStatistics.ShapeOfTexture(horizontal);
            sums.ShapeVV = ClutterStatistics.ShapeOfTexture(vertical);
            return sums;
        }

        /// <summary>Fraction lit by Smith's formula.</summary>
        public double SmithFraction(double grazing) => ClutterGeometry.LitFraction(math.radians(grazing), Math.Sqrt(
            _bed.Spectrum.SlopeVariance(SeaTestBed.LongestWave, Math.PI / FacetSide).x));

        void Add(Tile tile, double grazing, Figures sums, List<double> horizontal, List<double> vertical)
        {
            var radar = SeaTestBed.Radar(90 - grazing, 0);
            var lit = Lit(tile.Heights, Math.Tan(math.radians(grazing)));
            double breaker = SeaScattering.Breaking(radar.y), limit = tile.Quantile(_breaking);
            int across = _cells / CellAcross, down = _cells / CellDown;
            double[] cellsHH = new double[across * down], cellsVV = new double[across * down];
            for (int z = 0; z < _cells; z++)
                for (int x = 0; x < _cells; x++)
                {
                    int at = z * _cells + x;
                    var sigma = _table.Read(tile.Normal(at), radar, new double3(0, 0, 1));
                    bool breaks = tile.Accelerations[at] < limit;
                    double hh = breaks ? breaker : sigma.HH;
                    sums.Add(sigma, lit[at], hh, breaks ? breaker : sigma.VV);
                    if (!lit[at] || x >= across * CellAcross || z >= down * CellDown)
                        continue;
                    int cell = z / CellDown * across + x / CellAcross;
                    cellsHH[cell] += hh;
                    cellsVV[cell] += sigma.VV;
                }
            horizontal.AddRange(cellsHH);
            vertical.AddRange(cellsVV);
        }

        // A facet is lit if none nearer to the radar, which is along Z, rises above the ray from it; the tile repeats.
        bool[] Lit(double[] heights, double tangent)
        {
            var lit = new bool[heights.Length];
            for (int x = 0; x < _cells; x++)
            {
                double top = double.NegativeInfinity;
                for (int z = 2 * _cells - 1; z >= 0; z--)
                {
                    int at = z % _cells * _cells + x;
                    double height = heights[at] - z * FacetSide * tangent;
                    lit[at] = height >= top;
                    top = Math.Max(top, height);
                }
            }
            return lit;
        }

        /// <summary>Means of sigma0, fraction lit, and shapes of the cells' textures.</summary>
        public sealed class Figures
        {
            public double HH, VV, LitHH, LitVV, BreakingHH, BreakingVV, LitFraction, ShapeHH, ShapeVV;

            public void Add(in Sigma0 sigma, bool isLit, double hh, double vv)
            {
                HH += sigma.HH;
                VV += sigma.VV;
                if (!isLit)
                    return;
                LitFraction++;
                LitHH += sigma.HH;
                LitVV += sigma.VV;
                BreakingHH += hh;
                BreakingVV += vv;
            }

            public void Divide(double count)
            {
                HH /= count;
                VV /= count;
                LitHH /= count;
                LitVV /= count;
                BreakingHH /= count;
                BreakingVV /= count;
                LitFraction /= count;
            }
        }

        // Waves along Z and in its half-plane alone.
        sealed class Tile
        {
            public readonly double[] Heights, Accelerations;
            readonly double[] _slopesX, _slopesZ;

            public Tile(ElfouhailyFromPaper spectrum, int cells, int seed)
            {
                var random = new System.Random(seed);
                int reach = cells / 2 - 1;
                double step = 2 * Math.PI / (cells * FacetSide);
                var (heights, accelerations, slopesX, slopesZ) = (new WaveCoefficients(reach),
                    new WaveCoefficients(reach), new WaveCoefficients(reach), new WaveCoefficients(reach));
                for (int row = 1; row <= reach; row++)
                    for (int column = -reach; column <= reach; column++)
                    {
                        double length = Math.Sqrt((double)row * row + (double)column * column);
                        // The corners are shorter waves, which the table has.
                        if (length > cells / 2)
                            continue;
                        double k = step * length;
                        double size = step * Math.Sqrt(spectrum.Density(k, row / length) / 2);
                        var (real, imaginary) = (size * Normal(random), size * Normal(random));
                        int at = heights.IndexOf(column, row);
                        (heights.Real[at], heights.Imaginary[at]) = (real, imaginary);
                        double factor = -9.81 * k;
                        (accelerations.Real[at], accelerations.Imaginary[at]) = (factor * real, factor * imaginary);
                        (slopesX.Real[at], slopesX.Imaginary[at]) =
                            (-step * column * imaginary, step * column * real);
                        (slopesZ.Real[at], slopesZ.Imaginary[at]) = (-step * row * imaginary, step * row * real);
                    }
                var sum = new FourierSum(cells);
                (Heights, Accelerations) = (sum.Sum(heights), sum.Sum(accelerations));
                (_slopesX, _slopesZ) = (sum.Sum(slopesX), sum.Sum(slopesZ));
            }

            public double3 Normal(int at) => math.normalize(new double3(-_slopesX[at], 1, -_slopesZ[at]));

            public double Quantile(double fraction)
            {
                var sorted = Accelerations.ToArray();
                Array.Sort(sorted);
                return sorted[(int)(fraction * sorted.Length)];
            }

            static double Normal(System.Random random) => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble()))
                * Math.Cos(2 * Math.PI * random.NextDouble());
        }
    }
}
