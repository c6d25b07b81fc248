#ifndef GLINT_TUBE_CELLS
#define GLINT_TUBE_CELLS

#include "Sums.hlsl"
#include "TubeOutlines.hlsl"

// Sums the cells whose corners see the same, as one tube each, and lists the others as borders. One thread a cell, which
// follows the ray through its centre.

// Adds what the ray through a corner has met.
void AddCorner(inout Bounce bounce, Corner corner, float2 fromCentre)
{
    float4 position = 0.25 * corner.Position;
    float2 sides = fromCentre > 0.0 ? 1.0 : -1.0;
    bounce.AlongU += fromCentre.x * corner.AlongU;
    bounce.AlongV += fromCentre.y * corner.AlongV;
    bounce.Mean += position;
    bounce.SlopeU += sides.x * position;
    bounce.SlopeV += sides.y * position;
    bounce.Twist += sides.x * sides.y * position;
    bounce.Strength += 0.25 * corner.Strength.x * float4(1.0, sides, sides.x * sides.y);
}

// What the rays through the corners have met at a bounce, if it is the same. corners: their elements at it.
Bounce BounceOf(uint4 corners, float side)
{
    Bounce bounce = (Bounce)0;
    [unroll]
    for (uint i = 0; i < 4; i++)
        AddCorner(bounce, _Corners[corners[i]], side * CornerOf(i));
    return bounce;
}

// Bounces at which the rays through the corners have met the same. corners: their elements; bounces: theirs.
uint CommonBounces(uint4 corners, uint4 bounces)
{
    uint common = 0, end = min(min(bounces.x, bounces.y), min(bounces.z, bounces.w));
    [loop]
    for (uint bounce = 0; bounce < end && common == bounce; bounce++)
    {
        uint signature = _Corners[corners.x + bounce].Signature;
        bool isSame = true;
        for (uint i = 1; i < 4; i++)
            isSame = isSame && _Corners[corners[i] + bounce].Signature == signature;
        common += isSame ? 1 : 0;
    }
    return common;
}

// Largest strength of the corners at bounces that are not summed yet (Corner.Strength).
float2 StrengthLeft(uint4 corners, uint4 bounces, uint done)
{
    float2 most = 0.0;
    for (uint i = 0; i < 4; i++)
        for (uint bounce = done; bounce < bounces[i]; bounce++)
            most = max(most, _Corners[corners[i] + bounce].Strength);
    return most;
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= CellCount())
        return;
    Cell cell = LoadCell(index);
    if (IsEmpty(cell))
        return;
    if (HasVertex(cell))
    {
        cell.Strength = MISS;
        cell.Bent = MISS;
        AddBorder(cell);
        return;
    }
    uint4 corners = 0, bounces = 0, first = NO_SIGNATURE;
    bool areSame = true;
    [unroll]
    for (uint i = 0; i < 4; i++)
    {
        corners[i] = CornerOfCell(index, i) * _MaxBounces;
        bounces[i] = _Corners[corners[i]].Bounces;
        cell.Signatures[i] = NO_SIGNATURE;
        if (bounces[i] > 0)
        {
            first[i] = _Corners[corners[i]].Signature;
            cell.Signatures[i] = _Corners[corners[i] + bounces[i] - 1].Signature;
        }
        areSame = areSame && cell.Signatures[i] == cell.Signatures[0];
    }
    float thin = 0.0;
    if (cell.FirstBounce == 0 && cell.Level < _MaxLevel)
        thin = StrengthOfThinParts(cell, first);
    if (thin > 0.0)
    {
        cell.Strength = max(thin, StrengthLeft(corners, bounces, 0).x);
        cell.Bent = MISS;
        AddBorder(cell);
        return;
    }
    uint common = CommonBounces(corners, bounces), done = cell.FirstBounce;
    float2 left = 0.0;
    if (common > cell.FirstBounce)
    {
        float side = SideOfCell(cell);
        TubePath tube = BeginTube(CentreOfCell(cell));
        SurfacePoint at;
        [loop]
        while (AdvanceTube(tube, at))
        {
            uint bounce = tube.Path.Bounces - 1, receivers = ReceiversOf(tube, at);
            Sign(tube, receivers);
            float strength = StrengthAt(tube, at, receivers);
            bool goesOn = bounce < common && _Corners[corners.x + min(bounce, common - 1)].Signature == tube.Signature;
            areSame = areSame && goesOn;
            if (goesOn && bounce >= cell.FirstBounce)
            {
                Bounce met = BounceOf(corners + bounce, side);
                goesOn = AddSquare(met, tube, at, receivers, strength, side, cell.Level < _MaxLevel);
                done = goesOn ? bounce + 1 : done;
            }
            if (!goesOn)
            {
                left = strength * float2(1.0, BentErrorAt(tube, at, ReceiverFrom(0, tube.Path.Ray.Origin), side));
                break;
            }
            if (!ScatterTube(tube, at))
                break;
        }
        areSame = areSame && tube.Path.Bounces >= common;
        AddTo(CountWord(POSE_RAYS), 1);
    }
    if (areSame && done >= common)
        return;
    left = max(left, StrengthLeft(corners, bounces, done));
    cell.FirstBounce = done;
    cell.Strength = left.x;
    cell.Bent = done < common ? MISS : left.y;
    AddBorder(cell);
}

#endif
