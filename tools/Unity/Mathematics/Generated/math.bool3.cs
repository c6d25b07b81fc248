// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static bool3 bool3(bool x, bool y, bool z) => new bool3(x, y, z);
    [MethodImpl(AggressiveInlining)] public static bool3 bool3(bool x, bool2 yz) => new bool3(x, yz.x, yz.y);
    [MethodImpl(AggressiveInlining)] public static bool3 bool3(bool2 xy, bool z) => new bool3(xy.x, xy.y, z);
    [MethodImpl(AggressiveInlining)] public static bool3 bool3(bool3 xyz) => new bool3(xyz.x, xyz.y, xyz.z);
    [MethodImpl(AggressiveInlining)] public static bool3 bool3(bool v) => new bool3(v, v, v);

    [MethodImpl(AggressiveInlining)] public static bool any(bool3 x) => x.x || x.y || x.z;
    [MethodImpl(AggressiveInlining)] public static bool all(bool3 x) => x.x && x.y && x.z;
}
