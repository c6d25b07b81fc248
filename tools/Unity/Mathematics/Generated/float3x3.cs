// Written by generate.py.
using System;

namespace Unity.Mathematics;

[Serializable]
public partial struct float3x3 : IEquatable<float3x3>, IFormattable
{
    public float3 c0;
    public float3 c1;
    public float3 c2;
    public static readonly float3x3 identity = new(1, 0, 0, 0, 1, 0, 0, 0, 1);
    public static readonly float3x3 zero;

    public float3x3(float3 c0, float3 c1, float3 c2) { this.c0 = c0; this.c1 = c1; this.c2 = c2; }
    public float3x3(float m00, float m01, float m02, float m10, float m11, float m12, float m20, float m21, float m22) { this.c0 = new float3(m00, m10, m20); this.c1 = new float3(m01, m11, m21); this.c2 = new float3(m02, m12, m22); }
    public float3x3(float v) { this.c0 = v; this.c1 = v; this.c2 = v; }

    public unsafe ref float3 this[int index]
    {
        get
        {
            if ((uint)index >= 3)
                throw new ArgumentException("index must be between[0...2]");
            fixed (float3x3* p = &this) return ref ((float3*)p)[index];
        }
    }

    public static implicit operator float3x3(float v) => new(v);
    public static float3x3 operator +(float3x3 lhs, float3x3 rhs) => new(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2);
    public static float3x3 operator +(float3x3 lhs, float rhs) => new(lhs.c0 + rhs, lhs.c1 + rhs, lhs.c2 + rhs);
    public static float3x3 operator +(float lhs, float3x3 rhs) => new(lhs + rhs.c0, lhs + rhs.c1, lhs + rhs.c2);
    public static float3x3 operator -(float3x3 lhs, float3x3 rhs) => new(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2);
    public static float3x3 operator -(float3x3 lhs, float rhs) => new(lhs.c0 - rhs, lhs.c1 - rhs, lhs.c2 - rhs);
    public static float3x3 operator -(float lhs, float3x3 rhs) => new(lhs - rhs.c0, lhs - rhs.c1, lhs - rhs.c2);
    public static float3x3 operator *(float3x3 lhs, float3x3 rhs) => new(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2);
    public static float3x3 operator *(float3x3 lhs, float rhs) => new(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs);
    public static float3x3 operator *(float lhs, float3x3 rhs) => new(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2);
    public static float3x3 operator /(float3x3 lhs, float3x3 rhs) => new(lhs.c0 / rhs.c0, lhs.c1 / rhs.c1, lhs.c2 / rhs.c2);
    public static float3x3 operator /(float3x3 lhs, float rhs) => new(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs);
    public static float3x3 operator /(float lhs, float3x3 rhs) => new(lhs / rhs.c0, lhs / rhs.c1, lhs / rhs.c2);
    public static float3x3 operator -(float3x3 val) => new(-val.c0, -val.c1, -val.c2);

    public bool Equals(float3x3 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2);
    public override bool Equals(object o) => o is float3x3 other && Equals(other);
    public override int GetHashCode() => (c0.GetHashCode() * 73856093) ^ (c1.GetHashCode() * 19349663) ^ (c2.GetHashCode() * 83492791);
    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        return $"float3x3({c0.x.ToString(format, formatProvider)}f, {c1.x.ToString(format, formatProvider)}f, {c2.x.ToString(format, formatProvider)}f,  {c0.y.ToString(format, formatProvider)}f, {c1.y.ToString(format, formatProvider)}f, {c2.y.ToString(format, formatProvider)}f,  {c0.z.ToString(format, formatProvider)}f, {c1.z.ToString(format, formatProvider)}f, {c2.z.ToString(format, formatProvider)}f)";
    }
}
