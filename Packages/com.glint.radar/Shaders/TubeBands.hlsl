#ifndef GLINT_TUBE_BANDS
#define GLINT_TUBE_BANDS

#include "TubeSums.hlsl"

// Sums what the tubes radiate over bands of frequencies at equal steps. A group takes TUBES_A_GROUP tubes and a block of
// neighbouring frequencies at one time. Over a block the shape of a tube is a parabola: a thread finds it from three
// frequencies. Then each thread takes a frequency, and multiplies the shapes of all tubes by their phasors.

StructuredBuffer<float4> _Bands;           // per block: first sample, frequencies, half of its width in steps, 0; its middle
                                           // as an element of _WaveNumbers; the same of a step

// Places of the outer frequencies of a parabola, in half widths: Chebyshev's.
static const float BAND_NODE = 0.8660254;

// Largest change over half a block of the phase between the middle of a piece and its ends, rad. The error of a parabola is
// 1/24 of its third power, as a fraction of the area of the piece: -70 dB.
static const float MAX_BAND_PHASE = 0.2;

// Units of S that need no more than 31 bits.
static const float MAX_BAND_UNITS = 1073741824.0;

// Of a tube of the group: what it radiates over the block, beside its phasor, in units.
static const uint WAVE_ROWS = 5;
groupshared float4 s_waves[WAVE_ROWS * GLINT_GROUP];
groupshared uint2 s_squares[GLINT_GROUP];  // squared error
groupshared uint s_slots[GLINT_GROUP];     // slot of all poses

static const uint BAND_SLOTS = 256;        // Tube.Tag has eight bits for them
groupshared uint s_places[BAND_SLOTS];     // of each slot the place of its first tube in s_order
groupshared uint s_order[TUBES_A_GROUP];   // the tubes of the group by their slots

static const uint EACH_FREQUENCY = 0x100;  // in s_slots: is to be evaluated at each frequency

// Phase between the middle of a piece and its farthest end, rad.
float PhaseExtent(Tube tube, float k, float2 w)
{
    uint count = tube.Tag >> 16;
    if (count == EDGE_CORNERS)
        return abs(0.5 * tube.Corners01.x * w.x);
    if (count == 0)
        return 0.5 * tube.Corners01.x * (abs(w.x) + abs(w.y)) + k * dot(abs(tube.Corners01.yzw), 1.0);
    float4 extents = abs(float4(dot(w, tube.Corners01.xy), dot(w, tube.Corners01.zw), dot(w, tube.Corners23.xy),
        dot(w, tube.Corners23.zw)));
    return max(max(max(extents.x, extents.y), max(extents.z, extents.w)), abs(dot(w, tube.Corner4)));
}

// Leaves to the group what a tube radiates over a block. Returns its element of s_slots.
uint SetWave(uint thread, uint index, float4 size, float4 centre, float4 step)
{
    Tube tube = _Tubes[index];
    float2 gradient = tube.Gradient;
    DoubleFloat turnsPerMetre = MakeDoubleFloat(centre.y, centre.z), turns = Mul(turnsPerMetre, tube.Phase);
    float metres = tube.Phase;
    if (_IsMoving != 0)
    {
        float3 rate = _TubeRates[index].xyz;
        turns = Add(turns, Mul(Mul(turnsPerMetre, centre.w), rate.z));
        gradient += centre.w * rate.xy;
        metres += centre.w * rate.z;
    }
    float2 before = 0.0, atCentre = 0.0, after = 0.0;
    float error = 0.0, cancelled = 0.0;
    [loop]
    for (int node = -1; node <= 1; node++)
    {
        float k = centre.x + node * BAND_NODE * size.z * step.x;
        TubeShape shape = ShapeOf(tube, k, k * gradient);
        float2 wave = _UnitsPerMetre * shape.Scale * ComplexMul(shape.Integral, shape.Factor);
        if (node < 0)
            before = wave;
        else if (node > 0)
            after = wave;
        else
        {
            atCentre = wave;
            error = tube.Error * shape.Scale;
            cancelled = shape.Cancelled;
        }
    }
    // By steps from the middle.
    float width = 1.0 / (BAND_NODE * size.z);
    float2 slope = 0.5 * width * (after - before), curve = width * width * (0.5 * (after + before) - atCentre);
    float2 vv = ComplexMul(atCentre, tube.CoPolar.xy), hh = ComplexMul(atCentre, tube.CoPolar.zw);
    float2 bent = tube.Bent
        * ((dot(vv, vv) > dot(hh, hh) ? vv : hh) + float2(_UnitsPerMetre * error * cancelled, 0.0));
    Sum squares;
    squares.Lower = 0;
    squares.Upper = 0;
    uint overflow = 0;
    Accumulate(squares, SquaresOf(error, bent), overflow);
    s_squares[thread] = uint2(squares.Lower, squares.Upper);
    uint row = WAVE_ROWS * thread;
    s_waves[row] = float4(PartOfTurn(turns), step.y * metres, bent);
    s_waves[row + 1] = float4(atCentre, slope);
    s_waves[row + 2] = float4(curve, 0.0, 0.0);
    s_waves[row + 3] = tube.CoPolar;
    s_waves[row + 4] = tube.CrossPolar;
    float largest = MagnitudeOf(tube)
        * (length(atCentre) + size.z * length(slope) + size.z * size.z * length(curve)) + length(bent);
    float phase = PhaseExtent(tube, centre.x, centre.x * gradient) * size.z * step.x / centre.x;
    bool isEach = overflow != 0 || IsNaN(largest) || largest > MAX_BAND_UNITS || phase > MAX_BAND_PHASE;
    return (tube.Tag & 0xff) | (isEach ? EACH_FREQUENCY : 0);
}

