#ifndef GLINT_OUTLINE_LISTS
#define GLINT_OUTLINE_LISTS

#include "TubeBlocks.hlsl"

// Thin parts of patches, which pass between the rays through the corners of a cell: the outlines of the patches tell where
// they are, and rays beside them what is seen there. A part of a cell is looked at again: of a strip whose wide end a corner of
// the cell has met, no corner of the part may meet the narrow one.

// Of more sides through a cell no list is made.
static const uint TOO_MANY_RAYS = 0xffffffff;

// Fraction of a line at which it is halfway through a cell; below 0: it does not run through the cell.
float MiddleWithin(Cell cell, float2 start, float2 end)
{
    float halfSide = 0.5 * SideOfCell(cell);
    float2 step = end - start, from = CentreOfCell(cell) - start;
    step = abs(step) > 1.0e-9 ? step : 1.0e-9;
    float2 a = (from - halfSide) / step, b = (from + halfSide) / step;
    float2 enters = min(a, b), leaves = max(a, b);
    float first = max(0.0, max(enters.x, enters.y)), last = min(1.0, min(leaves.x, leaves.y));
    return first < last ? 0.5 * (first + last) : -1.0;
}

bool RunsThrough(Cell cell, uint side)
{
    float2 a = PlaceOnGrid(_Sides[SIDE_ROWS * side].xyz), b = PlaceOnGrid(_Sides[SIDE_ROWS * side + 1].xyz);
    return MiddleWithin(cell, a, b) >= 0.0;
}

// Start and end of the border of a shadow. link: its first element in _Links.
float4 ShadowOf(uint link)
{
    return asfloat(uint4(_Links[link].xy, _Links[link + 1].xy));
}

// None has one if the list of shadows is full.
bool HasShadow(Cell cell, uint link)
{
    if (!HasAllShadows())
        return false;
    float4 border = ShadowOf(link);
    return MiddleWithin(cell, border.xy, border.zw) >= 0.0;
}

// Rays that are to look beside the outlines in a cell, one for each, and on both sides of shadows, or TOO_MANY_RAYS. Lists have
// no order: a part of one would differ from run to run.
uint CountOutlineRays(Cell cell)
{
    uint link = _Marks[OutlineWord(cell.Position >> cell.Level)], listed = 0, rays = 0, shadows = 0;
    if (link == 0 || !HasAllSides())
        return 0;
    [loop]
    for (; link != 0 && listed < MAX_LISTED; listed++)
    {
        uint4 side = _Links[link - 1];
        if (side.w == 0)
            rays += RunsThrough(cell, side.x) ? 1 : 0;
        else
            shadows += HasShadow(cell, link - 1) ? 1 : 0;
        link = side.z;
    }
    return rays > MAX_SIDES || shadows > MAX_SHADOWS || listed == MAX_LISTED ? TOO_MANY_RAYS : rays + 2 * shadows;
}

// Lists these rays. centre: of the cell in _Centres.
void ListOutlineRays(Cell cell, uint centre, uint rays)
{
    uint ray;
    InterlockedAdd(_Sums[TUBE_OUTLINES], rays, ray);
    [loop]
    for (uint link = _Marks[OutlineWord(cell.Position >> cell.Level)]; link != 0;)
    {
        uint4 side = _Links[link - 1];
        bool isShadow = side.w != 0, isWithin;
        if (isShadow)
            isWithin = HasShadow(cell, link - 1);
        else
            isWithin = RunsThrough(cell, side.x);
        if (isWithin)
        {
            if (ray < _ListCapacity.x)
                _Outlines[ray] = uint2(centre, isShadow ? SHADOW_RAY | link - 1 : side.x);
            ray++;
            if (isShadow && ray < _ListCapacity.x)
                _Outlines[ray] = uint2(centre, SHADOW_RAY | LIT_RAY | link - 1);
            ray += isShadow ? 1 : 0;
        }
        link = side.z;
    }
}

#endif
