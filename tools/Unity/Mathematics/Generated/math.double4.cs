// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static double4 double4(double x, double y, double z, double w) => new double4(x, y, z, w);
    [MethodImpl(AggressiveInlining)] public static double4 double4(double x, double y, double2 zw) => new double4(x, y, zw.x, zw.y);
    [MethodImpl(AggressiveInlining)] public static double4 double4(double x, double2 yz, double w) => new double4(x, yz.x, yz.y, w);
    [MethodImpl(AggressiveInlining)] public static double4 double4(double x, double3 yzw) => new double4(x, yzw.x, yzw.y, yzw.z);
    [MethodImpl(AggressiveInlining)] public static double4 double4(double2 xy, double z, double w) => new double4(xy.x, xy.y, z, w);
    [MethodImpl(AggressiveInlining)] public static double4 double4(double2 xy, double2 zw) => new double4(xy.x, xy.y, zw.x, zw.y);
    [MethodImpl(AggressiveInlining)] public static double4 double4(double3 xyz, double w) => new double4(xyz.x, xyz.y, xyz.z, w);
    [MethodImpl(AggressiveInlining)] public static double4 double4(double4 xyzw) => new double4(xyzw.x, xyzw.y, xyzw.z, xyzw.w);
    [MethodImpl(AggressiveInlining)] public static double4 double4(double v) => new double4(v, v, v, v);
    [MethodImpl(AggressiveInlining)] public static double4 double4(bool v) => new double4(v ? 1.0 : 0.0, v ? 1.0 : 0.0, v ? 1.0 : 0.0, v ? 1.0 : 0.0);
    [MethodImpl(AggressiveInlining)] public static double4 double4(bool4 v) => new double4(v.x ? 1.0 : 0.0, v.y ? 1.0 : 0.0, v.z ? 1.0 : 0.0, v.w ? 1.0 : 0.0);
    [MethodImpl(AggressiveInlining)] public static double4 double4(int v) => new double4(v, v, v, v);
    [MethodImpl(AggressiveInlining)] public static double4 double4(int4 v) => new double4(v.x, v.y, v.z, v.w);
    [MethodImpl(AggressiveInlining)] public static double4 double4(uint v) => new double4(v, v, v, v);
    [MethodImpl(AggressiveInlining)] public static double4 double4(uint4 v) => new double4(v.x, v.y, v.z, v.w);
    [MethodImpl(AggressiveInlining)] public static double4 double4(float v) => new double4(v, v, v, v);
    [MethodImpl(AggressiveInlining)] public static double4 double4(float4 v) => new double4(v.x, v.y, v.z, v.w);

    [MethodImpl(AggressiveInlining)] public static bool any(double4 x) => x.x != 0 || x.y != 0 || x.z != 0 || x.w != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(double4 x) => x.x != 0 && x.y != 0 && x.z != 0 && x.w != 0;
    [MethodImpl(AggressiveInlining)] public static double4 abs(double4 x) => new double4(abs(x.x), abs(x.y), abs(x.z), abs(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 saturate(double4 x) => new double4(saturate(x.x), saturate(x.y), saturate(x.z), saturate(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 tan(double4 x) => new double4(tan(x.x), tan(x.y), tan(x.z), tan(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 tanh(double4 x) => new double4(tanh(x.x), tanh(x.y), tanh(x.z), tanh(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 atan(double4 x) => new double4(atan(x.x), atan(x.y), atan(x.z), atan(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 cos(double4 x) => new double4(cos(x.x), cos(x.y), cos(x.z), cos(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 cosh(double4 x) => new double4(cosh(x.x), cosh(x.y), cosh(x.z), cosh(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 acos(double4 x) => new double4(acos(x.x), acos(x.y), acos(x.z), acos(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 sin(double4 x) => new double4(sin(x.x), sin(x.y), sin(x.z), sin(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 sinh(double4 x) => new double4(sinh(x.x), sinh(x.y), sinh(x.z), sinh(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 asin(double4 x) => new double4(asin(x.x), asin(x.y), asin(x.z), asin(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 floor(double4 x) => new double4(floor(x.x), floor(x.y), floor(x.z), floor(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 ceil(double4 x) => new double4(ceil(x.x), ceil(x.y), ceil(x.z), ceil(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 round(double4 x) => new double4(round(x.x), round(x.y), round(x.z), round(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 trunc(double4 x) => new double4(trunc(x.x), trunc(x.y), trunc(x.z), trunc(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 frac(double4 x) => new double4(frac(x.x), frac(x.y), frac(x.z), frac(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 rcp(double4 x) => new double4(rcp(x.x), rcp(x.y), rcp(x.z), rcp(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 sign(double4 x) => new double4(sign(x.x), sign(x.y), sign(x.z), sign(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 exp(double4 x) => new double4(exp(x.x), exp(x.y), exp(x.z), exp(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 exp2(double4 x) => new double4(exp2(x.x), exp2(x.y), exp2(x.z), exp2(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 exp10(double4 x) => new double4(exp10(x.x), exp10(x.y), exp10(x.z), exp10(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 log(double4 x) => new double4(log(x.x), log(x.y), log(x.z), log(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 log2(double4 x) => new double4(log2(x.x), log2(x.y), log2(x.z), log2(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 log10(double4 x) => new double4(log10(x.x), log10(x.y), log10(x.z), log10(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 sqrt(double4 x) => new double4(sqrt(x.x), sqrt(x.y), sqrt(x.z), sqrt(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 rsqrt(double4 x) => new double4(rsqrt(x.x), rsqrt(x.y), rsqrt(x.z), rsqrt(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 radians(double4 x) => new double4(radians(x.x), radians(x.y), radians(x.z), radians(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 degrees(double4 x) => new double4(degrees(x.x), degrees(x.y), degrees(x.z), degrees(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 square(double4 x) => new double4(square(x.x), square(x.y), square(x.z), square(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 min(double4 x, double4 y) => new double4(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z), min(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static double4 max(double4 x, double4 y) => new double4(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z), max(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static double4 atan2(double4 y, double4 x) => new double4(atan2(y.x, x.x), atan2(y.y, x.y), atan2(y.z, x.z), atan2(y.w, x.w));
    [MethodImpl(AggressiveInlining)] public static double4 pow(double4 x, double4 y) => new double4(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z), pow(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static double4 fmod(double4 x, double4 y) => new double4(fmod(x.x, y.x), fmod(x.y, y.y), fmod(x.z, y.z), fmod(x.w, y.w));
    [MethodImpl(AggressiveInlining)] public static double4 step(double4 threshold, double4 x) => new double4(step(threshold.x, x.x), step(threshold.y, x.y), step(threshold.z, x.z), step(threshold.w, x.w));
    [MethodImpl(AggressiveInlining)] public static double4 lerp(double4 start, double4 end, double4 t) => new double4(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y), lerp(start.z, end.z, t.z), lerp(start.w, end.w, t.w));
    [MethodImpl(AggressiveInlining)] public static double4 unlerp(double4 start, double4 end, double4 x) => new double4(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y), unlerp(start.z, end.z, x.z), unlerp(start.w, end.w, x.w));
    [MethodImpl(AggressiveInlining)] public static double4 remap(double4 srcStart, double4 srcEnd, double4 dstStart, double4 dstEnd, double4 x) => new double4(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y), remap(srcStart.z, srcEnd.z, dstStart.z, dstEnd.z, x.z), remap(srcStart.w, srcEnd.w, dstStart.w, dstEnd.w, x.w));
    [MethodImpl(AggressiveInlining)] public static double4 mad(double4 mulA, double4 mulB, double4 addC) => new double4(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z), mad(mulA.w, mulB.w, addC.w));
    [MethodImpl(AggressiveInlining)] public static double4 clamp(double4 valueToClamp, double4 lowerBound, double4 upperBound) => new double4(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z), clamp(valueToClamp.w, lowerBound.w, upperBound.w));
    [MethodImpl(AggressiveInlining)] public static double4 smoothstep(double4 xMin, double4 xMax, double4 x) => new double4(smoothstep(xMin.x, xMax.x, x.x), smoothstep(xMin.y, xMax.y, x.y), smoothstep(xMin.z, xMax.z, x.z), smoothstep(xMin.w, xMax.w, x.w));
    [MethodImpl(AggressiveInlining)] public static double4 select(double4 falseValue, double4 trueValue, bool4 test) => new double4(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z), select(falseValue.w, trueValue.w, test.w));
    [MethodImpl(AggressiveInlining)] public static double4 select(double4 falseValue, double4 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static double csum(double4 x) => (x.x + x.y) + (x.z + x.w);
    [MethodImpl(AggressiveInlining)] public static double cmin(double4 x) => min(min(x.x, x.y), min(x.z, x.w));
    [MethodImpl(AggressiveInlining)] public static double cmax(double4 x) => max(max(x.x, x.y), max(x.z, x.w));
    [MethodImpl(AggressiveInlining)] public static double dot(double4 x, double4 y) => x.x * y.x + x.y * y.y + x.z * y.z + x.w * y.w;
    [MethodImpl(AggressiveInlining)] public static double mul(double4 a, double4 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static bool4 isfinite(double4 x) => new bool4(isfinite(x.x), isfinite(x.y), isfinite(x.z), isfinite(x.w));
    [MethodImpl(AggressiveInlining)] public static bool4 isinf(double4 x) => new bool4(isinf(x.x), isinf(x.y), isinf(x.z), isinf(x.w));
    [MethodImpl(AggressiveInlining)] public static bool4 isnan(double4 x) => new bool4(isnan(x.x), isnan(x.y), isnan(x.z), isnan(x.w));
    [MethodImpl(AggressiveInlining)] public static double4 lerp(double4 start, double4 end, double t) => start + t * (end - start);
    [MethodImpl(AggressiveInlining)] public static double lengthsq(double4 x) => dot(x, x);
    [MethodImpl(AggressiveInlining)] public static double length(double4 x) => sqrt(dot(x, x));
    [MethodImpl(AggressiveInlining)] public static double distance(double4 x, double4 y) => length(y - x);
    [MethodImpl(AggressiveInlining)] public static double distancesq(double4 x, double4 y) => lengthsq(y - x);
    [MethodImpl(AggressiveInlining)] public static double4 normalize(double4 x) => rsqrt(dot(x, x)) * x;
    [MethodImpl(AggressiveInlining)] public static double4 reflect(double4 i, double4 n) => i - 2.0 * n * dot(i, n);
    [MethodImpl(AggressiveInlining)] public static double4 project(double4 a, double4 ontoB) => (dot(a, ontoB) / dot(ontoB, ontoB)) * ontoB;
    [MethodImpl(AggressiveInlining)] public static double4 faceforward(double4 n, double4 i, double4 ng) => select(n, -n, dot(ng, i) >= 0);

    public static double4 normalizesafe(double4 x, double4 defaultvalue = default)
    {
        double square = dot(x, x);
        return square > DBL_MIN_NORMAL ? x * rsqrt(square) : defaultvalue;
    }

    public static double4 projectsafe(double4 a, double4 ontoB, double4 defaultValue = default)
    {
        double4 projection = project(a, ontoB);
        return all(isfinite(projection)) ? projection : defaultValue;
    }

    public static double4 refract(double4 i, double4 n, double indexOfRefraction)
    {
        double cosine = dot(n, i);
        double square = 1.0 - indexOfRefraction * indexOfRefraction * (1.0 - cosine * cosine);
        return square >= 0 ? indexOfRefraction * i - (indexOfRefraction * cosine + sqrt(square)) * n : new double4(0);
    }

    public static double4 modf(double4 x, out double4 i)
    {
        i = trunc(x);
        return x - i;
    }

    public static void sincos(double4 x, out double4 s, out double4 c)
    {
        s = sin(x);
        c = cos(x);
    }
}
