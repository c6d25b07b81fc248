// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct uint2 : IEquatable<uint2>, IFormattable
{
    public uint x;
    public uint y;
    public static readonly uint2 zero;

    [MethodImpl(AggressiveInlining)] public uint2(uint x, uint y) { this.x = x; this.y = y; }
    [MethodImpl(AggressiveInlining)] public uint2(uint2 xy) { this.x = xy.x; this.y = xy.y; }
    [MethodImpl(AggressiveInlining)] public uint2(uint v) { this.x = v; this.y = v; }
    [MethodImpl(AggressiveInlining)] public uint2(bool v) { this.x = v ? 1u : 0u; this.y = v ? 1u : 0u; }
    [MethodImpl(AggressiveInlining)] public uint2(bool2 v) { this.x = v.x ? 1u : 0u; this.y = v.y ? 1u : 0u; }
    [MethodImpl(AggressiveInlining)] public uint2(int v) { this.x = (uint)v; this.y = (uint)v; }
    [MethodImpl(AggressiveInlining)] public uint2(int2 v) { this.x = (uint)v.x; this.y = (uint)v.y; }
    [MethodImpl(AggressiveInlining)] public uint2(float v) { this.x = (uint)v; this.y = (uint)v; }
    [MethodImpl(AggressiveInlining)] public uint2(float2 v) { this.x = (uint)v.x; this.y = (uint)v.y; }
    [MethodImpl(AggressiveInlining)] public uint2(double v) { this.x = (uint)v; this.y = (uint)v; }
    [MethodImpl(AggressiveInlining)] public uint2(double2 v) { this.x = (uint)v.x; this.y = (uint)v.y; }

    public unsafe uint this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (uint2* p = &this) return ((uint*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (uint2* p = &this) ((uint*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator uint2(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint2(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint2(bool2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint2(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint2(int2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint2(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint2(float2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint2(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator uint2(double2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static uint2 operator +(uint2 lhs, uint2 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator +(uint2 lhs, uint rhs) => new(lhs.x + rhs, lhs.y + rhs);
    [MethodImpl(AggressiveInlining)] public static uint2 operator +(uint lhs, uint2 rhs) => new(lhs + rhs.x, lhs + rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator -(uint2 lhs, uint2 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator -(uint2 lhs, uint rhs) => new(lhs.x - rhs, lhs.y - rhs);
    [MethodImpl(AggressiveInlining)] public static uint2 operator -(uint lhs, uint2 rhs) => new(lhs - rhs.x, lhs - rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator *(uint2 lhs, uint2 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator *(uint2 lhs, uint rhs) => new(lhs.x * rhs, lhs.y * rhs);
    [MethodImpl(AggressiveInlining)] public static uint2 operator *(uint lhs, uint2 rhs) => new(lhs * rhs.x, lhs * rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator /(uint2 lhs, uint2 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator /(uint2 lhs, uint rhs) => new(lhs.x / rhs, lhs.y / rhs);
    [MethodImpl(AggressiveInlining)] public static uint2 operator /(uint lhs, uint2 rhs) => new(lhs / rhs.x, lhs / rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator %(uint2 lhs, uint2 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator %(uint2 lhs, uint rhs) => new(lhs.x % rhs, lhs.y % rhs);
    [MethodImpl(AggressiveInlining)] public static uint2 operator %(uint lhs, uint2 rhs) => new(lhs % rhs.x, lhs % rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(uint2 lhs, uint2 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(uint2 lhs, uint rhs) => new(lhs.x < rhs, lhs.y < rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(uint lhs, uint2 rhs) => new(lhs < rhs.x, lhs < rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(uint2 lhs, uint2 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(uint2 lhs, uint rhs) => new(lhs.x <= rhs, lhs.y <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(uint lhs, uint2 rhs) => new(lhs <= rhs.x, lhs <= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(uint2 lhs, uint2 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(uint2 lhs, uint rhs) => new(lhs.x > rhs, lhs.y > rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(uint lhs, uint2 rhs) => new(lhs > rhs.x, lhs > rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(uint2 lhs, uint2 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(uint2 lhs, uint rhs) => new(lhs.x >= rhs, lhs.y >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(uint lhs, uint2 rhs) => new(lhs >= rhs.x, lhs >= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(uint2 lhs, uint2 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(uint2 lhs, uint rhs) => new(lhs.x == rhs, lhs.y == rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(uint lhs, uint2 rhs) => new(lhs == rhs.x, lhs == rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(uint2 lhs, uint2 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(uint2 lhs, uint rhs) => new(lhs.x != rhs, lhs.y != rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(uint lhs, uint2 rhs) => new(lhs != rhs.x, lhs != rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator &(uint2 lhs, uint2 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator &(uint2 lhs, uint rhs) => new(lhs.x & rhs, lhs.y & rhs);
    [MethodImpl(AggressiveInlining)] public static uint2 operator &(uint lhs, uint2 rhs) => new(lhs & rhs.x, lhs & rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator |(uint2 lhs, uint2 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator |(uint2 lhs, uint rhs) => new(lhs.x | rhs, lhs.y | rhs);
    [MethodImpl(AggressiveInlining)] public static uint2 operator |(uint lhs, uint2 rhs) => new(lhs | rhs.x, lhs | rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator ^(uint2 lhs, uint2 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator ^(uint2 lhs, uint rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs);
    [MethodImpl(AggressiveInlining)] public static uint2 operator ^(uint lhs, uint2 rhs) => new(lhs ^ rhs.x, lhs ^ rhs.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator -(uint2 val) => new((uint)-val.x, (uint)-val.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator +(uint2 val) => val;
    [MethodImpl(AggressiveInlining)] public static uint2 operator ++(uint2 val) => new(val.x + 1, val.y + 1);
    [MethodImpl(AggressiveInlining)] public static uint2 operator --(uint2 val) => new(val.x - 1, val.y - 1);
    [MethodImpl(AggressiveInlining)] public static uint2 operator ~(uint2 val) => new(~val.x, ~val.y);
    [MethodImpl(AggressiveInlining)] public static uint2 operator <<(uint2 x, int n) => new(x.x << n, x.y << n);
    [MethodImpl(AggressiveInlining)] public static uint2 operator >>(uint2 x, int n) => new(x.x >> n, x.y >> n);

    [MethodImpl(AggressiveInlining)] public bool Equals(uint2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is uint2 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"uint2({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 2)
            throw new ArgumentException("index must be between[0...1]");
        return index;
    }
}
