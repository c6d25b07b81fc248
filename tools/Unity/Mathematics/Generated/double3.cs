// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct double3 : IEquatable<double3>, IFormattable
{
    public double x;
    public double y;
    public double z;
    public static readonly double3 zero;

    [MethodImpl(AggressiveInlining)] public double3(double x, double y, double z) { this.x = x; this.y = y; this.z = z; }
    [MethodImpl(AggressiveInlining)] public double3(double x, double2 yz) { this.x = x; this.y = yz.x; this.z = yz.y; }
    [MethodImpl(AggressiveInlining)] public double3(double2 xy, double z) { this.x = xy.x; this.y = xy.y; this.z = z; }
    [MethodImpl(AggressiveInlining)] public double3(double3 xyz) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; }
    [MethodImpl(AggressiveInlining)] public double3(double v) { this.x = v; this.y = v; this.z = v; }
    [MethodImpl(AggressiveInlining)] public double3(bool v) { this.x = v ? 1.0 : 0.0; this.y = v ? 1.0 : 0.0; this.z = v ? 1.0 : 0.0; }
    [MethodImpl(AggressiveInlining)] public double3(bool3 v) { this.x = v.x ? 1.0 : 0.0; this.y = v.y ? 1.0 : 0.0; this.z = v.z ? 1.0 : 0.0; }
    [MethodImpl(AggressiveInlining)] public double3(int v) { this.x = v; this.y = v; this.z = v; }
    [MethodImpl(AggressiveInlining)] public double3(int3 v) { this.x = v.x; this.y = v.y; this.z = v.z; }
    [MethodImpl(AggressiveInlining)] public double3(uint v) { this.x = v; this.y = v; this.z = v; }
    [MethodImpl(AggressiveInlining)] public double3(uint3 v) { this.x = v.x; this.y = v.y; this.z = v.z; }
    [MethodImpl(AggressiveInlining)] public double3(float v) { this.x = v; this.y = v; this.z = v; }
    [MethodImpl(AggressiveInlining)] public double3(float3 v) { this.x = v.x; this.y = v.y; this.z = v.z; }

    public unsafe double this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (double3* p = &this) return ((double*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (double3* p = &this) ((double*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator double3(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double3(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double3(int3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double3(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double3(uint3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double3(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double3(float3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator double3(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator double3(bool3 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static double3 operator +(double3 lhs, double3 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator +(double3 lhs, double rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    [MethodImpl(AggressiveInlining)] public static double3 operator +(double lhs, double3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator -(double3 lhs, double3 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator -(double3 lhs, double rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
    [MethodImpl(AggressiveInlining)] public static double3 operator -(double lhs, double3 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator *(double3 lhs, double3 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator *(double3 lhs, double rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
    [MethodImpl(AggressiveInlining)] public static double3 operator *(double lhs, double3 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator /(double3 lhs, double3 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator /(double3 lhs, double rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
    [MethodImpl(AggressiveInlining)] public static double3 operator /(double lhs, double3 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator %(double3 lhs, double3 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator %(double3 lhs, double rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);
    [MethodImpl(AggressiveInlining)] public static double3 operator %(double lhs, double3 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(double3 lhs, double3 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(double3 lhs, double rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <(double lhs, double3 rhs) => new(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(double3 lhs, double3 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(double3 lhs, double rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator <=(double lhs, double3 rhs) => new(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(double3 lhs, double3 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(double3 lhs, double rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >(double lhs, double3 rhs) => new(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(double3 lhs, double3 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(double3 lhs, double rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator >=(double lhs, double3 rhs) => new(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(double3 lhs, double3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(double3 lhs, double rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(double lhs, double3 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(double3 lhs, double3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(double3 lhs, double rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(double lhs, double3 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator -(double3 val) => new(-val.x, -val.y, -val.z);
    [MethodImpl(AggressiveInlining)] public static double3 operator +(double3 val) => val;
    [MethodImpl(AggressiveInlining)] public static double3 operator ++(double3 val) => new(val.x + 1, val.y + 1, val.z + 1);
    [MethodImpl(AggressiveInlining)] public static double3 operator --(double3 val) => new(val.x - 1, val.y - 1, val.z - 1);

    [MethodImpl(AggressiveInlining)] public bool Equals(double3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override bool Equals(object o) => o is double3 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663) ^ (z.GetHashCode() * 83492791);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"double3({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 3)
            throw new ArgumentException("index must be between[0...2]");
        return index;
    }
}
