#ifndef GLINT_SCREEN_PICTURE_FILE
#define GLINT_SCREEN_PICTURE_FILE

#include "ScreenPixel.hlsl"

// From the video of a turn to a picture: Core/Screen/ScreenPicture.cs explains the steps.

StructuredBuffer<float> _ShownTrails;      // _Trails of ScreenTrails.hlsl
RWTexture2D<float4> _Picture;              // row 0 at the bottom

float4 _PictureView;                       // pixels along a side; bearing at the top, turns; pixels between rings; radius
                                           // of the range marker, pixels
float4 _PictureFade;                       // exponent of the fading of video a spoke; last finished spoke; 1: colours
                                           // are written for a linear project
float4 _PictureTrail;                      // in the map of trails: pixel of the middle; to the east and north: the way
                                           // of one pixel up
float4 _PictureHeading, _PictureBearing;   // directions of lines in the picture; z: 1 if drawn
float4 _PictureColours[7];                 // ScreenColours, in the order of its members

// Half a pixel. It is smaller, so that rounding decides nothing where the edges of two pixels meet.
static const float TRAIL_REACH = 0.49;

float FadedVideo(int spoke, uint2 cells)
{
    uint age = ((uint)_PictureFade.y - (uint)spoke) & (_ScreenSize.x - 1);
    return LargestVideo(spoke, cells).x * exp(-_PictureFade.x * age);
}

// The largest video of the cells that a pixel touches.
float VideoAt(float2 position, float radius)
{
    float spoke = PixelSpoke(position, _PictureView.y), width = PixelWidth(radius), largest = 0.0;
    uint2 cells = PixelCells(radius, 0.5 * _PictureView.x);
    if (width < 1.0)
    {
        int below = (int)floor(spoke);
        largest = lerp(FadedVideo(below, cells), FadedVideo(below + 1, cells), spoke - below);
    }
    else
    {
        int2 spokes = PixelSpokes(spoke, width);
        [loop]
        for (int at = spokes.x; at <= spokes.y; at++)
            largest = max(largest, FadedVideo(at, cells));
    }
    return largest;
}

// The largest trail of the map's pixels that a pixel touches.
float TrailAt(float2 position)
{
    float2 up = _PictureTrail.zw, place = _PictureTrail.xy + position.x * float2(up.y, -up.x) + position.y * up;
    float reach = TRAIL_REACH * length(up), largest = 0.0;
    int2 first = (int2)floor(place - reach), last = (int2)floor(place + reach);
    [loop]
    for (int y = first.y; y <= last.y; y++)
    {
        [loop]
        for (int x = first.x; x <= last.x; x++)
            largest = max(largest,
                _ShownTrails[((uint)y & (TRAIL_SIDE - 1)) * TRAIL_SIDE + ((uint)x & (TRAIL_SIDE - 1))]);
    }
    return largest;
}

float3 DrawOver(float3 colour, uint of, float distance)
{
    return lerp(colour, _PictureColours[of].rgb, saturate(1.0 - distance));
}

float3 DrawLine(float3 colour, float2 position, float4 direction, uint of)
{
    return direction.z > 0.0 && dot(position, direction.xy) > 0.0
        ? DrawOver(colour, of, abs(position.x * direction.y - position.y * direction.x)) : colour;
}

// sRGB to linear light.
float3 Decoded(float3 colour)
{
    float3 low = colour / 12.92, high = pow((max(colour, 0.04045) + 0.055) / 1.055, 2.4);
    return float3(colour.x <= 0.04045 ? low.x : high.x, colour.y <= 0.04045 ? low.y : high.y,
        colour.z <= 0.04045 ? low.z : high.z);
}

float3 ColourAt(float2 position)
{
    float radius = length(position);
    if (radius > 0.5 * _PictureView.x)
        return _PictureColours[0].rgb;
    float3 colour = lerp(_PictureColours[1].rgb, _PictureColours[3].rgb, TrailAt(position));
    colour = lerp(colour, _PictureColours[2].rgb, VideoAt(position, radius));
    if (_PictureView.z > 0.0)
        colour = DrawOver(colour, 4, abs(radius - max(1.0, floor(radius / _PictureView.z + 0.5)) * _PictureView.z));
    colour = DrawLine(colour, position, _PictureHeading, 5);
    colour = DrawLine(colour, position, _PictureBearing, 6);
    return _PictureView.w > 0.0 ? DrawOver(colour, 6, abs(radius - _PictureView.w)) : colour;
}

[numthreads(8, 8, 1)]
void ScreenPicture(uint3 id : SV_DispatchThreadID)
{
    uint side = (uint)_PictureView.x;
    if (id.x >= side || id.y >= side)
        return;
    float3 colour = ColourAt(float2(id.xy) + 0.5 - 0.5 * _PictureView.x);
    _Picture[id.xy] = float4(_PictureFade.z != 0.0 ? Decoded(colour) : colour, 1.0);
}

#endif
