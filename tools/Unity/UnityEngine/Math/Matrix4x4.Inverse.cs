using System;
using Glint.Host;

namespace UnityEngine;

public partial struct Matrix4x4
{
    public static float Determinant(Matrix4x4 m)
    {
        Span<double> cofactors = stackalloc double[16];
        return (float)CofactorMatrix.Of(m, cofactors);
    }

    /// <summary>All zero for a singular matrix.</summary>
    public static Matrix4x4 Inverse(Matrix4x4 m)
    {
        Span<double> cofactors = stackalloc double[16];
        double determinant = CofactorMatrix.Of(m, cofactors);
        Matrix4x4 result = zero;
        if (determinant == 0.0)
            return result;
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
                result[row, column] = (float)(cofactors[column * 4 + row] / determinant);
        }
        return result;
    }

    public static bool Inverse3DAffine(Matrix4x4 input, ref Matrix4x4 result)
    {
        bool affine = input.m30 == 0f && input.m31 == 0f && input.m32 == 0f && input.m33 == 1f;
        if (!affine || Determinant(input) == 0f)
            return false;
        result = Inverse(input);
        return true;
    }

    public static Matrix4x4 Transpose(Matrix4x4 m) => new(m.GetRow(0), m.GetRow(1), m.GetRow(2), m.GetRow(3));
}
