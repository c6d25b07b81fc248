// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(uint x, uint y, uint z, uint w) => new uint4(x, y, z, w);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(uint x, uint y, uint2 zw) => new uint4(x, y, zw.x, zw.y);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(uint x, uint2 yz, uint w) => new uint4(x, yz.x, yz.y, w);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(uint x, uint3 yzw) => new uint4(x, yzw.x, yzw.y, yzw.z);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(uint2 xy, uint z, uint w) => new uint4(xy.x, xy.y, z, w);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(uint2 xy, uint2 zw) => new uint4(xy.x, xy.y, zw.x, zw.y);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(uint3 xyz, uint w) => new uint4(xyz.x, xyz.y, xyz.z, w);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(uint4 xyzw) => new uint4(xyzw.x, xyzw.y, xyzw.z, xyzw.w);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(uint v) => new uint4(v, v, v, v);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(bool v) => new uint4(v ? 1u : 0u, v ? 1u : 0u, v ? 1u : 0u, v ? 1u : 0u);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(bool4 v) => new uint4(v.x ? 1u : 0u, v.y ? 1u : 0u, v.z ? 1u : 0u, v.w ? 1u : 0u);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(int v) => new uint4((uint)v, (uint)v, (uint)v, (uint)v);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(int4 v) => new uint4((uint)v.x, (uint)v.y, (uint)v.z, (uint)v.w);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(float v) => new uint4((uint)v, (uint)v, (uint)v, (uint)v);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(float4 v) => new uint4((uint)v.x, (uint)v.y, (uint)v.z, (uint)v.w);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(double v) => new uint4((uint)v, (uint)v, (uint)v, (uint)v);
    [MethodImpl(AggressiveInlining)] public static uint4 uint4(double4 v) => new uint4((uint)v.x, (uint)v.y, (uint)v.z, (uint)v.w);

    [MethodImpl(AggressiveInlining)] public static bool any(uint4 x) => x.x != 0 || x.y != 0 || x.z != 0 || x.w != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(uint4 x) => x.x != 0 && x.y != 0 && x.z != 0 && x.w != 0;
    [MethodImpl(AggressiveInlining)] public static uint4 square(uint4 x) => new uint4(square(x.x), square(x.y), square(x.z), square(x.w));
    [MethodImpl(AggressiveInlining)] public static uint4 min(uint4 x, uint4 y) => new uint4(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z), min(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static uint4 max(uint4 x, uint4 y) => new uint4(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z), max(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static uint4 mad(uint4 mulA, uint4 mulB, uint4 addC) => new uint4(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z), mad(mulA.w, mulB.w, addC.w));
    [MethodImpl(AggressiveInlining)] public static uint4 clamp(uint4 valueToClamp, uint4 lowerBound, uint4 upperBound) => new uint4(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z), clamp(valueToClamp.w, lowerBound.w, upperBound.w));
    [MethodImpl(AggressiveInlining)] public static uint4 select(uint4 falseValue, uint4 trueValue, bool4 test) => new uint4(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z), select(falseValue.w, trueValue.w, test.w));
    [MethodImpl(AggressiveInlining)] public static uint4 select(uint4 falseValue, uint4 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static uint csum(uint4 x) => (x.x + x.y) + (x.z + x.w);
    [MethodImpl(AggressiveInlining)] public static uint cmin(uint4 x) => min(min(x.x, x.y), min(x.z, x.w));
    [MethodImpl(AggressiveInlining)] public static uint cmax(uint4 x) => max(max(x.x, x.y), max(x.z, x.w));
    [MethodImpl(AggressiveInlining)] public static uint dot(uint4 x, uint4 y) => x.x * y.x + x.y * y.y + x.z * y.z + x.w * y.w;
    [MethodImpl(AggressiveInlining)] public static uint mul(uint4 a, uint4 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static uint4 ceilpow2(uint4 x) => new uint4(ceilpow2(x.x), ceilpow2(x.y), ceilpow2(x.z), ceilpow2(x.w));
    [MethodImpl(AggressiveInlining)] public static bool4 ispow2(uint4 x) => new bool4(ispow2(x.x), ispow2(x.y), ispow2(x.z), ispow2(x.w));
    [MethodImpl(AggressiveInlining)] public static int4 countbits(uint4 x) => new int4(countbits(x.x), countbits(x.y), countbits(x.z), countbits(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 asfloat(uint4 x) => new float4(asfloat(x.x), asfloat(x.y), asfloat(x.z), asfloat(x.w));
    [MethodImpl(AggressiveInlining)] public static int4 asint(uint4 x) => new int4(asint(x.x), asint(x.y), asint(x.z), asint(x.w));
}
