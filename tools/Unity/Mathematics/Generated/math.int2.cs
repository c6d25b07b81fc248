// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static int2 int2(int x, int y) => new int2(x, y);
    [MethodImpl(AggressiveInlining)] public static int2 int2(int2 xy) => new int2(xy.x, xy.y);
    [MethodImpl(AggressiveInlining)] public static int2 int2(int v) => new int2(v, v);
    [MethodImpl(AggressiveInlining)] public static int2 int2(bool v) => new int2(v ? 1 : 0, v ? 1 : 0);
    [MethodImpl(AggressiveInlining)] public static int2 int2(bool2 v) => new int2(v.x ? 1 : 0, v.y ? 1 : 0);
    [MethodImpl(AggressiveInlining)] public static int2 int2(uint v) => new int2((int)v, (int)v);
    [MethodImpl(AggressiveInlining)] public static int2 int2(uint2 v) => new int2((int)v.x, (int)v.y);
    [MethodImpl(AggressiveInlining)] public static int2 int2(float v) => new int2((int)v, (int)v);
    [MethodImpl(AggressiveInlining)] public static int2 int2(float2 v) => new int2((int)v.x, (int)v.y);
    [MethodImpl(AggressiveInlining)] public static int2 int2(double v) => new int2((int)v, (int)v);
    [MethodImpl(AggressiveInlining)] public static int2 int2(double2 v) => new int2((int)v.x, (int)v.y);

    [MethodImpl(AggressiveInlining)] public static bool any(int2 x) => x.x != 0 || x.y != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(int2 x) => x.x != 0 && x.y != 0;
    [MethodImpl(AggressiveInlining)] public static int2 square(int2 x) => new int2(square(x.x), square(x.y));
    [MethodImpl(AggressiveInlining)] public static int2 abs(int2 x) => new int2(abs(x.x), abs(x.y));
    [MethodImpl(AggressiveInlining)] public static int2 sign(int2 x) => new int2(sign(x.x), sign(x.y));
    [MethodImpl(AggressiveInlining)] public static int2 min(int2 x, int2 y) => new int2(min(x.x, y.x), min(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static int2 max(int2 x, int2 y) => new int2(max(x.x, y.x), max(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static int2 mad(int2 mulA, int2 mulB, int2 addC) => new int2(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y));
    [MethodImpl(AggressiveInlining)] public static int2 clamp(int2 valueToClamp, int2 lowerBound, int2 upperBound) => new int2(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y));
    [MethodImpl(AggressiveInlining)] public static int2 select(int2 falseValue, int2 trueValue, bool2 test) => new int2(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y));
    [MethodImpl(AggressiveInlining)] public static int2 select(int2 falseValue, int2 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static int csum(int2 x) => x.x + x.y;
    [MethodImpl(AggressiveInlining)] public static int cmin(int2 x) => min(x.x, x.y);
    [MethodImpl(AggressiveInlining)] public static int cmax(int2 x) => max(x.x, x.y);
    [MethodImpl(AggressiveInlining)] public static int dot(int2 x, int2 y) => x.x * y.x + x.y * y.y;
    [MethodImpl(AggressiveInlining)] public static int mul(int2 a, int2 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static int2 ceilpow2(int2 x) => new int2(ceilpow2(x.x), ceilpow2(x.y));
    [MethodImpl(AggressiveInlining)] public static bool2 ispow2(int2 x) => new bool2(ispow2(x.x), ispow2(x.y));
    [MethodImpl(AggressiveInlining)] public static int2 countbits(int2 x) => new int2(countbits(x.x), countbits(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 asfloat(int2 x) => new float2(asfloat(x.x), asfloat(x.y));
    [MethodImpl(AggressiveInlining)] public static uint2 asuint(int2 x) => new uint2(asuint(x.x), asuint(x.y));
}
