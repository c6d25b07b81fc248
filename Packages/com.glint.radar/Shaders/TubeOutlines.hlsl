#ifndef GLINT_TUBE_OUTLINES
#define GLINT_TUBE_OUTLINES

#include "Sums.hlsl"
#include "CellCorners.hlsl"
#include "OutlineLists.hlsl"

// Follows the rays beside outlines, and notes how strongly answers what the rays through the corners of the cell have not met:
// thin parts of patches, and strips that a second bounce meets at grazing incidence, beside the line where patches meet. Beside
// the border of a shadow: what a receiver does not see, or nothing else. Beside the image of an outline: what the second bounce
// and later ones meet. One thread a ray.

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

// A line on the grid, with the patch or the shadow to its left. Of the border of a shadow the corners have met one side at most,
// if the other is smaller than the cell: a ray looks at each.
Outline LoadLine(uint ray)
{
    float4 ends = LineOf(ray & ~(SHADOW_RAY | LIT_RAY | IMAGE_RAY));
    float2 step = ends.zw - ends.xy, left = float2(-step.y, step.x);
    Outline outline;
    outline.Start = ends.xy;
    outline.End = ends.zw;
    outline.Inside = ends.xy + ((ray & LIT_RAY) == 0 ? left : -left);
    return outline;
}

// Where the ray looks; along: unit vector.
float2 PlaceBeside(Cell cell, Outline outline, out float2 along)
{
    float2 a = outline.Start, b = outline.End;
    along = (b - a) / max(length(b - a), 1.0e-9);
    return BesideLine(lerp(a, b, MiddleWithin(cell, a, b)), a, b, outline.Inside, SideOfCell(cell));
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
    bool isShadow = (ray.y & SHADOW_RAY) != 0, isImage = (ray.y & IMAGE_RAY) != 0;
    Cell cell = LoadCell(_Centres[centre]);
    CellCorners corners = LoadCorners(cell);
    Outline outline;
    if (isShadow || isImage)
        outline = LoadLine(ray.y);
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
        // The first bounce of an image is that off the mirror.
        if ((!isMet || isSlow) && tube.Path.Bounces > (isImage ? 1u : 0u))
        {
            // What is missing in a shadow is as strong as if it were seen.
            uint seen = isShadow && receivers == 0 ? ReceiversFaced(tube, at, SideOfCell(cell), false) : receivers;
            float crossPart = WeighedPartAt(tube, at, seen), strength = StrengthAt(tube, at, seen) * WeightOf(crossPart);
            if (!isMet)
            {
                InterlockedMax(_Centres[centre + (isImage ? 3 : 1)], asuint(strength));
                InterlockedMax(_Centres[centre + 4], UnitsOfPart(crossPart));
            }
            if (isSlow)
            {
                strength *= ThinningAlongEdge(SteepnessAt(tube, receivers), SideOfCell(cell));
                InterlockedMax(_Centres[centre + 2], asuint(strength));
            }
        }
        // Later bounces are the same on both sides of a shadow's border.
        if (isShadow || !ScatterTube(tube, at))
            break;
    }
}

#endif
