// Written by generate.py.
using System;

namespace Unity.Mathematics;

[Serializable]
public partial struct float4x4 : IEquatable<float4x4>, IFormattable
{
    public float4 c0;
    public float4 c1;
    public float4 c2;
    public float4 c3;
    public static readonly float4x4 identity = new(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    public static readonly float4x4 zero;

    public float4x4(float4 c0, float4 c1, float4 c2, float4 c3) { this.c0 = c0; this.c1 = c1; this.c2 = c2; this.c3 = c3; }
    public float4x4(float m00, float m01, float m02, float m03, float m10, float m11, float m12, float m13, float m20, float m21, float m22, float m23, float m30, float m31, float m32, float m33) { this.c0 = new float4(m00, m10, m20, m30); this.c1 = new float4(m01, m11, m21, m31); this.c2 = new float4(m02, m12, m22, m32); this.c3 = new float4(m03, m13, m23, m33); }
    public float4x4(float v) { this.c0 = v; this.c1 = v; this.c2 = v; this.c3 = v; }

    public unsafe ref float4 this[int index]
    {
        get
        {
            if ((uint)index >= 4)
                throw new ArgumentException("index must be between[0...3]");
            fixed (float4x4* p = &this) return ref ((float4*)p)[index];
        }
    }

    public static implicit operator float4x4(float v) => new(v);
    public static float4x4 operator +(float4x4 lhs, float4x4 rhs) => new(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2, lhs.c3 + rhs.c3);
    public static float4x4 operator +(float4x4 lhs, float rhs) => new(lhs.c0 + rhs, lhs.c1 + rhs, lhs.c2 + rhs, lhs.c3 + rhs);
    public static float4x4 operator +(float lhs, float4x4 rhs) => new(lhs + rhs.c0, lhs + rhs.c1, lhs + rhs.c2, lhs + rhs.c3);
    public static float4x4 operator -(float4x4 lhs, float4x4 rhs) => new(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2, lhs.c3 - rhs.c3);
    public static float4x4 operator -(float4x4 lhs, float rhs) => new(lhs.c0 - rhs, lhs.c1 - rhs, lhs.c2 - rhs, lhs.c3 - rhs);
    public static float4x4 operator -(float lhs, float4x4 rhs) => new(lhs - rhs.c0, lhs - rhs.c1, lhs - rhs.c2, lhs - rhs.c3);
    public static float4x4 operator *(float4x4 lhs, float4x4 rhs) => new(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2, lhs.c3 * rhs.c3);
    public static float4x4 operator *(float4x4 lhs, float rhs) => new(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs, lhs.c3 * rhs);
    public static float4x4 operator *(float lhs, float4x4 rhs) => new(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2, lhs * rhs.c3);
    public static float4x4 operator /(float4x4 lhs, float4x4 rhs) => new(lhs.c0 / rhs.c0, lhs.c1 / rhs.c1, lhs.c2 / rhs.c2, lhs.c3 / rhs.c3);
    public static float4x4 operator /(float4x4 lhs, float rhs) => new(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs, lhs.c3 / rhs);
    public static float4x4 operator /(float lhs, float4x4 rhs) => new(lhs / rhs.c0, lhs / rhs.c1, lhs / rhs.c2, lhs / rhs.c3);
    public static float4x4 operator -(float4x4 val) => new(-val.c0, -val.c1, -val.c2, -val.c3);

    public bool Equals(float4x4 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2) && c3.Equals(rhs.c3);
    public override bool Equals(object o) => o is float4x4 other && Equals(other);
    public override int GetHashCode() => (c0.GetHashCode() * 73856093) ^ (c1.GetHashCode() * 19349663) ^ (c2.GetHashCode() * 83492791) ^ (c3.GetHashCode() * 49979687);
    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        return $"float4x4({c0.x.ToString(format, formatProvider)}f, {c1.x.ToString(format, formatProvider)}f, {c2.x.ToString(format, formatProvider)}f, {c3.x.ToString(format, formatProvider)}f,  {c0.y.ToString(format, formatProvider)}f, {c1.y.ToString(format, formatProvider)}f, {c2.y.ToString(format, formatProvider)}f, {c3.y.ToString(format, formatProvider)}f,  {c0.z.ToString(format, formatProvider)}f, {c1.z.ToString(format, formatProvider)}f, {c2.z.ToString(format, formatProvider)}f, {c3.z.ToString(format, formatProvider)}f,  {c0.w.ToString(format, formatProvider)}f, {c1.w.ToString(format, formatProvider)}f, {c2.w.ToString(format, formatProvider)}f, {c3.w.ToString(format, formatProvider)}f)";
    }
}
