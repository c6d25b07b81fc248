using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>Comparisons with an absolute tolerance.</summary>
internal static class Near
{
    internal static void Point(Vector3 actual, double x, double y, double z, double tolerance)
    {
        string where = $"{actual.ToString("G9")} for ({x}, {y}, {z})";
        Assert.That(actual.x, Is.EqualTo(x).Within(tolerance), where);
        Assert.That(actual.y, Is.EqualTo(y).Within(tolerance), where);
        Assert.That(actual.z, Is.EqualTo(z).Within(tolerance), where);
    }

    internal static void Matrix(Matrix4x4 actual, double[,] expected, double tolerance)
    {
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
                Assert.That(actual[row, column], Is.EqualTo(expected[row, column]).Within(tolerance),
                    $"row {row}, column {column}");
        }
    }
}
