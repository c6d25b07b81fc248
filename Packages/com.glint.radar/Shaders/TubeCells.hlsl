#ifndef GLINT_TUBE_CELLS
#define GLINT_TUBE_CELLS

#include "CellCorners.hlsl"
#include "TubeDivisions.hlsl"
#include "OutlineLists.hlsl"

// Sorts the cells of a round by what their corners see: lists those whose centre is to be traced, and rays beside the
// outlines of patches in them; divides or lists the others as borders. One thread a cell, which traces no ray.

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= CellCount())
        return;
    Cell cell = LoadCell(index);
    if (IsEmpty(cell))
        return;
    cell.Strength = MISS;
    cell.Thinned = MISS;
    if (HasVertex(cell))
    {
        SetBent(cell, MISS);
        AddBorder(cell);
        return;
    }
    CellCorners corners = LoadCorners(cell);
    uint rays = 0;
    if (cell.FirstBounce == 0 && cell.Level < MaxLevel())
        rays = CountOutlineRays(cell, corners.First);
    if (rays == TOO_MANY_RAYS)
    {
        SetBent(cell, MISS);
        AddBorder(cell);
        return;
    }
    if (rays > 0 || corners.Common > cell.FirstBounce)
    {
        uint centre = AddToList(TUBE_CENTRES, IsDeep(cell), 1, _ListCapacity.w);
        _Centres[2 * centre] = index;
        _Centres[2 * centre + 1] = 0;
        if (rays > 0)
            ListOutlineRays(cell, corners.First, centre, rays);
        return;
    }
    if (corners.AreSame)
        return;
    cell.Traits |= CHECKED_CELL;
    CurrentsLeft left = LeftAt(corners, cell);
    cell.Strength = left.Strength;
    cell.Thinned = left.Thinned;
    SetBent(cell, left.Bent);
    AddBorder(cell);
}

#endif
