#ifndef GLINT_TUBE_CORNERS
#define GLINT_TUBE_CORNERS

#include "TubeBlocks.hlsl"
#include "Sums.hlsl"

// Follows the rays through the corners of cells, and notes what they meet at each bounce. Of a cell that was divided the corners
// are known; the middles of its sides and its centre are new. One thread a base corner, or a new one.

// Whether a triangle may be seen in a base cell at a corner of the grid.
bool HasBaseCell(uint2 corner)
{
    bool isCovered = false;
    for (uint i = 0; i < 4; i++)
    {
        uint2 cell = corner - uint2(i & 1, i >> 1);
        if (all(cell < _Poses[s_pose].Cells))
            isCovered = isCovered || IsCovered(cell);
    }
    return isCovered;
}

// A corner of cells.
struct CornerPosition
{
    float2 OnGrid;         // base cells
    float Side;            // of the cells
    uint Number;
    uint Whole;            // number in the round before of the cell that was divided
    bool IsNeeded;
    bool IsCounted;        // dispatches that share a base corner count it once
};

static const float MAX_HALF = 65504.0;

// Bits of a float16 that is not negative; larger numbers are its largest.
uint HalfOf(float value)
{
    return f32tof16(min(value, MAX_HALF));
}

CornerPosition PositionOf(uint index)
{
    CornerPosition position = (CornerPosition)0;
    position.Number = index;
    position.IsCounted = true;
    position.Side = 1.0;
    if (_Round == 0)
    {
        s_pose = PoseOf(index, true);
        uint across = SliceSize().x + 1, number = index - _Poses[s_pose].FirstCorner;
        uint2 inSlice = uint2(number % across, number / across), corner = SliceStart() + inSlice;
        position.OnGrid = corner;
        CountAt(corner);
        position.IsNeeded = HasBaseCell(corner);
        position.IsCounted = all(inSlice > 0 || corner == 0);
        return position;
    }
    uint block = index / NEW_CORNERS, place = 2 * (index % NEW_CORNERS) + 1;
    // Of nine places, row by row: 1, 3, 4, 5 and 7.
    place = place == 5 ? 4 : place == 7 ? 5 : place == 9 ? 7 : place;
    uint2 at = uint2(place % 3, place / 3);
    Cell cell = LoadCell(BLOCK_CELLS * block);
    position.Number = CornerOfBlock(block, at);
    position.Side = SideOfCell(cell);
    position.OnGrid = position.Side * (cell.Position + at);
    position.Whole = cell.Whole;
    position.IsNeeded = true;
    return position;
}

// Takes what the ray through one of the four known corners of a divided cell has met over from the round before.
void CopyCorner(uint whole, uint block, uint corner)
{
    uint2 at = uint2(corner & 1, corner >> 1);
    uint from = CornerOfCell(whole, at, _Round - 1) * _MaxBounces, to = CornerOfBlock(block, 2 * at) * _MaxBounces;
    uint bounces = BouncesOf(_CornersBefore[from]);
    for (uint i = 0; i < max(bounces, 1); i++)
        _Corners[to + i] = _CornersBefore[from + i];
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread), bounces = 0;
    if (index >= CornerCount())
        return;
    CornerPosition position = PositionOf(index);
    if (!position.IsNeeded)
        return;
    if (_Round > 0 && index % NEW_CORNERS < BLOCK_CELLS)
        CopyCorner(position.Whole, index / NEW_CORNERS, index % NEW_CORNERS);
    uint first = position.Number * _MaxBounces;
    TubePath tube = BeginTube(position.OnGrid);
    SurfacePoint at;
    bool isTurning = false;
    [loop]
    while (AdvanceTube(tube, at))
    {
        uint receivers = ReceiversOf(tube, at);
        Sign(tube, receivers);
        Corner corner;
        corner.Signature = tube.Signature;
        // Of what is hidden from all receivers a part between the corners may be seen, and as strong.
        uint seen = receivers != 0 ? receivers : ReceiversFaced(tube, at, position.Side, isTurning);
        corner.Traits = UnitsOfPart(CrossPartAt(tube, at, seen)) << 8 | FacetsOf(tube) << 16;
        corner.Strength = StrengthAt(tube, at, seen);
        corner.Changes = HalfOf(SteepnessAt(tube, seen))
            | HalfOf(BentOf(tube, at, ReceiverFrom(0, tube.Path.Ray.Origin))) << 16;
        corner.Position = float4(tube.Path.Ray.Origin, tube.Path.RelativeLength);
        corner.AlongU = float4(tube.PlaceU, tube.LengthSlope.x);
        corner.AlongV = float4(tube.PlaceV, tube.LengthSlope.y);
        _Corners[first + bounces++] = corner;
        isTurning = at.IsCurved;
        if (!ScatterTube(tube, at))
            break;
    }
    if (bounces > 0)
        bounces |= _Corners[first].Traits;
    _Corners[first].Traits = bounces;
    if (position.IsCounted)
        AddTo(CountWord(POSE_RAYS), 1);
}

#endif
