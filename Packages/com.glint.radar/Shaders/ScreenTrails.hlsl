#ifndef GLINT_SCREEN_TRAILS_FILE
#define GLINT_SCREEN_TRAILS_FILE

#include "ScreenPixel.hlsl"

// Trails of a radar screen in a map of the ground: Core/Screen/TrailMap.cs.

RWStructuredBuffer<float> _Trails;         // 0 to 1, row by row from the south

float4 _TrailFrame;                        // pixel of the antenna; what this frame keeps of trails

// Video of the spokes that the frame finished. The antenna has passed the last spoke of a pixel in this frame, or so
// little before that the pixel, which own ship's motion turns about the antenna, may have been missed.
float PassedVideo(float2 position, float radius)
{
    int2 spokes = PixelSpokes(PixelSpoke(position, 0.0), PixelWidth(radius));
    uint age = (_ScreenSlice.x + _ScreenSlice.y - 1 - (uint)spokes.y) & (_ScreenSize.x - 1);
    float largest = 0.0;
    if (age >= _ScreenSlice.y + (uint)(spokes.y - spokes.x) + 1)
        return largest;
    uint2 cells = PixelCells(radius, TRAIL_RADIUS);
    [loop]
    for (int spoke = spokes.x; spoke <= spokes.y; spoke++)
        largest = max(largest, LargestVideo(spoke, cells).y);
    return largest;
}

[numthreads(8, 8, 1)]
void ScreenTrails(uint3 id : SV_DispatchThreadID)
{
    float2 position = float2(id.xy) + 0.5 - _TrailFrame.xy;
    position -= TRAIL_SIDE * floor(position / TRAIL_SIDE + 0.5);
    float radius = length(position);
    uint element = id.y * TRAIL_SIDE + id.x;
    float trail = 0.0;
    if (radius <= TRAIL_RADIUS)
        trail = max(_Trails[element] * _TrailFrame.z, PassedVideo(position, radius));
    _Trails[element] = trail;
}

#endif
