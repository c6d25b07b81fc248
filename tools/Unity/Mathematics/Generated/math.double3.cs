// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static double3 double3(double x, double y, double z) => new double3(x, y, z);
    [MethodImpl(AggressiveInlining)] public static double3 double3(double x, double2 yz) => new double3(x, yz.x, yz.y);
    [MethodImpl(AggressiveInlining)] public static double3 double3(double2 xy, double z) => new double3(xy.x, xy.y, z);
    [MethodImpl(AggressiveInlining)] public static double3 double3(double3 xyz) => new double3(xyz.x, xyz.y, xyz.z);
    [MethodImpl(AggressiveInlining)] public static double3 double3(double v) => new double3(v, v, v);
    [MethodImpl(AggressiveInlining)] public static double3 double3(bool v) => new double3(v ? 1.0 : 0.0, v ? 1.0 : 0.0, v ? 1.0 : 0.0);
    [MethodImpl(AggressiveInlining)] public static double3 double3(bool3 v) => new double3(v.x ? 1.0 : 0.0, v.y ? 1.0 : 0.0, v.z ? 1.0 : 0.0);
    [MethodImpl(AggressiveInlining)] public static double3 double3(int v) => new double3(v, v, v);
    [MethodImpl(AggressiveInlining)] public static double3 double3(int3 v) => new double3(v.x, v.y, v.z);
    [MethodImpl(AggressiveInlining)] public static double3 double3(uint v) => new double3(v, v, v);
    [MethodImpl(AggressiveInlining)] public static double3 double3(uint3 v) => new double3(v.x, v.y, v.z);
    [MethodImpl(AggressiveInlining)] public static double3 double3(float v) => new double3(v, v, v);
    [MethodImpl(AggressiveInlining)] public static double3 double3(float3 v) => new double3(v.x, v.y, v.z);

    [MethodImpl(AggressiveInlining)] public static bool any(double3 x) => x.x != 0 || x.y != 0 || x.z != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(double3 x) => x.x != 0 && x.y != 0 && x.z != 0;
    [MethodImpl(AggressiveInlining)] public static double3 abs(double3 x) => new double3(abs(x.x), abs(x.y), abs(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 saturate(double3 x) => new double3(saturate(x.x), saturate(x.y), saturate(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 tan(double3 x) => new double3(tan(x.x), tan(x.y), tan(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 tanh(double3 x) => new double3(tanh(x.x), tanh(x.y), tanh(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 atan(double3 x) => new double3(atan(x.x), atan(x.y), atan(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 cos(double3 x) => new double3(cos(x.x), cos(x.y), cos(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 cosh(double3 x) => new double3(cosh(x.x), cosh(x.y), cosh(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 acos(double3 x) => new double3(acos(x.x), acos(x.y), acos(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 sin(double3 x) => new double3(sin(x.x), sin(x.y), sin(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 sinh(double3 x) => new double3(sinh(x.x), sinh(x.y), sinh(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 asin(double3 x) => new double3(asin(x.x), asin(x.y), asin(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 floor(double3 x) => new double3(floor(x.x), floor(x.y), floor(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 ceil(double3 x) => new double3(ceil(x.x), ceil(x.y), ceil(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 round(double3 x) => new double3(round(x.x), round(x.y), round(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 trunc(double3 x) => new double3(trunc(x.x), trunc(x.y), trunc(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 frac(double3 x) => new double3(frac(x.x), frac(x.y), frac(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 rcp(double3 x) => new double3(rcp(x.x), rcp(x.y), rcp(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 sign(double3 x) => new double3(sign(x.x), sign(x.y), sign(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 exp(double3 x) => new double3(exp(x.x), exp(x.y), exp(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 exp2(double3 x) => new double3(exp2(x.x), exp2(x.y), exp2(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 exp10(double3 x) => new double3(exp10(x.x), exp10(x.y), exp10(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 log(double3 x) => new double3(log(x.x), log(x.y), log(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 log2(double3 x) => new double3(log2(x.x), log2(x.y), log2(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 log10(double3 x) => new double3(log10(x.x), log10(x.y), log10(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 sqrt(double3 x) => new double3(sqrt(x.x), sqrt(x.y), sqrt(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 rsqrt(double3 x) => new double3(rsqrt(x.x), rsqrt(x.y), rsqrt(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 radians(double3 x) => new double3(radians(x.x), radians(x.y), radians(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 degrees(double3 x) => new double3(degrees(x.x), degrees(x.y), degrees(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 square(double3 x) => new double3(square(x.x), square(x.y), square(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 min(double3 x, double3 y) => new double3(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static double3 max(double3 x, double3 y) => new double3(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static double3 atan2(double3 y, double3 x) => new double3(atan2(y.x, x.x), atan2(y.y, x.y), atan2(y.z, x.z));
    [MethodImpl(AggressiveInlining)] public static double3 pow(double3 x, double3 y) => new double3(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static double3 fmod(double3 x, double3 y) => new double3(fmod(x.x, y.x), fmod(x.y, y.y), fmod(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static double3 step(double3 threshold, double3 x) => new double3(step(threshold.x, x.x), step(threshold.y, x.y), step(threshold.z, x.z));
    [MethodImpl(AggressiveInlining)] public static double3 lerp(double3 start, double3 end, double3 t) => new double3(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y), lerp(start.z, end.z, t.z));
    [MethodImpl(AggressiveInlining)] public static double3 unlerp(double3 start, double3 end, double3 x) => new double3(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y), unlerp(start.z, end.z, x.z));
    [MethodImpl(AggressiveInlining)] public static double3 remap(double3 srcStart, double3 srcEnd, double3 dstStart, double3 dstEnd, double3 x) => new double3(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y), remap(srcStart.z, srcEnd.z, dstStart.z, dstEnd.z, x.z));
    [MethodImpl(AggressiveInlining)] public static double3 mad(double3 mulA, double3 mulB, double3 addC) => new double3(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z));
    [MethodImpl(AggressiveInlining)] public static double3 clamp(double3 valueToClamp, double3 lowerBound, double3 upperBound) => new double3(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z));
    [MethodImpl(AggressiveInlining)] public static double3 smoothstep(double3 xMin, double3 xMax, double3 x) => new double3(smoothstep(xMin.x, xMax.x, x.x), smoothstep(xMin.y, xMax.y, x.y), smoothstep(xMin.z, xMax.z, x.z));
    [MethodImpl(AggressiveInlining)] public static double3 select(double3 falseValue, double3 trueValue, bool3 test) => new double3(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z));
    [MethodImpl(AggressiveInlining)] public static double3 select(double3 falseValue, double3 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static double csum(double3 x) => x.x + x.y + x.z;
    [MethodImpl(AggressiveInlining)] public static double cmin(double3 x) => min(min(x.x, x.y), x.z);
    [MethodImpl(AggressiveInlining)] public static double cmax(double3 x) => max(max(x.x, x.y), x.z);
    [MethodImpl(AggressiveInlining)] public static double dot(double3 x, double3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    [MethodImpl(AggressiveInlining)] public static double mul(double3 a, double3 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static bool3 isfinite(double3 x) => new bool3(isfinite(x.x), isfinite(x.y), isfinite(x.z));
    [MethodImpl(AggressiveInlining)] public static bool3 isinf(double3 x) => new bool3(isinf(x.x), isinf(x.y), isinf(x.z));
    [MethodImpl(AggressiveInlining)] public static bool3 isnan(double3 x) => new bool3(isnan(x.x), isnan(x.y), isnan(x.z));
    [MethodImpl(AggressiveInlining)] public static double3 lerp(double3 start, double3 end, double t) => start + t * (end - start);
    [MethodImpl(AggressiveInlining)] public static double lengthsq(double3 x) => dot(x, x);
    [MethodImpl(AggressiveInlining)] public static double length(double3 x) => sqrt(dot(x, x));
    [MethodImpl(AggressiveInlining)] public static double distance(double3 x, double3 y) => length(y - x);
    [MethodImpl(AggressiveInlining)] public static double distancesq(double3 x, double3 y) => lengthsq(y - x);
    [MethodImpl(AggressiveInlining)] public static double3 normalize(double3 x) => rsqrt(dot(x, x)) * x;
    [MethodImpl(AggressiveInlining)] public static double3 reflect(double3 i, double3 n) => i - 2.0 * n * dot(i, n);
    [MethodImpl(AggressiveInlining)] public static double3 project(double3 a, double3 ontoB) => (dot(a, ontoB) / dot(ontoB, ontoB)) * ontoB;
    [MethodImpl(AggressiveInlining)] public static double3 faceforward(double3 n, double3 i, double3 ng) => select(n, -n, dot(ng, i) >= 0);

    public static double3 normalizesafe(double3 x, double3 defaultvalue = default)
    {
        double square = dot(x, x);
        return square > DBL_MIN_NORMAL ? x * rsqrt(square) : defaultvalue;
    }

    public static double3 projectsafe(double3 a, double3 ontoB, double3 defaultValue = default)
    {
        double3 projection = project(a, ontoB);
        return all(isfinite(projection)) ? projection : defaultValue;
    }

    public static double3 refract(double3 i, double3 n, double indexOfRefraction)
    {
        double cosine = dot(n, i);
        double square = 1.0 - indexOfRefraction * indexOfRefraction * (1.0 - cosine * cosine);
        return square >= 0 ? indexOfRefraction * i - (indexOfRefraction * cosine + sqrt(square)) * n : new double3(0);
    }

    public static double3 modf(double3 x, out double3 i)
    {
        i = trunc(x);
        return x - i;
    }

    public static void sincos(double3 x, out double3 s, out double3 c)
    {
        s = sin(x);
        c = cos(x);
    }

    [MethodImpl(AggressiveInlining)]
    public static double3 cross(double3 x, double3 y)
    {
        return new double3(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);
    }

    /// <summary>Two unit vectors that complete a unit normal.</summary>
    public static void orthonormal_basis(double3 normal, out double3 basis1, out double3 basis2)
    {
        double side = normal.z >= 0 ? 1 : -1;
        double a = -1 / (side + normal.z);
        double b = normal.x * normal.y * a;
        basis1 = new double3(1 + side * normal.x * normal.x * a, side * b, -side * normal.x);
        basis2 = new double3(b, side + normal.y * normal.y * a, -normal.y);
    }
}
