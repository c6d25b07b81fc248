namespace Glint.Core
{
    /// <summary>The sum for any number of cells a side: along x, then along z.</summary>
    sealed class TrigonometricSum : IWaveSum
    {
        readonly int _cells;

        // cos and sin of 2 pi n i / cells at n * cells + i.
        readonly double[] _cosines, _sines;

        public TrigonometricSum(int cells, int reach)
        {
            _cells = cells;
            _cosines = new double[(reach + 1) * cells];
            _sines = new double[_cosines.Length];
            for (int n = 0; n <= reach; n++)
                for (int i = 0; i < cells; i++)
                    (_sines[n * cells + i], _cosines[n * cells + i]) =
                        PortableMath.SinCos((double)((long)n * i % cells) / cells);
        }

        public double[] Sum(WaveCoefficients waves)
        {
            double[] real = new double[(waves.Reach + 1) * _cells], imaginary = new double[real.Length];
            for (int row = 0; row <= waves.Reach; row++)
                SumAlongX(waves, row, real, imaginary);

            var field = new double[_cells * _cells];
            for (int z = 0; z < _cells; z++)
                for (int row = 0; row <= waves.Reach; row++)
                {
                    double cosine = 2 * _cosines[row * _cells + z], sine = 2 * _sines[row * _cells + z];
                    for (int x = 0, to = z * _cells, from = row * _cells; x < _cells; x++)
                        field[to + x] += real[from + x] * cosine - imaginary[from + x] * sine;
                }
            return field;
        }

        // Columns n and -n together: their cosines are equal, their sines opposite.
        void SumAlongX(WaveCoefficients waves, int row, double[] real, double[] imaginary)
        {
            int to = row * _cells;
            for (int n = 0; n <= waves.Reach; n++)
            {
                int plus = waves.IndexOf(n, row), minus = waves.IndexOf(-n, row);
                double half = n == 0 ? 0.5 : 1;
                double sumReal = half * (waves.Real[plus] + waves.Real[minus]),
                    sumImaginary = half * (waves.Imaginary[plus] + waves.Imaginary[minus]);
                double differenceReal = waves.Real[plus] - waves.Real[minus],
                    differenceImaginary = waves.Imaginary[plus] - waves.Imaginary[minus];
                for (int x = 0, at = n * _cells; x < _cells; x++)
                {
                    double cosine = _cosines[at + x], sine = _sines[at + x];
                    real[to + x] += sumReal * cosine - differenceImaginary * sine;
                    imaginary[to + x] += sumImaginary * cosine + differenceReal * sine;
                }
            }
        }
    }

    /// <summary>
    /// Coefficients c of a real field over a tile, 2 Re sum c e^(2 pi i (column x + row z)),
    /// x and z in tiles from its corner.
    /// </summary>
    sealed class WaveCoefficients
    {
        /// <param name="reach">Largest column and row; the smallest are -reach and 0.</param>
        public WaveCoefficients(int reach)
        {
            Reach = reach;
            Real = new double[(reach + 1) * Columns];
            Imaginary = new double[Real.Length];
        }

        public int Reach { get; }

        public int Columns => 2 * Reach + 1;

        /// <summary>Row by row, each from column -Reach.</summary>
        public double[] Real { get; }

        public double[] Imaginary { get; }

        public int IndexOf(int column, int row) => row * Columns + column + Reach;
    }

    /// <summary>Sums waves at the corners of the square cells of a tile.</summary>
    interface IWaveSum
    {
        /// <summary>The field at x, z = i / cells of the tile: cells a row, rows along z.</summary>
        double[] Sum(WaveCoefficients waves);
    }
}
