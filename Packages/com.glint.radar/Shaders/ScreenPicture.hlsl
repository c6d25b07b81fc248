#ifndef GLINT_SCREEN_PICTURE_FILE
#define GLINT_SCREEN_PICTURE_FILE

#include "Screen.hlsl"
#include "Trigonometry.hlsl"

// From the video of a turn to a picture: Core/Screen/ScreenPicture.cs explains the steps.

StructuredBuffer<float2> _ShownVideo;      // _Video of ScreenReceiver.hlsl
RWTexture2D<float4> _Picture;              // row 0 at the bottom

float4 _PictureView;                       // pixels along a side; bearing at the top, turns; pixels between rings; radius
                                           // of the range marker, pixels
float4 _PictureFade;                       // exponents of the fading of video and trails a spoke; last finished spoke;
                                           // 1: colours are written for a linear project
float4 _PictureHeading, _PictureBearing;   // directions of lines in the picture; z: 1 if drawn
float4 _PictureColours[7];                 // ScreenColours, in the order of its members

static const float SCREEN_PIXEL_SPOKES = 64.0; // that a pixel shows at most, to each side

float2 LargestVideo(int spoke, uint first, uint last)
{
    uint at = (uint)spoke & (_ScreenSize.x - 1), age = ((uint)_PictureFade.z - at) & (_ScreenSize.x - 1);
    float2 largest = 0.0;
    [loop]
    for (uint cell = first; cell <= last; cell++)
        largest = max(largest, _ShownVideo[at * _ScreenSize.y + cell]);
    return largest * exp(-_PictureFade.xy * age);
}

// The largest video and trail of the cells that a pixel touches.
float2 VideoAt(float2 position, float radius)
{
    float spokes = _ScreenSize.x, turns = atan2(position.x, position.y) / TWO_PI + _PictureView.y;
    float spoke = (turns - floor(turns)) * spokes, width = spokes / (TWO_PI * max(radius, 0.5));
    float cells = _ScreenSize.y / (0.5 * _PictureView.x);
    uint first = (uint)max(0.0, floor((radius - 0.5) * cells));
    uint last = min(_ScreenSize.y - 1, max(first, (uint)ceil((radius + 0.5) * cells) - 1));
    first = min(first, last);
    float2 largest = 0.0;
    if (width < 1.0)
    {
        int below = (int)floor(spoke);
        largest = lerp(LargestVideo(below, first, last), LargestVideo(below + 1, first, last), spoke - below);
    }
    else
    {
        float reach = min(0.5 * width, SCREEN_PIXEL_SPOKES);
        int end = (int)floor(spoke + reach + 0.5);
        [loop]
        for (int at = (int)floor(spoke - reach + 0.5); at <= end; at++)
            largest = max(largest, LargestVideo(at, first, last));
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
    float2 video = VideoAt(position, radius);
    float3 colour = lerp(_PictureColours[1].rgb, _PictureColours[3].rgb, video.y);
    colour = lerp(colour, _PictureColours[2].rgb, video.x);
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
    _Picture[id.xy] = float4(_PictureFade.w != 0.0 ? Decoded(colour) : colour, 1.0);
}

#endif
