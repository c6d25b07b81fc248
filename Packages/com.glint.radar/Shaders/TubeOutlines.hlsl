#ifndef GLINT_TUBE_OUTLINES
#define GLINT_TUBE_OUTLINES

#include "Sums.hlsl"
#include "CellCorners.hlsl"
#include "OutlineLists.hlsl"

// Follows the rays beside outlines, and notes how strongly answers what the rays through the corners of the cell have not met:
// thin parts of patches, and strips that a second bounce meets at grazing incidence, beside the line where patches meet. Beside
// the border of a shadow: what a receiver does not see, or nothing else. One thread a ray.

// Distance of a ray from the outline beside which it looks, on the side of the patch: in sides of the cell, and in places on
// the grid, which are rounded.
static const float BESIDE = 1.0 / 1024.0, ROUNDED_BESIDE = 1.0e-6;

// Start and end of an outline, and a place on the side of the patch.
struct Outline
{
    float2 Start, End, Inside;
};

Outline LoadOutline(uint side)
{
    Outline outline;
    outline.Start = PlaceOnGrid(_Sides[SIDE_ROWS * side].xyz);
    outline.End = PlaceOnGrid(_Sides[SIDE_ROWS * side + 1].xyz);
    outline.Inside = PlaceOnGrid(_Sides[SIDE_ROWS * side + 2].xyz);
    return outline;
}

// The border of a shadow, which lies to its left. The corners have met one side of it at most, if the other is smaller than the
// cell: a ray looks at each.
Outline LoadShadow(uint ray)
{
    float4 border = ShadowOf(ray & ~(SHADOW_RAY | LIT_RAY));
    float2 step = border.zw - border.xy, left = float2(-step.y, step.x);
    Outline outline;
    outline.Start = border.xy;
    outline.End = border.zw;
    outline.Inside = border.xy + ((ray & LIT_RAY) == 0 ? left : -left);
    return outline;
}

float2 PlaceBeside(Cell cell, Outline outline, out float2 along)
{
    float2 a = outline.Start, b = outline.End;
    along = (b - a) / max(length(b - a), 1.0e-9);
    float2 place = lerp(a, b, MiddleWithin(cell, a, b)), across = float2(-along.y, along.x);
    float offset = BESIDE * SideOfCell(cell) + ROUNDED_BESIDE * max(place.x, place.y);
    return place + (dot(across, outline.Inside - a) < 0.0 ? -offset : offset) * across;
}

// Whether a ray through a corner of a cell has met the same, up to the last hit.
bool IsMet(CellCorners corners, TubePath tube)
{
    bool isMet = false;
    for (uint i = 0; i < 4; i++)
        if (corners.Bounces[i] >= tube.Path.Bounces)
            isMet = isMet || _Corners[corners.Elements[i] + tube.Path.Bounces - 1].Signature == tube.Signature;
    return isMet;
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= min(_Sums[TUBE_OUTLINES], _ListCapacity.x))
        return;
    uint2 ray = _Outlines[index];
    uint centre = CENTRE_WORDS * ray.x;
    bool isShadow = (ray.y & SHADOW_RAY) != 0;
    Cell cell = LoadCell(_Centres[centre]);
    CellCorners corners = LoadCorners(cell);
    Outline outline;
    if (isShadow)
        outline = LoadShadow(ray.y);
    else
        outline = LoadOutline(ray.y);
    float2 along;
    TubePath tube = BeginTube(PlaceBeside(cell, outline, along));
    SurfacePoint at;
    AddTo(CountWord(POSE_RAYS), 1);
    [loop]
    while (AdvanceTube(tube, at))
    {
        uint receivers = ReceiversOf(tube, at);
        Sign(tube, receivers);
        // A phase is slow where it thins nothing.
        bool isMet = IsMet(corners, tube),
            isSlow = !isShadow && Thinning(SlopeAlong(tube, receivers, along), SideOfCell(cell)) == 1.0;
        if (!isMet || isSlow)
        {
            // What is missing in a shadow is as strong as if it were seen.
            uint seen = isShadow && receivers == 0 ? ReceiversFaced(tube, at, SideOfCell(cell)) : receivers;
            float strength = StrengthAt(tube, at, seen) * WeightAt(tube, at, seen);
            if (!isMet)
                InterlockedMax(_Centres[centre + 1], asuint(strength));
            if (isSlow)
                InterlockedMax(_Centres[centre + 2], asuint(strength));
        }
        // Later bounces are the same on both sides of a shadow's border.
        if (isShadow || !ScatterTube(tube, at))
            break;
    }
}

#endif
