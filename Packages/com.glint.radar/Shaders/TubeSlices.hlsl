#ifndef GLINT_TUBE_SLICES
#define GLINT_TUBE_SLICES

#include "TubeBindings.hlsl"

// The base cells of a dispatch: of each pose a slice of its grid, and their corners.

// Base cells of the pose's slice: across, and rows.
uint2 SliceSize()
{
    uint4 slice = _Poses[s_pose].Slice;
    return uint2(slice.z, slice.y / slice.z);
}

uint2 SliceStart()
{
    uint first = _Poses[s_pose].Slice.x, across = _Poses[s_pose].Cells.x;
    return uint2(first % across, first / across);
}

uint CellCount()
{
    return _Round == 0 ? _BaseCounts.x : CountOfList(TUBE_CELLS, _ListCapacity.y);
}

// The pose of a base cell of the dispatch, or of a corner of base cells.
uint PoseOf(uint index, bool isCorner)
{
    uint pose = 0;
    for (uint step = MAX_POSES / 2; step > 0; step /= 2)
    {
        uint next = min(pose + step, _PoseCount - 1);
        pose = (isCorner ? _Poses[next].FirstCorner : _Poses[next].Slice.w) <= index ? next : pose;
    }
    return pose;
}

// A base cell of the dispatch, whose pose becomes that of the thread.
Cell LoadBaseCell(uint index)
{
    s_pose = PoseOf(index, false);
    uint4 slice = _Poses[s_pose].Slice;
    uint inSlice = index - slice.w;
    Cell cell = (Cell)0;
    cell.Position = SliceStart() + uint2(inSlice % slice.z, inSlice / slice.z);
    cell.Pose = s_pose;
    cell.Number = index;
    CountAt(cell.Position);
    return cell;
}

// Number of a corner of a base cell. at: 0 or 1 along u and v.
uint CornerOfBaseCell(uint index, uint2 at)
{
    uint4 slice = _Poses[s_pose].Slice;
    uint inSlice = index - slice.w;
    at += uint2(inSlice % slice.z, inSlice / slice.z);
    return _Poses[s_pose].FirstCorner + at.x + at.y * (slice.z + 1);
}

#endif
