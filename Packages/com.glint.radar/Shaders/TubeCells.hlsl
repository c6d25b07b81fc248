#ifndef GLINT_TUBE_CELLS
#define GLINT_TUBE_CELLS

#include "CellCorners.hlsl"
#include "TubeDivisions.hlsl"
#include "OutlineLists.hlsl"
#include "RevealedCells.hlsl"

// Sorts the cells of a round by what their corners see: lists those whose centre is to be traced, and rays beside the
// outlines of patches in them; divides or lists the others as borders. One thread a cell, which traces no ray.

// How much more strongly than the corners of a cell may answer what lies between them, at the corner of a patch or beside many
// outlines: cross-polarised as a whole, and with no phase that runs over the cell.
static const float HIDDEN_STRENGTH = 4.0;

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= CellCount())
        return;
    Cell cell = LoadCell(index);
    if (IsEmpty(cell))
        return;
    CellCorners corners = LoadCorners(cell);
    uint rays = 0;
    if (HasVertex(cell))
        rays = TOO_MANY_RAYS;
    else if (cell.FirstBounce < 2 && cell.Level < MaxLevel())
        rays = CountOutlineRays(cell);
    if (rays == TOO_MANY_RAYS)
    {
        float strength = LeftAt(corners, cell).Unweighted;
        cell.Thinned = strength > 0.0 ? HIDDEN_STRENGTH * _Poses[s_pose].CrossWeight * strength : MISS;
        cell.Traits |= UnitsOfPart(1.0) << THIN_PART_SHIFT;
        SetBent(cell, MISS);
        AddBorder(cell);
        return;
    }
    if (rays > 0 || corners.Common > cell.FirstBounce)
    {
        uint centre = AddToList(TUBE_CENTRES, IsDeep(cell), 1, _ListCapacity.w);
        _Centres[CENTRE_WORDS * centre] = index;
        for (uint word = 1; word < CENTRE_WORDS; word++)
            _Centres[CENTRE_WORDS * centre + word] = 0;
        if (rays > 0)
            ListOutlineRays(cell, centre, rays);
        return;
    }
    bool isRevealed = IsRevealed(cell);
    if (corners.AreSame && !isRevealed)
        return;
    CurrentsLeft left = LeftAt(corners, cell);
    cell.Strength = left.Strength;
    cell.Thinned = isRevealed ? MISS : left.Thinned;
    SetBent(cell, isRevealed ? MISS : left.Bent);
    AddBorder(cell);
}

#endif
