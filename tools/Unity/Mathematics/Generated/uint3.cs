// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct uint3 : IEquatable<uint3>, IFormattable
{
    public uint x;
    public uint y;
    public uint z;
    public static readonly uint3 zero;

    [MethodImpl(AggressiveInlining)] public uint3(uint x, uint y, uint z) { this.x = x; this.y = y; this.z = z; }
    [MethodImpl(AggressiveInlining)] public uint3(uint x, uint2 yz) { this.x = x; this.y = yz.x; this.z = yz.y; }
    [MethodImpl(AggressiveInlining)] public uint3(uint2 xy, uint z) { this.x = xy.x; this.y = xy.y; this.z = z; }
    [MethodImpl(AggressiveInlining)] public uint3(uint3 xyz) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; }
    [MethodImpl(AggressiveInlining)] public uint3(uint v) { this.x = v; this.y = v; this.z = v; }
    [MethodImpl(AggressiveInlining)] public uint3(bool v) { this.x = v ? 1u : 0u; this.y = v ? 1u : 0u; this.z = v ? 1u : 0u; }
    [MethodImpl(AggressiveInlining)] public uint3(bool3 v) { this.x = v.x ? 1u : 0u; this.y = v.y ? 1u : 0u; this.z = v.z ? 1u : 0u; }
    [MethodImpl(AggressiveInlining)] public uint3(int v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; }
    [MethodImpl(AggressiveInlining)] public uint3(int3 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; }
    [MethodImpl(AggressiveInlining)] public uint3(float v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; }
    [MethodImpl(AggressiveInlining)] public uint3(float3 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; }
    [MethodImpl(AggressiveInlining)] public uint3(double v) { this.x = (uint)v; this.y = (uint)v; this.z = (uint)v; }
    [MethodImpl(AggressiveInlining)] public uint3(double3 v) { this.x = (uint)v.x; this.y = (uint)v.y; this.z = (uint)v.z; }

    public unsafe uint this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (uint3* p = &this) return ((uint*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (uint3* p = &this) ((uint*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator uint3(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint3(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint3(bool3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint3(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint3(int3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint3(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint3(float3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint3(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint3(double3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static uint3 operator +(uint3 lhs, uint3 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator +(uint3 lhs, uint rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    [MethodImpl(AggressiveInlining)] public static uint3 operator +(uint lhs, uint3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator -(uint3 lhs, uint3 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator -(uint3 lhs, uint rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
    [MethodImpl(AggressiveInlining)] public static uint3 operator -(uint lhs, uint3 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator *(uint3 lhs, uint3 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator *(uint3 lhs, uint rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
    [MethodImpl(AggressiveInlining)] public static uint3 operator *(uint lhs, uint3 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator /(uint3 lhs, uint3 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator /(uint3 lhs, uint rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
    [MethodImpl(AggressiveInlining)] public static uint3 operator /(uint lhs, uint3 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator %(uint3 lhs, uint3 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator %(uint3 lhs, uint rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);
    [MethodImpl(AggressiveInlining)] public static uint3 operator %(uint lhs, uint3 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(uint3 lhs, uint3 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(uint3 lhs, uint rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(uint lhs, uint3 rhs) => new(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(uint3 lhs, uint3 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(uint3 lhs, uint rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(uint lhs, uint3 rhs) => new(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(uint3 lhs, uint3 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(uint3 lhs, uint rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(uint lhs, uint3 rhs) => new(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(uint3 lhs, uint3 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(uint3 lhs, uint rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(uint lhs, uint3 rhs) => new(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(uint3 lhs, uint3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(uint3 lhs, uint rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(uint lhs, uint3 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(uint3 lhs, uint3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(uint3 lhs, uint rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(uint lhs, uint3 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator &(uint3 lhs, uint3 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator &(uint3 lhs, uint rhs) => new(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs);
    [MethodImpl(AggressiveInlining)] public static uint3 operator &(uint lhs, uint3 rhs) => new(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator |(uint3 lhs, uint3 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator |(uint3 lhs, uint rhs) => new(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs);
    [MethodImpl(AggressiveInlining)] public static uint3 operator |(uint lhs, uint3 rhs) => new(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator ^(uint3 lhs, uint3 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator ^(uint3 lhs, uint rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs);
    [MethodImpl(AggressiveInlining)] public static uint3 operator ^(uint lhs, uint3 rhs) => new(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator -(uint3 val) => new((uint)-val.x, (uint)-val.y, (uint)-val.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator +(uint3 val) => val;
    [MethodImpl(AggressiveInlining)] public static uint3 operator ++(uint3 val) => new(val.x + 1, val.y + 1, val.z + 1);
    [MethodImpl(AggressiveInlining)] public static uint3 operator --(uint3 val) => new(val.x - 1, val.y - 1, val.z - 1);
    [MethodImpl(AggressiveInlining)] public static uint3 operator ~(uint3 val) => new(~val.x, ~val.y, ~val.z);
    [MethodImpl(AggressiveInlining)] public static uint3 operator <<(uint3 x, int n) => new(x.x << n, x.y << n, x.z << n);
    [MethodImpl(AggressiveInlining)] public static uint3 operator >>(uint3 x, int n) => new(x.x >> n, x.y >> n, x.z >> n);

    [MethodImpl(AggressiveInlining)] public bool Equals(uint3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override bool Equals(object o) => o is uint3 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663) ^ (z.GetHashCode() * 83492791);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"uint3({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 3)
            throw new ArgumentException("index must be between[0...2]");
        return index;
    }
}
