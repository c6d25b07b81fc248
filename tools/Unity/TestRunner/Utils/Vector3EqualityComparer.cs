using System.Collections.Generic;

namespace UnityEngine.TestTools.Utils;

public class Vector3EqualityComparer : IEqualityComparer<Vector3>
{
    readonly float _allowedError;

    public Vector3EqualityComparer(float allowedError) => _allowedError = allowedError;

    public static Vector3EqualityComparer Instance { get; } = new(0.0001f);

    public bool Equals(Vector3 expected, Vector3 actual)
        => Utils.AreFloatsEqualAbsoluteError(expected.x, actual.x, _allowedError)
            && Utils.AreFloatsEqualAbsoluteError(expected.y, actual.y, _allowedError)
            && Utils.AreFloatsEqualAbsoluteError(expected.z, actual.z, _allowedError);

    // Nearly equal values must have equal codes.
    public int GetHashCode(Vector3 vec3) => 0;
}
