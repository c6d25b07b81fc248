// Written by generate.py.
namespace Unity.Mathematics;

public static partial class math
{
    public static float3x3 float3x3(float3 c0, float3 c1, float3 c2) => new float3x3(c0, c1, c2);
    public static float3x3 float3x3(float v) => new float3x3(v);

    public static float3x3 float3x3(float m00, float m01, float m02, float m10, float m11, float m12, float m20, float m21, float m22)
    {
        return new float3x3(m00, m01, m02, m10, m11, m12, m20, m21, m22);
    }

    public static float3 mul(float3x3 a, float3 b) => a.c0 * b.x + a.c1 * b.y + a.c2 * b.z;
    public static float3 mul(float3 a, float3x3 b) => new float3(dot(a, b.c0), dot(a, b.c1), dot(a, b.c2));
    public static float3x3 mul(float3x3 a, float3x3 b) => new float3x3(mul(a, b.c0), mul(a, b.c1), mul(a, b.c2));
    public static float3x3 transpose(float3x3 v) => new float3x3(new float3(v.c0.x, v.c1.x, v.c2.x), new float3(v.c0.y, v.c1.y, v.c2.y), new float3(v.c0.z, v.c1.z, v.c2.z));

    public static float determinant(float3x3 m) => dot(m.c0, cross(m.c1, m.c2));

    public static float3x3 inverse(float3x3 m)
    {
        float3 row0 = cross(m.c1, m.c2), row1 = cross(m.c2, m.c0), row2 = cross(m.c0, m.c1);
        return transpose(new float3x3(row0, row1, row2)) * (1 / dot(m.c0, row0));
    }
}
