using System;

namespace Glint.Host.Tests;

/// <summary>Textbook matrices in double precision, the reference for the float types.</summary>
internal static class DoubleMatrix
{
    internal static double[,] Identity() => Fill((row, column) => row == column ? 1 : 0);

    /// <summary>
    /// Right-handed rotation by the right-hand rule. Left-handed axes with the left-hand rule have the same matrix.
    /// </summary>
    internal static double[,] Turn(int axis, double degrees)
    {
        int from = (axis + 1) % 3, to = (axis + 2) % 3;
        (double sine, double cosine) = Math.SinCos(degrees * Math.PI / 180);
        double[,] m = Identity();
        m[from, from] = m[to, to] = cosine;
        m[to, from] = sine;
        m[from, to] = -sine;
        return m;
    }

    internal static double[,] Diagonal(double x, double y, double z) =>
        Fill((row, column) => row != column ? 0 : row switch { 0 => x, 1 => y, 2 => z, _ => 1 });

    internal static double[,] Move(double x, double y, double z)
    {
        double[,] m = Identity();
        (m[0, 3], m[1, 3], m[2, 3]) = (x, y, z);
        return m;
    }

    internal static double[,] Product(params double[][,] factors)
    {
        double[,] product = Identity();
        foreach (double[,] factor in factors)
        {
            double[,] left = product;
            product = Fill((row, column) =>
            {
                double sum = 0;
                for (int k = 0; k < 4; k++)
                    sum += left[row, k] * factor[k, column];
                return sum;
            });
        }
        return product;
    }

    internal static (double X, double Y, double Z, double W) Apply(double[,] m, double x, double y, double z, double w)
    {
        double Row(int i) => m[i, 0] * x + m[i, 1] * y + m[i, 2] * z + m[i, 3] * w;
        return (Row(0), Row(1), Row(2), Row(3));
    }

    internal static double[,] Fill(Func<int, int, double> cell)
    {
        var m = new double[4, 4];
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
                m[row, column] = cell(row, column);
        }
        return m;
    }
}
