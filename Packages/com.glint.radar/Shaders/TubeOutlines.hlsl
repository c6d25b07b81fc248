#ifndef GLINT_TUBE_OUTLINES
#define GLINT_TUBE_OUTLINES

#include "Sums.hlsl"
#include "CellCorners.hlsl"
#include "OutlineLists.hlsl"

// Follows the rays beside outlines, and notes how strongly answers what the rays through the corners of the cell have not met:
// thin parts of patches, and strips that a second bounce meets at grazing incidence, beside the line where patches meet. One
// thread a ray.

// Distance of a ray from the outline beside which it looks, on the side of the patch: in sides of the cell, and in places on
// the grid, which are rounded.
static const float BESIDE = 1.0 / 1024.0, ROUNDED_BESIDE = 1.0e-6;

float2 PlaceBeside(Cell cell, uint side, out float2 along)
{
    float2 a = PlaceOnGrid(_Sides[SIDE_ROWS * side].xyz), b = PlaceOnGrid(_Sides[SIDE_ROWS * side + 1].xyz),
        inside = PlaceOnGrid(_Sides[SIDE_ROWS * side + 2].xyz);
    along = (b - a) / max(length(b - a), 1.0e-9);
    float2 place = lerp(a, b, MiddleWithin(cell, a, b)), across = float2(-along.y, along.x);
    float offset = BESIDE * SideOfCell(cell) + ROUNDED_BESIDE * max(place.x, place.y);
    return place + (dot(across, inside - a) < 0.0 ? -offset : offset) * across;
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
    Cell cell = LoadCell(_Centres[centre]);
    CellCorners corners = LoadCorners(cell);
    float2 along;
    TubePath tube = BeginTube(PlaceBeside(cell, ray.y, along));
    SurfacePoint at;
    AddTo(CountWord(POSE_RAYS), 1);
    [loop]
    while (AdvanceTube(tube, at))
    {
        uint receivers = ReceiversOf(tube, at);
        Sign(tube, receivers);
        // A phase is slow where it thins nothing.
        bool isMet = IsMet(corners, tube), isSlow = Thinning(SlopeAlong(tube, receivers, along), SideOfCell(cell)) == 1.0;
        if (!isMet || isSlow)
        {
            float strength = StrengthAt(tube, at, receivers) * WeightAt(tube, at, receivers);
            if (!isMet)
                InterlockedMax(_Centres[centre + 1], asuint(strength));
            if (isSlow)
                InterlockedMax(_Centres[centre + 2], asuint(strength));
        }
        if (!ScatterTube(tube, at))
            break;
    }
}

#endif
