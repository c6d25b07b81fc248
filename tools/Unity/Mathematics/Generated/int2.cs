// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct int2 : IEquatable<int2>, IFormattable
{
    public int x;
    public int y;
    public static readonly int2 zero;

    [MethodImpl(AggressiveInlining)] public int2(int x, int y) { this.x = x; this.y = y; }
    [MethodImpl(AggressiveInlining)] public int2(int2 xy) { this.x = xy.x; this.y = xy.y; }
    [MethodImpl(AggressiveInlining)] public int2(int v) { this.x = v; this.y = v; }
    [MethodImpl(AggressiveInlining)] public int2(bool v) { this.x = v ? 1 : 0; this.y = v ? 1 : 0; }
    [MethodImpl(AggressiveInlining)] public int2(bool2 v) { this.x = v.x ? 1 : 0; this.y = v.y ? 1 : 0; }
    [MethodImpl(AggressiveInlining)] public int2(uint v) { this.x = (int)v; this.y = (int)v; }
    [MethodImpl(AggressiveInlining)] public int2(uint2 v) { this.x = (int)v.x; this.y = (int)v.y; }
    [MethodImpl(AggressiveInlining)] public int2(float v) { this.x = (int)v; this.y = (int)v; }
    [MethodImpl(AggressiveInlining)] public int2(float2 v) { this.x = (int)v.x; this.y = (int)v.y; }
    [MethodImpl(AggressiveInlining)] public int2(double v) { this.x = (int)v; this.y = (int)v; }
    [MethodImpl(AggressiveInlining)] public int2(double2 v) { this.x = (int)v.x; this.y = (int)v.y; }

    public unsafe int this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (int2* p = &this) return ((int*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (int2* p = &this) ((int*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator int2(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int2(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int2(bool2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int2(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int2(uint2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int2(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int2(float2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int2(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int2(double2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static int2 operator +(int2 lhs, int2 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator +(int2 lhs, int rhs) => new(lhs.x + rhs, lhs.y + rhs);
    [MethodImpl(AggressiveInlining)] public static int2 operator +(int lhs, int2 rhs) => new(lhs + rhs.x, lhs + rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator -(int2 lhs, int2 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator -(int2 lhs, int rhs) => new(lhs.x - rhs, lhs.y - rhs);
    [MethodImpl(AggressiveInlining)] public static int2 operator -(int lhs, int2 rhs) => new(lhs - rhs.x, lhs - rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator *(int2 lhs, int2 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator *(int2 lhs, int rhs) => new(lhs.x * rhs, lhs.y * rhs);
    [MethodImpl(AggressiveInlining)] public static int2 operator *(int lhs, int2 rhs) => new(lhs * rhs.x, lhs * rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator /(int2 lhs, int2 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator /(int2 lhs, int rhs) => new(lhs.x / rhs, lhs.y / rhs);
    [MethodImpl(AggressiveInlining)] public static int2 operator /(int lhs, int2 rhs) => new(lhs / rhs.x, lhs / rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator %(int2 lhs, int2 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator %(int2 lhs, int rhs) => new(lhs.x % rhs, lhs.y % rhs);
    [MethodImpl(AggressiveInlining)] public static int2 operator %(int lhs, int2 rhs) => new(lhs % rhs.x, lhs % rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(int2 lhs, int2 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(int2 lhs, int rhs) => new(lhs.x < rhs, lhs.y < rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(int lhs, int2 rhs) => new(lhs < rhs.x, lhs < rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(int2 lhs, int2 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(int2 lhs, int rhs) => new(lhs.x <= rhs, lhs.y <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(int lhs, int2 rhs) => new(lhs <= rhs.x, lhs <= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(int2 lhs, int2 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(int2 lhs, int rhs) => new(lhs.x > rhs, lhs.y > rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(int lhs, int2 rhs) => new(lhs > rhs.x, lhs > rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(int2 lhs, int2 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(int2 lhs, int rhs) => new(lhs.x >= rhs, lhs.y >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(int lhs, int2 rhs) => new(lhs >= rhs.x, lhs >= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(int2 lhs, int2 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(int2 lhs, int rhs) => new(lhs.x == rhs, lhs.y == rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(int lhs, int2 rhs) => new(lhs == rhs.x, lhs == rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(int2 lhs, int2 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(int2 lhs, int rhs) => new(lhs.x != rhs, lhs.y != rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(int lhs, int2 rhs) => new(lhs != rhs.x, lhs != rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator &(int2 lhs, int2 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator &(int2 lhs, int rhs) => new(lhs.x & rhs, lhs.y & rhs);
    [MethodImpl(AggressiveInlining)] public static int2 operator &(int lhs, int2 rhs) => new(lhs & rhs.x, lhs & rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator |(int2 lhs, int2 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator |(int2 lhs, int rhs) => new(lhs.x | rhs, lhs.y | rhs);
    [MethodImpl(AggressiveInlining)] public static int2 operator |(int lhs, int2 rhs) => new(lhs | rhs.x, lhs | rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator ^(int2 lhs, int2 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator ^(int2 lhs, int rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs);
    [MethodImpl(AggressiveInlining)] public static int2 operator ^(int lhs, int2 rhs) => new(lhs ^ rhs.x, lhs ^ rhs.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator -(int2 val) => new(-val.x, -val.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator +(int2 val) => val;
    [MethodImpl(AggressiveInlining)] public static int2 operator ++(int2 val) => new(val.x + 1, val.y + 1);
    [MethodImpl(AggressiveInlining)] public static int2 operator --(int2 val) => new(val.x - 1, val.y - 1);
    [MethodImpl(AggressiveInlining)] public static int2 operator ~(int2 val) => new(~val.x, ~val.y);
    [MethodImpl(AggressiveInlining)] public static int2 operator <<(int2 x, int n) => new(x.x << n, x.y << n);
    [MethodImpl(AggressiveInlining)] public static int2 operator >>(int2 x, int n) => new(x.x >> n, x.y >> n);

    [MethodImpl(AggressiveInlining)] public bool Equals(int2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is int2 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"int2({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 2)
            throw new ArgumentException("index must be between[0...1]");
        return index;
    }
}
