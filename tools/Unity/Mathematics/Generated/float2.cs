// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct float2 : IEquatable<float2>, IFormattable
{
    public float x;
    public float y;
    public static readonly float2 zero;

    [MethodImpl(AggressiveInlining)] public float2(float x, float y) { this.x = x; this.y = y; }
    [MethodImpl(AggressiveInlining)] public float2(float2 xy) { this.x = xy.x; this.y = xy.y; }
    [MethodImpl(AggressiveInlining)] public float2(float v) { this.x = v; this.y = v; }
    [MethodImpl(AggressiveInlining)] public float2(bool v) { this.x = v ? 1f : 0f; this.y = v ? 1f : 0f; }
    [MethodImpl(AggressiveInlining)] public float2(bool2 v) { this.x = v.x ? 1f : 0f; this.y = v.y ? 1f : 0f; }
    [MethodImpl(AggressiveInlining)] public float2(int v) { this.x = v; this.y = v; }
    [MethodImpl(AggressiveInlining)] public float2(int2 v) { this.x = v.x; this.y = v.y; }
    [MethodImpl(AggressiveInlining)] public float2(uint v) { this.x = v; this.y = v; }
    [MethodImpl(AggressiveInlining)] public float2(uint2 v) { this.x = v.x; this.y = v.y; }
    [MethodImpl(AggressiveInlining)] public float2(double v) { this.x = (float)v; this.y = (float)v; }
    [MethodImpl(AggressiveInlining)] public float2(double2 v) { this.x = (float)v.x; this.y = (float)v.y; }

    public unsafe float this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (float2* p = &this) return ((float*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (float2* p = &this) ((float*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator float2(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float2(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float2(int2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float2(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float2(uint2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float2(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float2(bool2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float2(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float2(double2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static float2 operator +(float2 lhs, float2 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator +(float2 lhs, float rhs) => new(lhs.x + rhs, lhs.y + rhs);
    [MethodImpl(AggressiveInlining)] public static float2 operator +(float lhs, float2 rhs) => new(lhs + rhs.x, lhs + rhs.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator -(float2 lhs, float2 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator -(float2 lhs, float rhs) => new(lhs.x - rhs, lhs.y - rhs);
    [MethodImpl(AggressiveInlining)] public static float2 operator -(float lhs, float2 rhs) => new(lhs - rhs.x, lhs - rhs.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator *(float2 lhs, float2 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator *(float2 lhs, float rhs) => new(lhs.x * rhs, lhs.y * rhs);
    [MethodImpl(AggressiveInlining)] public static float2 operator *(float lhs, float2 rhs) => new(lhs * rhs.x, lhs * rhs.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator /(float2 lhs, float2 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator /(float2 lhs, float rhs) => new(lhs.x / rhs, lhs.y / rhs);
    [MethodImpl(AggressiveInlining)] public static float2 operator /(float lhs, float2 rhs) => new(lhs / rhs.x, lhs / rhs.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator %(float2 lhs, float2 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator %(float2 lhs, float rhs) => new(lhs.x % rhs, lhs.y % rhs);
    [MethodImpl(AggressiveInlining)] public static float2 operator %(float lhs, float2 rhs) => new(lhs % rhs.x, lhs % rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(float2 lhs, float2 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(float2 lhs, float rhs) => new(lhs.x < rhs, lhs.y < rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(float lhs, float2 rhs) => new(lhs < rhs.x, lhs < rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(float2 lhs, float2 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(float2 lhs, float rhs) => new(lhs.x <= rhs, lhs.y <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(float lhs, float2 rhs) => new(lhs <= rhs.x, lhs <= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(float2 lhs, float2 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(float2 lhs, float rhs) => new(lhs.x > rhs, lhs.y > rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(float lhs, float2 rhs) => new(lhs > rhs.x, lhs > rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(float2 lhs, float2 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(float2 lhs, float rhs) => new(lhs.x >= rhs, lhs.y >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(float lhs, float2 rhs) => new(lhs >= rhs.x, lhs >= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(float2 lhs, float2 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(float2 lhs, float rhs) => new(lhs.x == rhs, lhs.y == rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(float lhs, float2 rhs) => new(lhs == rhs.x, lhs == rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(float2 lhs, float2 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(float2 lhs, float rhs) => new(lhs.x != rhs, lhs.y != rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(float lhs, float2 rhs) => new(lhs != rhs.x, lhs != rhs.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator -(float2 val) => new(-val.x, -val.y);
    [MethodImpl(AggressiveInlining)] public static float2 operator +(float2 val) => val;
    [MethodImpl(AggressiveInlining)] public static float2 operator ++(float2 val) => new(val.x + 1, val.y + 1);
    [MethodImpl(AggressiveInlining)] public static float2 operator --(float2 val) => new(val.x - 1, val.y - 1);

    [MethodImpl(AggressiveInlining)] public bool Equals(float2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is float2 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"float2({x.ToString(format, formatProvider)}f, {y.ToString(format, formatProvider)}f)";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 2)
            throw new ArgumentException("index must be between[0...1]");
        return index;
    }
}
