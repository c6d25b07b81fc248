using System;
using System.Collections.Generic;

namespace UnityEngine.TestTools.Utils;

public class QuaternionEqualityComparer : IEqualityComparer<Quaternion>
{
    readonly float _allowedError;

    public QuaternionEqualityComparer(float allowedError) => _allowedError = allowedError;

    public static QuaternionEqualityComparer Instance { get; } = new(0.00001f);

    // q and -q are the same rotation.
    public bool Equals(Quaternion expected, Quaternion actual) =>
        Math.Abs(Quaternion.Dot(expected, actual)) > 1f - _allowedError;

    // Nearly equal values must have equal codes.
    public int GetHashCode(Quaternion quaternion) => 0;
}
