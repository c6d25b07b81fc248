#ifndef GLINT_SPECKLE
#define GLINT_SPECKLE

#include "Trigonometry.hlsl"

// Speckle of the sea's surface, a function of cell, seed and time alone; Core/Clutter/Speckle.cs has the same in
// double precision.

// Four words of one of the 2^128 inputs: pcg4d of Jarzynski and Olano, Hash Functions for GPU Rendering (2020).
uint4 SpeckleHash(uint4 v)
{
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// -ln of (n + 1) / 2^24 for n below 2^24, to 3e-7; a device's own logarithm may be off by 5e-7 near 0.
float SpeckleIntensity(uint n)
{
    uint bits = asuint((float)(n + 1));
    // The mantissa is brought to 0.707 to 1.414.
    uint shifted = bits + 0x3F800000 - 0x3F3504F3;
    int exponent = (int)(shifted >> 23) - 127;
    precise float x = asfloat((shifted & 0x007FFFFF) + 0x3F3504F3) - 1.0;
    // ln(1 + x) of Cephes (Moshier).
    precise float y = 7.0376836292e-2;
    y = y * x - 1.1514610310e-1;
    y = y * x + 1.1676998740e-1;
    y = y * x - 1.2420140846e-1;
    y = y * x + 1.4249322787e-1;
    y = y * x - 1.6668057665e-1;
    y = y * x + 2.0000714765e-1;
    y = y * x - 2.4999993993e-1;
    y = y * x + 3.3333331174e-1;
    precise float square = x * x;
    precise float logarithm = x + (y * x * square - 0.5 * square);
    precise float intensity = (24 - exponent) * 0.693147180559945 - logarithm;
    return max(intensity, 0.0);
}

// Two independent complex Gaussian numbers of mean square 1 (Box and Muller): those of the waves that run towards the
// radar, and away from it.
float4 SpeckleAt(int2 cell, uint seed, int time)
{
    uint4 words = SpeckleHash(uint4(asuint(cell), seed, asuint(time))) >> 8;
    return float4(sqrt(SpeckleIntensity(words.x)) * Phasor(words.y / 16777216.0),
        sqrt(SpeckleIntensity(words.z)) * Phasor(words.w / 16777216.0));
}

// In place of a time, for the fraction at which those of a cell begin.
static const uint NO_TIME = 0x80000000;

// The same at any time, in coherence times: between the values of two whole times of the cell, which begin at a random
// fraction; with a mean square of 1 throughout.
float4 SpeckleBetween(int2 cell, uint seed, int time, float fraction)
{
    float at = fraction + (SpeckleHash(uint4(asuint(cell), seed, NO_TIME)).x >> 8) / 16777216.0;
    int whole = time + (at >= 1.0 ? 1 : 0);
    float2 weights = Phasor(0.25 * (at - (at >= 1.0 ? 1.0 : 0.0)));
    return weights.x * SpeckleAt(cell, seed, whole) + weights.y * SpeckleAt(cell, seed, whole + 1);
}

#endif
