using static Unity.Mathematics.math;

namespace Unity.Mathematics;

/// <summary>Angles in radians.</summary>
public partial struct float4x4
{
    public float4x4(float3x3 rotation, float3 translation)
        : this(new float4(rotation.c0, 0f), new float4(rotation.c1, 0f), new float4(rotation.c2, 0f),
            new float4(translation, 1f))
    {
    }

    public float4x4(quaternion rotation, float3 translation) : this(new float3x3(rotation), translation)
    {
    }

    public static implicit operator float4x4(UnityEngine.Matrix4x4 m) =>
        new(m.GetColumn(0), m.GetColumn(1), m.GetColumn(2), m.GetColumn(3));
    public static implicit operator UnityEngine.Matrix4x4(float4x4 m) => new(m.c0, m.c1, m.c2, m.c3);

    /// <summary>Scales first, then rotates, then moves.</summary>
    public static float4x4 TRS(float3 translation, quaternion rotation, float3 scale)
    {
        var turn = new float3x3(rotation);
        return new float4x4(new float3x3(turn.c0 * scale.x, turn.c1 * scale.y, turn.c2 * scale.z), translation);
    }

    public static float4x4 AxisAngle(float3 axis, float angle) => Turn(float3x3.AxisAngle(axis, angle));
    public static float4x4 EulerZXY(float3 xyz) => Euler(xyz);
    public static float4x4 EulerZXY(float x, float y, float z) => Euler(x, y, z);
    public static float4x4 Euler(float3 xyz, RotationOrder order = RotationOrder.ZXY) =>
        Turn(float3x3.Euler(xyz, order));
    public static float4x4 Euler(float x, float y, float z, RotationOrder order = RotationOrder.ZXY) =>
        Euler(new float3(x, y, z), order);
    public static float4x4 RotateX(float angle) => Turn(float3x3.RotateX(angle));
    public static float4x4 RotateY(float angle) => Turn(float3x3.RotateY(angle));
    public static float4x4 RotateZ(float angle) => Turn(float3x3.RotateZ(angle));
    public static float4x4 Scale(float s) => Scale(s, s, s);
    public static float4x4 Scale(float3 scales) => Scale(scales.x, scales.y, scales.z);
    public static float4x4 Scale(float x, float y, float z) => Turn(float3x3.Scale(x, y, z));
    public static float4x4 Translate(float3 vector) => new(new float3x3(1f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f), vector);

    /// <summary>From the viewer's space, +z ahead, to the world.</summary>
    public static float4x4 LookAt(float3 eye, float3 target, float3 up)
    {
        return new float4x4(float3x3.LookRotation(normalize(target - eye), up), eye);
    }

    static float4x4 Turn(float3x3 m) => new(m, new float3(0f));
}
