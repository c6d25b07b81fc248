// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct double2 : IEquatable<double2>, IFormattable
{
    public double x;
    public double y;
    public static readonly double2 zero;

    [MethodImpl(AggressiveInlining)] public double2(double x, double y) { this.x = x; this.y = y; }
    [MethodImpl(AggressiveInlining)] public double2(double2 xy) { this.x = xy.x; this.y = xy.y; }
    [MethodImpl(AggressiveInlining)] public double2(double v) { this.x = v; this.y = v; }
    [MethodImpl(AggressiveInlining)] public double2(bool v) { this.x = v ? 1.0 : 0.0; this.y = v ? 1.0 : 0.0; }
    [MethodImpl(AggressiveInlining)] public double2(bool2 v) { this.x = v.x ? 1.0 : 0.0; this.y = v.y ? 1.0 : 0.0; }
    [MethodImpl(AggressiveInlining)] public double2(int v) { this.x = v; this.y = v; }
    [MethodImpl(AggressiveInlining)] public double2(int2 v) { this.x = v.x; this.y = v.y; }
    [MethodImpl(AggressiveInlining)] public double2(uint v) { this.x = v; this.y = v; }
    [MethodImpl(AggressiveInlining)] public double2(uint2 v) { this.x = v.x; this.y = v.y; }
    [MethodImpl(AggressiveInlining)] public double2(float v) { this.x = v; this.y = v; }
    [MethodImpl(AggressiveInlining)] public double2(float2 v) { this.x = v.x; this.y = v.y; }

    public unsafe double this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (double2* p = &this) return ((double*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (double2* p = &this) ((double*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator double2(double v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double2(int v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double2(int2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double2(uint v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double2(uint2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double2(float v) => new(v);
    [MethodImpl(AggressiveInlining)] public static implicit operator double2(float2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator double2(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static explicit operator double2(bool2 v) => new(v);
    [MethodImpl(AggressiveInlining)] public static double2 operator +(double2 lhs, double2 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator +(double2 lhs, double rhs) => new(lhs.x + rhs, lhs.y + rhs);
    [MethodImpl(AggressiveInlining)] public static double2 operator +(double lhs, double2 rhs) => new(lhs + rhs.x, lhs + rhs.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator -(double2 lhs, double2 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator -(double2 lhs, double rhs) => new(lhs.x - rhs, lhs.y - rhs);
    [MethodImpl(AggressiveInlining)] public static double2 operator -(double lhs, double2 rhs) => new(lhs - rhs.x, lhs - rhs.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator *(double2 lhs, double2 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator *(double2 lhs, double rhs) => new(lhs.x * rhs, lhs.y * rhs);
    [MethodImpl(AggressiveInlining)] public static double2 operator *(double lhs, double2 rhs) => new(lhs * rhs.x, lhs * rhs.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator /(double2 lhs, double2 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator /(double2 lhs, double rhs) => new(lhs.x / rhs, lhs.y / rhs);
    [MethodImpl(AggressiveInlining)] public static double2 operator /(double lhs, double2 rhs) => new(lhs / rhs.x, lhs / rhs.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator %(double2 lhs, double2 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator %(double2 lhs, double rhs) => new(lhs.x % rhs, lhs.y % rhs);
    [MethodImpl(AggressiveInlining)] public static double2 operator %(double lhs, double2 rhs) => new(lhs % rhs.x, lhs % rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(double2 lhs, double2 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(double2 lhs, double rhs) => new(lhs.x < rhs, lhs.y < rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <(double lhs, double2 rhs) => new(lhs < rhs.x, lhs < rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(double2 lhs, double2 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(double2 lhs, double rhs) => new(lhs.x <= rhs, lhs.y <= rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator <=(double lhs, double2 rhs) => new(lhs <= rhs.x, lhs <= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(double2 lhs, double2 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(double2 lhs, double rhs) => new(lhs.x > rhs, lhs.y > rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >(double lhs, double2 rhs) => new(lhs > rhs.x, lhs > rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(double2 lhs, double2 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(double2 lhs, double rhs) => new(lhs.x >= rhs, lhs.y >= rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator >=(double lhs, double2 rhs) => new(lhs >= rhs.x, lhs >= rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(double2 lhs, double2 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(double2 lhs, double rhs) => new(lhs.x == rhs, lhs.y == rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(double lhs, double2 rhs) => new(lhs == rhs.x, lhs == rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(double2 lhs, double2 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(double2 lhs, double rhs) => new(lhs.x != rhs, lhs.y != rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(double lhs, double2 rhs) => new(lhs != rhs.x, lhs != rhs.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator -(double2 val) => new(-val.x, -val.y);
    [MethodImpl(AggressiveInlining)] public static double2 operator +(double2 val) => val;
    [MethodImpl(AggressiveInlining)] public static double2 operator ++(double2 val) => new(val.x + 1, val.y + 1);
    [MethodImpl(AggressiveInlining)] public static double2 operator --(double2 val) => new(val.x - 1, val.y - 1);

    [MethodImpl(AggressiveInlining)] public bool Equals(double2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is double2 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663);
    public override string ToString() => ToString(null, null);
    public string ToString(string format, IFormatProvider formatProvider) => $"double2({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 2)
            throw new ArgumentException("index must be between[0...1]");
        return index;
    }
}
