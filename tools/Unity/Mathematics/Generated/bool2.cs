// Written by generate.py.
using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

[Serializable]
public partial struct bool2 : IEquatable<bool2>
{
    [MarshalAs(UnmanagedType.U1)] public bool x;
    [MarshalAs(UnmanagedType.U1)] public bool y;

    [MethodImpl(AggressiveInlining)] public bool2(bool x, bool y) { this.x = x; this.y = y; }
    [MethodImpl(AggressiveInlining)] public bool2(bool2 xy) { this.x = xy.x; this.y = xy.y; }
    [MethodImpl(AggressiveInlining)] public bool2(bool v) { this.x = v; this.y = v; }

    public unsafe bool this[int index]
    {
        [MethodImpl(AggressiveInlining)] get { fixed (bool2* p = &this) return ((bool*)p)[Checked(index)]; }
        [MethodImpl(AggressiveInlining)] set { fixed (bool2* p = &this) ((bool*)p)[Checked(index)] = value; }
    }

    [MethodImpl(AggressiveInlining)] public static implicit operator bool2(bool v) => new(v);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(bool2 lhs, bool2 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(bool2 lhs, bool rhs) => new(lhs.x == rhs, lhs.y == rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ==(bool lhs, bool2 rhs) => new(lhs == rhs.x, lhs == rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(bool2 lhs, bool2 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(bool2 lhs, bool rhs) => new(lhs.x != rhs, lhs.y != rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !=(bool lhs, bool2 rhs) => new(lhs != rhs.x, lhs != rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator &(bool2 lhs, bool2 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator &(bool2 lhs, bool rhs) => new(lhs.x & rhs, lhs.y & rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator &(bool lhs, bool2 rhs) => new(lhs & rhs.x, lhs & rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator |(bool2 lhs, bool2 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator |(bool2 lhs, bool rhs) => new(lhs.x | rhs, lhs.y | rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator |(bool lhs, bool2 rhs) => new(lhs | rhs.x, lhs | rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ^(bool2 lhs, bool2 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ^(bool2 lhs, bool rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs);
    [MethodImpl(AggressiveInlining)] public static bool2 operator ^(bool lhs, bool2 rhs) => new(lhs ^ rhs.x, lhs ^ rhs.y);
    [MethodImpl(AggressiveInlining)] public static bool2 operator !(bool2 val) => new(!val.x, !val.y);

    [MethodImpl(AggressiveInlining)] public bool Equals(bool2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is bool2 other && Equals(other);
    public override int GetHashCode() => (x.GetHashCode() * 73856093) ^ (y.GetHashCode() * 19349663);
    public override string ToString() => $"bool2({x}, {y})";

    [MethodImpl(AggressiveInlining)]
    static int Checked(int index)
    {
        if ((uint)index >= 2)
            throw new ArgumentException("index must be between[0...1]");
        return index;
    }
}
