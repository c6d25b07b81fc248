#ifndef GLINT_SEA_TRANSFORM
#define GLINT_SEA_TRANSFORM

#include "SeaField.hlsl"
#include "Trigonometry.hlsl"

// From a sea's waves to its points: fast Fourier transforms along x, then along z, a row or column a group. Height and
// acceleration of a point are the real and the imaginary part of one transform.

// GLINT_SEA_WAVE: a wave of a cascade (Runtime/Sea/SeaPoint.cs) at row * SEA_SIDE + column; negative columns are
// counted from SEA_SIDE down. It is one of each pair k and -k, SeaMode of Core/Sea/SeaSurface.cs; its row is below
// SEA_SIDE / 2.
struct SeaWave
{
    float2 Amplitude;      // complex, at the start of the clock, m
    float Frequency;       // turns a second
    uint Turns;            // fraction of the frequency, 2^-32 turns a second: whole seconds lose no precision
};

StructuredBuffer<SeaWave> _SeaWaves;
RWStructuredBuffer<SeaPoint> _WrittenSeaPoints;
uint _SeaSeconds;                          // whole seconds of the clock,
float _SeaFraction;                        // and the rest

groupshared float2 s_sums[SEA_SIDE];       // complex

// The transform takes its elements in the order of reversed bits.
uint Reversed(uint index)
{
    return reversebits(index) >> 24;
}

// Sums a e^(2 pi i n x / SEA_SIDE) in place; a thread has two elements.
void Transform(uint thread)
{
    for (uint stride = 1; stride < SEA_SIDE; stride *= 2)
    {
        GroupMemoryBarrierWithGroupSync();
        uint within = thread & (stride - 1), low = 2 * thread - within, high = low + stride;
        float2 turned = ComplexMul(s_sums[high], Phasor(0.5 * within / stride));
        s_sums[high] = s_sums[low] - turned;
        s_sums[low] += turned;
    }
    GroupMemoryBarrierWithGroupSync();
}

// Between the transforms, the fields of a point are real and imaginary parts of sums along x.
void StorePoint(uint index, uint at)
{
    SeaPoint sea;
    sea.Height = s_sums[at].x;
    sea.Acceleration = s_sums[at].y;
    _WrittenSeaPoints[index] = sea;
}

void LoadPoint(uint index, uint at)
{
    SeaPoint sea = _WrittenSeaPoints[index];
    s_sums[at] = float2(sea.Height, sea.Acceleration);
}

// The transform of height + i acceleration at a wave vector, at the time of the clock. A real field's transform at -k
// is the conjugate of that at k.
void LoadWave(uint cascade, int2 k, uint at)
{
    bool isOpposite = k.y < 0 || k.y == 0 && k.x < 0;
    uint2 index = (uint2)(isOpposite ? -k : k) & (SEA_SIDE - 1);
    SeaWave wave = (SeaWave)0;
    if (index.y < SEA_SIDE / 2)
        wave = _SeaWaves[(cascade * SEA_SIDE / 2 + index.y) * SEA_SIDE + index.x];
    // 24 bits of a turn are exact in float32.
    float turns = ((wave.Turns * _SeaSeconds) >> 8) / 16777216.0 + wave.Frequency * _SeaFraction;
    float2 turn = Phasor(turns - floor(turns));
    float2 height = ComplexMul(wave.Amplitude, float2(turn.x, -turn.y));
    if (isOpposite)
        height.y = -height.y;
    float frequency = TWO_PI * wave.Frequency;
    s_sums[at] = ComplexMul(height, float2(1.0, -frequency * frequency));
}

int SignedOf(uint index)
{
    return index < SEA_SIDE / 2 ? (int)index : (int)index - (int)SEA_SIDE;
}

// A group has a row and a cascade.
[numthreads(128, 1, 1)] // SEA_SIDE / 2
void SeaRows(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint second = thread + SEA_SIDE / 2, first = (group.y * SEA_SIDE + group.x) * SEA_SIDE;
    LoadWave(group.y, int2(SignedOf(thread), SignedOf(group.x)), Reversed(thread));
    LoadWave(group.y, int2(SignedOf(second), SignedOf(group.x)), Reversed(second));
    Transform(thread);
    StorePoint(first + thread, thread);
    StorePoint(first + second, second);
}

// A group has a column and a cascade.
[numthreads(128, 1, 1)] // SEA_SIDE / 2
void SeaColumns(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint second = thread + SEA_SIDE / 2, first = group.y * SEA_SIDE * SEA_SIDE + group.x;
    LoadPoint(first + thread * SEA_SIDE, Reversed(thread));
    LoadPoint(first + second * SEA_SIDE, Reversed(second));
    Transform(thread);
    StorePoint(first + thread * SEA_SIDE, thread);
    StorePoint(first + second * SEA_SIDE, second);
}

#endif
