namespace Glint.Core
{
    /// <summary>The sum by a fast Fourier transform. Cells must be a power of two, above twice the reach.</summary>
    sealed class FourierSum : IWaveSum
    {
        readonly int _cells;
        readonly int[] _reversed;

        // e^(2 pi i n / cells), n below half of the cells.
        readonly double[] _cosines, _sines;

        public FourierSum(int cells)
        {
            _cells = cells;
            _reversed = new int[cells];
            for (int i = 1; i < cells; i++)
                _reversed[i] = _reversed[i / 2] / 2 + (i % 2) * cells / 2;
            _cosines = new double[cells / 2];
            _sines = new double[cells / 2];
            for (int n = 0; n < cells / 2; n++)
                (_sines[n], _cosines[n]) = PortableMath.SinCos((double)n / cells);
        }

        public double[] Sum(WaveCoefficients waves)
        {
            double[] real = new double[_cells * _cells], imaginary = new double[real.Length];
            for (int row = 0; row <= waves.Reach; row++)
            {
                // Both transforms take their input in bit-reversed order; rows above the reach stay 0.
                int to = _reversed[row] * _cells;
                for (int column = -waves.Reach; column <= waves.Reach; column++)
                {
                    int from = waves.IndexOf(column, row), at = to + _reversed[column & (_cells - 1)];
                    real[at] = waves.Real[from];
                    imaginary[at] = waves.Imaginary[from];
                }
                Transform(real, imaginary, to, 1, 1);
            }
            Transform(real, imaginary, 0, _cells, _cells);
            for (int i = 0; i < real.Length; i++)
                real[i] *= 2;
            return real;
        }

        // Radix 2, in place. An element has this width: one number along x, a whole row along z.
        void Transform(double[] real, double[] imaginary, int start, int stride, int width)
        {
            for (int half = 1; half < _cells; half *= 2)
                for (int block = 0; block < _cells; block += 2 * half)
                    for (int n = 0; n < half; n++)
                    {
                        double cosine = _cosines[n * (_cells / 2 / half)], sine = _sines[n * (_cells / 2 / half)];
                        int a = start + (block + n) * stride, b = a + half * stride;
                        for (int end = a + width; a < end; a++, b++)
                        {
                            double turnedReal = real[b] * cosine - imaginary[b] * sine,
                                turnedImaginary = real[b] * sine + imaginary[b] * cosine;
                            real[b] = real[a] - turnedReal;
                            imaginary[b] = imaginary[a] - turnedImaginary;
                            real[a] += turnedReal;
                            imaginary[a] += turnedImaginary;
                        }
                    }
        }
    }
}
