// Written by generate.py.
using System;

namespace Unity.Mathematics;

[Serializable]
public partial struct double3x3 : IEquatable<double3x3>, IFormattable
{
    public double3 c0;
    public double3 c1;
    public double3 c2;
    public static readonly double3x3 identity = new(1, 0, 0, 0, 1, 0, 0, 0, 1);
    public static readonly double3x3 zero;

    public double3x3(double3 c0, double3 c1, double3 c2) { this.c0 = c0; this.c1 = c1; this.c2 = c2; }
    public double3x3(double m00, double m01, double m02, double m10, double m11, double m12, double m20, double m21, double m22) { this.c0 = new double3(m00, m10, m20); this.c1 = new double3(m01, m11, m21); this.c2 = new double3(m02, m12, m22); }
    public double3x3(double v) { this.c0 = v; this.c1 = v; this.c2 = v; }
    public double3x3(float3x3 v) { this.c0 = v.c0; this.c1 = v.c1; this.c2 = v.c2; }

    public unsafe ref double3 this[int index]
    {
        get
        {
            if ((uint)index >= 3)
                throw new ArgumentException("index must be between[0...2]");
            fixed (double3x3* p = &this) return ref ((double3*)p)[index];
        }
    }

    public static implicit operator double3x3(double v) => new(v);
    public static implicit operator double3x3(float3x3 v) => new(v);
    public static double3x3 operator +(double3x3 lhs, double3x3 rhs) => new(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2);
    public static double3x3 operator +(double3x3 lhs, double rhs) => new(lhs.c0 + rhs, lhs.c1 + rhs, lhs.c2 + rhs);
    public static double3x3 operator +(double lhs, double3x3 rhs) => new(lhs + rhs.c0, lhs + rhs.c1, lhs + rhs.c2);
    public static double3x3 operator -(double3x3 lhs, double3x3 rhs) => new(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2);
    public static double3x3 operator -(double3x3 lhs, double rhs) => new(lhs.c0 - rhs, lhs.c1 - rhs, lhs.c2 - rhs);
    public static double3x3 operator -(double lhs, double3x3 rhs) => new(lhs - rhs.c0, lhs - rhs.c1, lhs - rhs.c2);
    public static double3x3 operator *(double3x3 lhs, double3x3 rhs) => new(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2);
    public static double3x3 operator *(double3x3 lhs, double rhs) => new(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs);
    public static double3x3 operator *(double lhs, double3x3 rhs) => new(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2);
    public static double3x3 operator /(double3x3 lhs, double3x3 rhs) => new(lhs.c0 / rhs.c0, lhs.c1 / rhs.c1, lhs.c2 / rhs.c2);
    public static double3x3 operator /(double3x3 lhs, double rhs) => new(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs);
    public static double3x3 operator /(double lhs, double3x3 rhs) => new(lhs / rhs.c0, lhs / rhs.c1, lhs / rhs.c2);
    public static double3x3 operator -(double3x3 val) => new(-val.c0, -val.c1, -val.c2);

    public bool Equals(double3x3 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2);
    public override bool Equals(object o) => o is double3x3 other && Equals(other);
    public override int GetHashCode() => (c0.GetHashCode() * 73856093) ^ (c1.GetHashCode() * 19349663) ^ (c2.GetHashCode() * 83492791);
    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        return $"double3x3({c0.x.ToString(format, formatProvider)}, {c1.x.ToString(format, formatProvider)}, {c2.x.ToString(format, formatProvider)},  {c0.y.ToString(format, formatProvider)}, {c1.y.ToString(format, formatProvider)}, {c2.y.ToString(format, formatProvider)},  {c0.z.ToString(format, formatProvider)}, {c1.z.ToString(format, formatProvider)}, {c2.z.ToString(format, formatProvider)})";
    }
}
