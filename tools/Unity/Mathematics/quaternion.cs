using System;
using static Unity.Mathematics.math;

namespace Unity.Mathematics;

/// <summary>Angles in radians.</summary>
[Serializable]
public partial struct quaternion : IEquatable<quaternion>, IFormattable
{
    public float4 value;
    public static readonly quaternion identity = new(0f, 0f, 0f, 1f);

    public quaternion(float x, float y, float z, float w) => value = new float4(x, y, z, w);
    public quaternion(float4 value) => this.value = value;
    public quaternion(float4x4 m) : this(new float3x3(m))
    {
    }

    /// <summary>
    /// From orthonormal columns with determinant 1. The largest component is calculated by a square root, so that none
    /// is lost to cancellation.
    /// </summary>
    public quaternion(float3x3 m)
    {
        float xx = m.c0.x, yy = m.c1.y, zz = m.c2.z;
        float yz = m.c1.z - m.c2.y, zx = m.c2.x - m.c0.z, xy = m.c0.y - m.c1.x;
        float4 q;
        if (xx + yy + zz > 0f)
            q = new float4(yz, zx, xy, 1f + xx + yy + zz);
        else if (xx >= yy && xx >= zz)
            q = new float4(1f + xx - yy - zz, m.c1.x + m.c0.y, m.c2.x + m.c0.z, yz);
        else if (yy >= zz)
            q = new float4(m.c1.x + m.c0.y, 1f + yy - xx - zz, m.c2.y + m.c1.z, zx);
        else
            q = new float4(m.c2.x + m.c0.z, m.c2.y + m.c1.z, 1f + zz - xx - yy, xy);
        value = normalize(q);
    }

    public static implicit operator quaternion(float4 v) => new(v);
    public static implicit operator UnityEngine.Quaternion(quaternion q) =>
        new(q.value.x, q.value.y, q.value.z, q.value.w);
    public static implicit operator quaternion(UnityEngine.Quaternion q) => new(q.x, q.y, q.z, q.w);

    public static quaternion AxisAngle(float3 axis, float angle)
    {
        sincos(0.5f * angle, out float sine, out float cosine);
        return new quaternion(new float4(axis * sine, cosine));
    }

    public static quaternion RotateX(float angle) => AxisAngle(new float3(1f, 0f, 0f), angle);
    public static quaternion RotateY(float angle) => AxisAngle(new float3(0f, 1f, 0f), angle);
    public static quaternion RotateZ(float angle) => AxisAngle(new float3(0f, 0f, 1f), angle);

    // The order of the letters is the order of the rotations about fixed axes.
    public static quaternion EulerXYZ(float3 xyz) => mul(RotateZ(xyz.z), mul(RotateY(xyz.y), RotateX(xyz.x)));
    public static quaternion EulerXZY(float3 xyz) => mul(RotateY(xyz.y), mul(RotateZ(xyz.z), RotateX(xyz.x)));
    public static quaternion EulerYXZ(float3 xyz) => mul(RotateZ(xyz.z), mul(RotateX(xyz.x), RotateY(xyz.y)));
    public static quaternion EulerYZX(float3 xyz) => mul(RotateX(xyz.x), mul(RotateZ(xyz.z), RotateY(xyz.y)));
    public static quaternion EulerZXY(float3 xyz) => mul(RotateY(xyz.y), mul(RotateX(xyz.x), RotateZ(xyz.z)));
    public static quaternion EulerZYX(float3 xyz) => mul(RotateX(xyz.x), mul(RotateY(xyz.y), RotateZ(xyz.z)));
    public static quaternion EulerXYZ(float x, float y, float z) => EulerXYZ(new float3(x, y, z));
    public static quaternion EulerXZY(float x, float y, float z) => EulerXZY(new float3(x, y, z));
    public static quaternion EulerYXZ(float x, float y, float z) => EulerYXZ(new float3(x, y, z));
    public static quaternion EulerYZX(float x, float y, float z) => EulerYZX(new float3(x, y, z));
    public static quaternion EulerZXY(float x, float y, float z) => EulerZXY(new float3(x, y, z));
    public static quaternion EulerZYX(float x, float y, float z) => EulerZYX(new float3(x, y, z));
    public static quaternion Euler(float x, float y, float z, RotationOrder order = RotationOrder.ZXY) =>
        Euler(new float3(x, y, z), order);

    public static quaternion Euler(float3 xyz, RotationOrder order = RotationOrder.ZXY) => order switch
    {
        RotationOrder.XYZ => EulerXYZ(xyz),
        RotationOrder.XZY => EulerXZY(xyz),
        RotationOrder.YXZ => EulerYXZ(xyz),
        RotationOrder.YZX => EulerYZX(xyz),
        RotationOrder.ZXY => EulerZXY(xyz),
        RotationOrder.ZYX => EulerZYX(xyz),
        _ => identity,
    };

    /// <summary>Both vectors have length 1 and are not parallel.</summary>
    public static quaternion LookRotation(float3 forward, float3 up) => new(float3x3.LookRotation(forward, up));

    /// <summary>For any vectors; no rotation if they do not define one.</summary>
    public static quaternion LookRotationSafe(float3 forward, float3 up) => new(float3x3.LookRotationSafe(forward, up));

    public bool Equals(quaternion x) => value.Equals(x.value);
    public override bool Equals(object x) => x is quaternion other && Equals(other);
    public override int GetHashCode() => value.GetHashCode();
    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        return value.ToString(format, formatProvider).Replace("float4(", "quaternion(");
    }
}
