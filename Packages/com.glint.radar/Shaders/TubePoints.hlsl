#ifndef GLINT_TUBE_POINTS
#define GLINT_TUBE_POINTS

#include "TubeBlocks.hlsl"
#include "Sums.hlsl"

// Point sampling, which ray tubes are compared with: the current at a hit stands for its square of the grid, with one
// phase. One thread a point.

uint _PointsAcross;                        // along a side of a base cell
float4 _FirstPoint;                        // xy: of a base cell, in spacings of points

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread), inCell = _PointsAcross * _PointsAcross, number = index % inCell;
    if (index >= _BaseCounts.x * inCell)
        return;
    Cell cell = LoadBaseCell(index / inCell);
    uint2 place = uint2(number % _PointsAcross, number / _PointsAcross);
    if (IsEmpty(cell))
        return;
    float spacing = 1.0 / _PointsAcross;
    TubePath tube = BeginTube(float2(cell.Position) + spacing * (float2(place) + _FirstPoint.xy));
    SurfacePoint at;
    [loop]
    while (AdvanceTube(tube, at))
    {
        uint receivers = ReceiversOf(tube, at);
        Incidence incidence = IncidenceAt(tube, at);
        [loop]
        for (uint which = 0; which < _ReceiverCount; which++)
        {
            if ((receivers >> which & 1) == 0)
                continue;
            Receiver receiver = ReceiverFrom(which, tube.Path.Ray.Origin);
            Tube currents = CurrentsAt(incidence, tube, which, receiver);
            currents.Gradient = 0.0;
            currents.Corners01.x = spacing;
            currents.Corners23.x = 1.0;
            AddTube(currents, at.Part, RateTo(receiver, tube, at));
        }
        if (!ScatterTube(tube, at))
            break;
    }
    AddTo(CountWord(POSE_RAYS), 1);
}

#endif
