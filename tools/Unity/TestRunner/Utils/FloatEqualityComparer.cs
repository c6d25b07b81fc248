using System.Collections.Generic;

namespace UnityEngine.TestTools.Utils;

public class FloatEqualityComparer : IEqualityComparer<float>
{
    readonly float _allowedError;

    public FloatEqualityComparer(float allowedError) => _allowedError = allowedError;

    public static FloatEqualityComparer Instance { get; } = new(0.0001f);

    public bool Equals(float expected, float actual) => Utils.AreFloatsEqual(expected, actual, _allowedError);

    // Nearly equal values must have equal codes.
    public int GetHashCode(float value) => 0;
}
