#ifndef GLINT_SUB_RAY_CHOICE
#define GLINT_SUB_RAY_CHOICE

#include "WorkLists.hlsl"
#include "DoubleFloat.hlsl"

// The pixels that get sub-rays, the same as Core/Sampling/RefinedPixels.cs: received ones around which the phase is not
// smooth, and all neighbours of received ones.

// Maximum differences of lengths around a smooth pixel, m, double-floats (Core/Sampling/PixelPhase.cs).
float4 _MaxSlope, _MaxBend, _MaxTwist;

RWStructuredBuffer<uint> _ChosenPixels;

// Length of the received ray of a position in the picture; NO_LENGTH if there is none.
uint LengthAt(int2 at)
{
    bool isInRegion = IsInRegion(at);
    uint number = _Lengths[isInRegion ? InRegion((uint)at.x + (uint)at.y * _RaysAcross) : 0]; // both sides of ? are evaluated
    return isInRegion ? number : NO_LENGTH;
}

// The eight neighbours of a position: below it from the left, beside it, above it from the left.
static const int2 NEIGHBOURS[8] =
{
    int2(-1, -1), int2(0, -1), int2(1, -1), int2(-1, 0), int2(1, 0), int2(-1, 1), int2(0, 1), int2(1, 1)
};

bool IsWithin(DoubleFloat a, float4 maximum)
{
    DoubleFloat size = Mul(a, a.Hi < 0.0 ? -1.0 : 1.0), excess = Sub(size, MakeDoubleFloat(maximum.x, maximum.y));
    return excess.Hi < 0.0 || excess.Hi == 0.0 && excess.Lo <= 0.0;
}

// Whether the phase over the pixel is a parabola through its neighbours (Core/Sampling/PixelPhase.cs).
bool IsSmooth(float centre, float around[8])
{
    float twice = -2.0 * centre;
    DoubleFloat twist = Sub(TwoSum(around[7], -around[5]), TwoSum(around[2], -around[0]));
    return IsWithin(TwoSum(around[4], -around[3]), _MaxSlope) && IsWithin(TwoSum(around[6], -around[1]), _MaxSlope)
        && IsWithin(Add(TwoSum(around[4], around[3]), MakeDoubleFloat(twice, 0.0)), _MaxBend)
        && IsWithin(Add(TwoSum(around[6], around[1]), MakeDoubleFloat(twice, 0.0)), _MaxBend)
        && IsWithin(twist, _MaxTwist);
}

void Choose(int2 at)
{
    uint entry;
    InterlockedAdd(_Sums[COUNT_CHOSEN], 1, entry);
    if (entry < MAX_CHOSEN)
        _ChosenPixels[entry] = (uint)at.x + (uint)at.y * _RaysAcross;
}

// Whether a received ray is the first around a pixel without one, which is chosen only once.
bool IsFirstAround(int2 at, int2 received)
{
    bool isFirst = false, isFound = false;
    [unroll] // the loads then do not wait for each other
    for (uint i = 0; i < 8; i++)
    {
        int2 other = at + NEIGHBOURS[i];
        bool isReceived = LengthAt(other) != NO_LENGTH;
        isFirst = isFirst || !isFound && isReceived && all(other == received);
        isFound = isFound || isReceived;
    }
    return isFirst;
}

// Chooses among the pixel of a received ray and its neighbours.
void ChooseAround(uint pixel)
{
    int2 at = int2(pixel % _RaysAcross, pixel / _RaysAcross);
    float around[8];
    uint missing = 0;
    [unroll]
    for (uint i = 0; i < 8; i++)
    {
        uint there = LengthAt(at + NEIGHBOURS[i]);
        around[i] = asfloat(there);
        missing |= there == NO_LENGTH ? 1u << i : 0;
    }
    [loop]
    for (uint j = 0; j < 8; j++)
    {
        int2 neighbour = at + NEIGHBOURS[j];
        if ((missing >> j & 1) != 0 && IsInRegion(neighbour) && IsFirstAround(neighbour, at))
            Choose(neighbour);
    }
    if (missing != 0 || !IsSmooth(asfloat(LengthAt(at)), around))
        Choose(at);
}

#endif
