#ifndef GLINT_AMPLITUDE_POINTS
#define GLINT_AMPLITUDE_POINTS

#include "AmplitudePath.hlsl"

// Follows the rays through the corners of base cells; in later rounds those through the new points of cells that were divided.
// One thread a ray.

// Tells the cell on the other side of a position on a side.
void RevealAcross(float2 position, float2 outward)
{
    // The position may be between two parts.
    for (uint i = 0; i < 2; i++)
    {
        float2 beside = outward + (i == 0 ? -1.0 : 1.0) * float2(outward.y, outward.x);
        int2 part = (int2)floor(REVEALED_PARTS * position + 0.25 * beside);
        uint2 cell = (uint2)(part >> REVEALED_LEVEL), bit = (uint2)(part & (REVEALED_PARTS - 1));
        uint word = FirstRevealed(cell) + bit.y, before;
        if (any(part < 0) || any(cell >= _Poses[s_pose].Cells))
            continue;
        InterlockedOr(_RevealedByNow[word], 1u << bit.x, before);
        if ((before >> bit.x & 1) == 0)
            AddTo(AmplitudeWord(AMPLITUDE_REVEALED), 1);
    }
}

// Position of a new point of a cell that is divided, in sides from its centre: the middles of the sides, or the centre.
float2 FromCentre(uint ray)
{
    return ray == 4 ? (float2)0 : 0.5 * (CornerOf(ray) + CornerOf((ray + 1) & 3));
}

// A ray through a corner of cells.
struct PointRay
{
    float2 OnGrid;         // base cells
    uint Number;           // of its point; NO_POINT: there is none
    bool IsCounted;        // slices that share a row of corners count it once
};

// Makes its pose that of the thread.
PointRay BaseCorner(uint index)
{
    PointRay ray = (PointRay)0;
    ray.Number = NO_POINT;
    if (index < _BaseCounts.y)
    {
        EnterPose(PoseOf(index, true), index);
        uint across = SliceSize().x + 1, number = index - _Poses[s_pose].FirstCorner;
        uint2 inSlice = uint2(number % across, number / across), corner = SliceStart() + inSlice;
        ray.OnGrid = corner;
        ray.Number = index;
        ray.IsCounted = inSlice.y > 0 || corner.y == 0;
    }
    return ray;
}

// Of a cell that was divided. Makes its pose that of the thread.
PointRay NewPoint(uint index)
{
    PointRay ray = (PointRay)0;
    ray.Number = NO_POINT;
    uint block = index / NEW_CORNERS, number = index % NEW_CORNERS;
    if (BLOCK_CELLS * block < CellCount())
    {
        Cell first = _TubeCells[BLOCK_CELLS * block], cell = (Cell)0;
        EnterPose(first.Pose, index);
        cell.Position = first.Position >> 1;
        cell.Level = first.Level - 1;
        ray.OnGrid = CentreOfCell(cell) + SideOfCell(cell) * FromCentre(number);
        ray.Number = FirstNewPoint(first) + number;
        ray.IsCounted = true;
    }
    return ray;
}

[numthreads(GLINT_GROUP, 1, 1)]
void AmplitudePoints(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (_Round == 0 && index == 0)
        InterlockedAdd(_Sums[TUBE_POINTS], _BaseCounts.y);
    PointRay ray;
    if (_Round == 0)
        ray = BaseCorner(index);
    else
        ray = NewPoint(index);
    if (ray.Number == NO_POINT)
        return;
    // One call, so that the code of a path is compiled once.
    uint signature = Follow(ray.OnGrid, ray.Number, ray.IsCounted).Signature;
    if (ray.IsCounted)
        AddRays(1);
    uint block = index / NEW_CORNERS, number = index % NEW_CORNERS;
    if (_Round > 0 && number < 4 && signature != SignatureOfCorner(block, number)
        && signature != SignatureOfCorner(block, (number + 1) & 3))
        RevealAcross(ray.OnGrid, 2.0 * FromCentre(number));
}

#endif
