// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(AggressiveInlining)] public static float3 float3(float x, float y, float z) => new float3(x, y, z);
    [MethodImpl(AggressiveInlining)] public static float3 float3(float x, float2 yz) => new float3(x, yz.x, yz.y);
    [MethodImpl(AggressiveInlining)] public static float3 float3(float2 xy, float z) => new float3(xy.x, xy.y, z);
    [MethodImpl(AggressiveInlining)] public static float3 float3(float3 xyz) => new float3(xyz.x, xyz.y, xyz.z);
    [MethodImpl(AggressiveInlining)] public static float3 float3(float v) => new float3(v, v, v);
    [MethodImpl(AggressiveInlining)] public static float3 float3(bool v) => new float3(v ? 1f : 0f, v ? 1f : 0f, v ? 1f : 0f);
    [MethodImpl(AggressiveInlining)] public static float3 float3(bool3 v) => new float3(v.x ? 1f : 0f, v.y ? 1f : 0f, v.z ? 1f : 0f);
    [MethodImpl(AggressiveInlining)] public static float3 float3(int v) => new float3(v, v, v);
    [MethodImpl(AggressiveInlining)] public static float3 float3(int3 v) => new float3(v.x, v.y, v.z);
    [MethodImpl(AggressiveInlining)] public static float3 float3(uint v) => new float3(v, v, v);
    [MethodImpl(AggressiveInlining)] public static float3 float3(uint3 v) => new float3(v.x, v.y, v.z);
    [MethodImpl(AggressiveInlining)] public static float3 float3(double v) => new float3((float)v, (float)v, (float)v);
    [MethodImpl(AggressiveInlining)] public static float3 float3(double3 v) => new float3((float)v.x, (float)v.y, (float)v.z);

    [MethodImpl(AggressiveInlining)] public static bool any(float3 x) => x.x != 0 || x.y != 0 || x.z != 0;
    [MethodImpl(AggressiveInlining)] public static bool all(float3 x) => x.x != 0 && x.y != 0 && x.z != 0;
    [MethodImpl(AggressiveInlining)] public static float3 abs(float3 x) => new float3(abs(x.x), abs(x.y), abs(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 saturate(float3 x) => new float3(saturate(x.x), saturate(x.y), saturate(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 tan(float3 x) => new float3(tan(x.x), tan(x.y), tan(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 tanh(float3 x) => new float3(tanh(x.x), tanh(x.y), tanh(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 atan(float3 x) => new float3(atan(x.x), atan(x.y), atan(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 cos(float3 x) => new float3(cos(x.x), cos(x.y), cos(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 cosh(float3 x) => new float3(cosh(x.x), cosh(x.y), cosh(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 acos(float3 x) => new float3(acos(x.x), acos(x.y), acos(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 sin(float3 x) => new float3(sin(x.x), sin(x.y), sin(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 sinh(float3 x) => new float3(sinh(x.x), sinh(x.y), sinh(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 asin(float3 x) => new float3(asin(x.x), asin(x.y), asin(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 floor(float3 x) => new float3(floor(x.x), floor(x.y), floor(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 ceil(float3 x) => new float3(ceil(x.x), ceil(x.y), ceil(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 round(float3 x) => new float3(round(x.x), round(x.y), round(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 trunc(float3 x) => new float3(trunc(x.x), trunc(x.y), trunc(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 frac(float3 x) => new float3(frac(x.x), frac(x.y), frac(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 rcp(float3 x) => new float3(rcp(x.x), rcp(x.y), rcp(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 sign(float3 x) => new float3(sign(x.x), sign(x.y), sign(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 exp(float3 x) => new float3(exp(x.x), exp(x.y), exp(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 exp2(float3 x) => new float3(exp2(x.x), exp2(x.y), exp2(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 exp10(float3 x) => new float3(exp10(x.x), exp10(x.y), exp10(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 log(float3 x) => new float3(log(x.x), log(x.y), log(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 log2(float3 x) => new float3(log2(x.x), log2(x.y), log2(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 log10(float3 x) => new float3(log10(x.x), log10(x.y), log10(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 sqrt(float3 x) => new float3(sqrt(x.x), sqrt(x.y), sqrt(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 rsqrt(float3 x) => new float3(rsqrt(x.x), rsqrt(x.y), rsqrt(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 radians(float3 x) => new float3(radians(x.x), radians(x.y), radians(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 degrees(float3 x) => new float3(degrees(x.x), degrees(x.y), degrees(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 square(float3 x) => new float3(square(x.x), square(x.y), square(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 min(float3 x, float3 y) => new float3(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static float3 max(float3 x, float3 y) => new float3(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static float3 atan2(float3 y, float3 x) => new float3(atan2(y.x, x.x), atan2(y.y, x.y), atan2(y.z, x.z));
    [MethodImpl(AggressiveInlining)] public static float3 pow(float3 x, float3 y) => new float3(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static float3 fmod(float3 x, float3 y) => new float3(fmod(x.x, y.x), fmod(x.y, y.y), fmod(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static float3 step(float3 threshold, float3 x) => new float3(step(threshold.x, x.x), step(threshold.y, x.y), step(threshold.z, x.z));
    [MethodImpl(AggressiveInlining)] public static float3 lerp(float3 start, float3 end, float3 t) => new float3(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y), lerp(start.z, end.z, t.z));
    [MethodImpl(AggressiveInlining)] public static float3 unlerp(float3 start, float3 end, float3 x) => new float3(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y), unlerp(start.z, end.z, x.z));
    [MethodImpl(AggressiveInlining)] public static float3 remap(float3 srcStart, float3 srcEnd, float3 dstStart, float3 dstEnd, float3 x) => new float3(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y), remap(srcStart.z, srcEnd.z, dstStart.z, dstEnd.z, x.z));
    [MethodImpl(AggressiveInlining)] public static float3 mad(float3 mulA, float3 mulB, float3 addC) => new float3(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z));
    [MethodImpl(AggressiveInlining)] public static float3 clamp(float3 valueToClamp, float3 lowerBound, float3 upperBound) => new float3(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z));
    [MethodImpl(AggressiveInlining)] public static float3 smoothstep(float3 xMin, float3 xMax, float3 x) => new float3(smoothstep(xMin.x, xMax.x, x.x), smoothstep(xMin.y, xMax.y, x.y), smoothstep(xMin.z, xMax.z, x.z));
    [MethodImpl(AggressiveInlining)] public static float3 select(float3 falseValue, float3 trueValue, bool3 test) => new float3(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z));
    [MethodImpl(AggressiveInlining)] public static float3 select(float3 falseValue, float3 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(AggressiveInlining)] public static float csum(float3 x) => x.x + x.y + x.z;
    [MethodImpl(AggressiveInlining)] public static float cmin(float3 x) => min(min(x.x, x.y), x.z);
    [MethodImpl(AggressiveInlining)] public static float cmax(float3 x) => max(max(x.x, x.y), x.z);
    [MethodImpl(AggressiveInlining)] public static float dot(float3 x, float3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    [MethodImpl(AggressiveInlining)] public static float mul(float3 a, float3 b) => dot(a, b);
    [MethodImpl(AggressiveInlining)] public static bool3 isfinite(float3 x) => new bool3(isfinite(x.x), isfinite(x.y), isfinite(x.z));
    [MethodImpl(AggressiveInlining)] public static bool3 isinf(float3 x) => new bool3(isinf(x.x), isinf(x.y), isinf(x.z));
    [MethodImpl(AggressiveInlining)] public static bool3 isnan(float3 x) => new bool3(isnan(x.x), isnan(x.y), isnan(x.z));
    [MethodImpl(AggressiveInlining)] public static int3 asint(float3 x) => new int3(asint(x.x), asint(x.y), asint(x.z));
    [MethodImpl(AggressiveInlining)] public static uint3 asuint(float3 x) => new uint3(asuint(x.x), asuint(x.y), asuint(x.z));
    [MethodImpl(AggressiveInlining)] public static float3 chgsign(float3 x, float3 y) => new float3(chgsign(x.x, y.x), chgsign(x.y, y.y), chgsign(x.z, y.z));
    [MethodImpl(AggressiveInlining)] public static float3 lerp(float3 start, float3 end, float t) => start + t * (end - start);
    [MethodImpl(AggressiveInlining)] public static float lengthsq(float3 x) => dot(x, x);
    [MethodImpl(AggressiveInlining)] public static float length(float3 x) => sqrt(dot(x, x));
    [MethodImpl(AggressiveInlining)] public static float distance(float3 x, float3 y) => length(y - x);
    [MethodImpl(AggressiveInlining)] public static float distancesq(float3 x, float3 y) => lengthsq(y - x);
    [MethodImpl(AggressiveInlining)] public static float3 normalize(float3 x) => rsqrt(dot(x, x)) * x;
    [MethodImpl(AggressiveInlining)] public static float3 reflect(float3 i, float3 n) => i - 2f * n * dot(i, n);
    [MethodImpl(AggressiveInlining)] public static float3 project(float3 a, float3 ontoB) => (dot(a, ontoB) / dot(ontoB, ontoB)) * ontoB;
    [MethodImpl(AggressiveInlining)] public static float3 faceforward(float3 n, float3 i, float3 ng) => select(n, -n, dot(ng, i) >= 0);

    public static float3 normalizesafe(float3 x, float3 defaultvalue = default)
    {
        float square = dot(x, x);
        return square > FLT_MIN_NORMAL ? x * rsqrt(square) : defaultvalue;
    }

    public static float3 projectsafe(float3 a, float3 ontoB, float3 defaultValue = default)
    {
        float3 projection = project(a, ontoB);
        return all(isfinite(projection)) ? projection : defaultValue;
    }

    public static float3 refract(float3 i, float3 n, float indexOfRefraction)
    {
        float cosine = dot(n, i);
        float square = 1f - indexOfRefraction * indexOfRefraction * (1f - cosine * cosine);
        return square >= 0 ? indexOfRefraction * i - (indexOfRefraction * cosine + sqrt(square)) * n : new float3(0);
    }

    public static float3 modf(float3 x, out float3 i)
    {
        i = trunc(x);
        return x - i;
    }

    public static void sincos(float3 x, out float3 s, out float3 c)
    {
        s = sin(x);
        c = cos(x);
    }

    [MethodImpl(AggressiveInlining)]
    public static float3 cross(float3 x, float3 y)
    {
        return new float3(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);
    }

    /// <summary>Two unit vectors that complete a unit normal.</summary>
    public static void orthonormal_basis(float3 normal, out float3 basis1, out float3 basis2)
    {
        float side = normal.z >= 0 ? 1 : -1;
        float a = -1 / (side + normal.z);
        float b = normal.x * normal.y * a;
        basis1 = new float3(1 + side * normal.x * normal.x * a, side * b, -side * normal.x);
        basis2 = new float3(b, side + normal.y * normal.y * a, -normal.y);
    }
}
