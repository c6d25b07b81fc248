#ifndef GLINT_REVEALED_CELLS
#define GLINT_REVEALED_CELLS

#include "TubePath.hlsl"

// Cells of which a neighbour has found that something reaches into them, between their corners: where a curved surface mirrors
// an edge, second bounces fill fingers of the grid that are narrower than a cell. A bit of each level and position, by a hash:
// cells that share one are divided without need.

StructuredBuffer<uint> _Revealed;          // by earlier attempts of a pose: those of its next attempt are divided

uint RevealedBit(uint2 position, uint level)
{
    return Mixed(Mixed(Mixed(NO_SIGNATURE, level), position.x), position.y) & (32 * REVEALED_WORDS - 1);
}

bool IsRevealed(Cell cell)
{
    uint bit = RevealedBit(cell.Position, cell.Level);
    return cell.Level < MaxLevel() && (_Revealed[s_pose * REVEALED_WORDS + (bit >> 5)] >> (bit & 31) & 1) != 0;
}

#endif
