namespace Unity.Mathematics;

public static partial class math
{
    public static int min(int x, int y) => x < y ? x : y;
    public static int max(int x, int y) => x > y ? x : y;
    public static int clamp(int valueToClamp, int lowerBound, int upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    public static int mad(int mulA, int mulB, int addC) => mulA * mulB + addC;
    public static int select(int falseValue, int trueValue, bool test) => test ? trueValue : falseValue;
    public static int dot(int x, int y) => x * y;
    public static int mul(int a, int b) => a * b;
    public static int square(int x) => x * x;

    public static uint min(uint x, uint y) => x < y ? x : y;
    public static uint max(uint x, uint y) => x > y ? x : y;
    public static uint clamp(uint valueToClamp, uint lowerBound, uint upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    public static uint mad(uint mulA, uint mulB, uint addC) => mulA * mulB + addC;
    public static uint select(uint falseValue, uint trueValue, bool test) => test ? trueValue : falseValue;
    public static uint dot(uint x, uint y) => x * y;
    public static uint mul(uint a, uint b) => a * b;
    public static uint square(uint x) => x * x;

    public static long min(long x, long y) => x < y ? x : y;
    public static long max(long x, long y) => x > y ? x : y;
    public static long clamp(long valueToClamp, long lowerBound, long upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    public static long mad(long mulA, long mulB, long addC) => mulA * mulB + addC;
    public static long select(long falseValue, long trueValue, bool test) => test ? trueValue : falseValue;

    public static ulong min(ulong x, ulong y) => x < y ? x : y;
    public static ulong max(ulong x, ulong y) => x > y ? x : y;
    public static ulong clamp(ulong valueToClamp, ulong lowerBound, ulong upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    public static ulong mad(ulong mulA, ulong mulB, ulong addC) => mulA * mulB + addC;
    public static ulong select(ulong falseValue, ulong trueValue, bool test) => test ? trueValue : falseValue;

    // Math.Abs is not used, since it throws for the smallest integer.
    public static int abs(int x) => max(-x, x);
    public static long abs(long x) => max(-x, x);
    public static int sign(int x) => (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0);
}
