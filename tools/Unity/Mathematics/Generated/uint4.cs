// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct uint4 : IEquatable<uint4>, IFormattable
{
    public uint x;
    public uint y;
    public uint z;
    public uint w;
    public static readonly uint4 zero;

    [MethodImpl(AggressiveInlining)] public uint4(uint x, uint y, uint z, uint w) { this.x = x; this.y = y; this.z = z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public uint4(uint x, uint y, uint2 zw) { this.x = x; this.y = y; this.z = zw.x; this.w = zw.y; }
    [MethodImpl(AggressiveInlining)] public uint4(uint x, uint2 yz, uint w) { this.x = x; this.y = yz.x; this.z = yz.y; this.w = w; }
    [MethodImpl(AggressiveInlining)] public uint4(uint x, uint3 yzw) { this.x = x; this.y = yzw.x; this.z = yzw.y; this.w = yzw.z; }
    [MethodImpl(AggressiveInlining)] public uint4(uint2 xy, uint z, uint w) { this.x = xy.x; this.y = xy.y; this.z = z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public uint4(uint2 xy, uint2 zw) { this.x = xy.x; this.y = xy.y; this.z = zw.x; this.w = zw.y; }
    [MethodImpl(AggressiveInlining)] public uint4(uint3 xyz, uint w) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public uint4(uint4 xyzw) { this.x = xyzw.x; this.y = xyzw.y; this.z = xyzw.z; this.w = xyzw.w; }
    [MethodImpl(AggressiveInlining)] public uint4(uint v) { this.x = v; this.y = v; this.z = v; this.w = v; }
    [MethodImpl(AggressiveInlining)] public uint4(bool v) { this.x = v ? 1u : 0u; this.y = v ? 1u : 0u; this.z = v ? 1u : 0u; this.w = v ? 1u : 0u; }
    [MethodImpl(AggressiveInlining)] public uint4(bool4 v) { this.x = v.x ? 1u : 0u; this.y = v.y ? 1u : 0u; this.z = v.z ? 1u : 0u; this.w = v.w ? 1u : 0u; }
    [MethodImpl(AggressiveInlining)] public uint4(int v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; this.w = (uint)v; }
    [MethodImpl(AggressiveInlining)] public uint4(int4 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; this.w = (uint)v.w; }
    [MethodImpl(AggressiveInlining)] public uint4(float v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; this.w = (uint)v; }
    [MethodImpl(AggressiveInlining)] public uint4(float4 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; this.w = (uint)v.w; }
    [MethodImpl(AggressiveInlining)] public uint4(double v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; this.w = (uint)v; }
    [MethodImpl(AggressiveInlining)] public uint4(double4 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; this.w = (uint)v.w; }

    public unsafe uint this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (uint4* p = &this) return ((uint*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (uint4* p = &this) ((uint*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator uint4(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint4(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint4(bool4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint4(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint4(int4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint4(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint4(float4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint4(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint4(double4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static uint4 operator +(uint4 lhs, uint4 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator +(uint4 lhs, uint rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);
    [MethodImpl(AggressiveInlining)] public static uint4 operator +(uint lhs, uint4 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator -(uint4 lhs, uint4 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator -(uint4 lhs, uint rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);
    [MethodImpl(AggressiveInlining)] public static uint4 operator -(uint lhs, uint4 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator *(uint4 lhs, uint4 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator *(uint4 lhs, uint rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);
    [MethodImpl(AggressiveInlining)] public static uint4 operator *(uint lhs, uint4 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator /(uint4 lhs, uint4 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator /(uint4 lhs, uint rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);
    [MethodImpl(AggressiveInlining)] public static uint4 operator /(uint lhs, uint4 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator %(uint4 lhs, uint4 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator %(uint4 lhs, uint rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);
    [MethodImpl(AggressiveInlining)] public static uint4 operator %(uint lhs, uint4 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(uint4 lhs, uint4 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(uint4 lhs, uint rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(uint lhs, uint4 rhs) => new(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(uint4 lhs, uint4 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(uint4 lhs, uint rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(uint lhs, uint4 rhs) => new(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(uint4 lhs, uint4 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(uint4 lhs, uint rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(uint lhs, uint4 rhs) => new(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(uint4 lhs, uint4 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(uint4 lhs, uint rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(uint lhs, uint4 rhs) => new(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(uint4 lhs, uint4 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(uint4 lhs, uint rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(uint lhs, uint4 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(uint4 lhs, uint4 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(uint4 lhs, uint rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(uint lhs, uint4 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator &(uint4 lhs, uint4 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z, lhs.w & rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator &(uint4 lhs, uint rhs) => new(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs, lhs.w & rhs);
    [MethodImpl(AggressiveInlining)] public static uint4 operator &(uint lhs, uint4 rhs) => new(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z, lhs & rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator |(uint4 lhs, uint4 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z, lhs.w | rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator |(uint4 lhs, uint rhs) => new(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs, lhs.w | rhs);
    [MethodImpl(AggressiveInlining)] public static uint4 operator |(uint lhs, uint4 rhs) => new(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z, lhs | rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator ^(uint4 lhs, uint4 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z, lhs.w ^ rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator ^(uint4 lhs, uint rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs, lhs.w ^ rhs);
    [MethodImpl(AggressiveInlining)] public static uint4 operator ^(uint lhs, uint4 rhs) => new(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z, lhs ^ rhs.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator -(uint4 val) => new((uint)-val.x, (uint)-val.y, (uint)-val.z, (uint)-val.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator +(uint4 val) => val;
    [MethodImpl(AggressiveInlining)] public static uint4 operator ++(uint4 val) => new(val.x + 1, val.y + 1, val.z + 1, val.w + 1);
    [MethodImpl(AggressiveInlining)] public static uint4 operator --(uint4 val) => new(val.x - 1, val.y - 1, val.z - 1, val.w - 1);
    [MethodImpl(AggressiveInlining)] public static uint4 operator ~(uint4 val) => new(~val.x, ~val.y, ~val.z, ~val.w);
    [MethodImpl(AggressiveInlining)] public static uint4 operator <<(uint4 x, int n) => new(x.x << n, x.y << n, x.z << n, x.w << n);
    [MethodImpl(AggressiveInlining)] public static uint4 operator >>(uint4 x, int n) => new(x.x >> n, x.y >> n, x.z >> n, x.w >> n);

    [MethodImpl(AggressiveInlining)] public bool Equals(uint4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
    public override bool Equals(object o) => o is uint4 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663) ^ (z.GetHashCode() * 83492791) ^ (w.GetHashCode() * 49979687);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"uint4({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)}, {w.ToString(format, formatProvider)})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 4)
            throw new ArgumentException("index must be between[0...3]");
        return index;
    }
}
