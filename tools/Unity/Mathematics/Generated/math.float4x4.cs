// Written by generate.py.
namespace Unity.Mathematics;

public static partial class math
{
    public static float4x4 float4x4(float4 c0, float4 c1, float4 c2, float4 c3) => new float4x4(c0, c1, c2, c3);
    public static float4x4 float4x4(float v) => new float4x4(v);

    public static float4x4 float4x4(float m00, float m01, float m02, float m03, float m10, float m11, float m12, float m13, float m20, float m21, float m22, float m23, float m30, float m31, float m32, float m33)
    {
        return new float4x4(m00, m01, m02, m03, m10, m11, m12, m13, m20, m21, m22, m23, m30, m31, m32, m33);
    }

    public static float4 mul(float4x4 a, float4 b) => a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3 * b.w;
    public static float4 mul(float4 a, float4x4 b) => new float4(dot(a, b.c0), dot(a, b.c1), dot(a, b.c2), dot(a, b.c3));
    public static float4x4 mul(float4x4 a, float4x4 b) => new float4x4(mul(a, b.c0), mul(a, b.c1), mul(a, b.c2), mul(a, b.c3));
    public static float4x4 transpose(float4x4 v) => new float4x4(new float4(v.c0.x, v.c1.x, v.c2.x, v.c3.x), new float4(v.c0.y, v.c1.y, v.c2.y, v.c3.y), new float4(v.c0.z, v.c1.z, v.c2.z, v.c3.z), new float4(v.c0.w, v.c1.w, v.c2.w, v.c3.w));

    public static float3 rotate(float4x4 a, float3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z).xyz;
    public static float3 transform(float4x4 a, float3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3).xyz;

    public static float determinant(float4x4 m)
    {
        Minors(m, out var s, out var t, out var c, out var d);
        return dot(s, new float3(d.z, -d.y, d.x)) + dot(t, new float3(c.z, -c.y, c.x));
    }

    public static float4x4 inverse(float4x4 m)
    {
        Minors(m, out var s, out var t, out var c, out var d);
        float scale = 1 / determinant(m);
        return new float4x4(
            new float4(
                m.c1.y * d.z - m.c2.y * d.y + m.c3.y * d.x,
                -m.c0.y * d.z + m.c2.y * c.z - m.c3.y * c.y,
                m.c0.y * d.y - m.c1.y * c.z + m.c3.y * c.x,
                -m.c0.y * d.x + m.c1.y * c.y - m.c2.y * c.x),
            new float4(
                -m.c1.x * d.z + m.c2.x * d.y - m.c3.x * d.x,
                m.c0.x * d.z - m.c2.x * c.z + m.c3.x * c.y,
                -m.c0.x * d.y + m.c1.x * c.z - m.c3.x * c.x,
                m.c0.x * d.x - m.c1.x * c.y + m.c2.x * c.x),
            new float4(
                m.c1.w * t.z - m.c2.w * t.y + m.c3.w * t.x,
                -m.c0.w * t.z + m.c2.w * s.z - m.c3.w * s.y,
                m.c0.w * t.y - m.c1.w * s.z + m.c3.w * s.x,
                -m.c0.w * t.x + m.c1.w * s.y - m.c2.w * s.x),
            new float4(
                -m.c1.z * t.z + m.c2.z * t.y - m.c3.z * t.x,
                m.c0.z * t.z - m.c2.z * s.z + m.c3.z * s.y,
                -m.c0.z * t.y + m.c1.z * s.z - m.c3.z * s.x,
                m.c0.z * t.x - m.c1.z * s.y + m.c2.z * s.x)) * scale;
    }

    /// <summary>Of a rotation and a translation, nothing else.</summary>
    public static float4x4 fastinverse(float4x4 m)
    {
        var turn = transpose(new float3x3(m.c0.xyz, m.c1.xyz, m.c2.xyz));
        return new float4x4(new float4(turn.c0, 0), new float4(turn.c1, 0), new float4(turn.c2, 0), new float4(-mul(turn, m.c3.xyz), 1));
    }

    // Minors of the upper two rows (s, t) and the lower two (c, d), of columns 01, 02, 03 and 12, 13, 23.
    static void Minors(in float4x4 m, out float3 s, out float3 t, out float3 c, out float3 d)
    {
        s = new float3(
            m.c0.x * m.c1.y - m.c1.x * m.c0.y,
            m.c0.x * m.c2.y - m.c2.x * m.c0.y,
            m.c0.x * m.c3.y - m.c3.x * m.c0.y);
        t = new float3(
            m.c1.x * m.c2.y - m.c2.x * m.c1.y,
            m.c1.x * m.c3.y - m.c3.x * m.c1.y,
            m.c2.x * m.c3.y - m.c3.x * m.c2.y);
        c = new float3(
            m.c0.z * m.c1.w - m.c1.z * m.c0.w,
            m.c0.z * m.c2.w - m.c2.z * m.c0.w,
            m.c0.z * m.c3.w - m.c3.z * m.c0.w);
        d = new float3(
            m.c1.z * m.c2.w - m.c2.z * m.c1.w,
            m.c1.z * m.c3.w - m.c3.z * m.c1.w,
            m.c2.z * m.c3.w - m.c3.z * m.c2.w);
    }
}
