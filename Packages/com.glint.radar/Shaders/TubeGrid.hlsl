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

// Who would receive it if nothing were in between.
uint ReceiversFaced(TubePath tube, SurfacePoint at)
{
    uint receivers = 0;
    [loop]
    for (uint index = 0; index < _ReceiverCount; index++)
        if (RadiatesInSight(tube, at, ReceiverFrom(index, tube.Path.Ray.Origin)))
            receivers |= 1u << index;
    return receivers;
}

// Second derivative of the phase by u or v towards a receiver at a finite range, beside that of the wave that arrives, m: the
// distance to the receiver is bent, and rays of a cone meet the facet at places that are not linear in u and v. placeBy, turnBy
// and slope: derivatives of place, direction and phase.
float NearBend(TubePath tube, SurfacePoint at, Receiver receiver, float3 placeBy, float3 turnBy, float slope)
{
    float along = dot(receiver.Direction, placeBy);
    return (along * along - dot(placeBy, placeBy)) / receiver.Distance
        - 2.0 * slope * dot(at.Normal, turnBy) / dot(at.Normal, tube.Path.Ray.Direction);
}

// Relative error of a piece of a cell of a side of one by the curvatures of surface and wave at a hit: its phase is taken as
// linear.
float BentOf(TubePath tube, SurfacePoint at, Receiver receiver)
{
    float3 d = tube.Path.Ray.Direction;
    float surface = (1.0 - dot(receiver.Direction, d)) / dot(at.Normal, d);
    float bendU = surface * dot(at.NormalU, tube.PlaceU) - dot(tube.DirectionU, tube.PlaceU),
        bendV = surface * dot(at.NormalV, tube.PlaceV) - dot(tube.DirectionV, tube.PlaceV);
    if (_IsNear != 0)
    {
        float2 slope = PhaseSlope(tube, receiver);
        bendU += NearBend(tube, at, receiver, tube.PlaceU, tube.DirectionU, slope.x);
        bendV += NearBend(tube, at, receiver, tube.PlaceV, tube.DirectionV, slope.y);
    }
    return 0.06 * _WaveNumber * (abs(bendU) + abs(bendV));
}

// The same of a cell.
float BentErrorAt(TubePath tube, SurfacePoint at, Receiver receiver, float side)
{
    return min(1.0, side * side * BentOf(tube, at, receiver));
}

// Signature of the ray through a position of the grid.
uint SignatureAt(float2 position)
{
    TubePath tube = BeginTube(position);
    SurfacePoint at;
    [loop]
    while (AdvanceTube(tube, at))
    {
        Sign(tube, ReceiversOf(tube, at));
        if (!ScatterTube(tube, at))
            break;
    }
    return tube.Signature;
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
