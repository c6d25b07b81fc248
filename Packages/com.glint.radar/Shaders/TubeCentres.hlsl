#ifndef GLINT_TUBE_CENTRES
#define GLINT_TUBE_CENTRES

#include "Sums.hlsl"
#include "CellCorners.hlsl"
#include "TubeDivisions.hlsl"

// Sums the cells whose corners see the same, as one tube each bounce, and divides or lists the others as borders. One thread
// a cell, which follows the ray through its centre.

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

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = CountingThread(group, thread);
    if (index >= CountOfList(TUBE_CENTRES, _ListCapacity.w))
        return;
    uint centre = ElementOfList(TUBE_CENTRES, index, 1, _ListCapacity.w);
    Cell cell = LoadCell(_Centres[2 * centre]);
    CellCorners corners = LoadCorners(cell);
    float thin = asfloat(_Centres[2 * centre + 1]);
    uint common = thin > 0.0 ? 0 : corners.Common;
    float2 left = thin;
    if (common > cell.FirstBounce)
    {
        uint firstBounce = cell.FirstBounce;
        float side = SideOfCell(cell);
        bool canDivide = cell.Level < MaxLevel();
        TubePath tube = BeginTube(CentreOfCell(cell));
        SurfacePoint at;
        [loop]
        while (AdvanceTube(tube, at))
        {
            uint bounce = tube.Path.Bounces - 1, receivers = ReceiversOf(tube, at);
            Sign(tube, receivers);
            float strength = StrengthAt(tube, at, receivers);
            bool goesOn = bounce < common
                && _Corners[corners.Elements.x + min(bounce, common - 1)].Signature == tube.Signature;
            corners.AreSame = corners.AreSame && goesOn;
            if (goesOn && bounce >= firstBounce)
            {
                Bounce met = BounceOf(corners.Elements + bounce, side);
                goesOn = AddSquare(met, tube, at, receivers, strength, side, canDivide);
                cell.FirstBounce = goesOn ? bounce + 1 : cell.FirstBounce;
            }
            if (!goesOn)
            {
                left = strength * float2(1.0, BentErrorAt(tube, at, ReceiverFrom(0, tube.Path.Ray.Origin), side));
                break;
            }
            if (!ScatterTube(tube, at))
                break;
        }
        corners.AreSame = corners.AreSame && tube.Path.Bounces >= common;
        AddTo(CountWord(POSE_RAYS), 1);
    }
    if (thin == 0.0 && corners.AreSame && cell.FirstBounce >= common)
        return;
    left = max(left, StrengthLeft(corners, cell));
    cell.Strength = left.x;
    cell.Bent = thin > 0.0 || cell.FirstBounce < common ? MISS : left.y;
    AddBorder(cell);
}

#endif
