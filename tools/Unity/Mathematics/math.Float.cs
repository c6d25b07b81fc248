using System;

namespace Unity.Mathematics;

public static partial class math
{
    public static bool isfinite(float x) => float.IsFinite(x);
    public static bool isinf(float x) => float.IsInfinity(x);
    public static bool isnan(float x) => float.IsNaN(x);

    /// <summary>NaN is ignored if the other argument is a number.</summary>
    public static float min(float x, float y) => float.IsNaN(y) || x < y ? x : y;

    /// <summary>NaN is ignored if the other argument is a number.</summary>
    public static float max(float x, float y) => float.IsNaN(y) || x > y ? x : y;

    public static float abs(float x) => Math.Abs(x);
    public static float lerp(float start, float end, float t) => start + t * (end - start);
    public static float unlerp(float start, float end, float x) => (x - start) / (end - start);
    public static float remap(float srcStart, float srcEnd, float dstStart, float dstEnd, float x) =>
        lerp(dstStart, dstEnd, unlerp(srcStart, srcEnd, x));
    public static float mad(float mulA, float mulB, float addC) => mulA * mulB + addC;
    public static float clamp(float valueToClamp, float lowerBound, float upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    public static float saturate(float x) => clamp(x, 0f, 1f);
    public static float dot(float x, float y) => x * y;
    public static float mul(float a, float b) => a * b;
    public static float square(float x) => x * x;
    public static float select(float falseValue, float trueValue, bool test) => test ? trueValue : falseValue;
    public static float step(float threshold, float x) => x >= threshold ? 1f : 0f;

    public static float smoothstep(float xMin, float xMax, float x)
    {
        float t = saturate((x - xMin) / (xMax - xMin));
        return t * t * (3f - 2f * t);
    }

    public static float length(float x) => abs(x);
    public static float lengthsq(float x) => x * x;
    public static float distance(float x, float y) => abs(y - x);
    public static float distancesq(float x, float y) => square(y - x);

    /// <summary>0 for zero and for NaN.</summary>
    public static float sign(float x) => (x > 0f ? 1f : 0f) - (x < 0f ? 1f : 0f);

    /// <summary>Rounds half to even.</summary>
    public static float round(float x) => MathF.Round(x);
    public static float floor(float x) => MathF.Floor(x);
    public static float ceil(float x) => MathF.Ceiling(x);
    public static float trunc(float x) => MathF.Truncate(x);
    public static float frac(float x) => x - floor(x);
    public static float fmod(float x, float y) => x % y;

    public static float modf(float x, out float i)
    {
        i = trunc(x);
        return x - i;
    }

    public static float rcp(float x) => 1f / x;
    public static float sqrt(float x) => (float)Math.Sqrt(x);
    public static float rsqrt(float x) => 1f / sqrt(x);
    public static float pow(float x, float y) => (float)Math.Pow(x, y);
    public static float exp(float x) => (float)Math.Exp(x);
    public static float exp2(float x) => (float)Math.Exp(x * LN2);
    public static float exp10(float x) => (float)Math.Exp(x * LN10);
    public static float log(float x) => (float)Math.Log(x);
    public static float log2(float x) => (float)Math.Log(x, 2.0);
    public static float log10(float x) => (float)Math.Log10(x);

    public static float sin(float x) => (float)Math.Sin(x);
    public static float cos(float x) => (float)Math.Cos(x);
    public static float tan(float x) => (float)Math.Tan(x);
    public static float asin(float x) => (float)Math.Asin(x);
    public static float acos(float x) => (float)Math.Acos(x);
    public static float atan(float x) => (float)Math.Atan(x);
    public static float atan2(float y, float x) => (float)Math.Atan2(y, x);
    public static float sinh(float x) => (float)Math.Sinh(x);
    public static float cosh(float x) => (float)Math.Cosh(x);
    public static float tanh(float x) => (float)Math.Tanh(x);

    public static void sincos(float x, out float s, out float c)
    {
        s = sin(x);
        c = cos(x);
    }

    public static float radians(float x) => x * TORADIANS;
    public static float degrees(float x) => x * TODEGREES;

    /// <summary>Multiplies the sign of x by the sign of y.</summary>
    public static float chgsign(float x, float y) => asfloat(asuint(x) ^ (asuint(y) & 0x80000000u));
}
