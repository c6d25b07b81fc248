// Written by generate.py.
namespace Unity.Mathematics;

public static partial class math
{
    public static double3x3 double3x3(double3 c0, double3 c1, double3 c2) => new double3x3(c0, c1, c2);
    public static double3x3 double3x3(double v) => new double3x3(v);
    public static double3x3 double3x3(float3x3 v) => new double3x3(v);

    public static double3x3 double3x3(double m00, double m01, double m02, double m10, double m11, double m12, double m20, double m21, double m22)
    {
        return new double3x3(m00, m01, m02, m10, m11, m12, m20, m21, m22);
    }

    public static double3 mul(double3x3 a, double3 b) => a.c0 * b.x + a.c1 * b.y + a.c2 * b.z;
    public static double3 mul(double3 a, double3x3 b) => new double3(dot(a, b.c0), dot(a, b.c1), dot(a, b.c2));
    public static double3x3 mul(double3x3 a, double3x3 b) => new double3x3(mul(a, b.c0), mul(a, b.c1), mul(a, b.c2));
    public static double3x3 transpose(double3x3 v) => new double3x3(new double3(v.c0.x, v.c1.x, v.c2.x), new double3(v.c0.y, v.c1.y, v.c2.y), new double3(v.c0.z, v.c1.z, v.c2.z));

    public static double determinant(double3x3 m) => dot(m.c0, cross(m.c1, m.c2));

    public static double3x3 inverse(double3x3 m)
    {
        double3 row0 = cross(m.c1, m.c2), row1 = cross(m.c2, m.c0), row2 = cross(m.c0, m.c1);
        return transpose(new double3x3(row0, row1, row2)) * (1 / dot(m.c0, row0));
    }
}
