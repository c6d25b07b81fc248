using System;
using System.Linq;
using System.Numerics;
using Glint.Core;

namespace Glint.Tests
{
    /// <summary>Plain Fourier sums with System.Math, and measures of a sea's mesh from them.</summary>
    static class SeaFields
    {
        /// <summary>Settings of a small Phillips sea for a wind speed.</summary>
        public static SeaSettings Settings(int grid = 16, int cells = 24, double wind = 9)
        {
            var settings = SeaSettings.Default;
            (settings.Kind, settings.SignificantWaveHeight, settings.Fetch) = (SeaSpectrumKind.Phillips, 2, 1e5);
            (settings.GridSize, settings.Cells, settings.WindSpeed) = (grid, cells, wind);
            return settings;
        }

        /// <summary>2 Re sum c e^(2 pi i (column x + row z) / cells), term by term.</summary>
        public static double[] Sum(WaveCoefficients waves, int cells)
        {
            var field = new double[cells * cells];
            for (int z = 0; z < cells; z++)
                for (int x = 0; x < cells; x++)
                    for (int row = 0; row <= waves.Reach; row++)
                        for (int column = -waves.Reach; column <= waves.Reach; column++)
                        {
                            int at = waves.IndexOf(column, row);
                            var wave = new Complex(waves.Real[at], waves.Imaginary[at])
                                * Complex.FromPolarCoordinates(1, 2 * Math.PI * (column * x + row * z) / cells);
                            field[z * cells + x] += 2 * wave.Real;
                        }
            return field;
        }

        /// <summary>Heights of a mesh at its cells, without the last row and column, which repeat the first.</summary>
        public static double[] Heights(TriangleMesh mesh, int cells) =>
            Enumerable.Range(0, cells * cells)
                .Select(i => (double)mesh.Vertices[i / cells * (cells + 1) + i % cells].y).ToArray();

        /// <summary>
        /// Amplitude of a complex wave in a field: the mean of field x e^(-2 pi i (column x + row z) / cells).
        /// </summary>
        public static Complex Amplitude(double[] field, int cells, int column, int row)
        {
            Complex sum = 0;
            for (int z = 0; z < cells; z++)
                for (int x = 0; x < cells; x++)
                    sum += field[z * cells + x] * Complex.FromPolarCoordinates(1,
                        -2 * Math.PI * ((column * x + row * z) % cells) / cells);
            return sum / (cells * cells);
        }

        /// <summary>
        /// Variance of the waves of each row and column from -reach to reach, [row + reach, column + reach].
        /// </summary>
        public static double[,] Variances(double[] field, int cells, int reach)
        {
            // Along x first, then along z.
            var turns = Enumerable.Range(0, cells)
                .Select(i => Complex.FromPolarCoordinates(1, -2 * Math.PI * i / cells)).ToArray();
            int columns = 2 * reach + 1;
            var alongX = new Complex[cells, columns];
            for (int z = 0; z < cells; z++)
                for (int column = -reach; column <= reach; column++)
                    for (int x = 0; x < cells; x++)
                        alongX[z, column + reach] += field[z * cells + x] * turns[(column * x % cells + cells) % cells];
            var variances = new double[columns, columns];
            for (int row = -reach; row <= reach; row++)
                for (int column = 0; column < columns; column++)
                {
                    Complex sum = 0;
                    for (int z = 0; z < cells; z++)
                        sum += alongX[z, column] * turns[(row * z % cells + cells) % cells];
                    sum /= cells * cells;
                    variances[row + reach, column] = sum.Real * sum.Real + sum.Imaginary * sum.Imaginary;
                }
            return variances;
        }
    }
}
