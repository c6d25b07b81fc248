// Written by generate.py.
using System;

namespace Unity.Mathematics;

[Serializable]
public partial struct double4x4 : IEquatable<double4x4>, IFormattable
{
    public double4 c0;
    public double4 c1;
    public double4 c2;
    public double4 c3;
    public static readonly double4x4 identity = new(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    public static readonly double4x4 zero;

    public double4x4(double4 c0, double4 c1, double4 c2, double4 c3) { this.c0 = c0; this.c1 = c1; this.c2 = c2; this.c3 = c3; }
    public double4x4(double m00, double m01, double m02, double m03, double m10, double m11, double m12, double m13, double m20, double m21, double m22, double m23, double m30, double m31, double m32, double m33) { this.c0 = new double4(m00, m10, m20, m30); this.c1 = new double4(m01, m11, m21, m31); this.c2 = new double4(m02, m12, m22, m32); this.c3 = new double4(m03, m13, m23, m33); }
    public double4x4(double v) { this.c0 = v; this.c1 = v; this.c2 = v; this.c3 = v; }
    public double4x4(float4x4 v) { this.c0 = v.c0; this.c1 = v.c1; this.c2 = v.c2; this.c3 = v.c3; }

    public unsafe ref double4 this[int index]
    {
        get
        {
            if ((uint)index >= 4)
                throw new ArgumentException("index must be between[0...3]");
            fixed (double4x4* p = &this) return ref ((double4*)p)[index];
        }
    }

    public static implicit operator double4x4(double v) => new(v);
    public static implicit operator double4x4(float4x4 v) => new(v);
    public static double4x4 operator +(double4x4 lhs, double4x4 rhs) => new(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2, lhs.c3 + rhs.c3);
    public static double4x4 operator +(double4x4 lhs, double rhs) => new(lhs.c0 + rhs, lhs.c1 + rhs, lhs.c2 + rhs, lhs.c3 + rhs);
    public static double4x4 operator +(double lhs, double4x4 rhs) => new(lhs + rhs.c0, lhs + rhs.c1, lhs + rhs.c2, lhs + rhs.c3);
    public static double4x4 operator -(double4x4 lhs, double4x4 rhs) => new(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2, lhs.c3 - rhs.c3);
    public static double4x4 operator -(double4x4 lhs, double rhs) => new(lhs.c0 - rhs, lhs.c1 - rhs, lhs.c2 - rhs, lhs.c3 - rhs);
    public static double4x4 operator -(double lhs, double4x4 rhs) => new(lhs - rhs.c0, lhs - rhs.c1, lhs - rhs.c2, lhs - rhs.c3);
    public static double4x4 operator *(double4x4 lhs, double4x4 rhs) => new(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2, lhs.c3 * rhs.c3);
    public static double4x4 operator *(double4x4 lhs, double rhs) => new(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs, lhs.c3 * rhs);
    public static double4x4 operator *(double lhs, double4x4 rhs) => new(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2, lhs * rhs.c3);
    public static double4x4 operator /(double4x4 lhs, double4x4 rhs) => new(lhs.c0 / rhs.c0, lhs.c1 / rhs.c1, lhs.c2 / rhs.c2, lhs.c3 / rhs.c3);
    public static double4x4 operator /(double4x4 lhs, double rhs) => new(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs, lhs.c3 / rhs);
    public static double4x4 operator /(double lhs, double4x4 rhs) => new(lhs / rhs.c0, lhs / rhs.c1, lhs / rhs.c2, lhs / rhs.c3);
    public static double4x4 operator -(double4x4 val) => new(-val.c0, -val.c1, -val.c2, -val.c3);

    public bool Equals(double4x4 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2) && c3.Equals(rhs.c3);
    public override bool Equals(object o) => o is double4x4 other && Equals(other);
    public override int GetHashCode() => (c0.GetHashCode() * 73856093) ^ (c1.GetHashCode() * 19349663) ^ (c2.GetHashCode() * 83492791) ^ (c3.GetHashCode() * 49979687);
    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        return $"double4x4({c0.x.ToString(format, formatProvider)}, {c1.x.ToString(format, formatProvider)}, {c2.x.ToString(format, formatProvider)}, {c3.x.ToString(format, formatProvider)},  {c0.y.ToString(format, formatProvider)}, {c1.y.ToString(format, formatProvider)}, {c2.y.ToString(format, formatProvider)}, {c3.y.ToString(format, formatProvider)},  {c0.z.ToString(format, formatProvider)}, {c1.z.ToString(format, formatProvider)}, {c2.z.ToString(format, formatProvider)}, {c3.z.ToString(format, formatProvider)},  {c0.w.ToString(format, formatProvider)}, {c1.w.ToString(format, formatProvider)}, {c2.w.ToString(format, formatProvider)}, {c3.w.ToString(format, formatProvider)})";
    }
}
