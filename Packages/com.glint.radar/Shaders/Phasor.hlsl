#ifndef GLINT_PHASOR
#define GLINT_PHASOR

#include "DoubleFloat.hlsl"
#include "Trigonometry.hlsl"

// Fractional part of a number of turns, 0 to 1.
float PartOfTurn(DoubleFloat turns)
{
    precise float part = (turns.Hi - floor(turns.Hi)) + turns.Lo;
    return part - floor(part);
}

#endif
