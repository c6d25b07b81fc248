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

// Start and end of a line. link: its first element in _Links.
float4 LineOf(uint link)
{
    return asfloat(uint4(_Links[link].xy, _Links[link + 1].xy));
}

// None has one if the list of lines is full.
bool HasLine(Cell cell, uint link)
{
    if (!HasAllLines())
        return false;
    float4 ends = LineOf(link);
    return MiddleWithin(cell, ends.xy, ends.zw) >= 0.0;
}

// Whether rays are to look beside an element of a list in a cell. Images matter until the second bounce is summed.
bool IsToLook(Cell cell, uint link)
{
    uint4 element = _Links[link];
    bool isImage = element.w == IMAGE_LINE, isWithin = false;
    if (cell.FirstBounce > (isImage ? 1u : 0u))
        return false;
    if (element.w == 0)
        isWithin = RunsThrough(cell, element.x);
    else
        isWithin = HasLine(cell, link);
    return isWithin;
}

// Rays that are to look beside the outlines in a cell, one for each, and on both sides of shadows, or TOO_MANY_RAYS. Lists have
// no order: a part of one would differ from run to run.
uint CountOutlineRays(Cell cell)
{
    uint link = _Marks[OutlineWord(cell.Position >> cell.Level)], listed = 0, rays = 0, shadows = 0, images = 0;
    if (link == 0 || !HasAllSides())
        return 0;
    [loop]
    for (; link != 0 && listed < MAX_LISTED; listed++)
    {
        uint kind = _Links[link - 1].w, toLook = IsToLook(cell, link - 1) ? 1 : 0;
        rays += kind == 0 ? toLook : 0;
        shadows += kind == SHADOW_LINE ? toLook : 0;
        images += kind == IMAGE_LINE ? toLook : 0;
        link = _Links[link - 1].z;
    }
    bool isTooMany = rays > MAX_SIDES || shadows > MAX_SHADOWS || images > MAX_IMAGES || listed == MAX_LISTED;
    return isTooMany ? TOO_MANY_RAYS : rays + 2 * shadows + images;
}

void ListRay(inout uint ray, uint centre, uint beside)
{
    if (ray < _ListCapacity.x)
        _Outlines[ray] = uint2(centre, beside);
    ray++;
}

// Lists these rays. centre: of the cell in _Centres.
void ListOutlineRays(Cell cell, uint centre, uint rays)
{
    uint ray;
    InterlockedAdd(_Sums[TUBE_OUTLINES], rays, ray);
    [loop]
    for (uint link = _Marks[OutlineWord(cell.Position >> cell.Level)]; link != 0;)
    {
        uint4 element = _Links[link - 1];
        if (IsToLook(cell, link - 1))
        {
            uint lineRay = link - 1 | (element.w == IMAGE_LINE ? IMAGE_RAY : SHADOW_RAY);
            ListRay(ray, centre, element.w == 0 ? element.x : lineRay);
            if (element.w == SHADOW_LINE)
                ListRay(ray, centre, lineRay | LIT_RAY);
        }
        link = element.z;
    }
}

#endif
