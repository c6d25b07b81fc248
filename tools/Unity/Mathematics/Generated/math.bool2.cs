// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static bool2 bool2(bool x, bool y) => new bool2(x, y);
    [MethodImpl(AggressiveInlining)] public static bool2 bool2(bool2 xy) => new bool2(xy.x, xy.y);
    [MethodImpl(AggressiveInlining)] public static bool2 bool2(bool v) => new bool2(v, v);

    [MethodImpl(AggressiveInlining)] public static bool any(bool2 x) => x.x || x.y;
    [MethodImpl(AggressiveInlining)] public static bool all(bool2 x) => x.x && x.y;
}
