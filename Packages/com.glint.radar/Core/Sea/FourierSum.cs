namespace Glint.Core
{
    /// <summary>The sum by a fast Fourier transform. Cells must be a power of two, above twice the reach.</summary>
    sealed class FourierSum : IWaveSum
    {
        readonly int _cells;
        readonly FourierTransform _transform;

        public FourierSum(int cells)
        {
            _cells = cells;
            _transform = new FourierTransform(cells);
        }

        public double[] Sum(WaveCoefficients waves)
        {
            double[] real = new double[_cells * _cells], imaginary = new double[real.Length];
            int[] reversed = _transform.Reversed;
            for (int row = 0; row <= waves.Reach; row++)
            {
                // Rows above the reach stay 0.
                int to = reversed[row] * _cells;
                for (int column = -waves.Reach; column <= waves.Reach; column++)
                {
                    int from = waves.IndexOf(column, row), at = to + reversed[column & (_cells - 1)];
                    real[at] = waves.Real[from];
                    imaginary[at] = waves.Imaginary[from];
                }
                _transform.TransformReversed(real, imaginary, to, 1, 1);
            }
            _transform.TransformReversed(real, imaginary, 0, _cells, _cells);
            for (int i = 0; i < real.Length; i++)
                real[i] *= 2;
            return real;
        }
    }
}
