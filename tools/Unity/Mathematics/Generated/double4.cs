// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct double4 : IEquatable<double4>, IFormattable
{
    public double x;
    public double y;
    public double z;
    public double w;
    public static readonly double4 zero;

    [MethodImpl(AggressiveInlining)] public double4(double x, double y, double z, double w) { this.x = x; this.y = y; this.z = z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public double4(double x, double y, double2 zw) { this.x = x; this.y = y; this.z = zw.x; this.w = zw.y; }
    [MethodImpl(AggressiveInlining)] public double4(double x, double2 yz, double w) { this.x = x; this.y = yz.x; this.z = yz.y; this.w = w; }
    [MethodImpl(AggressiveInlining)] public double4(double x, double3 yzw) { this.x = x; this.y = yzw.x; this.z = yzw.y; this.w = yzw.z; }
    [MethodImpl(AggressiveInlining)] public double4(double2 xy, double z, double w) { this.x = xy.x; this.y = xy.y; this.z = z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public double4(double2 xy, double2 zw) { this.x = xy.x; this.y = xy.y; this.z = zw.x; this.w = zw.y; }
    [MethodImpl(AggressiveInlining)] public double4(double3 xyz, double w) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public double4(double4 xyzw) { this.x = xyzw.x; this.y = xyzw.y; this.z = xyzw.z; this.w = xyzw.w; }
    [MethodImpl(AggressiveInlining)] public double4(double v) { this.x = v; this.y = v; this.z = v; this.w = v; }
    [MethodImpl(AggressiveInlining)] public double4(bool v) { this.x = v ? 1.0 : 0.0; this.y = v ? 1.0 : 0.0; this.z = v ? 1.0 : 0.0; this.w = v ? 1.0 : 0.0; }
    [MethodImpl(AggressiveInlining)] public double4(bool4 v) { this.x = v.x ? 1.0 : 0.0; this.y = v.y ? 1.0 : 0.0; this.z = v.z ? 1.0 : 0.0; this.w = v.w ? 1.0 : 0.0; }
    [MethodImpl(AggressiveInlining)] public double4(int v) { this.x = v; this.y = v; this.z = v; this.w = v; }
    [MethodImpl(AggressiveInlining)] public double4(int4 v) { this.x = v.x; this.y = v.y; this.z = v.z; this.w = v.w; }
    [MethodImpl(AggressiveInlining)] public double4(uint v) { this.x = v; this.y = v; this.z = v; this.w = v; }
    [MethodImpl(AggressiveInlining)] public double4(uint4 v) { this.x = v.x; this.y = v.y; this.z = v.z; this.w = v.w; }
    [MethodImpl(AggressiveInlining)] public double4(float v) { this.x = v; this.y = v; this.z = v; this.w = v; }
    [MethodImpl(AggressiveInlining)] public double4(float4 v) { this.x = v.x; this.y = v.y; this.z = v.z; this.w = v.w; }

    public unsafe double this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (double4* p = &this) return ((double*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (double4* p = &this) ((double*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator double4(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double4(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double4(int4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double4(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double4(uint4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double4(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double4(float4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator double4(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator double4(bool4 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static double4 operator +(double4 lhs, double4 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator +(double4 lhs, double rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);
    [MethodImpl(AggressiveInlining)] public static double4 operator +(double lhs, double4 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator -(double4 lhs, double4 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator -(double4 lhs, double rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);
    [MethodImpl(AggressiveInlining)] public static double4 operator -(double lhs, double4 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator *(double4 lhs, double4 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator *(double4 lhs, double rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);
    [MethodImpl(AggressiveInlining)] public static double4 operator *(double lhs, double4 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator /(double4 lhs, double4 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator /(double4 lhs, double rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);
    [MethodImpl(AggressiveInlining)] public static double4 operator /(double lhs, double4 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator %(double4 lhs, double4 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator %(double4 lhs, double rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);
    [MethodImpl(AggressiveInlining)] public static double4 operator %(double lhs, double4 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(double4 lhs, double4 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(double4 lhs, double rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <(double lhs, double4 rhs) => new(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(double4 lhs, double4 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(double4 lhs, double rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator <=(double lhs, double4 rhs) => new(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(double4 lhs, double4 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(double4 lhs, double rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >(double lhs, double4 rhs) => new(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(double4 lhs, double4 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(double4 lhs, double rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator >=(double lhs, double4 rhs) => new(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(double4 lhs, double4 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(double4 lhs, double rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(double lhs, double4 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(double4 lhs, double4 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(double4 lhs, double rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(double lhs, double4 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator -(double4 val) => new(-val.x, -val.y, -val.z, -val.w);
    [MethodImpl(AggressiveInlining)] public static double4 operator +(double4 val) => val;
    [MethodImpl(AggressiveInlining)] public static double4 operator ++(double4 val) => new(val.x + 1, val.y + 1, val.z + 1, val.w + 1);
    [MethodImpl(AggressiveInlining)] public static double4 operator --(double4 val) => new(val.x - 1, val.y - 1, val.z - 1, val.w - 1);

    [MethodImpl(AggressiveInlining)] public bool Equals(double4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
    public override bool Equals(object o) => o is double4 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663) ^ (z.GetHashCode() * 83492791) ^ (w.GetHashCode() * 49979687);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"double4({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)}, {w.ToString(format, formatProvider)})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 4)
            throw new ArgumentException("index must be between[0...3]");
        return index;
    }
}
