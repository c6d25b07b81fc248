// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(uint x, uint y, uint z) => new uint3(x, y, z);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(uint x, uint2 yz) => new uint3(x, yz.x, yz.y);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(uint2 xy, uint z) => new uint3(xy.x, xy.y, z);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(uint3 xyz) => new uint3(xyz.x, xyz.y, xyz.z);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(uint v) => new uint3(v, v, v);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(bool v) => new uint3(v ? 1u : 0u, v ? 1u : 0u, v ? 1u : 0u);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(bool3 v) => new uint3(v.x ? 1u : 0u, v.y ? 1u : 0u, v.z ? 1u : 0u);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(int v) => new uint3((uint)v, (uint)v, (uint)v);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(int3 v) => new uint3((uint)v.x, (uint)v.y, (uint)v.z);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(float v) => new uint3((uint)v, (uint)v, (uint)v);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(float3 v) => new uint3((uint)v.x, (uint)v.y, (uint)v.z);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(double v) => new uint3((uint)v, (uint)v, (uint)v);
    [MethodImpl(AggressiveInlining)] public static uint3 uint3(double3 v) => new uint3((uint)v.x, (uint)v.y, (uint)v.z);

    [MethodImpl(AggressiveInlining)] public static bool any(uint3 x) => x.x != 0 || x.y != 0 || x.z != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(uint3 x) => x.x != 0 && x.y != 0 && x.z != 0;
    [MethodImpl(AggressiveInlining)] public static uint3 square(uint3 x) => new uint3(square(x.x), square(x.y), square(x.z));
    [MethodImpl(AggressiveInlining)] public static uint3 min(uint3 x, uint3 y) => new uint3(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static uint3 max(uint3 x, uint3 y) => new uint3(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static uint3 mad(uint3 mulA, uint3 mulB, uint3 addC) => new uint3(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z));
    [MethodImpl(AggressiveInlining)] public static uint3 clamp(uint3 valueToClamp, uint3 lowerBound, uint3 upperBound) => new uint3(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z));
    [MethodImpl(AggressiveInlining)] public static uint3 select(uint3 falseValue, uint3 trueValue, bool3 test) => new uint3(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z));
    [MethodImpl(AggressiveInlining)] public static uint3 select(uint3 falseValue, uint3 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static uint csum(uint3 x) => x.x + x.y + x.z;
    [MethodImpl(AggressiveInlining)] public static uint cmin(uint3 x) => min(min(x.x, x.y), x.z);
    [MethodImpl(AggressiveInlining)] public static uint cmax(uint3 x) => max(max(x.x, x.y), x.z);
    [MethodImpl(AggressiveInlining)] public static uint dot(uint3 x, uint3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    [MethodImpl(AggressiveInlining)] public static uint mul(uint3 a, uint3 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static uint3 ceilpow2(uint3 x) => new uint3(ceilpow2(x.x), ceilpow2(x.y), ceilpow2(x.z));
    [MethodImpl(AggressiveInlining)] public static bool3 ispow2(uint3 x) => new bool3(ispow2(x.x), ispow2(x.y), ispow2(x.z));
    [MethodImpl(AggressiveInlining)] public static int3 countbits(uint3 x) => new int3(countbits(x.x), countbits(x.y), countbits(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 asfloat(uint3 x) => new float3(asfloat(x.x), asfloat(x.y), asfloat(x.z));
    [MethodImpl(AggressiveInlining)] public static int3 asint(uint3 x) => new int3(asint(x.x), asint(x.y), asint(x.z));
}
