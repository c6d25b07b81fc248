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

// Relative error of a piece of a cell of a side of one by the curvatures of surface and wave at a hit: its phase is taken as
// linear.
float BentOf(TubePath tube, SurfacePoint at, Receiver receiver)
{
    float3 d = tube.Path.Ray.Direction;
    float surface = (1.0 - dot(receiver.Direction, d)) / dot(at.Normal, d);
    float bendU = surface * dot(at.NormalU, tube.PlaceU) - dot(tube.DirectionU, tube.PlaceU),
        bendV = surface * dot(at.NormalV, tube.PlaceV) - dot(tube.DirectionV, tube.PlaceV);
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
