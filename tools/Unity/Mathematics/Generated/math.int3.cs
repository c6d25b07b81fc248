// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static int3 int3(int x, int y, int z) => new int3(x, y, z);
    [MethodImpl(AggressiveInlining)] public static int3 int3(int x, int2 yz) => new int3(x, yz.x, yz.y);
    [MethodImpl(AggressiveInlining)] public static int3 int3(int2 xy, int z) => new int3(xy.x, xy.y, z);
    [MethodImpl(AggressiveInlining)] public static int3 int3(int3 xyz) => new int3(xyz.x, xyz.y, xyz.z);
    [MethodImpl(AggressiveInlining)] public static int3 int3(int v) => new int3(v, v, v);
    [MethodImpl(AggressiveInlining)] public static int3 int3(bool v) => new int3(v ? 1 : 0, v ? 1 : 0, v ? 1 : 0);
    [MethodImpl(AggressiveInlining)] public static int3 int3(bool3 v) => new int3(v.x ? 1 : 0, v.y ? 1 : 0, v.z ? 1 : 0);
    [MethodImpl(AggressiveInlining)] public static int3 int3(uint v) => new int3((int)v, (int)v, (int)v);
    [MethodImpl(AggressiveInlining)] public static int3 int3(uint3 v) => new int3((int)v.x, (int)v.y, (int)v.z);
    [MethodImpl(AggressiveInlining)] public static int3 int3(float v) => new int3((int)v, (int)v, (int)v);
    [MethodImpl(AggressiveInlining)] public static int3 int3(float3 v) => new int3((int)v.x, (int)v.y, (int)v.z);
    [MethodImpl(AggressiveInlining)] public static int3 int3(double v) => new int3((int)v, (int)v, (int)v);
    [MethodImpl(AggressiveInlining)] public static int3 int3(double3 v) => new int3((int)v.x, (int)v.y, (int)v.z);

    [MethodImpl(AggressiveInlining)] public static bool any(int3 x) => x.x != 0 || x.y != 0 || x.z != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(int3 x) => x.x != 0 && x.y != 0 && x.z != 0;
    [MethodImpl(AggressiveInlining)] public static int3 square(int3 x) => new int3(square(x.x), square(x.y), square(x.z));
    [MethodImpl(AggressiveInlining)] public static int3 abs(int3 x) => new int3(abs(x.x), abs(x.y), abs(x.z));
    [MethodImpl(AggressiveInlining)] public static int3 sign(int3 x) => new int3(sign(x.x), sign(x.y), sign(x.z));
    [MethodImpl(AggressiveInlining)] public static int3 min(int3 x, int3 y) => new int3(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static int3 max(int3 x, int3 y) => new int3(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static int3 mad(int3 mulA, int3 mulB, int3 addC) => new int3(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z));
    [MethodImpl(AggressiveInlining)] public static int3 clamp(int3 valueToClamp, int3 lowerBound, int3 upperBound) => new int3(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z));
    [MethodImpl(AggressiveInlining)] public static int3 select(int3 falseValue, int3 trueValue, bool3 test) => new int3(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z));
    [MethodImpl(AggressiveInlining)] public static int3 select(int3 falseValue, int3 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static int csum(int3 x) => x.x + x.y + x.z;
    [MethodImpl(AggressiveInlining)] public static int cmin(int3 x) => min(min(x.x, x.y), x.z);
    [MethodImpl(AggressiveInlining)] public static int cmax(int3 x) => max(max(x.x, x.y), x.z);
    [MethodImpl(AggressiveInlining)] public static int dot(int3 x, int3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    [MethodImpl(AggressiveInlining)] public static int mul(int3 a, int3 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static int3 ceilpow2(int3 x) => new int3(ceilpow2(x.x), ceilpow2(x.y), ceilpow2(x.z));
    [MethodImpl(AggressiveInlining)] public static bool3 ispow2(int3 x) => new bool3(ispow2(x.x), ispow2(x.y), ispow2(x.z));
    [MethodImpl(AggressiveInlining)] public static int3 countbits(int3 x) => new int3(countbits(x.x), countbits(x.y), countbits(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 asfloat(int3 x) => new float3(asfloat(x.x), asfloat(x.y), asfloat(x.z));
    [MethodImpl(AggressiveInlining)] public static uint3 asuint(int3 x) => new uint3(asuint(x.x), asuint(x.y), asuint(x.z));
}
