using System;
using System.Numerics;

namespace Unity.Mathematics;

public static partial class math
{
    public static int asint(uint x) => (int)x;
    public static int asint(float x) => BitConverter.SingleToInt32Bits(x);
    public static uint asuint(int x) => (uint)x;
    public static uint asuint(float x) => (uint)BitConverter.SingleToInt32Bits(x);
    public static long aslong(ulong x) => (long)x;
    public static long aslong(double x) => BitConverter.DoubleToInt64Bits(x);
    public static ulong asulong(long x) => (ulong)x;
    public static ulong asulong(double x) => (ulong)BitConverter.DoubleToInt64Bits(x);
    public static float asfloat(int x) => BitConverter.Int32BitsToSingle(x);
    public static float asfloat(uint x) => BitConverter.Int32BitsToSingle((int)x);
    public static double asdouble(long x) => BitConverter.Int64BitsToDouble(x);
    public static double asdouble(ulong x) => BitConverter.Int64BitsToDouble((long)x);

    /// <summary>Bit 0 is x.</summary>
    public static int bitmask(bool4 value) =>
        (value.x ? 1 : 0) | (value.y ? 2 : 0) | (value.z ? 4 : 0) | (value.w ? 8 : 0);

    public static int countbits(int x) => BitOperations.PopCount((uint)x);
    public static int countbits(uint x) => BitOperations.PopCount(x);
    public static int countbits(ulong x) => BitOperations.PopCount(x);
    public static int countbits(long x) => BitOperations.PopCount((ulong)x);
    public static int lzcnt(int x) => BitOperations.LeadingZeroCount((uint)x);
    public static int lzcnt(uint x) => BitOperations.LeadingZeroCount(x);
    public static int lzcnt(long x) => BitOperations.LeadingZeroCount((ulong)x);
    public static int lzcnt(ulong x) => BitOperations.LeadingZeroCount(x);

    // BitOperations counts 32 (64) zeros in zero, as here.
    public static int tzcnt(int x) => BitOperations.TrailingZeroCount(x);
    public static int tzcnt(uint x) => BitOperations.TrailingZeroCount(x);
    public static int tzcnt(long x) => BitOperations.TrailingZeroCount(x);
    public static int tzcnt(ulong x) => BitOperations.TrailingZeroCount(x);

    public static uint rol(uint x, int n) => BitOperations.RotateLeft(x, n);
    public static uint ror(uint x, int n) => BitOperations.RotateRight(x, n);
    public static int rol(int x, int n) => (int)rol((uint)x, n);
    public static int ror(int x, int n) => (int)ror((uint)x, n);

    public static uint reversebits(uint x)
    {
        x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
        x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
        x = ((x >> 4) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4);
        x = ((x >> 8) & 0x00FF00FFu) | ((x & 0x00FF00FFu) << 8);
        return (x >> 16) | (x << 16);
    }

    public static int reversebits(int x) => (int)reversebits((uint)x);

    /// <summary>0 for zero and for numbers without a power of two above them.</summary>
    public static uint ceilpow2(uint x) => BitOperations.RoundUpToPowerOf2(x);
    public static ulong ceilpow2(ulong x) => BitOperations.RoundUpToPowerOf2(x);
    public static int ceilpow2(int x) => (int)ceilpow2((uint)x);
    public static long ceilpow2(long x) => (long)ceilpow2((ulong)x);

    public static bool ispow2(int x) => x > 0 && (x & (x - 1)) == 0;
    public static bool ispow2(uint x) => x > 0u && (x & (x - 1u)) == 0u;
    public static int ceillog2(int x) => 32 - lzcnt((uint)x - 1u);
    public static int ceillog2(uint x) => 32 - lzcnt(x - 1u);
    public static int floorlog2(int x) => 31 - lzcnt((uint)x);
    public static int floorlog2(uint x) => 31 - lzcnt(x);
}
