#ifndef GLINT_AMPLITUDE_POINTS
#define GLINT_AMPLITUDE_POINTS

#include "AmplitudePath.hlsl"

// Traces the rays through the corners of base cells. One thread a ray.

[numthreads(GLINT_GROUP, 1, 1)]
void AmplitudePoints(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint ray = IndexOf(group, thread), across = _Grid.x + 1, rows = _Grid.z / _Grid.x + 1;
    if (ray == 0)
        InterlockedAdd(_Sums[TUBE_POINTS], across * rows);
    if (ray >= across * rows)
        return;
    Follow(float2(ray % across, _Grid.y / _Grid.x + ray / across), ray);
    AddTo(CountWord(POSE_RAYS), 1);
}

#endif
