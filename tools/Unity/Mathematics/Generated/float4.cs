// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct float4 : IEquatable<float4>, IFormattable
{
    public float x;
    public float y;
    public float z;
    public float w;
    public static readonly float4 zero;

    [MethodImpl(AggressiveInlining)] public float4(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public float4(float x, float y, float2 zw) { this.x = x; this.y = y; this.z = zw.x; this.w = zw.y; }
    [MethodImpl(AggressiveInlining)] public float4(float x, float2 yz, float w) { this.x = x; this.y = yz.x; this.z = yz.y; this.w = w; }
    [MethodImpl(AggressiveInlining)] public float4(float x, float3 yzw) { this.x = x; this.y = yzw.x; this.z = yzw.y; this.w = yzw.z; }
    [MethodImpl(AggressiveInlining)] public float4(float2 xy, float z, float w) { this.x = xy.x; this.y = xy.y; this.z = z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public float4(float2 xy, float2 zw) { this.x = xy.x; this.y = xy.y; this.z = zw.x; this.w = zw.y; }
    [MethodImpl(AggressiveInlining)] public float4(float3 xyz, float w) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public float4(float4 xyzw) { this.x = xyzw.x; this.y = xyzw.y; this.z = xyzw.z; this.w = xyzw.w; }
    [MethodImpl(AggressiveInlining)] public float4(float v) { this.x = v; this.y = v; this.z = v; this.w = v; }
    [MethodImpl(AggressiveInlining)] public float4(bool v) { this.x = v ? 1f : 0f; this.y = v ? 1f : 0f; this.z = v ? 1f : 0f; this.w = v ? 1f : 0f; }
    [MethodImpl(AggressiveInlining)] public float4(bool4 v) { this.x = v.x ? 1f : 0f; this.y = v.y ? 1f : 0f; this.z = v.z ? 1f : 0f; this.w = v.w ? 1f : 0f; }
    [MethodImpl(AggressiveInlining)] public float4(int v) { this.x = v; this.y = v; this.z = v; this.w = v; }
    [MethodImpl(AggressiveInlining)] public float4(int4 v) { this.x = v.x; this.y = v.y; this.z = v.z; this.w = v.w; }
    [MethodImpl(AggressiveInlining)] public float4(uint v) { this.x = v; this.y = v; this.z = v; this.w = v; }
    [MethodImpl(AggressiveInlining)] public float4(uint4 v) { this.x = v.x; this.y = v.y; this.z = v.z; this.w = v.w; }
    [MethodImpl(AggressiveInlining)] public float4(double v) { this.x = (float)v; this.y = (float)v; this.z = (float)v; this.w = (float)v; }
    [MethodImpl(AggressiveInlining)] public float4(double4 v) { this.x = (float)v.x; this.y = (float)v.y; this.z = (float)v.z; this.w = (float)v.w; }

    public unsafe float this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (float4* p = &this) return ((float*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (float4* p = &this) ((float*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator float4(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float4(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float4(int4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float4(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator float4(uint4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float4(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float4(bool4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float4(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator float4(double4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static float4 operator +(float4 lhs, float4 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator +(float4 lhs, float rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);
    [MethodImpl(AggressiveInlining)] public static float4 operator +(float lhs, float4 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator -(float4 lhs, float4 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator -(float4 lhs, float rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);
    [MethodImpl(AggressiveInlining)] public static float4 operator -(float lhs, float4 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator *(float4 lhs, float4 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator *(float4 lhs, float rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);
    [MethodImpl(AggressiveInlining)] public static float4 operator *(float lhs, float4 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator /(float4 lhs, float4 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator /(float4 lhs, float rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);
    [MethodImpl(AggressiveInlining)] public static float4 operator /(float lhs, float4 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator %(float4 lhs, float4 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator %(float4 lhs, float rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);
    [MethodImpl(AggressiveInlining)] public static float4 operator %(float lhs, float4 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(float4 lhs, float4 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(float4 lhs, float rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(float lhs, float4 rhs) => new(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(float4 lhs, float4 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(float4 lhs, float rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(float lhs, float4 rhs) => new(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(float4 lhs, float4 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(float4 lhs, float rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(float lhs, float4 rhs) => new(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(float4 lhs, float4 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(float4 lhs, float rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(float lhs, float4 rhs) => new(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(float4 lhs, float4 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(float4 lhs, float rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(float lhs, float4 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(float4 lhs, float4 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(float4 lhs, float rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(float lhs, float4 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator -(float4 val) => new(-val.x, -val.y, -val.z, -val.w);
    [MethodImpl(AggressiveInlining)] public static float4 operator +(float4 val) => val;
    [MethodImpl(AggressiveInlining)] public static float4 operator ++(float4 val) => new(val.x + 1, val.y + 1, val.z + 1, val.w + 1);
    [MethodImpl(AggressiveInlining)] public static float4 operator --(float4 val) => new(val.x - 1, val.y - 1, val.z - 1, val.w - 1);

    [MethodImpl(AggressiveInlining)] public bool Equals(float4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
    public override bool Equals(object o) => o is float4 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663) ^ (z.GetHashCode() * 83492791) ^ (w.GetHashCode() * 49979687);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"float4({x.ToString(format, formatProvider)}f, {y.ToString(format, formatProvider)}f, {z.ToString(format, formatProvider)}f, {w.ToString(format, formatProvider)}f)";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 4)
            throw new ArgumentException("index must be between[0...3]");
        return index;
    }
}
