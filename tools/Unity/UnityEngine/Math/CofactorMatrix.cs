using System;
using UnityEngine;

namespace Glint.Host;

/// <summary>Cofactors of a 4x4 matrix, row by row, in double precision.</summary>
internal static class CofactorMatrix
{
    /// <summary>Returns the determinant.</summary>
    internal static double Of(in Matrix4x4 m, Span<double> cofactors)
    {
        double determinant = 0.0;
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
                cofactors[row * 4 + column] = Of(m, row, column);
            determinant += m[row, 0] * cofactors[row * 4];
        }
        return determinant;
    }

    static double Of(in Matrix4x4 m, int row, int column)
    {
        int r0 = row == 0 ? 1 : 0, r1 = row <= 1 ? 2 : 1, r2 = row <= 2 ? 3 : 2;
        int c0 = column == 0 ? 1 : 0, c1 = column <= 1 ? 2 : 1, c2 = column <= 2 ? 3 : 2;
        double minor = m[r0, c0] * ((double)m[r1, c1] * m[r2, c2] - (double)m[r1, c2] * m[r2, c1])
            - m[r0, c1] * ((double)m[r1, c0] * m[r2, c2] - (double)m[r1, c2] * m[r2, c0])
            + m[r0, c2] * ((double)m[r1, c0] * m[r2, c1] - (double)m[r1, c1] * m[r2, c0]);
        return ((row + column) & 1) == 0 ? minor : -minor;
    }
}
