#ifndef GLINT_BACKPROJECTION
#define GLINT_BACKPROJECTION

#include "Constants.hlsl"
#include "Phasor.hlsl"

// Backprojection: one thread a pixel, looks in a loop. The phase of the carrier is thousands of turns, so that turns
// and cells are double-floats.

// GLINT_LOOK: a look and its profile (Runtime/Echo/IsarImager.cs).
struct Look
{
    float4 Turns;          // of the carrier, a pixel down range and a pixel cross range, each with its Lo part
    float4 Cells;          // of the profile, as Turns
    float2 CentreCell;     // of the image, with its Lo part
    float Weight;
    float Range;           // from the middle to the radar, pixels; 0: the wave is plane
    float4 Bend;           // range of a plane wave a pixel down range and cross range, pixels; cells and turns of a pixel
};

static const uint BACKPROJECTION_GROUP = 64;

StructuredBuffer<Look> _Looks;
StructuredBuffer<float2> _Profiles;        // of the looks of this dispatch, one after the other
RWStructuredBuffer<float2> _Image;         // row by row: rows are down range, columns cross range
uint4 _ImageSize;                          // pixels along a side; cells of a profile; looks; 1: adds to earlier ones

DoubleFloat Along(float4 steps, float2 position)
{
    return Add(Mul(MakeDoubleFloat(steps.x, steps.y), position.x), Mul(MakeDoubleFloat(steps.z, steps.w), position.y));
}

// Pixels by which a place is further away than for a plane wave.
float Curvature(Look look, float2 position)
{
    float away = dot(position, look.Bend.xy), ahead = look.Range + away;
    float across = max(0.0, dot(position, position) - away * away);
    return look.Range == 0.0 ? 0.0 : across / (ahead + sqrt(ahead * ahead + across));
}

[numthreads(BACKPROJECTION_GROUP, 1, 1)]
void Backproject(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint pixel = (group.x + group.y * GROUPS_A_ROW) * BACKPROJECTION_GROUP + thread;
    if (pixel >= _ImageSize.x * _ImageSize.x)
        return;
    // From the middle of the image, exact.
    float2 position = float2(pixel / _ImageSize.x, pixel % _ImageSize.x) - 0.5 * (_ImageSize.x - 1.0);
    float2 sum = _ImageSize.w != 0 ? _Image[pixel] : 0.0;
    [loop]
    for (uint i = 0; i < _ImageSize.z; i++)
    {
        Look look = _Looks[i];
        float bend = Curvature(look, position);
        DoubleFloat cell = Add(Along(look.Cells, position), MakeDoubleFloat(look.CentreCell.x, look.CentreCell.y));
        cell = Add(cell, MakeDoubleFloat(look.Bend.z * bend, 0.0));
        float first = floor(cell.Hi), part = (cell.Hi - first) + cell.Lo, step = floor(part);
        int at = (int)first + (int)step;
        if (at < 0 || at + 1 >= (int)_ImageSize.y)
            continue;
        uint element = i * _ImageSize.y + at;
        float2 value = look.Weight * lerp(_Profiles[element], _Profiles[element + 1], part - step);
        DoubleFloat turns = Add(Along(look.Turns, position), MakeDoubleFloat(look.Bend.w * bend, 0.0));
        float2 wave = Phasor(PartOfTurn(turns));
        sum += float2(value.x * wave.x - value.y * wave.y, value.x * wave.y + value.y * wave.x);
    }
    _Image[pixel] = sum;
}

#endif
