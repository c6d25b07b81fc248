#ifndef GLINT_TUBE_CORNERS
#define GLINT_TUBE_CORNERS

#include "TubeBlocks.hlsl"
#include "Sums.hlsl"

// Follows the rays through the corners of cells, and notes what they meet at each bounce. One thread a corner.

// Whether a base cell at a corner of the grid is to be traced.
bool HasBaseCell(uint2 corner)
{
    bool isTraced = false;
    [loop]
    for (uint i = 0; i < 4 && !isTraced; i++)
    {
        Cell cell = (Cell)0;
        cell.Position = corner - uint2(i & 1, i >> 1);
        if (all(cell.Position < _Poses[s_pose].Cells))
            isTraced = IsToTrace(cell);
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

// A corner of cells.
struct CornerPosition
{
    float2 OnGrid;         // base cells
    float Side;            // of its cells
    bool IsTraced;         // some cell needs it
    bool IsCounted;        // dispatches that share a base corner count it once
};

CornerPosition PositionOf(uint index)
{
    CornerPosition position;
    position.Side = 1.0;
    position.IsCounted = true;
    if (_Round == 0)
    {
        s_pose = PoseOfCorner(index);
        uint across = SliceSize().x + 1, number = index - _Poses[s_pose].FirstCorner;
        uint2 inSlice = uint2(number % across, number / across), corner = SliceStart() + inSlice;
        position.OnGrid = corner;
        position.IsTraced = HasBaseCell(corner);
        position.IsCounted = all(inSlice > 0 || corner == 0);
        return position;
    }
    uint block = index / BLOCK_CORNERS, number = index % BLOCK_CORNERS;
    uint2 at = uint2(number % 3, number / 3);
    Cell cell = LoadCell(BLOCK_CELLS * block);
    position.Side = SideOfCell(cell);
    position.OnGrid = position.Side * (cell.Position + at);
    position.IsTraced = HasPart(block, at);
    return position;
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread), bounces = 0;
    if (index >= CornerCount())
        return;
    CornerPosition position = PositionOf(index);
    if (!position.IsTraced)
        return;
    TubePath tube = BeginTube(position.OnGrid);
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
            * float2(1.0, BentErrorAt(tube, at, ReceiverFrom(0, tube.Path.Ray.Origin), position.Side));
        corner.Position = PlaceOf(tube);
        corner.AlongU = DifferentialOf(tube, tube.PlaceU, tube.LengthSlope.x);
        corner.AlongV = DifferentialOf(tube, tube.PlaceV, tube.LengthSlope.y);
        _Corners[index * _MaxBounces + bounces++] = corner;
        if (!ScatterTube(tube, at))
            break;
    }
    _Corners[index * _MaxBounces].Bounces = bounces;
    if (position.IsCounted)
        AddTo(CountWord(POSE_RAYS), 1);
}

#endif
