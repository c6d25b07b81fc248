#ifndef GLINT_SCREEN_ECHOES_FILE
#define GLINT_SCREEN_ECHOES_FILE

#include "Screen.hlsl"
#include "Speckle.hlsl"

// Echoes of the spokes of a frame. Sums of integers do not depend on the order of threads.

// The complex field of each spoke and cell, real and imaginary part, in 1 / ECHO_UNITS of the root of the noise's power:
// element 2 (spoke cells + cell). The beam and the pulse are applied later.
RWStructuredBuffer<int> _Echo;

float4 _ScreenEcho;                        // size of a cell, m; amplitude of 1 m2 at 1 m, in units; cells after which
                                           // the next pulse leaves; amplitude of rain times cells of range
float _RainLoss;                           // exponent of a field in the rain, 1/m

// Of one echo: 112 dB over noise. A sum of 32 bits holds 85 of them.
static const float MAX_UNITS = 2.5e7;

void AddEcho(uint spoke, uint cell, float2 field)
{
    int2 units = (int2)round(clamp(field, -MAX_UNITS, MAX_UNITS));
    uint element = 2 * (spoke * _ScreenSize.y + cell);
    InterlockedAdd(_Echo[element], units.x);
    InterlockedAdd(_Echo[element + 1], units.y);
}

// The place at which an echo is shown, in cells: that after the last pulse. cells: after its own.
float ShownCell(float cells)
{
    return cells - _ScreenEcho.z * floor(cells / _ScreenEcho.z);
}

#if !defined(GLINT_SCREEN_SEA)

[numthreads(64, 1, 1)]
void ScreenClear(uint3 id : SV_DispatchThreadID)
{
    if (id.x < 2 * _ScreenSize.y)
        _Echo[2 * SpokeAt(id.y) * _ScreenSize.y + id.x] = 0;
}

// Rain that fills the beam: a number of mean power 1 for each cell and turn.
[numthreads(64, 1, 1)]
void ScreenRain(uint3 id : SV_DispatchThreadID)
{
    if (id.x >= _ScreenSize.y)
        return;
    uint spoke = SpokeAt(id.y);
    // Drops move by more than a wavelength between turns. The noise has other cells: those from 0.
    float2 number = SpeckleAt(int2(-1 - (int)id.x, spoke), _ScreenSize.w, TurnAt(id.y)).xy;
    float cells = id.x + 0.5;
    AddEcho(spoke, id.x, _ScreenEcho.w / cells * exp(-2.0 * _RainLoss * _ScreenEcho.x * cells) * number);
}

#endif

#include "ScreenPoints.hlsl"

#if defined(GLINT_SCREEN_SEA)
#include "ScreenSea.hlsl"
#endif

#endif
