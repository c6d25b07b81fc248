using System;

namespace UnityEngine.TestTools.Utils;

public static class Utils
{
    // Relative to the larger of the two, but at least to 1.
    public static bool AreFloatsEqual(float expected, float actual, float epsilon)
        => expected == actual
            || Math.Abs(actual - expected) <= epsilon * Math.Max(Math.Max(Math.Abs(actual), Math.Abs(expected)), 1f);

    public static bool AreFloatsEqualAbsoluteError(float expected, float actual, float allowedAbsoluteError)
        => Math.Abs(actual - expected) <= allowedAbsoluteError;
}
