// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static int4 int4(int x, int y, int z, int w) => new int4(x, y, z, w);
    [MethodImpl(AggressiveInlining)] public static int4 int4(int x, int y, int2 zw) => new int4(x, y, zw.x, zw.y);
    [MethodImpl(AggressiveInlining)] public static int4 int4(int x, int2 yz, int w) => new int4(x, yz.x, yz.y, w);
    [MethodImpl(AggressiveInlining)] public static int4 int4(int x, int3 yzw) => new int4(x, yzw.x, yzw.y, yzw.z);
    [MethodImpl(AggressiveInlining)] public static int4 int4(int2 xy, int z, int w) => new int4(xy.x, xy.y, z, w);
    [MethodImpl(AggressiveInlining)] public static int4 int4(int2 xy, int2 zw) => new int4(xy.x, xy.y, zw.x, zw.y);
    [MethodImpl(AggressiveInlining)] public static int4 int4(int3 xyz, int w) => new int4(xyz.x, xyz.y, xyz.z, w);
    [MethodImpl(AggressiveInlining)] public static int4 int4(int4 xyzw) => new int4(xyzw.x, xyzw.y, xyzw.z, xyzw.w);
    [MethodImpl(AggressiveInlining)] public static int4 int4(int v) => new int4(v, v, v, v);
    [MethodImpl(AggressiveInlining)] public static int4 int4(bool v) => new int4(v ? 1 : 0, v ? 1 : 0, v ? 1 : 0, v ? 1 : 0);
    [MethodImpl(AggressiveInlining)] public static int4 int4(bool4 v) => new int4(v.x ? 1 : 0, v.y ? 1 : 0, v.z ? 1 : 0, v.w ? 1 : 0);
    [MethodImpl(AggressiveInlining)] public static int4 int4(uint v) => new int4((int)v, (int)v, (int)v, (int)v);
    [MethodImpl(AggressiveInlining)] public static int4 int4(uint4 v) => new int4((int)v.x, (int)v.y, (int)v.z, (int)v.w);
    [MethodImpl(AggressiveInlining)] public static int4 int4(float v) => new int4((int)v, (int)v, (int)v, (int)v);
    [MethodImpl(AggressiveInlining)] public static int4 int4(float4 v) => new int4((int)v.x, (int)v.y, (int)v.z, (int)v.w);
    [MethodImpl(AggressiveInlining)] public static int4 int4(double v) => new int4((int)v, (int)v, (int)v, (int)v);
    [MethodImpl(AggressiveInlining)] public static int4 int4(double4 v) => new int4((int)v.x, (int)v.y, (int)v.z, (int)v.w);

    [MethodImpl(AggressiveInlining)] public static bool any(int4 x) => x.x != 0 || x.y != 0 || x.z != 0 || x.w != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(int4 x) => x.x != 0 && x.y != 0 && x.z != 0 && x.w != 0;
    [MethodImpl(AggressiveInlining)] public static int4 square(int4 x) => new int4(square(x.x), square(x.y), square(x.z), square(x.w));
    [MethodImpl(AggressiveInlining)] public static int4 abs(int4 x) => new int4(abs(x.x), abs(x.y), abs(x.z), abs(x.w));
    [MethodImpl(AggressiveInlining)] public static int4 sign(int4 x) => new int4(sign(x.x), sign(x.y), sign(x.z), sign(x.w));
    [MethodImpl(AggressiveInlining)] public static int4 min(int4 x, int4 y) => new int4(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z), min(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static int4 max(int4 x, int4 y) => new int4(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z), max(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static int4 mad(int4 mulA, int4 mulB, int4 addC) => new int4(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z), mad(mulA.w, mulB.w, addC.w));
    [MethodImpl(AggressiveInlining)] public static int4 clamp(int4 valueToClamp, int4 lowerBound, int4 upperBound) => new int4(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z), clamp(valueToClamp.w, lowerBound.w, upperBound.w));
    [MethodImpl(AggressiveInlining)] public static int4 select(int4 falseValue, int4 trueValue, bool4 test) => new int4(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z), select(falseValue.w, trueValue.w, test.w));
    [MethodImpl(AggressiveInlining)] public static int4 select(int4 falseValue, int4 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static int csum(int4 x) => (x.x + x.y) + (x.z + x.w);
    [MethodImpl(AggressiveInlining)] public static int cmin(int4 x) => min(min(x.x, x.y), min(x.z, x.w));
    [MethodImpl(AggressiveInlining)] public static int cmax(int4 x) => max(max(x.x, x.y), max(x.z, x.w));
    [MethodImpl(AggressiveInlining)] public static int dot(int4 x, int4 y) => x.x * y.x + x.y * y.y + x.z * y.z + x.w * y.w;
    [MethodImpl(AggressiveInlining)] public static int mul(int4 a, int4 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static int4 ceilpow2(int4 x) => new int4(ceilpow2(x.x), ceilpow2(x.y), ceilpow2(x.z), ceilpow2(x.w));
    [MethodImpl(AggressiveInlining)] public static bool4 ispow2(int4 x) => new bool4(ispow2(x.x), ispow2(x.y), ispow2(x.z), ispow2(x.w));
    [MethodImpl(AggressiveInlining)] public static int4 countbits(int4 x) => new int4(countbits(x.x), countbits(x.y), countbits(x.z), countbits(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 asfloat(int4 x) => new float4(asfloat(x.x), asfloat(x.y), asfloat(x.z), asfloat(x.w));
    [MethodImpl(AggressiveInlining)] public static uint4 asuint(int4 x) => new uint4(asuint(x.x), asuint(x.y), asuint(x.z), asuint(x.w));
}
