#ifndef GLINT_SUMS
#define GLINT_SUMS

#include "Bindings.hlsl"
#include "Geometry.hlsl"

// Channels: sums over rays in whole units (Core/Radar/Channel.cs), the same bit for bit in any order. Threads spread
// over SUM_SLOTS slots, which reduces contention. Sums of several words have the lowest first, in two's complement.

static const float TWO_TO_32 = 4294967296.0;

void AddTo(uint word, uint value)
{
    InterlockedAdd(_Sums[word], value);
}

// Adds a number of 64 bits, or of 96 with three words, with carries.
void AddWords(uint word, uint words, uint lower, uint upper, uint top)
{
    uint before;
    InterlockedAdd(_Sums[word], lower, before);
    uint carry = before + lower < before ? 1 : 0;
    upper += carry;
    top += upper < carry ? 1 : 0;
    if (upper != 0)
    {
        InterlockedAdd(_Sums[word + 1], upper, before);
        top += before + upper < before ? 1 : 0;
    }
    if (words == 3 && top != 0)
        InterlockedAdd(_Sums[word + 2], top);
}

void AddUnsigned(uint word, uint value)
{
    AddWords(word, 2, value, 0, 0);
}

// Adds a whole number of units to a sum of two or three words.
void AddUnits(uint word, uint words, float units)
{
    float magnitude = abs(units);
    uint upper = (uint)(magnitude / TWO_TO_32), lower = (uint)(magnitude - upper * TWO_TO_32);
    if (units < 0.0)
        AddWords(word, words, 0 - lower, lower == 0 ? 0 - upper : ~upper, 0xffffffff);
    else
        AddWords(word, words, lower, upper, 0);
}

// Adds one ray's part to a channel of two or three words. A part above maxPart, or NaN, sets the bit of SUM_OVERFLOW
// instead.
void AddPart(uint slot, uint channel, uint words, float part, float maxPart, float unitsPerPart, uint overflow)
{
    if (IsNaN(part) || abs(part) > maxPart)
    {
        InterlockedOr(_Sums[slot + SUM_OVERFLOW], overflow);
        return;
    }
    AddUnits(slot + channel, words, round(part * unitsPerPart));
}

// Each ray adds for itself: a reduction within the group gains nothing on a GPU, and its barriers cost a software
// device 10 % of its time. RelativeLength: path length less _OriginDepth, m, positive.
void AddPath(uint slot, uint bounces, float relativeLength)
{
    if (bounces == 0)
        return;
    AddTo(slot + SUM_HITS, 1);
    AddTo(slot + SUM_BOUNCES, bounces);
    float units = relativeLength * _LengthUnits + 0.5;
    if (units < LENGTH_UNITS + 1.0)
        AddUnsigned(slot + SUM_LENGTH, (uint)units);
    else
        InterlockedOr(_Sums[slot + SUM_OVERFLOW], LENGTH_OVERFLOW);
}

// Turns: phase as a fraction of a turn, 0 to 1.
void AddReceived(uint slot, float turns, float2 phasor)
{
    AddTo(slot + SUM_RECEIVED, 1);
    AddPart(slot, SUM_IN_PHASE, 2, phasor.x, MAX_PHASOR_PART, PHASOR_UNITS, IN_PHASE_OVERFLOW);
    AddPart(slot, SUM_QUADRATURE, 2, phasor.y, MAX_PHASOR_PART, PHASOR_UNITS, QUADRATURE_OVERFLOW);
    AddTo(slot + SUM_HISTOGRAM + min(PHASE_BINS - 1, (uint)(turns * PHASE_BINS)), 1);
}

// Adds a received ray to the list behind the counts. Returns its place among all of the slice.
uint ListReceived(uint pixel, float length)
{
    uint at;
    InterlockedAdd(_Sums[COUNT_RECEIVED], 1, at);
    if (at < _ReceivedCapacity)
    {
        _Sums[RECEIVED_RAYS + 2 * at] = pixel;
        _Sums[RECEIVED_RAYS + 2 * at + 1] = asuint(length);
    }
    return at;
}

#endif
