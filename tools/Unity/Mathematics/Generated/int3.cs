// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct int3 : IEquatable<int3>, IFormattable
{
    public int x;
    public int y;
    public int z;
    public static readonly int3 zero;

    [MethodImpl(AggressiveInlining)] public int3(int x, int y, int z) { this.x = x; this.y = y; this.z = z; }
    [MethodImpl(AggressiveInlining)] public int3(int x, int2 yz) { this.x = x; this.y = yz.x; this.z = yz.y; }
    [MethodImpl(AggressiveInlining)] public int3(int2 xy, int z) { this.x = xy.x; this.y = xy.y; this.z = z; }
    [MethodImpl(AggressiveInlining)] public int3(int3 xyz) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; }
    [MethodImpl(AggressiveInlining)] public int3(int v) { this.x = v; this.y = v; this.z = v; }
    [MethodImpl(AggressiveInlining)] public int3(bool v) { this.x = v ? 1 : 0; this.y = v ? 1 : 0; this.z = v ? 1 : 0; }
    [MethodImpl(AggressiveInlining)] public int3(bool3 v) { this.x = v.x ? 1 : 0; this.y = v.y ? 1 : 0; this.z = v.z ? 1 : 0; }
    [MethodImpl(AggressiveInlining)] public int3(uint v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; }
    [MethodImpl(AggressiveInlining)] public int3(uint3 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; }
    [MethodImpl(AggressiveInlining)] public int3(float v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; }
    [MethodImpl(AggressiveInlining)] public int3(float3 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; }
    [MethodImpl(AggressiveInlining)] public int3(double v) { this.x = (int)v; this.y = (int)v; this.z = (int)v; }
    [MethodImpl(AggressiveInlining)] public int3(double3 v) { this.x = (int)v.x; this.y = (int)v.y; this.z = (int)v.z; }

    public unsafe int this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (int3* p = &this) return ((int*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (int3* p = &this) ((int*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator int3(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int3(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int3(bool3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int3(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int3(uint3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int3(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int3(float3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int3(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator int3(double3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static int3 operator +(int3 lhs, int3 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator +(int3 lhs, int rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    [MethodImpl(AggressiveInlining)] public static int3 operator +(int lhs, int3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator -(int3 lhs, int3 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator -(int3 lhs, int rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
    [MethodImpl(AggressiveInlining)] public static int3 operator -(int lhs, int3 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator *(int3 lhs, int3 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator *(int3 lhs, int rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
    [MethodImpl(AggressiveInlining)] public static int3 operator *(int lhs, int3 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator /(int3 lhs, int3 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator /(int3 lhs, int rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
    [MethodImpl(AggressiveInlining)] public static int3 operator /(int lhs, int3 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator %(int3 lhs, int3 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator %(int3 lhs, int rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);
    [MethodImpl(AggressiveInlining)] public static int3 operator %(int lhs, int3 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(int3 lhs, int3 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(int3 lhs, int rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(int lhs, int3 rhs) => new(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(int3 lhs, int3 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(int3 lhs, int rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(int lhs, int3 rhs) => new(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(int3 lhs, int3 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(int3 lhs, int rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(int lhs, int3 rhs) => new(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(int3 lhs, int3 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(int3 lhs, int rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(int lhs, int3 rhs) => new(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(int3 lhs, int3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(int3 lhs, int rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(int lhs, int3 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(int3 lhs, int3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(int3 lhs, int rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(int lhs, int3 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator &(int3 lhs, int3 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator &(int3 lhs, int rhs) => new(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs);
    [MethodImpl(AggressiveInlining)] public static int3 operator &(int lhs, int3 rhs) => new(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator |(int3 lhs, int3 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator |(int3 lhs, int rhs) => new(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs);
    [MethodImpl(AggressiveInlining)] public static int3 operator |(int lhs, int3 rhs) => new(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator ^(int3 lhs, int3 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator ^(int3 lhs, int rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs);
    [MethodImpl(AggressiveInlining)] public static int3 operator ^(int lhs, int3 rhs) => new(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator -(int3 val) => new(-val.x, -val.y, -val.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator +(int3 val) => val;
    [MethodImpl(AggressiveInlining)] public static int3 operator ++(int3 val) => new(val.x + 1, val.y + 1, val.z + 1);
    [MethodImpl(AggressiveInlining)] public static int3 operator --(int3 val) => new(val.x - 1, val.y - 1, val.z - 1);
    [MethodImpl(AggressiveInlining)] public static int3 operator ~(int3 val) => new(~val.x, ~val.y, ~val.z);
    [MethodImpl(AggressiveInlining)] public static int3 operator <<(int3 x, int n) => new(x.x << n, x.y << n, x.z << n);
    [MethodImpl(AggressiveInlining)] public static int3 operator >>(int3 x, int n) => new(x.x >> n, x.y >> n, x.z >> n);

    [MethodImpl(AggressiveInlining)] public bool Equals(int3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override bool Equals(object o) => o is int3 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663) ^ (z.GetHashCode() * 83492791);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"int3({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 3)
            throw new ArgumentException("index must be between[0...2]");
        return index;
    }
}
