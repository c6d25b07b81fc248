#ifndef GLINT_TUBE_GRID
#define GLINT_TUBE_GRID

#include "PhysicalOptics.hlsl"
#include "TubeShapes.hlsl"

// Who receives what is painted at a hit: a bit each.
uint ReceiversOf(TubePath tube, SurfacePoint at)
{
    uint receivers = 0;
    [loop]
    for (uint index = 0; index < _ReceiverCount; index++)
        if (Radiates(tube, at, ReceiverFrom(index, tube.Path.Ray.Origin)))
            receivers |= 1u << index;
    return receivers;
}

// Whether what is met within a step on the grid, base cells, may face a receiver: a curved patch turns.
bool MayFace(SurfacePoint at, float3 direction, float step)
{
    return dot(at.Normal, direction) + step * (abs(dot(at.NormalU, direction)) + abs(dot(at.NormalV, direction))) > 0.0;
}

// Who would receive what is painted within a step on the grid if nothing were in between. isTurning: a curved surface has
// reflected the ray; then others of the faces that it meets within a step may look at any receiver.
uint ReceiversFaced(TubePath tube, SurfacePoint at, float step, bool isTurning)
{
    uint receivers = 0;
    [loop]
    for (uint index = 0; index < _ReceiverCount; index++)
    {
        Receiver receiver = ReceiverFrom(index, tube.Path.Ray.Origin);
        if (RadiatesInSight(tube, at, receiver)
            || IsSummed(tube, at, receiver) && (isTurning || MayFace(at, receiver.Direction, step)))
            receivers |= 1u << index;
    }
    return receivers;
}

// Second derivatives of the phase at a hit by u, by v and by both, m a base cell squared, from the curvatures of surface and
// wave.
float3 PhaseBends(TubePath tube, SurfacePoint at, Receiver receiver)
{
    float3 d = tube.Path.Ray.Direction;
    float toNormal = dot(at.Normal, d), surface = (1.0 - dot(receiver.Direction, d)) / toNormal;
    float3 bends = surface * float3(dot(at.NormalU, tube.PlaceU), dot(at.NormalV, tube.PlaceV), dot(at.NormalU, tube.PlaceV))
        - float3(dot(tube.DirectionU, tube.PlaceU), dot(tube.DirectionV, tube.PlaceV), dot(tube.DirectionU, tube.PlaceV));
    if (_IsNear == 0)
        return bends;
    // The distance to a receiver at a finite range is bent, and rays of a cone meet the facet at places that are not linear
    // in u and v.
    float2 slope = PhaseSlope(tube, receiver), along = slope + tube.LengthSlope;
    float2 turns = float2(dot(at.Normal, tube.DirectionU), dot(at.Normal, tube.DirectionV)) / toNormal;
    float3 squares = float3(along * along, along.x * along.y)
        - float3(dot(tube.PlaceU, tube.PlaceU), dot(tube.PlaceV, tube.PlaceV), dot(tube.PlaceU, tube.PlaceV));
    return bends + squares / receiver.Distance - float3(2.0 * slope * turns, slope.x * turns.y + slope.y * turns.x);
}

// Relative error of a piece of a cell of a side of one by the bends of its phase, if it is taken as linear.
float BentOf(TubePath tube, SurfacePoint at, Receiver receiver)
{
    float3 bends = PhaseBends(tube, at, receiver);
    return 0.06 * _WaveNumber * (abs(bends.x) + abs(bends.y));
}

// The same of a cell.
float BentErrorAt(TubePath tube, SurfacePoint at, Receiver receiver, float side)
{
    return min(1.0, side * side * BentOf(tube, at, receiver));
}

// Sixteen bits of the signature of the facets that a tube has met.
uint FacetsOf(TubePath tube)
{
    return tube.Facets >> 16;
}

// Signature of a path, that of its patches, which tells facets apart too.
uint FineSignature(uint signature, uint facets)
{
    return signature ^ (facets * 2654435769u);
}

bool IsKinked(Cell cell)
{
    return (cell.Traits & KINKED_CELL) != 0;
}

// Signature of a tube, beside those of a cell.
uint SignatureIn(Cell cell, TubePath tube)
{
    return IsKinked(cell) ? FineSignature(tube.Signature, FacetsOf(tube)) : tube.Signature;
}

// Signature of the ray through a position of the grid up to a bounce, beside those of a cell.
uint SignatureAt(float2 position, Cell cell, uint bounces)
{
    TubePath tube = BeginTube(position);
    SurfacePoint at;
    [loop]
    while (AdvanceTube(tube, at))
    {
        Sign(tube, ReceiversOf(tube, at));
        if (tube.Path.Bounces == bounces || !ScatterTube(tube, at))
            break;
    }
    return SignatureIn(cell, tube);
}

// Distance of a ray from the outline beside which it looks, on the side of the patch: in sides of the cell, and in places on
// the grid, which are rounded.
static const float BESIDE = 1.0 / 1024.0, ROUNDED_BESIDE = 1.0e-6;

// A position beside another one on a line from a to b, towards one inside. side: of the cell.
float2 BesideLine(float2 position, float2 a, float2 b, float2 inside, float side)
{
    float2 along = (b - a) / max(length(b - a), 1.0e-9), across = float2(-along.y, along.x);
    float offset = BESIDE * side + ROUNDED_BESIDE * max(position.x, position.y);
    return position + (dot(across, inside - a) < 0.0 ? -offset : offset) * across;
}

// Makes its pose that of the thread.
Cell LoadBorder(uint index)
{
    Cell cell = _Borders[index];
    s_pose = cell.Pose;
    CountAt(cell.Position >> cell.Level);
    return cell;
}

#endif
