// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct bool4 : IEquatable<bool4>
{
    [MarshalAs(UnmanagedType.U1)] public bool x;
    [MarshalAs(UnmanagedType.U1)] public bool y;
    [MarshalAs(UnmanagedType.U1)] public bool z;
    [MarshalAs(UnmanagedType.U1)] public bool w;

    [MethodImpl(AggressiveInlining)] public bool4(bool x, bool y, bool z, bool w) { this.x = x; this.y = y; this.z = z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public bool4(bool x, bool y, bool2 zw) { this.x = x; this.y = y; this.z = zw.x; this.w = zw.y; }
    [MethodImpl(AggressiveInlining)] public bool4(bool x, bool2 yz, bool w) { this.x = x; this.y = yz.x; this.z = yz.y; this.w = w; }
    [MethodImpl(AggressiveInlining)] public bool4(bool x, bool3 yzw) { this.x = x; this.y = yzw.x; this.z = yzw.y; this.w = yzw.z; }
    [MethodImpl(AggressiveInlining)] public bool4(bool2 xy, bool z, bool w) { this.x = xy.x; this.y = xy.y; this.z = z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public bool4(bool2 xy, bool2 zw) { this.x = xy.x; this.y = xy.y; this.z = zw.x; this.w = zw.y; }
    [MethodImpl(AggressiveInlining)] public bool4(bool3 xyz, bool w) { this.x = xyz.x; this.y = xyz.y; this.z = xyz.z; this.w = w; }
    [MethodImpl(AggressiveInlining)] public bool4(bool4 xyzw) { this.x = xyzw.x; this.y = xyzw.y; this.z = xyzw.z; this.w = xyzw.w; }
    [MethodImpl(AggressiveInlining)] public bool4(bool v) { this.x = v; this.y = v; this.z = v; this.w = v; }

    public unsafe bool this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (bool4* p = &this) return ((bool*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (bool4* p = &this) ((bool*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator bool4(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(bool4 lhs, bool4 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(bool4 lhs, bool rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ==(bool lhs, bool4 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(bool4 lhs, bool4 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(bool4 lhs, bool rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !=(bool lhs, bool4 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator &(bool4 lhs, bool4 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z, lhs.w & rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator &(bool4 lhs, bool rhs) => new(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs, lhs.w & rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator &(bool lhs, bool4 rhs) => new(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z, lhs & rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator |(bool4 lhs, bool4 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z, lhs.w | rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator |(bool4 lhs, bool rhs) => new(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs, lhs.w | rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator |(bool lhs, bool4 rhs) => new(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z, lhs | rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ^(bool4 lhs, bool4 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z, lhs.w ^ rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ^(bool4 lhs, bool rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs, lhs.w ^ rhs);
    [MethodImpl(AggressiveInlining)] public static bool4 operator ^(bool lhs, bool4 rhs) => new(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z, lhs ^ rhs.w);
    [MethodImpl(AggressiveInlining)] public static bool4 operator !(bool4 val) => new(!val.x, !val.y, !val.z, !val.w);

    [MethodImpl(AggressiveInlining)] public bool Equals(bool4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
    public override bool Equals(object o) => o is bool4 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663) ^ (z.GetHashCode() * 83492791) ^ (w.GetHashCode() * 49979687);
    public override string ToString() => $"bool4({x}, {y}, {z}, {w})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 4)
            throw new ArgumentException("index must be between[0...3]");
        return index;
    }
}
