namespace System.Numerics;

// Of .NET 10, for the counts of bits in Unity.Mathematics; the product does not use them.
static class BitOperations
{
    public static int PopCount(ulong x)
    {
        int count = 0;
        for (; x != 0; x &= x - 1)
            count++;
        return count;
    }

    public static int TrailingZeroCount(ulong x) => PopCount(~x & (x - 1));
    public static int TrailingZeroCount(long x) => TrailingZeroCount((ulong)x);
    public static int TrailingZeroCount(uint x) => TrailingZeroCount(x | (1UL << 32));
    public static int TrailingZeroCount(int x) => TrailingZeroCount((uint)x);

    public static int LeadingZeroCount(ulong x)
    {
        int count = 64;
        for (; x != 0; x >>= 1)
            count--;
        return count;
    }

    public static int LeadingZeroCount(uint x) => LeadingZeroCount((ulong)x) - 32;
    public static uint RotateLeft(uint x, int n) => (x << n) | (x >> -n);
    public static uint RotateRight(uint x, int n) => (x >> n) | (x << -n);
    public static ulong RoundUpToPowerOf2(ulong x) => x == 0 ? 0 : 1UL << -LeadingZeroCount(x - 1);
    public static uint RoundUpToPowerOf2(uint x) => (uint)RoundUpToPowerOf2((ulong)x);
}