// A float below 2^22 plus it is that float rounded, ties to the even number; its bits are those of this number plus the
// whole one. GPUs convert floats to integers at a fraction of the rate at which they add.
static const float ROUNDER = 12582912.0;   // 1.5 * 2^23
static const float UPPER_UNITS = 65536.0;

// Adds units below 2^31 in magnitude, rounded, to a sum of a wave: parts in UPPER_UNITS and the rest, at most half of one,
// each as the bits of ROUNDER plus the part. No step but the rounding is inexact, fused or not.
void AddUnits(inout Sum sum, float units)
{
    precise float upper = mad(units, 1.0 / UPPER_UNITS, ROUNDER);
    precise float lower = mad(ROUNDER - upper, UPPER_UNITS, units) + ROUNDER;
    sum.Upper += asuint(upper);
    sum.Lower += asuint(lower);
}

void AddUnits(inout Sum real, inout Sum imaginary, float2 units)
{
    AddUnits(real, units.x);
    AddUnits(imaginary, units.y);
}

static const uint WAVE_SUMS = 10;

void ClearWaves(out Sum waves[WAVE_SUMS])
{
    for (uint i = 0; i < WAVE_SUMS; i++)
    {
        waves[i].Lower = 0;
        waves[i].Upper = 0;
    }
}

// Moves the sums of a number of waves to others.
void MoveWaves(inout Sum sums[11], inout Sum waves[WAVE_SUMS], uint count)
{
    uint rounders = count * asuint(ROUNDER);
    for (uint i = 0; i < WAVE_SUMS; i++)
    {
        int upper = (int)(waves[i].Upper - rounders), lower = (int)(waves[i].Lower - rounders);
        AddWhole(sums[i], (uint)upper << 16, (uint)(upper >> 16));
        AddWhole(sums[i], (uint)lower, (uint)(lower >> 31));
    }
    ClearWaves(waves);
}

// Cosine and sine of a number of turns, to 1e-6 and the rounding of the turns, with neither conversions to integers nor
// divisions: Taylor's series over half a turn.
float2 WavePhasor(float turns)
{
    precise float halves = mad(turns, 2.0, ROUNDER);
    precise float x = mad(halves - ROUNDER, -0.5, turns);
    float square = x * x;
    float sine = x * (6.28318531 + square * (-41.3417022 + square * (81.6052493 + square * (-76.7058598
        + square * (42.0586939 - square * 15.0946426)))));
    float cosine = 1.0 + square * (-19.7392088 + square * (64.939394 + square * (-85.4568172
        + square * (60.2446414 - square * 26.4262568))));
    // Half a turn more changes both signs.
    return asfloat(asuint(float2(cosine, sine)) ^ (asuint(halves) << 31));
}

