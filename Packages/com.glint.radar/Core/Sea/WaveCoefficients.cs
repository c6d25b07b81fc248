namespace Glint.Core
{
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
}
