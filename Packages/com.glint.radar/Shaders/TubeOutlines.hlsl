#ifndef GLINT_TUBE_OUTLINES
#define GLINT_TUBE_OUTLINES

#include "TubeBlocks.hlsl"

// Thin parts of patches, which pass between the rays through the corners of a cell: the outlines of the patches tell where
// they are.

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

// Distance of a ray from the outline beside which it looks, on the side of the patch: in sides of the cell, and in places on
// the grid, which are rounded.
static const float BESIDE = 1.0 / 256.0, ROUNDED_BESIDE = 1.0e-6;

// Strength of what a ray beside an outline meets first, if that is not what a ray through a corner of the cell meets; 0 if it
// is. met: what those rays have met first.
float StrengthBeside(Cell cell, uint4 met, uint number)
{
    // Of what all receivers see no ray is needed.
    TubePath path = (TubePath)0;
    path.Signature = NO_SIGNATURE;
    Sign(path, asuint(_Sides[SIDE_ROWS * number].w));
    Sign(path, (1u << _ReceiverCount) - 1);
    if (any(met == path.Signature))
        return 0.0;
    float2 a = PlaceOnGrid(_Sides[SIDE_ROWS * number].xyz), b = PlaceOnGrid(_Sides[SIDE_ROWS * number + 1].xyz),
        inside = PlaceOnGrid(_Sides[SIDE_ROWS * number + 2].xyz);
    float middle = MiddleWithin(cell, a, b), size = length(b - a);
    if (middle < 0.0)
        return 0.0;
    float2 place = lerp(a, b, middle), across = float2(a.y - b.y, b.x - a.x) / max(size, 1.0e-9);
    float offset = BESIDE * SideOfCell(cell) + ROUNDED_BESIDE * max(place.x, place.y);
    TubePath tube = BeginTube(place + (dot(across, inside - a) < 0.0 ? -offset : offset) * across);
    SurfacePoint at;
    AddTo(CountWord(POSE_RAYS), 1);
    if (!AdvanceTube(tube, at))
        return 0.0;
    uint receivers = ReceiversOf(tube, at);
    Sign(tube, receivers);
    return any(met == tube.Signature) ? 0.0 : StrengthAt(tube, at, receivers);
}

// Whether more sides run through a cell than rays can look beside. Lists have no order: a part of one would differ from run
// to run.
bool HasManySides(Cell cell, uint first)
{
    uint listed = 0, through = 0;
    [loop]
    for (uint link = first; link != 0 && listed < MAX_LISTED_SIDES; listed++)
    {
        uint4 side = _Links[link - 1];
        float2 a = PlaceOnGrid(_Sides[SIDE_ROWS * side.x].xyz), b = PlaceOnGrid(_Sides[SIDE_ROWS * side.x + 1].xyz);
        through += MiddleWithin(cell, a, b) < 0.0 ? 0 : 1;
        link = side.z;
    }
    return through > MAX_SIDES || listed == MAX_LISTED_SIDES;
}

// Largest strength of what outlines through a cell show that the rays through its corners have not met first; MISS: unknown.
float StrengthOfThinParts(Cell cell, uint4 met)
{
    uint2 base = cell.Position >> cell.Level;
    uint first = _Marks[OutlineWord(base)];
    if (first == 0 || !HasAllSides())
        return 0.0;
    if (HasManySides(cell, first))
        return MISS;
    float strength = 0.0;
    [loop]
    for (uint link = first; link != 0;)
    {
        uint4 side = _Links[link - 1];
        strength = max(strength, StrengthBeside(cell, met, side.x));
        link = side.z;
    }
    return strength;
}

#endif
