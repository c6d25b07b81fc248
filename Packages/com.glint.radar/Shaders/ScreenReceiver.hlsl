#ifndef GLINT_SCREEN_RECEIVER
#define GLINT_SCREEN_RECEIVER

#include "Screen.hlsl"
#include "Speckle.hlsl"

// From the echoes of a spoke to its video. A row of threads has the cells of a spoke.

StructuredBuffer<int> _Echoes;             // _Echo of ScreenEchoes.hlsl
StructuredBuffer<float> _BeamWeights;      // of the spokes from the left to the right end of the beam
StructuredBuffer<float4> _ForeignPulses;   // ScreenInterference.PulsesOf, radar by radar of the spokes of this dispatch
StructuredBuffer<float> _PulseWeights;     // by the distance in cells
RWStructuredBuffer<float2> _Signals;       // of the spokes of this dispatch: field before the pulse's weights
RWStructuredBuffer<float> _Levels;         // of a turn: dB over noise
RWStructuredBuffer<float2> _Video;         // of a turn when the spoke was finished: video with persistence, and without

float4 _Receiver;                          // gain, dB; 1 / dynamic range, 1/dB; sensitivity time, cells; root of the
                                           // power of the noise before the pulse's weights, over that behind them
float4 _ReceiverFilters;                   // shares of rain and clutter filter; what persistence leaves of video a turn
uint _PulseCells;                          // weights of the pulse
uint _ForeignRadars;                       // for each spoke in _ForeignPulses
float4 _BlindSector;                       // left end and width of the bearings in which nothing is sent, turns

static const float SMALLEST_POWER = 1.0e-6;
static const float DECIBELS = 4.34294481903; // of an e-fold of power
static const uint CLUTTER_CELLS = 16;      // on each side, of the mean of the clutter filter

bool IsBlind(uint spoke)
{
    float turns = (float)spoke / _ScreenSize.x - _BlindSector.x;
    return turns - floor(turns) < _BlindSector.y;
}

// Field of the pulses of other radars that come in a cell.
float ForeignField(uint number, uint cell)
{
    float field = 0.0;
    [loop]
    for (uint i = number * _ForeignRadars; i < (number + 1) * _ForeignRadars; i++)
    {
        float4 pulses = _ForeignPulses[i];
        float next = pulses.x + pulses.y * max(0.0, ceil((cell - pulses.x) / pulses.y));
        field += next < cell + 1.0 ? pulses.z : 0.0;
    }
    return field;
}

// The beam: echoes of neighbouring spokes add as fields. The receiver adds its noise, and what other radars send.
[numthreads(64, 1, 1)]
void ScreenBeam(uint3 id : SV_DispatchThreadID)
{
    uint cells = _ScreenSize.y, half_beam = _ScreenSize.z;
    if (id.x >= cells)
        return;
    uint spoke = SpokeAt(id.y);
    float2 sum = 0.0;
    uint count = IsBlind(spoke) ? 0 : 2 * half_beam + 1;
    [loop]
    for (uint i = 0; i < count; i++)
    {
        uint element = 2 * (((spoke - half_beam + i) & (_ScreenSize.x - 1)) * cells + id.x);
        sum += _BeamWeights[i] * float2(_Echoes[element], _Echoes[element + 1]);
    }
    float2 noise = SpeckleAt(int2(id.x, spoke), _ScreenSize.w, TurnAt(id.y)).xy;
    _Signals[id.y * cells + id.x] = sum / ECHO_UNITS + _Receiver.w * noise + float2(ForeignField(id.y, id.x), 0.0);
}

// The pulse, and the square-law detector.
[numthreads(64, 1, 1)]
void ScreenLevel(uint3 id : SV_DispatchThreadID)
{
    uint cells = _ScreenSize.y, first = id.y * cells;
    if (id.x >= cells)
        return;
    float2 sum = _PulseWeights[0] * _Signals[first + id.x];
    [loop]
    for (uint i = 1; i < _PulseCells; i++)
    {
        if (id.x >= i)
            sum += _PulseWeights[i] * _Signals[first + id.x - i];
        if (id.x + i < cells)
            sum += _PulseWeights[i] * _Signals[first + id.x + i];
    }
    _Levels[SpokeAt(id.y) * cells + id.x] = DECIBELS * log(max(dot(sum, sum), SMALLEST_POWER));
}

// Level of a cell behind the sensitivity time control, dB.
float ControlledLevel(uint spoke, uint cell)
{
    float range = cell + 0.5;
    float level = _Levels[spoke * _ScreenSize.y + cell];
    return range < _Receiver.z ? level + 3.0 * DECIBELS * log(range / _Receiver.z) : level;
}

// Mean level of the cells around a cell, dB.
float LevelAround(uint spoke, uint cell)
{
    float sum = 0.0;
    uint count = 0;
    [loop]
    for (uint i = _PulseCells + 1; i <= _PulseCells + CLUTTER_CELLS; i++)
    {
        if (cell >= i)
        {
            sum += ControlledLevel(spoke, cell - i);
            count++;
        }
        if (cell + i < _ScreenSize.y)
        {
            sum += ControlledLevel(spoke, cell + i);
            count++;
        }
    }
    return count > 0 ? sum / count : 0.0;
}

[numthreads(64, 1, 1)]
void ScreenVideo(uint3 id : SV_DispatchThreadID)
{
    if (id.x >= _ScreenSize.y)
        return;
    uint spoke = SpokeAt(id.y), element = spoke * _ScreenSize.y + id.x;
    float level = ControlledLevel(spoke, id.x);
    if (_ReceiverFilters.x > 0.0 && id.x >= _PulseCells)
        level -= _ReceiverFilters.x * max(0.0, ControlledLevel(spoke, id.x - _PulseCells));
    if (_ReceiverFilters.y > 0.0)
        level -= _ReceiverFilters.y * max(0.0, LevelAround(spoke, id.x));
    float video = saturate((level + _Receiver.x) * _Receiver.y);
    _Video[element] = float2(max(video, _Video[element].x * _ReceiverFilters.z), video);
}

#endif
