#ifndef GLINT_TUBE_REVEALS
#define GLINT_TUBE_REVEALS

#include "CellCorners.hlsl"
#include "RevealedCells.hlsl"

// Finds what reaches into a cell through a side between its ends: a cell beside it that is divided has a ray through the middle
// of the side. The next attempt divides the cell. One thread a side of a cell that was divided.

RWStructuredBuffer<uint> _RevealedByNow;   // as _Revealed, with this attempt

// Largest weighted strength of what the ray through a corner has met and that through another has not.
float StrengthBeyond(uint corner, uint other)
{
    float most = 0.0;
    uint bounces = BouncesOf(_Corners[corner]), otherBounces = BouncesOf(_Corners[other]);
    [loop]
    for (uint bounce = 0; bounce < bounces; bounce++)
    {
        Corner met = _Corners[corner + bounce];
        if (bounce >= otherBounces || _Corners[other + bounce].Signature != met.Signature)
            most = max(most, met.Strength * WeightOf(CrossPartOf(met)));
    }
    return most;
}

// Signature of the whole path of the ray through a corner.
uint LastSignature(uint corner)
{
    return SignatureOf(corner, BouncesOf(_Corners[corner]));
}

// First element of a corner of a cell that was divided.
uint ElementOfBlock(uint block, int2 at)
{
    return CornerOfBlock(block, (uint2)at) * _MaxBounces;
}

// Tells the cell at a position of a level, and the larger cells about it that are not about the one at its side.
void Reveal(uint2 position, uint2 aside, uint level)
{
    [loop]
    for (uint up = level + 1; up > 0 && any(position != aside); up--)
    {
        uint bit = RevealedBit(position, up - 1);
        InterlockedOr(_RevealedByNow[s_pose * REVEALED_WORDS + (bit >> 5)], 1u << (bit & 31));
        position >>= 1;
        aside >>= 1;
    }
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= CellCount())
        return;
    Cell part = LoadCell(index);
    // The side of this thread: outward points across it.
    int side = index & 3;
    int2 outward = (side & 1) != 0 ? int2(side - 2, 0) : int2(0, side - 1), along = abs(outward.yx), at = 1 + outward;
    uint block = index / BLOCK_CELLS, level = part.Level - 1;
    uint2 whole = part.Position >> 1;
    int2 beside = (int2)whole + outward;
    if (any(beside < 0) || any((uint2)beside >> level >= _Poses[s_pose].Cells))
        return;
    uint middle = ElementOfBlock(block, at), first = ElementOfBlock(block, at - along),
        second = ElementOfBlock(block, at + along);
    uint signature = LastSignature(middle);
    if (signature == LastSignature(first) || signature == LastSignature(second))
        return;
    float strength = max(min(StrengthBeyond(middle, first), StrengthBeyond(middle, second)),
        min(StrengthBeyond(first, middle), StrengthBeyond(second, middle)));
    float size = 2.0 * SideOfCell(part);
    if (CRUDE_ERROR * size * size * strength > CellError())
        Reveal((uint2)beside, whole, level);
}

#endif
