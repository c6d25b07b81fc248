// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct float3 : IEquatable<float3>, IFormattable
{
    public float x;
    public float y;
    public float z;
    public static readonly float3 zero;

    [MethodImpl(AggressiveInlining)] public float3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
    [MethodImpl(AggressiveInlining)] public float3(float x, float2 yz) { this.x = x; this.y = yz.x; this.z = yz.y; }
    [MethodImpl(AggressiveInlining)] public float3(float2 xy, float z) { this.x = xy.x; this.y = xy.y; this.z = z; }
    [MethodImpl(AggressiveInlining)] public float3(float3 xyz) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; }
    [MethodImpl(AggressiveInlining)] public float3(float v) { this.x = v; this.y = v; this.z = v; }
    [MethodImpl(AggressiveInlining)] public float3(bool v) { this.x = v ? 1f : 0f; this.y = v ? 1f : 0f; this.z = v ? 1f : 0f; }
    [MethodImpl(AggressiveInlining)] public float3(bool3 v) { this.x = v.x ? 1f : 0f; this.y = v.y ? 1f : 0f; this.z = v.z ? 1f : 0f; }
    [MethodImpl(AggressiveInlining)] public float3(int v) { this.x = v; this.y = v; this.z = v; }
    [MethodImpl(AggressiveInlining)] public float3(int3 v) { this.x = v.x; this.y = v.y; this.z = v.z; }
    [MethodImpl(AggressiveInlining)] public float3(uint v) { this.x = v; this.y = v; this.z = v; }
    [MethodImpl(AggressiveInlining)] public float3(uint3 v) { this.x = v.x; this.y = v.y; this.z = v.z; }
    [MethodImpl(AggressiveInlining)] public float3(double v) { this.x = (float)v; this.y = (float)v; this.z = (float)v; }
    [MethodImpl(AggressiveInlining)] public float3(double3 v) { this.x = (float)v.x; this.y = (float)v.y; this.z = (float)v.z; }

    public unsafe float this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (float3* p = &this) return ((float*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (float3* p = &this) ((float*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator float3(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float3(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float3(int3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float3(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float3(uint3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float3(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float3(bool3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float3(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float3(double3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static float3 operator +(float3 lhs, float3 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator +(float3 lhs, float rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    [MethodImpl(AggressiveInlining)] public static float3 operator +(float lhs, float3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator -(float3 lhs, float3 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator -(float3 lhs, float rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
    [MethodImpl(AggressiveInlining)] public static float3 operator -(float lhs, float3 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator *(float3 lhs, float3 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator *(float3 lhs, float rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
    [MethodImpl(AggressiveInlining)] public static float3 operator *(float lhs, float3 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator /(float3 lhs, float3 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator /(float3 lhs, float rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
    [MethodImpl(AggressiveInlining)] public static float3 operator /(float lhs, float3 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator %(float3 lhs, float3 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator %(float3 lhs, float rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);
    [MethodImpl(AggressiveInlining)] public static float3 operator %(float lhs, float3 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(float3 lhs, float3 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(float3 lhs, float rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(float lhs, float3 rhs) => new(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(float3 lhs, float3 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(float3 lhs, float rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(float lhs, float3 rhs) => new(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(float3 lhs, float3 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(float3 lhs, float rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(float lhs, float3 rhs) => new(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(float3 lhs, float3 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(float3 lhs, float rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(float lhs, float3 rhs) => new(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(float3 lhs, float3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(float3 lhs, float rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(float lhs, float3 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(float3 lhs, float3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(float3 lhs, float rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(float lhs, float3 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator -(float3 val) => new(-val.x, -val.y, -val.z);
    [MethodImpl(AggressiveInlining)] public static float3 operator +(float3 val) => val;
    [MethodImpl(AggressiveInlining)] public static float3 operator ++(float3 val) => new(val.x + 1, val.y + 1, val.z + 1);
    [MethodImpl(AggressiveInlining)] public static float3 operator --(float3 val) => new(val.x - 1, val.y - 1, val.z - 1);

    [MethodImpl(AggressiveInlining)] public bool Equals(float3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override bool Equals(object o) => o is float3 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663) ^ (z.GetHashCode() * 83492791);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"float3({x.ToString(format, formatProvider)}f, {y.ToString(format, formatProvider)}f, {z.ToString(format, formatProvider)}f)";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 3)
            throw new ArgumentException("index must be between[0...2]");
        return index;
    }
}
