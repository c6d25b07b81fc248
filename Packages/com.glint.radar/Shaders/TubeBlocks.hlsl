#ifndef GLINT_TUBE_BLOCKS
#define GLINT_TUBE_BLOCKS

#include "TubeSquares.hlsl"

// The cells of a round, and the corners that they share: base cells those of a slice of the grid, cells of later rounds
// those of the four into which a cell was divided.

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

uint CornerCount()
{
    return _Round == 0 ? _BaseCounts.y : CellCount() / BLOCK_CELLS * BLOCK_CORNERS;
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

// A cell of the round, whose pose becomes that of the thread.
Cell LoadCell(uint index)
{
    if (_Round == 0)
        return LoadBaseCell(index);
    Cell cell = _TubeCells[ElementOfList(TUBE_CELLS, index, BLOCK_CELLS, _ListCapacity.y)];
    cell.Number = index;
    s_pose = cell.Pose;
    CountAt(cell.Position >> cell.Level);
    return cell;
}

// Number of a corner of a cell that was divided. at: 0 to 2 along u and v.
uint CornerOfBlock(uint block, uint2 at)
{
    return BLOCK_CORNERS * block + at.x + 3 * at.y;
}

// Number of a corner of a cell of a round. at: 0 or 1 along u and v.
uint CornerOfCell(uint index, uint2 at, uint round)
{
    if (round == 0)
    {
        uint4 slice = _Poses[s_pose].Slice;
        uint inSlice = index - slice.w;
        at += uint2(inSlice % slice.z, inSlice / slice.z);
        return _Poses[s_pose].FirstCorner + at.x + at.y * (slice.z + 1);
    }
    at += uint2(index & 1, index >> 1 & 1);
    return CornerOfBlock(index / BLOCK_CELLS, at);
}

// Whether a corner of a patch is seen in the cell or within half its side: between rays it may reach into it.
bool HasVertex(Cell cell)
{
    if (cell.Level >= MaxLevel())
        return false;
    float side = SideOfCell(cell);
    float2 centre = CentreOfCell(cell);
    uint2 base = cell.Position >> cell.Level;
    uint link = _Marks[VertexWord(base)];
    bool isNear = false;
    [loop]
    for (uint read = 0; read < MAX_LISTED && link != 0 && !isNear; read++)
    {
        uint4 vertex = _Links[link - 1];
        isNear = all(abs(asfloat(vertex.xy) - centre) <= side);
        link = vertex.z;
    }
    // A longer list is not read: its corners may be anywhere.
    return isNear || link != 0;
}

// Whether a triangle may be seen in the base cell.
bool IsCovered(uint2 cell)
{
    uint bit = cell.x / COVER_SIDE + cell.y / COVER_SIDE * _Poses[s_pose].Blocks.x;
    return _Marks[AllCoveredWord()] != 0 || (_Marks[CoverWord(bit)] >> (bit & 31) & 1) != 0;
}

// Whether no triangle can be seen in the cell.
bool IsEmpty(Cell cell)
{
    if (_Round > 0)
        return false;
    return !IsCovered(cell.Position);
}

#endif