// Adds a tube of the group at a frequency, some steps from the middle of the block.
void AddWave(inout Sum squares, inout Sum waves[WAVE_SUMS], uint tube, float steps)
{
    uint row = WAVE_ROWS * tube;
    float4 path = s_waves[row], parabola = s_waves[row + 1];
    float2 phasor = WavePhasor(path.x + steps * path.y);
    float2 wave = ComplexMul(parabola.xy + steps * (parabola.zw + steps * s_waves[row + 2].xy), phasor);
    float4 coPolar = s_waves[row + 3], crossPolar = s_waves[row + 4];
    AddUnits(waves[0], waves[1], ComplexMul(wave, coPolar.xy));
    AddUnits(waves[2], waves[3], ComplexMul(wave, crossPolar.xy));
    AddUnits(waves[4], waves[5], ComplexMul(wave, crossPolar.zw));
    AddUnits(waves[6], waves[7], ComplexMul(wave, coPolar.zw));
    AddUnits(waves[8], waves[9], ComplexMul(phasor, path.zw));
    AddWhole(squares, s_squares[tube].x, s_squares[tube].y);
}

// Puts the tubes of the group into the order of their slots: tubes of several poses may lie in any order, and each change
// of the slot takes an addition to all sums.
void SortTubes(uint thread, uint2 tubes)
{
    for (uint i = thread; i < BAND_SLOTS; i += GLINT_GROUP)
        s_places[i] = 0;
    GroupMemoryBarrierWithGroupSync();
    uint part, place;
    for (part = thread; part < TUBES_A_GROUP; part += GLINT_GROUP)
        if (tubes.x + part < tubes.y)
            InterlockedAdd(s_places[_Tubes[tubes.x + part].Tag & 0xff], 1);
    GroupMemoryBarrierWithGroupSync();
    if (thread == 0)
    {
        uint sum = 0;
        for (uint slot = 0; slot < _PoseCount * _SlotCount; slot++)
        {
            uint count = s_places[slot];
            s_places[slot] = sum;
            sum += count;
        }
    }
    GroupMemoryBarrierWithGroupSync();
    for (part = thread; part < TUBES_A_GROUP; part += GLINT_GROUP)
        if (tubes.x + part < tubes.y)
        {
            InterlockedAdd(s_places[_Tubes[tubes.x + part].Tag & 0xff], 1, place);
            s_order[place] = tubes.x + part;
        }
}

[numthreads(GLINT_GROUP, 1, 1)]
void TubeBands(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    float4 size = _Bands[BAND_ROWS * group.z], centre = _Bands[BAND_ROWS * group.z + 1],
        step = _Bands[BAND_ROWS * group.z + 2];
    uint number = thread % BAND_FREQUENCIES, share = thread / BAND_FREQUENCIES, shares = GLINT_GROUP / BAND_FREQUENCIES;
    bool hasFrequency = number < (uint)size.y;
    uint sample = (uint)size.x + min(number, (uint)size.y - 1);
    float steps = number - 0.5 * (size.y - 1.0);
    uint2 tubes = TubesOf(group);
    uint copy = (group.x + group.y * GROUPS_A_ROW) % _SumCopies;
    SortTubes(thread, tubes);
    Sum sums[11];
    Clear(sums);
    Sum waves[WAVE_SUMS];
    ClearWaves(waves);
    uint overflow = 0, held = NO_SLOT, waveCount = 0;
    [loop]
    for (uint part = 0; part < TUBES_A_GROUP; part += GLINT_GROUP)
    {
        uint first = tubes.x + part;
        GroupMemoryBarrierWithGroupSync();
        if (first + thread < tubes.y)
            s_slots[thread] = SetWave(thread, s_order[part + thread], size, centre, step);
        GroupMemoryBarrierWithGroupSync();
        uint count = hasFrequency && first < tubes.y ? min(GLINT_GROUP, tubes.y - first) : 0;
        [loop]
        for (uint i = share; i < count; i += shares)
        {
            uint slot = s_slots[i];
            if ((slot & 0xff) != held)
            {
                MoveWaves(sums, waves, waveCount);
                waveCount = 0;
                AddSums(held, sample, copy, sums, overflow);
                Clear(sums);
                overflow = 0;
                held = slot & 0xff;
            }
            uint index = s_order[part + i];
            if ((slot & EACH_FREQUENCY) == 0)
            {
                AddWave(sums[10], waves, i, steps);
                waveCount++;
            }
            else
                AccumulateTube(sums, _Tubes[index], RadiationOf(_Tubes[index], index, _WaveNumbers[sample]), overflow);
        }
    }
    MoveWaves(sums, waves, waveCount);
    AddSums(held, sample, copy, sums, overflow);
}

#endif
