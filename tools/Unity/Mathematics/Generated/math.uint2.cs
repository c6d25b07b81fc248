// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(uint x, uint y) => new uint2(x, y);
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(uint2 xy) => new uint2(xy.x, xy.y);
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(uint v) => new uint2(v, v);
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(bool v) => new uint2(v ? 1u : 0u, v ? 1u : 0u);
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(bool2 v) => new uint2(v.x ? 1u : 0u, v.y ? 1u : 0u);
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(int v) => new uint2((uint)v, (uint)v);
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(int2 v) => new uint2((uint)v.x, (uint)v.y);
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(float v) => new uint2((uint)v, (uint)v);
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(float2 v) => new uint2((uint)v.x, (uint)v.y);
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(double v) => new uint2((uint)v, (uint)v);
    [MethodImpl(AggressiveInlining)] public static uint2 uint2(double2 v) => new uint2((uint)v.x, (uint)v.y);

    [MethodImpl(AggressiveInlining)] public static bool any(uint2 x) => x.x != 0 || x.y != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(uint2 x) => x.x != 0 && x.y != 0;
    [MethodImpl(AggressiveInlining)] public static uint2 square(uint2 x) => new uint2(square(x.x), square(x.y));
    [MethodImpl(AggressiveInlining)] public static uint2 min(uint2 x, uint2 y) => new uint2(min(x.x, y.x), min(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static uint2 max(uint2 x, uint2 y) => new uint2(max(x.x, y.x), max(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static uint2 mad(uint2 mulA, uint2 mulB, uint2 addC) => new uint2(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y));
    [MethodImpl(AggressiveInlining)] public static uint2 clamp(uint2 valueToClamp, uint2 lowerBound, uint2 upperBound) => new uint2(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y));
    [MethodImpl(AggressiveInlining)] public static uint2 select(uint2 falseValue, uint2 trueValue, bool2 test) => new uint2(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y));
    [MethodImpl(AggressiveInlining)] public static uint2 select(uint2 falseValue, uint2 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static uint csum(uint2 x) => x.x + x.y;
    [MethodImpl(AggressiveInlining)] public static uint cmin(uint2 x) => min(x.x, x.y);
    [MethodImpl(AggressiveInlining)] public static uint cmax(uint2 x) => max(x.x, x.y);
    [MethodImpl(AggressiveInlining)] public static uint dot(uint2 x, uint2 y) => x.x * y.x + x.y * y.y;
    [MethodImpl(AggressiveInlining)] public static uint mul(uint2 a, uint2 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static uint2 ceilpow2(uint2 x) => new uint2(ceilpow2(x.x), ceilpow2(x.y));
    [MethodImpl(AggressiveInlining)] public static bool2 ispow2(uint2 x) => new bool2(ispow2(x.x), ispow2(x.y));
    [MethodImpl(AggressiveInlining)] public static int2 countbits(uint2 x) => new int2(countbits(x.x), countbits(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 asfloat(uint2 x) => new float2(asfloat(x.x), asfloat(x.y));
    [MethodImpl(AggressiveInlining)] public static int2 asint(uint2 x) => new int2(asint(x.x), asint(x.y));
}
