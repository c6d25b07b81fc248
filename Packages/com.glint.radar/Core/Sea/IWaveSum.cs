namespace Glint.Core
{
    /// <summary>Sums waves at the corners of the square cells of a tile.</summary>
    interface IWaveSum
    {
        /// <summary>The field at x, z = i / cells of the tile: cells a row, rows along z.</summary>
        double[] Sum(WaveCoefficients waves);
    }
}
