#ifndef GLINT_TUBE_BISECT
#define GLINT_TUBE_BISECT

#include "Sums.hlsl"
#ifdef GLINT_AMPLITUDE
#include "AmplitudePath.hlsl"
#else
#include "CellCorners.hlsl"
#endif

// Finds where borders cross the sides of their cells. One thread a side.

// Signatures of the paths on both sides of a border, up to a bounce.
struct BothSides
{
    uint Bounces;
    uint Before, After;
};

BothSides WholePaths(Border border)
{
    BothSides sides;
    sides.Bounces = _MaxBounces;
    sides.Before = border.SignatureBefore;
    sides.After = border.SignatureAfter;
    return sides;
}

#ifdef GLINT_AMPLITUDE
BothSides PartingPaths(Cell cell, Border border, uint which)
{
    return WholePaths(border);
}
#else
void AddRays(uint rays)
{
    AddTo(CountWord(POSE_BORDER_RAYS), rays);
}

// Up to the bounce at which the paths through the ends of a side part.
BothSides PartingPaths(Cell cell, Border border, uint which)
{
    uint first = which == 0 ? border.Sides.x : border.Sides.y, second = (first + 1) & 3;
    BothSides sides;
    sides.Bounces = 0;
    [loop]
    do
    {
        sides.Bounces++;
        sides.Before = SignatureUpTo(cell, which == 0 ? first : second, sides.Bounces);
        sides.After = SignatureUpTo(cell, which == 0 ? second : first, sides.Bounces);
    } while (sides.Bounces < _MaxBounces && sides.Before == sides.After);
    return sides;
}
#endif

// Bisections whose rays are followed to the end, to find what else is there; those of the others to where the paths on both
// sides part.
static const uint WHOLE_PATHS = 3;

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread), which = index & 1;
    if (index >= 2 * CountOfList(TUBE_BORDERS, _ListCapacity.z))
        return;
    uint listed = ElementOfList(TUBE_BORDERS, index / 2, 1, _ListCapacity.z);
    Cell cell = LoadBorder(listed);
    Border border = BorderOf(cell);
    uint crossing = which == 0 ? cell.Crossings.x : cell.Crossings.y, end = BisectionsOf(cell), rays = 0;
    float side = SideOfCell(cell);
    BothSides sides = WholePaths(border), parting = PartingPaths(cell, border, which);
    [loop]
    for (uint step = _BisectSteps.x; step < min(end, _BisectSteps.y); step++)
    {
        if (!border.IsCut || (crossing & NO_CROSSING) != 0)
            break;
        float fraction = (crossing + 0.5) * asfloat((127 - step) << 23);
        if (step >= WHOLE_PATHS)
            sides = parting;
        uint signature = SignatureAt(CentreOfCell(cell) + PlaceOnSide(border, which, fraction, side), cell, sides.Bounces);
        rays++;
        if (signature == sides.Before)
            crossing = 2 * crossing + 1;
        else if (signature == sides.After)
            crossing = 2 * crossing;
        else
            crossing |= NO_CROSSING;
    }
    if (which == 0)
        _Borders[listed].Crossings.x = crossing;
    else
        _Borders[listed].Crossings.y = crossing;
    if (rays > 0)
        AddRays(rays);
}

#endif
