#ifndef GLINT_SEA_BOUNDS
#define GLINT_SEA_BOUNDS

#include "SeaField.hlsl"

// Minimum and maximum height in each cell of a tile, and in blocks of 2 x 2, 4 x 4, ... cells up to the whole tile.

static const uint SEA_BLOCK = 16;          // cells along a side of a group's block

StructuredBuffer<SeaPoint> _SeaPoints;
RWStructuredBuffer<float2> _WrittenSeaBounds;

groupshared float2 s_bounds[SEA_BLOCK * SEA_BLOCK];

float2 Joined(float2 a, float2 b)
{
    return float2(min(a.x, b.x), max(a.y, b.y));
}

// The four levels above that of the block's cells.
void StoreLevelsAbove(uint cascade, uint level, uint2 block, uint thread)
{
    uint side = SEA_BLOCK;
    for (uint above = level + 1; above <= level + 4; above++)
    {
        side /= 2;
        GroupMemoryBarrierWithGroupSync();
        uint x = thread % side, z = thread / side, corner = 4 * side * z + 2 * x;
        bool isInside = z < side;
        float2 bounds = 0.0;
        if (isInside)
            bounds = Joined(Joined(s_bounds[corner], s_bounds[corner + 1]),
                Joined(s_bounds[corner + 2 * side], s_bounds[corner + 2 * side + 1]));
        GroupMemoryBarrierWithGroupSync();
        if (isInside)
        {
            s_bounds[thread] = bounds;
            uint2 cell = block * side + uint2(x, z);
            _WrittenSeaBounds[SeaBoundsOf(cascade, above) + cell.y * (SEA_SIDE >> above) + cell.x] = bounds;
        }
    }
}

float2 HeightAt(uint cascade, uint2 corner)
{
    corner &= SEA_SIDE - 1;
    return _SeaPoints[(cascade * SEA_SIDE + corner.y) * SEA_SIDE + corner.x].Height;
}

// A group has a block of cells and a cascade.
[numthreads(256, 1, 1)] // SEA_BLOCK * SEA_BLOCK
void SeaBounds(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint2 block = uint2(group.x % SEA_BLOCK, group.x / SEA_BLOCK),
        cell = block * SEA_BLOCK + uint2(thread % SEA_BLOCK, thread / SEA_BLOCK);
    float2 bounds = Joined(Joined(HeightAt(group.y, cell), HeightAt(group.y, cell + uint2(1, 0))),
        Joined(HeightAt(group.y, cell + uint2(0, 1)), HeightAt(group.y, cell + 1)));
    s_bounds[thread] = bounds;
    _WrittenSeaBounds[SeaBoundsOf(group.y, 0) + cell.y * SEA_SIDE + cell.x] = bounds;
    StoreLevelsAbove(group.y, 0, block, thread);
}

// A group has a cascade: the levels above the blocks of SeaBounds.
[numthreads(256, 1, 1)] // SEA_BLOCK * SEA_BLOCK
void SeaUpperBounds(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    s_bounds[thread] = _WrittenSeaBounds[SeaBoundsOf(group.y, 4) + thread];
    StoreLevelsAbove(group.y, 4, 0, thread);
}

#endif
