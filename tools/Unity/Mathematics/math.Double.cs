using System;

namespace Unity.Mathematics;

public static partial class math
{
    public static bool isfinite(double x) => double.IsFinite(x);
    public static bool isinf(double x) => double.IsInfinity(x);
    public static bool isnan(double x) => double.IsNaN(x);

    /// <summary>NaN is ignored if the other argument is a number.</summary>
    public static double min(double x, double y) => double.IsNaN(y) || x < y ? x : y;

    /// <summary>NaN is ignored if the other argument is a number.</summary>
    public static double max(double x, double y) => double.IsNaN(y) || x > y ? x : y;

    public static double abs(double x) => Math.Abs(x);
    public static double lerp(double start, double end, double t) => start + t * (end - start);
    public static double unlerp(double start, double end, double x) => (x - start) / (end - start);
    public static double remap(double srcStart, double srcEnd, double dstStart, double dstEnd, double x) =>
        lerp(dstStart, dstEnd, unlerp(srcStart, srcEnd, x));
    public static double mad(double mulA, double mulB, double addC) => mulA * mulB + addC;
    public static double clamp(double valueToClamp, double lowerBound, double upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    public static double saturate(double x) => clamp(x, 0.0, 1.0);
    public static double dot(double x, double y) => x * y;
    public static double mul(double a, double b) => a * b;
    public static double square(double x) => x * x;
    public static double select(double falseValue, double trueValue, bool test) => test ? trueValue : falseValue;
    public static double step(double threshold, double x) => x >= threshold ? 1.0 : 0.0;

    public static double smoothstep(double xMin, double xMax, double x)
    {
        double t = saturate((x - xMin) / (xMax - xMin));
        return t * t * (3.0 - 2.0 * t);
    }

    public static double length(double x) => abs(x);
    public static double lengthsq(double x) => x * x;
    public static double distance(double x, double y) => abs(y - x);
    public static double distancesq(double x, double y) => square(y - x);

    /// <summary>0 for zero and for NaN.</summary>
    public static double sign(double x) => (x > 0.0 ? 1.0 : 0.0) - (x < 0.0 ? 1.0 : 0.0);

    /// <summary>Rounds half to even.</summary>
    public static double round(double x) => Math.Round(x);
    public static double floor(double x) => Math.Floor(x);
    public static double ceil(double x) => Math.Ceiling(x);
    public static double trunc(double x) => Math.Truncate(x);
    public static double frac(double x) => x - floor(x);
    public static double fmod(double x, double y) => x % y;

    public static double modf(double x, out double i)
    {
        i = trunc(x);
        return x - i;
    }

    public static double rcp(double x) => 1.0 / x;
    public static double sqrt(double x) => Math.Sqrt(x);
    public static double rsqrt(double x) => 1.0 / sqrt(x);
    public static double pow(double x, double y) => Math.Pow(x, y);
    public static double exp(double x) => Math.Exp(x);
    public static double exp2(double x) => Math.Exp(x * LN2_DBL);
    public static double exp10(double x) => Math.Exp(x * LN10_DBL);
    public static double log(double x) => Math.Log(x);
    public static double log2(double x) => Math.Log(x, 2.0);
    public static double log10(double x) => Math.Log10(x);

    public static double sin(double x) => Math.Sin(x);
    public static double cos(double x) => Math.Cos(x);
    public static double tan(double x) => Math.Tan(x);
    public static double asin(double x) => Math.Asin(x);
    public static double acos(double x) => Math.Acos(x);
    public static double atan(double x) => Math.Atan(x);
    public static double atan2(double y, double x) => Math.Atan2(y, x);
    public static double sinh(double x) => Math.Sinh(x);
    public static double cosh(double x) => Math.Cosh(x);
    public static double tanh(double x) => Math.Tanh(x);

    public static void sincos(double x, out double s, out double c)
    {
        s = sin(x);
        c = cos(x);
    }

    public static double radians(double x) => x * TORADIANS_DBL;
    public static double degrees(double x) => x * TODEGREES_DBL;
}
