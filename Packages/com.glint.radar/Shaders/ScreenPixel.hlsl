#ifndef GLINT_SCREEN_PIXEL
#define GLINT_SCREEN_PIXEL

#include "Screen.hlsl"
#include "Trigonometry.hlsl"

// Spokes and cells that a pixel touches, of the picture or of the map of trails. Radius and edge of the range scale are
// in pixels.

StructuredBuffer<float2> _ShownVideo;      // _Video of ScreenReceiver.hlsl

static const float SCREEN_PIXEL_SPOKES = 512.0; // that a pixel shows at most, to each side
static const uint TRAIL_SIDE = 1024;       // pixels after which the map of trails repeats
static const float TRAIL_RADIUS = 480.0;   // its pixels in the range scale

// Bearing of a pixel in spokes; up: that of the y axis, turns.
float PixelSpoke(float2 position, float up)
{
    float turns = atan2(position.x, position.y) / TWO_PI + up;
    return (turns - floor(turns)) * _ScreenSize.x;
}

// Width of a pixel in spokes.
float PixelWidth(float radius)
{
    return _ScreenSize.x / (TWO_PI * max(radius, 0.5));
}

// First and last spoke that a pixel touches.
int2 PixelSpokes(float spoke, float width)
{
    float reach = min(0.5 * width, SCREEN_PIXEL_SPOKES);
    return (int2)floor(float2(spoke - reach, spoke + reach) + 0.5);
}

// First and last cell that a pixel touches.
uint2 PixelCells(float radius, float edge)
{
    float cells = _ScreenSize.y / edge;
    uint first = (uint)max(0.0, floor((radius - 0.5) * cells));
    uint last = min(_ScreenSize.y - 1, max(first, (uint)ceil((radius + 0.5) * cells) - 1));
    return uint2(min(first, last), last);
}

float2 LargestVideo(int spoke, uint2 cells)
{
    uint first = ((uint)spoke & (_ScreenSize.x - 1)) * _ScreenSize.y;
    float2 largest = 0.0;
    [loop]
    for (uint cell = cells.x; cell <= cells.y; cell++)
        largest = max(largest, _ShownVideo[first + cell]);
    return largest;
}

#endif
