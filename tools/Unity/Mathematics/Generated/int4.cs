// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct int4 : IEquatable<int4>, IFormattable
{
    public int x;
    public int y;
    public int z;
    public int w;
    public static readonly int4 zero;

    [MethodImpl(AggressiveInlining)] public int4(int x, int y, int z, int w) { this.x = x; this.y = y; this.z = z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public int4(int x, int y, int2 zw) { this.x = x; this.y = y; this.z = zw.x; this.w = zw.y; }
    [MethodImpl(AggressiveInlining)] public int4(int x, int2 yz, int w) { this.x = x; this.y = yz.x; this.z = yz.y; this.w = w; }
    [MethodImpl(AggressiveInlining)] public int4(int x, int3 yzw) { this.x = x; this.y = yzw.x; this.z = yzw.y; this.w = yzw.z; }
    [MethodImpl(AggressiveInlining)] public int4(int2 xy, int z, int w) { this.x = xy.x; this.y = xy.y; this.z = z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public int4(int2 xy, int2 zw) { this.x = xy.x; this.y = xy.y; this.z = zw.x; this.w = zw.y; }
    [MethodImpl(AggressiveInlining)] public int4(int3 xyz, int w) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public int4(int4 xyzw) { this.x = xyzw.x; this.y = xyzw.y; this.z = xyzw.z; this.w = xyzw.w; }
    [MethodImpl(AggressiveInlining)] public int4(int v) { this.x = v; this.y = v; this.z = v; this.w = v; }
    [MethodImpl(AggressiveInlining)] public int4(bool v) { this.x = v ? 1 : 0; this.y = v ? 1 : 0; this.z = v ? 1 : 0; this.w = v ? 1 : 0; }
    [MethodImpl(AggressiveInlining)] public int4(bool4 v) { this.x = v.x ? 1 : 0; this.y = v.y ? 1 : 0; this.z = v.z ? 1 : 0; this.w = v.w ? 1 : 0; }
    [MethodImpl(AggressiveInlining)] public int4(uint v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; this.w = (int)v; }
    [MethodImpl(AggressiveInlining)] public int4(uint4 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; this.w = (int)v.w; }
    [MethodImpl(AggressiveInlining)] public int4(float v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; this.w = (int)v; }
    [MethodImpl(AggressiveInlining)] public int4(float4 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; this.w = (int)v.w; }
    [MethodImpl(AggressiveInlining)] public int4(double v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; this.w = (int)v; }
    [MethodImpl(AggressiveInlining)] public int4(double4 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; this.w = (int)v.w; }

    public unsafe int this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (int4* p = &this) return ((int*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (int4* p = &this) ((int*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator int4(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int4(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int4(bool4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int4(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int4(uint4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int4(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int4(float4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int4(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int4(double4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static int4 operator +(int4 lhs, int4 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator +(int4 lhs, int rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);
    [MethodImpl(AggressiveInlining)] public static int4 operator +(int lhs, int4 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator -(int4 lhs, int4 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator -(int4 lhs, int rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);
    [MethodImpl(AggressiveInlining)] public static int4 operator -(int lhs, int4 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator *(int4 lhs, int4 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator *(int4 lhs, int rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);
    [MethodImpl(AggressiveInlining)] public static int4 operator *(int lhs, int4 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator /(int4 lhs, int4 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator /(int4 lhs, int rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);
    [MethodImpl(AggressiveInlining)] public static int4 operator /(int lhs, int4 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator %(int4 lhs, int4 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator %(int4 lhs, int rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);
    [MethodImpl(AggressiveInlining)] public static int4 operator %(int lhs, int4 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(int4 lhs, int4 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(int4 lhs, int rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(int lhs, int4 rhs) => new(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(int4 lhs, int4 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(int4 lhs, int rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(int lhs, int4 rhs) => new(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(int4 lhs, int4 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(int4 lhs, int rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(int lhs, int4 rhs) => new(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(int4 lhs, int4 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(int4 lhs, int rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(int lhs, int4 rhs) => new(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(int4 lhs, int4 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(int4 lhs, int rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(int lhs, int4 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(int4 lhs, int4 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(int4 lhs, int rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(int lhs, int4 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator &(int4 lhs, int4 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z, lhs.w & rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator &(int4 lhs, int rhs) => new(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs, lhs.w & rhs);
    [MethodImpl(AggressiveInlining)] public static int4 operator &(int lhs, int4 rhs) => new(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z, lhs & rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator |(int4 lhs, int4 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z, lhs.w | rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator |(int4 lhs, int rhs) => new(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs, lhs.w | rhs);
    [MethodImpl(AggressiveInlining)] public static int4 operator |(int lhs, int4 rhs) => new(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z, lhs | rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator ^(int4 lhs, int4 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z, lhs.w ^ rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator ^(int4 lhs, int rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs, lhs.w ^ rhs);
    [MethodImpl(AggressiveInlining)] public static int4 operator ^(int lhs, int4 rhs) => new(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z, lhs ^ rhs.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator -(int4 val) => new(-val.x, -val.y, -val.z, -val.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator +(int4 val) => val;
    [MethodImpl(AggressiveInlining)] public static int4 operator ++(int4 val) => new(val.x + 1, val.y + 1, val.z + 1, val.w + 1);
    [MethodImpl(AggressiveInlining)] public static int4 operator --(int4 val) => new(val.x - 1, val.y - 1, val.z - 1, val.w - 1);
    [MethodImpl(AggressiveInlining)] public static int4 operator ~(int4 val) => new(~val.x, ~val.y, ~val.z, ~val.w);
    [MethodImpl(AggressiveInlining)] public static int4 operator <<(int4 x, int n) => new(x.x << n, x.y << n, x.z << n, x.w << n);
    [MethodImpl(AggressiveInlining)] public static int4 operator >>(int4 x, int n) => new(x.x >> n, x.y >> n, x.z >> n, x.w >> n);

    [MethodImpl(AggressiveInlining)] public bool Equals(int4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
    public override bool Equals(object o) => o is int4 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663) ^ (z.GetHashCode() * 83492791) ^ (w.GetHashCode() * 49979687);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"int4({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)}, {w.ToString(format, formatProvider)})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 4)
            throw new ArgumentException("index must be between[0...3]");
        return index;
    }
}
