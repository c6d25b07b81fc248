#ifndef GLINT_SUMS
#define GLINT_SUMS

#include "Bindings.hlsl"
#include "Geometry.hlsl"

// Sums over rays are whole numbers, so that they are the same bit for bit in any order:
// lengths in units of _LengthUnits, I and Q in units of 2^-24.
// Groups add to one of SUM_SLOTS slots of SUM_WORDS words each, so that they seldom wait for each other.
// 64-bit sums take two words, the lower one first.
static const uint SUM_SLOTS = 64;
static const uint SUM_WORDS = 64;
static const uint SUM_HITS = 0;
static const uint SUM_BOUNCES = 1;
static const uint SUM_RECEIVED = 2;
static const uint SUM_RETURNING = 3;        // rays in _Returning; in the first slot only
static const uint SUM_LENGTH = 4;
static const uint SUM_IN_PHASE = 6;
static const uint SUM_QUADRATURE = 8;
static const uint SUM_NODES = 10;
static const uint SUM_PAIRS = 12;
static const uint SUM_HISTOGRAM = 16;       // received rays by phase
static const uint PHASE_BINS = 36;

static const float PHASOR_UNITS = 16777216.0;

void AddTo(uint word, uint value)
{
    InterlockedAdd(_Sums[word], value);
}

// Adds a number of 64 bits, given by its halves.
void AddHalves(uint word, uint lower, uint upper)
{
    uint before;
    InterlockedAdd(_Sums[word], lower, before);
    upper += before + lower < before ? 1 : 0;
    if (upper != 0)
        InterlockedAdd(_Sums[word + 1], upper);
}

void AddUnsigned(uint word, uint value)
{
    AddHalves(word, value, 0);
}

void AddSigned(uint word, int value)
{
    AddHalves(word, (uint)value, value < 0 ? 0xffffffff : 0);
}

uint InLengthUnits(float length)
{
    return (uint)(length * _LengthUnits + 0.5);
}

int InPhasorUnits(float part)
{
    return (int)round(part * PHASOR_UNITS);
}

// Ray by ray: adding within a group first gains a GPU nothing,
// and its barriers cost a software device a tenth of its time.
void AddPath(uint slot, uint bounces, float lengthBeyond)
{
    if (bounces == 0)
        return;
    AddTo(slot + SUM_HITS, 1);
    AddTo(slot + SUM_BOUNCES, bounces);
    AddUnsigned(slot + SUM_LENGTH, InLengthUnits(lengthBeyond));
}

// Turns: phase as a part of a turn, 0 to 1.
void AddReceived(uint slot, float turns, float2 phasor)
{
    AddTo(slot + SUM_RECEIVED, 1);
    AddSigned(slot + SUM_IN_PHASE, InPhasorUnits(phasor.x));
    AddSigned(slot + SUM_QUADRATURE, InPhasorUnits(phasor.y));
    AddTo(slot + SUM_HISTOGRAM + min(PHASE_BINS - 1, (uint)(turns * PHASE_BINS)), 1);
}

#endif
