using System;

namespace UnityEngine;

public struct Mathf
{
    public const float PI = (float)Math.PI;
    public const float Infinity = float.PositiveInfinity;
    public const float NegativeInfinity = float.NegativeInfinity;
    public const float Deg2Rad = PI * 2f / 360f;
    public const float Rad2Deg = 1f / Deg2Rad;
    public static readonly float Epsilon = float.Epsilon;

    public static float Sin(float f) => (float)Math.Sin(f);
    public static float Cos(float f) => (float)Math.Cos(f);
    public static float Tan(float f) => (float)Math.Tan(f);
    public static float Asin(float f) => (float)Math.Asin(f);
    public static float Acos(float f) => (float)Math.Acos(f);
    public static float Atan(float f) => (float)Math.Atan(f);
    public static float Atan2(float y, float x) => (float)Math.Atan2(y, x);
    public static float Sqrt(float f) => (float)Math.Sqrt(f);
    public static float Pow(float f, float p) => (float)Math.Pow(f, p);
    public static float Exp(float power) => (float)Math.Exp(power);
    public static float Log(float f, float p) => (float)Math.Log(f, p);
    public static float Log(float f) => (float)Math.Log(f);
    public static float Log10(float f) => (float)Math.Log10(f);

    public static float Abs(float f) => Math.Abs(f);
    public static int Abs(int value) => Math.Abs(value);

    // Comparisons instead of Math.Min: with NaN the second argument wins, as in Unity.
    public static float Min(float a, float b) => a < b ? a : b;
    public static int Min(int a, int b) => a < b ? a : b;
    public static float Max(float a, float b) => a > b ? a : b;
    public static int Max(int a, int b) => a > b ? a : b;
    public static float Min(params float[] values) => Fold(values, Min);
    public static int Min(params int[] values) => Fold(values, Min);
    public static float Max(params float[] values) => Fold(values, Max);
    public static int Max(params int[] values) => Fold(values, Max);

    public static float Ceil(float f) => (float)Math.Ceiling(f);
    public static float Floor(float f) => (float)Math.Floor(f);
    public static float Round(float f) => (float)Math.Round(f);
    public static int CeilToInt(float f) => (int)Math.Ceiling(f);
    public static int FloorToInt(float f) => (int)Math.Floor(f);
    public static int RoundToInt(float f) => (int)Math.Round(f);

    /// <summary>1 for zero, as in Unity.</summary>
    public static float Sign(float f) => f >= 0f ? 1f : -1f;

    public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;
    public static int Clamp(int value, int min, int max) => value < min ? min : value > max ? max : value;
    public static float Clamp01(float value) => Clamp(value, 0f, 1f);

    public static float Lerp(float a, float b, float t) => a + (b - a) * Clamp01(t);
    public static float LerpUnclamped(float a, float b, float t) => a + (b - a) * t;
    public static float LerpAngle(float a, float b, float t) => a + DeltaAngle(a, b) * Clamp01(t);
    public static float InverseLerp(float a, float b, float value) => a != b ? Clamp01((value - a) / (b - a)) : 0f;

    public static float MoveTowards(float current, float target, float maxDelta)
    {
        return Abs(target - current) <= maxDelta ? target : current + Sign(target - current) * maxDelta;
    }

    public static float MoveTowardsAngle(float current, float target, float maxDelta)
    {
        float delta = DeltaAngle(current, target);
        return -maxDelta < delta && delta < maxDelta ? target : MoveTowards(current, current + delta, maxDelta);
    }

    public static float SmoothStep(float from, float to, float t)
    {
        t = Clamp01(t);
        t = -2f * t * t * t + 3f * t * t;
        return to * t + from * (1f - t);
    }

    public static bool Approximately(float a, float b)
    {
        return Abs(b - a) < Max(1e-6f * Max(Abs(a), Abs(b)), Epsilon * 8f);
    }

    public static float Repeat(float t, float length) => Clamp(t - Floor(t / length) * length, 0f, length);
    public static float PingPong(float t, float length) => length - Abs(Repeat(t, length * 2f) - length);

    /// <summary>Shortest difference from one angle to another, degrees, in (-180, 180].</summary>
    public static float DeltaAngle(float current, float target)
    {
        float delta = Repeat(target - current, 360f);
        return delta > 180f ? delta - 360f : delta;
    }

    public static bool IsPowerOfTwo(int value) => (value & (value - 1)) == 0;
    public static int NextPowerOfTwo(int value) => (int)System.Numerics.BitOperations.RoundUpToPowerOf2((uint)value);

    public static int ClosestPowerOfTwo(int value)
    {
        int next = NextPowerOfTwo(value);
        int previous = next >> 1;
        return value - previous < next - value ? previous : next;
    }

    public static ushort FloatToHalf(float val) => BitConverter.HalfToUInt16Bits((Half)val);
    public static float HalfToFloat(ushort val) => (float)BitConverter.UInt16BitsToHalf(val);

    public static float GammaToLinearSpace(float value)
    {
        return value <= 0.04045f ? value / 12.92f
            : value < 1f ? Pow((value + 0.055f) / 1.055f, 2.4f)
            : value == 1f ? 1f : Pow(value, 2.2f);
    }

    public static float LinearToGammaSpace(float value)
    {
        return value <= 0f ? 0f
            : value <= 0.0031308f ? 12.92f * value
            : value < 1f ? 1.055f * Pow(value, 1f / 2.4f) - 0.055f
            : value == 1f ? 1f : Pow(value, 1f / 2.2f);
    }

    static T Fold<T>(T[] values, Func<T, T, T> choose)
    {
        if (values.Length == 0)
            return default;
        T result = values[0];
        for (int i = 1; i < values.Length; i++)
            result = choose(values[i], result);
        return result;
    }
}
