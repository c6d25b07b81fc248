#ifndef GLINT_TUBE_BLOCKS
#define GLINT_TUBE_BLOCKS

#include "TubeSquares.hlsl"

// The cells of a round, and the corners that they share: base cells those of a slice of the grid, cells of later rounds
// those of the four into which a cell was divided.

// Base cells of this dispatch: across, and rows.
uint2 SliceSize()
{
    return uint2(_Grid.w, _Grid.z / _Grid.w);
}

uint2 SliceStart()
{
    return uint2(_Grid.y % _Grid.x, _Grid.y / _Grid.x);
}

uint2 CellsOfGrid()
{
    return uint2(_Grid.x, FirstCoverWord() / _Grid.x);
}

uint CellCount()
{
    return _Round == 0 ? _Grid.z : min(_Sums[TUBE_CELLS], _ListCapacity.y);
}

uint CornerCount()
{
    uint2 size = SliceSize() + 1;
    return _Round == 0 ? size.x * size.y : CellCount() / BLOCK_CELLS * BLOCK_CORNERS;
}

// Position of a base cell of this dispatch.
uint2 BaseCellOf(uint index)
{
    return SliceStart() + uint2(index % _Grid.w, index / _Grid.w);
}

Cell LoadCell(uint index)
{
    if (_Round > 0)
        return _TubeCells[index];
    Cell cell = (Cell)0;
    cell.Position = BaseCellOf(index);
    return cell;
}

// Number of a corner of a cell, in their order around it.
uint CornerOfCell(uint index, uint corner)
{
    uint2 at = uint2(CornerOf(corner) > 0.0);
    if (_Round == 0)
        return index % _Grid.w + at.x + (index / _Grid.w + at.y) * (_Grid.w + 1);
    at += uint2(index & 1, index >> 1 & 1);
    return index / BLOCK_CELLS * BLOCK_CORNERS + at.x + 3 * at.y;
}

// Whether a corner of a patch is seen in the cell or within half its side: between rays it may reach into it.
bool HasVertex(Cell cell)
{
    if (cell.Level >= _MaxLevel)
        return false;
    float side = SideOfCell(cell);
    float2 centre = CentreOfCell(cell);
    uint2 base = cell.Position >> cell.Level;
    uint link = _Marks[base.x + base.y * _Grid.x];
    bool isNear = false;
    [loop]
    for (uint read = 0; read < MAX_VERTICES && link != 0 && !isNear; read++)
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
    uint bit = cell.x / COVER_SIDE + cell.y / COVER_SIDE * _Blocks.x;
    return _Marks[_MarkWords - 1] != 0 || (_Marks[FirstCoverWord() + (bit >> 5)] >> (bit & 31) & 1) != 0;
}

// Whether no triangle can be seen in the cell.
bool IsEmpty(Cell cell)
{
    if (_Round > 0)
        return false;
    return !IsCovered(cell.Position);
}

// Whether the cell is to be traced.
bool IsToTrace(Cell cell)
{
    if (IsEmpty(cell))
        return false;
    return !HasVertex(cell);
}

#endif
