// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct bool3 : IEquatable<bool3>
{
    [MarshalAs(UnmanagedType.U1)] public bool x;
    [MarshalAs(UnmanagedType.U1)] public bool y;
    [MarshalAs(UnmanagedType.U1)] public bool z;

    [MethodImpl(AggressiveInlining)] public bool3(bool x, bool y, bool z) { this.x = x; this.y = y; this.z = z; }
    [MethodImpl(AggressiveInlining)] public bool3(bool x, bool2 yz) { this.x = x; this.y = yz.x; this.z = yz.y; }
    [MethodImpl(AggressiveInlining)] public bool3(bool2 xy, bool z) { this.x = xy.x; this.y = xy.y; this.z = z; }
    [MethodImpl(AggressiveInlining)] public bool3(bool3 xyz) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; }
    [MethodImpl(AggressiveInlining)] public bool3(bool v) { this.x = v; this.y = v; this.z = v; }

    public unsafe bool this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (bool3* p = &this) return ((bool*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (bool3* p = &this) ((bool*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator bool3(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(bool3 lhs, bool3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(bool3 lhs, bool rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ==(bool lhs, bool3 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(bool3 lhs, bool3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(bool3 lhs, bool rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !=(bool lhs, bool3 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator &(bool3 lhs, bool3 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator &(bool3 lhs, bool rhs) => new(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator &(bool lhs, bool3 rhs) => new(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator |(bool3 lhs, bool3 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator |(bool3 lhs, bool rhs) => new(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator |(bool lhs, bool3 rhs) => new(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ^(bool3 lhs, bool3 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ^(bool3 lhs, bool rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs);
    [MethodImpl(AggressiveInlining)] public static bool3 operator ^(bool lhs, bool3 rhs) => new(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z);
    [MethodImpl(AggressiveInlining)] public static bool3 operator !(bool3 val) => new(!val.x, !val.y, !val.z);

    [MethodImpl(AggressiveInlining)] public bool Equals(bool3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override bool Equals(object o) => o is bool3 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663) ^ (z.GetHashCode() * 83492791);
    public override string ToString() => $"bool3({x}, {y}, {z})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 3)
            throw new ArgumentException("index must be between[0...2]");
        return index;
    }
}
