#ifndef GLINT_TUBE_DIVISIONS
#define GLINT_TUBE_DIVISIONS

#include "TubeShapes.hlsl"

// Divides a cell into four of the next round.
void Divide(Cell cell)
{
    uint first = AddToList(TUBE_NEXT_CELLS, IsDeep(cell), BLOCK_CELLS, _ListCapacity.y);
    if (first == _ListCapacity.y)
        return;
    for (uint i = 0; i < BLOCK_CELLS; i++)
    {
        Cell part = (Cell)0;
        part.Position = 2 * cell.Position + uint2(i & 1, i >> 1);
        part.Level = cell.Level + 1;
        part.FirstBounce = cell.FirstBounce;
        part.Pose = cell.Pose;
        part.Whole = cell.Number;
        part.Traits = cell.Traits & (DEEP_CELL | EDGE_CELL);
        _NextCells[first + i] = part;
    }
}

// Divides a cell that its corners do not tell, or lists it: if a border cuts it in two, or if it is small.
void AddBorder(Cell cell)
{
    if (BorderOf(cell).IsCut)
    {
        ListBorder(cell);
        return;
    }
    if (CanDivide(cell))
    {
        Divide(cell);
        return;
    }
    uint border = AddToList(TUBE_WHOLES, IsDeep(cell), 1, _ListCapacity.z);
    if (border < _ListCapacity.z)
        _Borders[_ListCapacity.z + border] = cell;
}

#endif
