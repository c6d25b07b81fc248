// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static float4 float4(float x, float y, float z, float w) => new float4(x, y, z, w);
    [MethodImpl(AggressiveInlining)] public static float4 float4(float x, float y, float2 zw) => new float4(x, y, zw.x, zw.y);
    [MethodImpl(AggressiveInlining)] public static float4 float4(float x, float2 yz, float w) => new float4(x, yz.x, yz.y, w);
    [MethodImpl(AggressiveInlining)] public static float4 float4(float x, float3 yzw) => new float4(x, yzw.x, yzw.y, yzw.z);
    [MethodImpl(AggressiveInlining)] public static float4 float4(float2 xy, float z, float w) => new float4(xy.x, xy.y, z, w);
    [MethodImpl(AggressiveInlining)] public static float4 float4(float2 xy, float2 zw) => new float4(xy.x, xy.y, zw.x, zw.y);
    [MethodImpl(AggressiveInlining)] public static float4 float4(float3 xyz, float w) => new float4(xyz.x, xyz.y, xyz.z, w);
    [MethodImpl(AggressiveInlining)] public static float4 float4(float4 xyzw) => new float4(xyzw.x, xyzw.y, xyzw.z, xyzw.w);
    [MethodImpl(AggressiveInlining)] public static float4 float4(float v) => new float4(v, v, v, v);
    [MethodImpl(AggressiveInlining)] public static float4 float4(bool v) => new float4(v ? 1f : 0f, v ? 1f : 0f, v ? 1f : 0f, v ? 1f : 0f);
    [MethodImpl(AggressiveInlining)] public static float4 float4(bool4 v) => new float4(v.x ? 1f : 0f, v.y ? 1f : 0f, v.z ? 1f : 0f, v.w ? 1f : 0f);
    [MethodImpl(AggressiveInlining)] public static float4 float4(int v) => new float4(v, v, v, v);
    [MethodImpl(AggressiveInlining)] public static float4 float4(int4 v) => new float4(v.x, v.y, v.z, v.w);
    [MethodImpl(AggressiveInlining)] public static float4 float4(uint v) => new float4(v, v, v, v);
    [MethodImpl(AggressiveInlining)] public static float4 float4(uint4 v) => new float4(v.x, v.y, v.z, v.w);
    [MethodImpl(AggressiveInlining)] public static float4 float4(double v) => new float4((float)v, (float)v, (float)v, (float)v);
    [MethodImpl(AggressiveInlining)] public static float4 float4(double4 v) => new float4((float)v.x, (float)v.y, (float)v.z, (float)v.w);

    [MethodImpl(AggressiveInlining)] public static bool any(float4 x) => x.x != 0 || x.y != 0 || x.z != 0 || x.w != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(float4 x) => x.x != 0 && x.y != 0 && x.z != 0 && x.w != 0;
    [MethodImpl(AggressiveInlining)] public static float4 abs(float4 x) => new float4(abs(x.x), abs(x.y), abs(x.z), abs(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 saturate(float4 x) => new float4(saturate(x.x), saturate(x.y), saturate(x.z), saturate(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 tan(float4 x) => new float4(tan(x.x), tan(x.y), tan(x.z), tan(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 tanh(float4 x) => new float4(tanh(x.x), tanh(x.y), tanh(x.z), tanh(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 atan(float4 x) => new float4(atan(x.x), atan(x.y), atan(x.z), atan(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 cos(float4 x) => new float4(cos(x.x), cos(x.y), cos(x.z), cos(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 cosh(float4 x) => new float4(cosh(x.x), cosh(x.y), cosh(x.z), cosh(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 acos(float4 x) => new float4(acos(x.x), acos(x.y), acos(x.z), acos(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 sin(float4 x) => new float4(sin(x.x), sin(x.y), sin(x.z), sin(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 sinh(float4 x) => new float4(sinh(x.x), sinh(x.y), sinh(x.z), sinh(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 asin(float4 x) => new float4(asin(x.x), asin(x.y), asin(x.z), asin(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 floor(float4 x) => new float4(floor(x.x), floor(x.y), floor(x.z), floor(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 ceil(float4 x) => new float4(ceil(x.x), ceil(x.y), ceil(x.z), ceil(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 round(float4 x) => new float4(round(x.x), round(x.y), round(x.z), round(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 trunc(float4 x) => new float4(trunc(x.x), trunc(x.y), trunc(x.z), trunc(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 frac(float4 x) => new float4(frac(x.x), frac(x.y), frac(x.z), frac(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 rcp(float4 x) => new float4(rcp(x.x), rcp(x.y), rcp(x.z), rcp(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 sign(float4 x) => new float4(sign(x.x), sign(x.y), sign(x.z), sign(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 exp(float4 x) => new float4(exp(x.x), exp(x.y), exp(x.z), exp(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 exp2(float4 x) => new float4(exp2(x.x), exp2(x.y), exp2(x.z), exp2(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 exp10(float4 x) => new float4(exp10(x.x), exp10(x.y), exp10(x.z), exp10(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 log(float4 x) => new float4(log(x.x), log(x.y), log(x.z), log(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 log2(float4 x) => new float4(log2(x.x), log2(x.y), log2(x.z), log2(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 log10(float4 x) => new float4(log10(x.x), log10(x.y), log10(x.z), log10(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 sqrt(float4 x) => new float4(sqrt(x.x), sqrt(x.y), sqrt(x.z), sqrt(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 rsqrt(float4 x) => new float4(rsqrt(x.x), rsqrt(x.y), rsqrt(x.z), rsqrt(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 radians(float4 x) => new float4(radians(x.x), radians(x.y), radians(x.z), radians(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 degrees(float4 x) => new float4(degrees(x.x), degrees(x.y), degrees(x.z), degrees(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 square(float4 x) => new float4(square(x.x), square(x.y), square(x.z), square(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 min(float4 x, float4 y) => new float4(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z), min(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static float4 max(float4 x, float4 y) => new float4(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z), max(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static float4 atan2(float4 y, float4 x) => new float4(atan2(y.x, x.x), atan2(y.y, x.y), atan2(y.z, x.z), atan2(y.w, x.w));
    [MethodImpl(AggressiveInlining)] public static float4 pow(float4 x, float4 y) => new float4(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z), pow(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static float4 fmod(float4 x, float4 y) => new float4(fmod(x.x, y.x), fmod(x.y, y.y), fmod(x.z, y.z), fmod(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static float4 step(float4 threshold, float4 x) => new float4(step(threshold.x, x.x), step(threshold.y, x.y), step(threshold.z, x.z), step(threshold.w, x.w));
    [MethodImpl(AggressiveInlining)] public static float4 lerp(float4 start, float4 end, float4 t) => new float4(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y), lerp(start.z, end.z, t.z), lerp(start.w, end.w, t.w));
    [MethodImpl(AggressiveInlining)] public static float4 unlerp(float4 start, float4 end, float4 x) => new float4(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y), unlerp(start.z, end.z, x.z), unlerp(start.w, end.w, x.w));
    [MethodImpl(AggressiveInlining)] public static float4 remap(float4 srcStart, float4 srcEnd, float4 dstStart, float4 dstEnd, float4 x) => new float4(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y), remap(srcStart.z, srcEnd.z, dstStart.z, dstEnd.z, x.z), remap(srcStart.w, srcEnd.w, dstStart.w, dstEnd.w, x.w));
    [MethodImpl(AggressiveInlining)] public static float4 mad(float4 mulA, float4 mulB, float4 addC) => new float4(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z), mad(mulA.w, mulB.w, addC.w));
    [MethodImpl(AggressiveInlining)] public static float4 clamp(float4 valueToClamp, float4 lowerBound, float4 upperBound) => new float4(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z), clamp(valueToClamp.w, lowerBound.w, upperBound.w));
    [MethodImpl(AggressiveInlining)] public static float4 smoothstep(float4 xMin, float4 xMax, float4 x) => new float4(smoothstep(xMin.x, xMax.x, x.x), smoothstep(xMin.y, xMax.y, x.y), smoothstep(xMin.z, xMax.z, x.z), smoothstep(xMin.w, xMax.w, x.w));
    [MethodImpl(AggressiveInlining)] public static float4 select(float4 falseValue, float4 trueValue, bool4 test) => new float4(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z), select(falseValue.w, trueValue.w, test.w));
    [MethodImpl(AggressiveInlining)] public static float4 select(float4 falseValue, float4 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static float csum(float4 x) => (x.x + x.y) + (x.z + x.w);
    [MethodImpl(AggressiveInlining)] public static float cmin(float4 x) => min(min(x.x, x.y), min(x.z, x.w));
    [MethodImpl(AggressiveInlining)] public static float cmax(float4 x) => max(max(x.x, x.y), max(x.z, x.w));
    [MethodImpl(AggressiveInlining)] public static float dot(float4 x, float4 y) => x.x * y.x + x.y * y.y + x.z * y.z + x.w * y.w;
    [MethodImpl(AggressiveInlining)] public static float mul(float4 a, float4 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static bool4 isfinite(float4 x) => new bool4(isfinite(x.x), isfinite(x.y), isfinite(x.z), isfinite(x.w));
    [MethodImpl(AggressiveInlining)] public static bool4 isinf(float4 x) => new bool4(isinf(x.x), isinf(x.y), isinf(x.z), isinf(x.w));
    [MethodImpl(AggressiveInlining)] public static bool4 isnan(float4 x) => new bool4(isnan(x.x), isnan(x.y), isnan(x.z), isnan(x.w));
    [MethodImpl(AggressiveInlining)] public static int4 asint(float4 x) => new int4(asint(x.x), asint(x.y), asint(x.z), asint(x.w));
    [MethodImpl(AggressiveInlining)] public static uint4 asuint(float4 x) => new uint4(asuint(x.x), asuint(x.y), asuint(x.z), asuint(x.w));
    [MethodImpl(AggressiveInlining)] public static float4 chgsign(float4 x, float4 y) => new float4(chgsign(x.x, y.x), chgsign(x.y, y.y), chgsign(x.z, y.z), chgsign(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static float4 lerp(float4 start, float4 end, float t) => start + t * (end - start);
    [MethodImpl(AggressiveInlining)] public static float lengthsq(float4 x) => dot(x, x);
    [MethodImpl(AggressiveInlining)] public static float length(float4 x) => sqrt(dot(x, x));
    [MethodImpl(AggressiveInlining)] public static float distance(float4 x, float4 y) => length(y - x);
    [MethodImpl(AggressiveInlining)] public static float distancesq(float4 x, float4 y) => lengthsq(y - x);
    [MethodImpl(AggressiveInlining)] public static float4 normalize(float4 x) => rsqrt(dot(x, x)) * x;
    [MethodImpl(AggressiveInlining)] public static float4 reflect(float4 i, float4 n) => i - 2f * n * dot(i, n);
    [MethodImpl(AggressiveInlining)] public static float4 project(float4 a, float4 ontoB) => (dot(a, ontoB) / dot(ontoB, ontoB)) * ontoB;
    [MethodImpl(AggressiveInlining)] public static float4 faceforward(float4 n, float4 i, float4 ng) => select(n, -n, dot(ng, i) >= 0);

    public static float4 normalizesafe(float4 x, float4 defaultvalue = default)
    {
        float square = dot(x, x);
        return square > FLT_MIN_NORMAL ? x * rsqrt(square) : defaultvalue;
    }

    public static float4 projectsafe(float4 a, float4 ontoB, float4 defaultValue = default)
    {
        float4 projection = project(a, ontoB);
        return all(isfinite(projection)) ? projection : defaultValue;
    }

    public static float4 refract(float4 i, float4 n, float indexOfRefraction)
    {
        float cosine = dot(n, i);
        float square = 1f - indexOfRefraction * indexOfRefraction * (1f - cosine * cosine);
        return square >= 0 ? indexOfRefraction * i - (indexOfRefraction * cosine + sqrt(square)) * n : new float4(0);
    }

    public static float4 modf(float4 x, out float4 i)
    {
        i = trunc(x);
        return x - i;
    }

    public static void sincos(float4 x, out float4 s, out float4 c)
    {
        s = sin(x);
        c = cos(x);
    }
}
