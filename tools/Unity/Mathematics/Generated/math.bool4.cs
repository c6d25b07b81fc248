// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static bool4 bool4(bool x, bool y, bool z, bool w) => new bool4(x, y, z, w);
    [MethodImpl(AggressiveInlining)] public static bool4 bool4(bool x, bool y, bool2 zw) => new bool4(x, y, zw.x, zw.y);
    [MethodImpl(AggressiveInlining)] public static bool4 bool4(bool x, bool2 yz, bool w) => new bool4(x, yz.x, yz.y, w);
    [MethodImpl(AggressiveInlining)] public static bool4 bool4(bool x, bool3 yzw) => new bool4(x, yzw.x, yzw.y, yzw.z);
    [MethodImpl(AggressiveInlining)] public static bool4 bool4(bool2 xy, bool z, bool w) => new bool4(xy.x, xy.y, z, w);
    [MethodImpl(AggressiveInlining)] public static bool4 bool4(bool2 xy, bool2 zw) => new bool4(xy.x, xy.y, zw.x, zw.y);
    [MethodImpl(AggressiveInlining)] public static bool4 bool4(bool3 xyz, bool w) => new bool4(xyz.x, xyz.y, xyz.z, w);
    [MethodImpl(AggressiveInlining)] public static bool4 bool4(bool4 xyzw) => new bool4(xyzw.x, xyzw.y, xyzw.z, xyzw.w);
    [MethodImpl(AggressiveInlining)] public static bool4 bool4(bool v) => new bool4(v, v, v, v);

    [MethodImpl(AggressiveInlining)] public static bool any(bool4 x) => x.x || x.y || x.z || x.w;
    [MethodImpl(AggressiveInlining)] public static bool all(bool4 x) => x.x && x.y && x.z && x.w;
}
