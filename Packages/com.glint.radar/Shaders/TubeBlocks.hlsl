#ifndef GLINT_TUBE_BLOCKS
#define GLINT_TUBE_BLOCKS

#include "TubeSquares.hlsl"
#include "TubeSlices.hlsl"

// The cells of a round, and the corners that they share: base cells those of a slice of the grid, cells of later rounds
// those of the four into which a cell was divided.

uint CornerCount()
{
    return _Round == 0 ? _BaseCounts.y : CellCount() / BLOCK_CELLS * NEW_CORNERS;
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
        return CornerOfBaseCell(index, at);
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
