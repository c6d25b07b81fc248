// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static float2 float2(float x, float y) => new float2(x, y);
    [MethodImpl(AggressiveInlining)] public static float2 float2(float2 xy) => new float2(xy.x, xy.y);
    [MethodImpl(AggressiveInlining)] public static float2 float2(float v) => new float2(v, v);
    [MethodImpl(AggressiveInlining)] public static float2 float2(bool v) => new float2(v ? 1f : 0f, v ? 1f : 0f);
    [MethodImpl(AggressiveInlining)] public static float2 float2(bool2 v) => new float2(v.x ? 1f : 0f, v.y ? 1f : 0f);
    [MethodImpl(AggressiveInlining)] public static float2 float2(int v) => new float2(v, v);
    [MethodImpl(AggressiveInlining)] public static float2 float2(int2 v) => new float2(v.x, v.y);
    [MethodImpl(AggressiveInlining)] public static float2 float2(uint v) => new float2(v, v);
    [MethodImpl(AggressiveInlining)] public static float2 float2(uint2 v) => new float2(v.x, v.y);
    [MethodImpl(AggressiveInlining)] public static float2 float2(double v) => new float2((float)v, (float)v);
    [MethodImpl(AggressiveInlining)] public static float2 float2(double2 v) => new float2((float)v.x, (float)v.y);

    [MethodImpl(AggressiveInlining)] public static bool any(float2 x) => x.x != 0 || x.y != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(float2 x) => x.x != 0 && x.y != 0;
    [MethodImpl(AggressiveInlining)] public static float2 abs(float2 x) => new float2(abs(x.x), abs(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 saturate(float2 x) => new float2(saturate(x.x), saturate(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 tan(float2 x) => new float2(tan(x.x), tan(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 tanh(float2 x) => new float2(tanh(x.x), tanh(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 atan(float2 x) => new float2(atan(x.x), atan(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 cos(float2 x) => new float2(cos(x.x), cos(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 cosh(float2 x) => new float2(cosh(x.x), cosh(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 acos(float2 x) => new float2(acos(x.x), acos(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 sin(float2 x) => new float2(sin(x.x), sin(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 sinh(float2 x) => new float2(sinh(x.x), sinh(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 asin(float2 x) => new float2(asin(x.x), asin(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 floor(float2 x) => new float2(floor(x.x), floor(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 ceil(float2 x) => new float2(ceil(x.x), ceil(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 round(float2 x) => new float2(round(x.x), round(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 trunc(float2 x) => new float2(trunc(x.x), trunc(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 frac(float2 x) => new float2(frac(x.x), frac(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 rcp(float2 x) => new float2(rcp(x.x), rcp(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 sign(float2 x) => new float2(sign(x.x), sign(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 exp(float2 x) => new float2(exp(x.x), exp(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 exp2(float2 x) => new float2(exp2(x.x), exp2(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 exp10(float2 x) => new float2(exp10(x.x), exp10(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 log(float2 x) => new float2(log(x.x), log(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 log2(float2 x) => new float2(log2(x.x), log2(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 log10(float2 x) => new float2(log10(x.x), log10(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 sqrt(float2 x) => new float2(sqrt(x.x), sqrt(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 rsqrt(float2 x) => new float2(rsqrt(x.x), rsqrt(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 radians(float2 x) => new float2(radians(x.x), radians(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 degrees(float2 x) => new float2(degrees(x.x), degrees(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 square(float2 x) => new float2(square(x.x), square(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 min(float2 x, float2 y) => new float2(min(x.x, y.x), min(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static float2 max(float2 x, float2 y) => new float2(max(x.x, y.x), max(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static float2 atan2(float2 y, float2 x) => new float2(atan2(y.x, x.x), atan2(y.y, x.y));
    [MethodImpl(AggressiveInlining)] public static float2 pow(float2 x, float2 y) => new float2(pow(x.x, y.x), pow(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static float2 fmod(float2 x, float2 y) => new float2(fmod(x.x, y.x), fmod(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static float2 step(float2 threshold, float2 x) => new float2(step(threshold.x, x.x), step(threshold.y, x.y));
    [MethodImpl(AggressiveInlining)] public static float2 lerp(float2 start, float2 end, float2 t) => new float2(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y));
    [MethodImpl(AggressiveInlining)] public static float2 unlerp(float2 start, float2 end, float2 x) => new float2(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y));
    [MethodImpl(AggressiveInlining)] public static float2 remap(float2 srcStart, float2 srcEnd, float2 dstStart, float2 dstEnd, float2 x) => new float2(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y));
    [MethodImpl(AggressiveInlining)] public static float2 mad(float2 mulA, float2 mulB, float2 addC) => new float2(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y));
    [MethodImpl(AggressiveInlining)] public static float2 clamp(float2 valueToClamp, float2 lowerBound, float2 upperBound) => new float2(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y));
    [MethodImpl(AggressiveInlining)] public static float2 smoothstep(float2 xMin, float2 xMax, float2 x) => new float2(smoothstep(xMin.x, xMax.x, x.x), smoothstep(xMin.y, xMax.y, x.y));
    [MethodImpl(AggressiveInlining)] public static float2 select(float2 falseValue, float2 trueValue, bool2 test) => new float2(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y));
    [MethodImpl(AggressiveInlining)] public static float2 select(float2 falseValue, float2 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static float csum(float2 x) => x.x + x.y;
    [MethodImpl(AggressiveInlining)] public static float cmin(float2 x) => min(x.x, x.y);
    [MethodImpl(AggressiveInlining)] public static float cmax(float2 x) => max(x.x, x.y);
    [MethodImpl(AggressiveInlining)] public static float dot(float2 x, float2 y) => x.x * y.x + x.y * y.y;
    [MethodImpl(AggressiveInlining)] public static float mul(float2 a, float2 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static bool2 isfinite(float2 x) => new bool2(isfinite(x.x), isfinite(x.y));
    [MethodImpl(AggressiveInlining)] public static bool2 isinf(float2 x) => new bool2(isinf(x.x), isinf(x.y));
    [MethodImpl(AggressiveInlining)] public static bool2 isnan(float2 x) => new bool2(isnan(x.x), isnan(x.y));
    [MethodImpl(AggressiveInlining)] public static int2 asint(float2 x) => new int2(asint(x.x), asint(x.y));
    [MethodImpl(AggressiveInlining)] public static uint2 asuint(float2 x) => new uint2(asuint(x.x), asuint(x.y));
    [MethodImpl(AggressiveInlining)] public static float2 chgsign(float2 x, float2 y) => new float2(chgsign(x.x, y.x), chgsign(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static float2 lerp(float2 start, float2 end, float t) => start + t * (end - start);
    [MethodImpl(AggressiveInlining)] public static float lengthsq(float2 x) => dot(x, x);
    [MethodImpl(AggressiveInlining)] public static float length(float2 x) => sqrt(dot(x, x));
    [MethodImpl(AggressiveInlining)] public static float distance(float2 x, float2 y) => length(y - x);
    [MethodImpl(AggressiveInlining)] public static float distancesq(float2 x, float2 y) => lengthsq(y - x);
    [MethodImpl(AggressiveInlining)] public static float2 normalize(float2 x) => rsqrt(dot(x, x)) * x;
    [MethodImpl(AggressiveInlining)] public static float2 reflect(float2 i, float2 n) => i - 2f * n * dot(i, n);
    [MethodImpl(AggressiveInlining)] public static float2 project(float2 a, float2 ontoB) => (dot(a, ontoB) / dot(ontoB, ontoB)) * ontoB;
    [MethodImpl(AggressiveInlining)] public static float2 faceforward(float2 n, float2 i, float2 ng) => select(n, -n, dot(ng, i) >= 0);

    public static float2 normalizesafe(float2 x, float2 defaultvalue = default)
    {
        float square = dot(x, x);
        return square > FLT_MIN_NORMAL ? x * rsqrt(square) : defaultvalue;
    }

    public static float2 projectsafe(float2 a, float2 ontoB, float2 defaultValue = default)
    {
        float2 projection = project(a, ontoB);
        return all(isfinite(projection)) ? projection : defaultValue;
    }

    public static float2 refract(float2 i, float2 n, float indexOfRefraction)
    {
        float cosine = dot(n, i);
        float square = 1f - indexOfRefraction * indexOfRefraction * (1f - cosine * cosine);
        return square >= 0 ? indexOfRefraction * i - (indexOfRefraction * cosine + sqrt(square)) * n : new float2(0);
    }

    public static float2 modf(float2 x, out float2 i)
    {
        i = trunc(x);
        return x - i;
    }

    public static void sincos(float2 x, out float2 s, out float2 c)
    {
        s = sin(x);
        c = cos(x);
    }
}
