#ifndef GLINT_TUBE_CORNERS
#define GLINT_TUBE_CORNERS

#include "TubeBlocks.hlsl"
#include "Sums.hlsl"

// Follows the rays through the corners of cells, and notes what they meet at each bounce. One thread a corner.

// Whether a cell at a corner of the slice is to be traced.
bool HasBaseCell(uint2 corner)
{
    bool isTraced = false;
    [loop]
    for (uint i = 0; i < 4 && !isTraced; i++)
    {
        int2 at = (int2)corner - int2(i & 1, i >> 1);
        if (all(at >= 0) && all((uint2)at < SliceSize()))
            isTraced = IsToTrace(LoadCell(at.x + at.y * _Grid.w));
    }
    return isTraced;
}

// Whether one of the four parts of a cell is to be traced that has this corner.
bool HasPart(uint block, uint2 corner)
{
    bool isTraced = false;
    [loop]
    for (uint i = 0; i < BLOCK_CELLS && !isTraced; i++)
        if (all(corner - uint2(i & 1, i >> 1) < 2))
            isTraced = IsToTrace(LoadCell(BLOCK_CELLS * block + i));
    return isTraced;
}

// The place of a corner, base cells. False if no cell needs it.
bool PlaceOfCorner(uint index, out float2 place)
{
    if (_Round == 0)
    {
        uint2 corner = uint2(index % (_Grid.w + 1), index / (_Grid.w + 1));
        place = SliceStart() + corner;
        return HasBaseCell(corner);
    }
    uint block = index / BLOCK_CORNERS, number = index % BLOCK_CORNERS;
    uint2 at = uint2(number % 3, number / 3);
    Cell cell = LoadCell(BLOCK_CELLS * block);
    place = SideOfCell(cell) * (cell.Position + at);
    return HasPart(block, at);
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread), bounces = 0;
    float2 place;
    if (index >= CornerCount())
        return;
    if (!PlaceOfCorner(index, place))
        return;
    float side = _Round == 0 ? 1.0 : SideOfCell(LoadCell(index / BLOCK_CORNERS * BLOCK_CELLS));
    TubePath tube = BeginTube(place);
    SurfacePoint at;
    [loop]
    while (AdvanceTube(tube, at))
    {
        uint receivers = ReceiversOf(tube, at);
        Sign(tube, receivers);
        Corner corner;
        corner.Signature = tube.Signature;
        corner.Bounces = 0;
        corner.Strength = StrengthAt(tube, at, receivers)
            * float2(1.0, BentErrorAt(tube, at, ReceiverFrom(0, tube.Path.Ray.Origin), side));
        corner.Place = PlaceOf(tube);
        corner.AlongU = DifferentialOf(tube, tube.PlaceU);
        corner.AlongV = DifferentialOf(tube, tube.PlaceV);
        _Corners[index * _MaxBounces + bounces++] = corner;
        if (!ScatterTube(tube, at))
            break;
    }
    _Corners[index * _MaxBounces].Bounces = bounces;
    AddUnsigned(TUBE_RAYS, 1);
}

#endif
