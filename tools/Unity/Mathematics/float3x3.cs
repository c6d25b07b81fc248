using static Unity.Mathematics.math;

namespace Unity.Mathematics;

/// <summary>Angles in radians.</summary>
public partial struct float3x3
{
    public float3x3(float4x4 f4x4) : this(f4x4.c0.xyz, f4x4.c1.xyz, f4x4.c2.xyz)
    {
    }

    public float3x3(quaternion q) : this(mul(q, right()), mul(q, up()), mul(q, forward()))
    {
    }

    public static explicit operator float3x3(float4x4 f4x4) => new(f4x4);

    public static float3x3 AxisAngle(float3 axis, float angle) => new(quaternion.AxisAngle(axis, angle));
    public static float3x3 EulerZXY(float3 xyz) => Euler(xyz);
    public static float3x3 EulerZXY(float x, float y, float z) => Euler(x, y, z);
    public static float3x3 Euler(float3 xyz, RotationOrder order = RotationOrder.ZXY) =>
        new(quaternion.Euler(xyz, order));
    public static float3x3 Euler(float x, float y, float z, RotationOrder order = RotationOrder.ZXY) =>
        Euler(new float3(x, y, z), order);

    public static float3x3 RotateX(float angle)
    {
        sincos(angle, out float s, out float c);
        return new float3x3(1f, 0f, 0f, 0f, c, -s, 0f, s, c);
    }

    public static float3x3 RotateY(float angle)
    {
        sincos(angle, out float s, out float c);
        return new float3x3(c, 0f, s, 0f, 1f, 0f, -s, 0f, c);
    }

    public static float3x3 RotateZ(float angle)
    {
        sincos(angle, out float s, out float c);
        return new float3x3(c, -s, 0f, s, c, 0f, 0f, 0f, 1f);
    }

    public static float3x3 Scale(float s) => Scale(s, s, s);
    public static float3x3 Scale(float3 v) => Scale(v.x, v.y, v.z);
    public static float3x3 Scale(float x, float y, float z) => new(x, 0f, 0f, 0f, y, 0f, 0f, 0f, z);

    /// <summary>Both vectors have length 1 and are not parallel.</summary>
    public static float3x3 LookRotation(float3 forward, float3 up)
    {
        float3 side = normalize(cross(up, forward));
        return new float3x3(side, cross(forward, side), forward);
    }

    /// <summary>For any vectors; no rotation if they do not define one.</summary>
    public static float3x3 LookRotationSafe(float3 forward, float3 up)
    {
        float3 ahead = normalize(forward);
        float3 side = cross(normalize(up), ahead);
        bool usable = lengthsq(forward) > 1e-35f && lengthsq(up) > 1e-35f && lengthsq(side) > 1e-35f
            && isfinite(lengthsq(forward)) && isfinite(lengthsq(up));
        return usable ? LookRotation(ahead, normalize(up)) : identity;
    }
}
