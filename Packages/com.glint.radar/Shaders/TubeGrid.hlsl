#ifndef GLINT_TUBE_GRID
#define GLINT_TUBE_GRID

#include "PhysicalOptics.hlsl"

// Corners of a cell in order around it, from its centre.
float2 CornerOf(uint corner)
{
    return float2(corner == 1 || corner == 2 ? 0.5 : -0.5, corner >= 2 ? 0.5 : -0.5);
}

float SideOfCell(Cell cell)
{
    return asfloat((127 - cell.Level) << 23);
}

float2 CentreOfCell(Cell cell)
{
    return (float2(cell.Position) + 0.5) * SideOfCell(cell);
}

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

#endif
