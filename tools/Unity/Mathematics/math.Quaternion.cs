namespace Unity.Mathematics;

public static partial class math
{
    public static quaternion quaternion(float x, float y, float z, float w) => new quaternion(x, y, z, w);
    public static quaternion quaternion(float4 value) => new quaternion(value);
    public static quaternion quaternion(float3x3 m) => new quaternion(m);
    public static quaternion quaternion(float4x4 m) => new quaternion(m);

    public static quaternion conjugate(quaternion q) => new quaternion(q.value * new float4(-1f, -1f, -1f, 1f));
    public static quaternion inverse(quaternion q) => new quaternion(rcp(dot(q.value, q.value)) * conjugate(q).value);
    public static float dot(quaternion a, quaternion b) => dot(a.value, b.value);
    public static float length(quaternion q) => length(q.value);
    public static float lengthsq(quaternion q) => lengthsq(q.value);
    public static quaternion normalize(quaternion q) => new quaternion(normalize(q.value));
    public static quaternion normalizesafe(quaternion q) => normalizesafe(q, new quaternion(0f, 0f, 0f, 1f));
    public static quaternion normalizesafe(quaternion q, quaternion defaultvalue) =>
        new quaternion(normalizesafe(q.value, defaultvalue.value));

    /// <summary>b is applied first.</summary>
    public static quaternion mul(quaternion a, quaternion b)
    {
        float4 p = a.value, q = b.value;
        return new quaternion(
            new float4(p.w * q.xyz + q.w * p.xyz + cross(p.xyz, q.xyz), p.w * q.w - dot(p.xyz, q.xyz)));
    }

    public static float3 mul(quaternion q, float3 v)
    {
        float3 t = 2f * cross(q.value.xyz, v);
        return v + q.value.w * t + cross(q.value.xyz, t);
    }

    public static float3 rotate(quaternion q, float3 v) => mul(q, v);
    public static float3 forward(quaternion q) => mul(q, new float3(0f, 0f, 1f));

    public static quaternion nlerp(quaternion q1, quaternion q2, float t)
    {
        float4 end = dot(q1, q2) < 0f ? -q2.value : q2.value;
        return new quaternion(normalize(lerp(q1.value, end, t)));
    }

    public static quaternion slerp(quaternion q1, quaternion q2, float t)
    {
        float cosine = dot(q1, q2);
        float4 end = cosine < 0f ? -q2.value : q2.value;
        cosine = abs(cosine);
        if (cosine > 0.9995f)
            return nlerp(q1, q2, t);
        float angle = acos(cosine);
        return new quaternion((q1.value * sin(angle * (1f - t)) + end * sin(angle * t)) * rcp(sin(angle)));
    }

    public static float angle(quaternion q1, quaternion q2)
    {
        float4 turn = normalize(mul(conjugate(q1), q2)).value;
        return 2f * asin(min(length(turn.xyz), 1f));
    }

    public static float3 up() => new float3(0f, 1f, 0f);
    public static float3 down() => new float3(0f, -1f, 0f);
    public static float3 forward() => new float3(0f, 0f, 1f);
    public static float3 back() => new float3(0f, 0f, -1f);
    public static float3 left() => new float3(-1f, 0f, 0f);
    public static float3 right() => new float3(1f, 0f, 0f);

    public static float3x3 float3x3(float4x4 f4x4) => new float3x3(f4x4);
    public static float3x3 float3x3(quaternion rotation) => new float3x3(rotation);
    public static float4x4 float4x4(float3x3 rotation, float3 translation) => new float4x4(rotation, translation);
    public static float4x4 float4x4(quaternion rotation, float3 translation) => new float4x4(rotation, translation);
}
