// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static double2 double2(double x, double y) => new double2(x, y);
    [MethodImpl(AggressiveInlining)] public static double2 double2(double2 xy) => new double2(xy.x, xy.y);
    [MethodImpl(AggressiveInlining)] public static double2 double2(double v) => new double2(v, v);
    [MethodImpl(AggressiveInlining)] public static double2 double2(bool v) => new double2(v ? 1.0 : 0.0, v ? 1.0 : 0.0);
    [MethodImpl(AggressiveInlining)] public static double2 double2(bool2 v) => new double2(v.x ? 1.0 : 0.0, v.y ? 1.0 : 0.0);
    [MethodImpl(AggressiveInlining)] public static double2 double2(int v) => new double2(v, v);
    [MethodImpl(AggressiveInlining)] public static double2 double2(int2 v) => new double2(v.x, v.y);
    [MethodImpl(AggressiveInlining)] public static double2 double2(uint v) => new double2(v, v);
    [MethodImpl(AggressiveInlining)] public static double2 double2(uint2 v) => new double2(v.x, v.y);
    [MethodImpl(AggressiveInlining)] public static double2 double2(float v) => new double2(v, v);
    [MethodImpl(AggressiveInlining)] public static double2 double2(float2 v) => new double2(v.x, v.y);

    [MethodImpl(AggressiveInlining)] public static bool any(double2 x) => x.x != 0 || x.y != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(double2 x) => x.x != 0 && x.y != 0;
    [MethodImpl(AggressiveInlining)] public static double2 abs(double2 x) => new double2(abs(x.x), abs(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 saturate(double2 x) => new double2(saturate(x.x), saturate(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 tan(double2 x) => new double2(tan(x.x), tan(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 tanh(double2 x) => new double2(tanh(x.x), tanh(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 atan(double2 x) => new double2(atan(x.x), atan(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 cos(double2 x) => new double2(cos(x.x), cos(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 cosh(double2 x) => new double2(cosh(x.x), cosh(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 acos(double2 x) => new double2(acos(x.x), acos(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 sin(double2 x) => new double2(sin(x.x), sin(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 sinh(double2 x) => new double2(sinh(x.x), sinh(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 asin(double2 x) => new double2(asin(x.x), asin(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 floor(double2 x) => new double2(floor(x.x), floor(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 ceil(double2 x) => new double2(ceil(x.x), ceil(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 round(double2 x) => new double2(round(x.x), round(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 trunc(double2 x) => new double2(trunc(x.x), trunc(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 frac(double2 x) => new double2(frac(x.x), frac(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 rcp(double2 x) => new double2(rcp(x.x), rcp(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 sign(double2 x) => new double2(sign(x.x), sign(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 exp(double2 x) => new double2(exp(x.x), exp(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 exp2(double2 x) => new double2(exp2(x.x), exp2(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 exp10(double2 x) => new double2(exp10(x.x), exp10(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 log(double2 x) => new double2(log(x.x), log(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 log2(double2 x) => new double2(log2(x.x), log2(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 log10(double2 x) => new double2(log10(x.x), log10(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 sqrt(double2 x) => new double2(sqrt(x.x), sqrt(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 rsqrt(double2 x) => new double2(rsqrt(x.x), rsqrt(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 radians(double2 x) => new double2(radians(x.x), radians(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 degrees(double2 x) => new double2(degrees(x.x), degrees(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 square(double2 x) => new double2(square(x.x), square(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 min(double2 x, double2 y) => new double2(min(x.x, y.x), min(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static double2 max(double2 x, double2 y) => new double2(max(x.x, y.x), max(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static double2 atan2(double2 y, double2 x) => new double2(atan2(y.x, x.x), atan2(y.y, x.y));
    [MethodImpl(AggressiveInlining)] public static double2 pow(double2 x, double2 y) => new double2(pow(x.x, y.x), pow(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static double2 fmod(double2 x, double2 y) => new double2(fmod(x.x, y.x), fmod(x.y, y.y));
    [MethodImpl(AggressiveInlining)] public static double2 step(double2 threshold, double2 x) => new double2(step(threshold.x, x.x), step(threshold.y, x.y));
    [MethodImpl(AggressiveInlining)] public static double2 lerp(double2 start, double2 end, double2 t) => new double2(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y));
    [MethodImpl(AggressiveInlining)] public static double2 unlerp(double2 start, double2 end, double2 x) => new double2(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y));
    [MethodImpl(AggressiveInlining)] public static double2 remap(double2 srcStart, double2 srcEnd, double2 dstStart, double2 dstEnd, double2 x) => new double2(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y));
    [MethodImpl(AggressiveInlining)] public static double2 mad(double2 mulA, double2 mulB, double2 addC) => new double2(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y));
    [MethodImpl(AggressiveInlining)] public static double2 clamp(double2 valueToClamp, double2 lowerBound, double2 upperBound) => new double2(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y));
    [MethodImpl(AggressiveInlining)] public static double2 smoothstep(double2 xMin, double2 xMax, double2 x) => new double2(smoothstep(xMin.x, xMax.x, x.x), smoothstep(xMin.y, xMax.y, x.y));
    [MethodImpl(AggressiveInlining)] public static double2 select(double2 falseValue, double2 trueValue, bool2 test) => new double2(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y));
    [MethodImpl(AggressiveInlining)] public static double2 select(double2 falseValue, double2 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static double csum(double2 x) => x.x + x.y;
    [MethodImpl(AggressiveInlining)] public static double cmin(double2 x) => min(x.x, x.y);
    [MethodImpl(AggressiveInlining)] public static double cmax(double2 x) => max(x.x, x.y);
    [MethodImpl(AggressiveInlining)] public static double dot(double2 x, double2 y) => x.x * y.x + x.y * y.y;
    [MethodImpl(AggressiveInlining)] public static double mul(double2 a, double2 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static bool2 isfinite(double2 x) => new bool2(isfinite(x.x), isfinite(x.y));
    [MethodImpl(AggressiveInlining)] public static bool2 isinf(double2 x) => new bool2(isinf(x.x), isinf(x.y));
    [MethodImpl(AggressiveInlining)] public static bool2 isnan(double2 x) => new bool2(isnan(x.x), isnan(x.y));
    [MethodImpl(AggressiveInlining)] public static double2 lerp(double2 start, double2 end, double t) => start + t * (end - start);
    [MethodImpl(AggressiveInlining)] public static double lengthsq(double2 x) => dot(x, x);
    [MethodImpl(AggressiveInlining)] public static double length(double2 x) => sqrt(dot(x, x));
    [MethodImpl(AggressiveInlining)] public static double distance(double2 x, double2 y) => length(y - x);
    [MethodImpl(AggressiveInlining)] public static double distancesq(double2 x, double2 y) => lengthsq(y - x);
    [MethodImpl(AggressiveInlining)] public static double2 normalize(double2 x) => rsqrt(dot(x, x)) * x;
    [MethodImpl(AggressiveInlining)] public static double2 reflect(double2 i, double2 n) => i - 2.0 * n * dot(i, n);
    [MethodImpl(AggressiveInlining)] public static double2 project(double2 a, double2 ontoB) => (dot(a, ontoB) / dot(ontoB, ontoB)) * ontoB;
    [MethodImpl(AggressiveInlining)] public static double2 faceforward(double2 n, double2 i, double2 ng) => select(n, -n, dot(ng, i) >= 0);

    public static double2 normalizesafe(double2 x, double2 defaultvalue = default)
    {
        double square = dot(x, x);
        return square > DBL_MIN_NORMAL ? x * rsqrt(square) : defaultvalue;
    }

    public static double2 projectsafe(double2 a, double2 ontoB, double2 defaultValue = default)
    {
        double2 projection = project(a, ontoB);
        return all(isfinite(projection)) ? projection : defaultValue;
    }

    public static double2 refract(double2 i, double2 n, double indexOfRefraction)
    {
        double cosine = dot(n, i);
        double square = 1.0 - indexOfRefraction * indexOfRefraction * (1.0 - cosine * cosine);
        return square >= 0 ? indexOfRefraction * i - (indexOfRefraction * cosine + sqrt(square)) * n : new double2(0);
    }

    public static double2 modf(double2 x, out double2 i)
    {
        i = trunc(x);
        return x - i;
    }

    public static void sincos(double2 x, out double2 s, out double2 c)
    {
        s = sin(x);
        c = cos(x);
    }
}
