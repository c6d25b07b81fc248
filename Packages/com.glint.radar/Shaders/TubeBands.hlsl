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

// Half the change of the currents over a square that is left out: its integral is less than half of that.
static const float MAX_BAND_SLOPE = 1.0e-3;

// Units of S that need no more than 31 bits.
static const float MAX_BAND_UNITS = 1073741824.0;

// Of a tube of the group: what it radiates over the block, beside its phasor, in units.
static const uint WAVE_ROWS = 5;
groupshared float4 s_waves[WAVE_ROWS * GLINT_GROUP];
groupshared uint4 s_squares[GLINT_GROUP];  // squared errors: of VV and HH, of HV and VH
groupshared uint s_slots[GLINT_GROUP];     // slot of all poses

static const uint BAND_SLOTS = 256;        // Tube.Tag has eight bits for them
groupshared uint s_places[BAND_SLOTS];     // of each slot the place of its first tube in s_order
groupshared uint s_order[TUBES_A_GROUP];   // the tubes of the group by their slots

static const uint EACH_FREQUENCY = 0x100;  // in s_slots: is to be evaluated at each frequency

// Phase between the middle of a piece and its farthest end, rad.
float PhaseExtent(Tube tube, float k, float2 w)
{
    uint count = CornersOf(tube);
    if (count == EDGE_CORNERS)
        return abs(0.5 * tube.Corners01.x * w.x) + k * abs(tube.Corners01.y);
    if (count == 0)
        return 0.5 * tube.Corners01.x * (abs(w.x) + abs(w.y)) + k * dot(abs(tube.Corners01.yzw), 1.0);
    float4 extents = abs(float4(dot(w, tube.Corners01.xy), dot(w, tube.Corners01.zw), dot(w, tube.Corners23.xy),
        dot(w, tube.Corners23.zw)));
    return max(max(max(extents.x, extents.y), max(extents.z, extents.w)), abs(dot(w, tube.Corner4)));
}

// Largest change of the currents over a square (_TubeExtras).
float LargestSlope(Tube tube, uint index)
{
    float largest = 0.0;
    for (uint row = 1; row < TUBE_EXTRAS && HasChanges(tube); row++)
    {
        float4 slope = _TubeExtras[_ExtraRows * index + row];
        largest = max(largest, dot(slope, slope));
    }
    return sqrt(largest);
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
        float3 rate = _TubeExtras[_ExtraRows * index].xyz;
        turns = Add(turns, Mul(Mul(turnsPerMetre, centre.w), rate.z));
        gradient += centre.w * rate.xy;
        metres += centre.w * rate.z;
    }
    float2 before = 0.0, atCentre = 0.0, after = 0.0;
    float2 errors = 0.0;
    float cancelled = 0.0;
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
            errors = tube.Error * shape.Scale * MagnitudesOf(tube);
            cancelled = shape.Cancelled;
        }
    }
    // By steps from the middle.
    float width = 1.0 / (BAND_NODE * size.z);
    float2 slope = 0.5 * width * (after - before), curve = width * width * (0.5 * (after + before) - atCentre);
    float2 bent = BentS(tube.Bent, ComplexMul(atCentre, tube.CoPolar.xy), ComplexMul(atCentre, tube.CoPolar.zw), errors.x,
        float2(cancelled, 0.0));
    float2 crossBent = BentS(tube.Bent, ComplexMul(atCentre, tube.CrossPolar.xy),
        ComplexMul(atCentre, tube.CrossPolar.zw), errors.y, float2(cancelled, 0.0));
    Sum squares[2];
    squares[0] = NoSum();
    squares[1] = NoSum();
    uint overflow = 0;
    Accumulate(squares[0], SquaresOf(errors.x, bent), overflow);
    Accumulate(squares[1], SquaresOf(errors.y, crossBent), overflow);
    s_squares[thread] = uint4(squares[0].Lower, squares[0].Upper, squares[1].Lower, squares[1].Upper);
    uint row = WAVE_ROWS * thread;
    s_waves[row] = float4(PartOfTurn(turns), step.y * metres, bent);
    s_waves[row + 1] = float4(atCentre, slope);
    s_waves[row + 2] = float4(curve, crossBent);
    s_waves[row + 3] = tube.CoPolar;
    s_waves[row + 4] = tube.CrossPolar;
    float2 magnitudes = MagnitudesOf(tube);
    float magnitude = max(magnitudes.x, magnitudes.y);
    float largest = magnitude
        * (length(atCentre) + size.z * length(slope) + size.z * size.z * length(curve)) + length(bent) + length(crossBent);
    float phase = PhaseExtent(tube, centre.x, centre.x * gradient) * size.z * step.x / centre.x;
    bool isEach = overflow != 0 || IsNaN(largest) || largest > MAX_BAND_UNITS || phase > MAX_BAND_PHASE
        || LargestSlope(tube, index) > MAX_BAND_SLOPE * magnitude;
    return (tube.Tag & 0xff) | (isEach ? EACH_FREQUENCY : 0);
}

// Adds units that need no more than 31 bits.
void AddSmall(inout Sum sum, float units)
{
    int whole = (int)round(units);
    uint lower = (uint)whole;
    sum.Lower += lower;
    sum.Upper += (whole < 0 ? 0xffffffff : 0) + (sum.Lower < lower ? 1 : 0);
}

void AddSmall(inout Sum real, inout Sum imaginary, float2 units)
{
    AddSmall(real, units.x);
    AddSmall(imaginary, units.y);
}

void AddSquares(inout Sum sum, uint2 squares)
{
    sum.Lower += squares.x;
    sum.Upper += squares.y + (sum.Lower < squares.x ? 1 : 0);
}

// Adds a tube of the group at a frequency, some steps from the middle of the block.
void AddWave(inout Sum sums[TUBE_SUM_COUNT], uint tube, float steps)
{
    uint row = WAVE_ROWS * tube;
    float4 path = s_waves[row], parabola = s_waves[row + 1], curve = s_waves[row + 2];
    float turns = path.x + steps * path.y;
    float2 phasor = Phasor(turns - floor(turns));
    float2 wave = ComplexMul(parabola.xy + steps * (parabola.zw + steps * curve.xy), phasor);
    float4 coPolar = s_waves[row + 3], crossPolar = s_waves[row + 4];
    AddSmall(sums[0], sums[1], ComplexMul(wave, coPolar.xy));
    AddSmall(sums[2], sums[3], ComplexMul(wave, crossPolar.xy));
    AddSmall(sums[4], sums[5], ComplexMul(wave, crossPolar.zw));
    AddSmall(sums[6], sums[7], ComplexMul(wave, coPolar.zw));
    AddSmall(sums[8], sums[9], ComplexMul(phasor, path.zw));
    AddSmall(sums[11], sums[12], ComplexMul(phasor, curve.zw));
    uint4 squares = s_squares[tube];
    AddSquares(sums[10], squares.xy);
    AddSquares(sums[13], squares.zw);
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
    Sum sums[TUBE_SUM_COUNT];
    Clear(sums);
    uint overflow = 0, held = NO_SLOT;
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
                AddSums(held, sample, copy, sums, overflow);
                Clear(sums);
                overflow = 0;
                held = slot & 0xff;
            }
            uint index = s_order[part + i];
            if ((slot & EACH_FREQUENCY) == 0)
                AddWave(sums, i, steps);
            else
                AccumulateTube(sums, _Tubes[index], RadiationOf(_Tubes[index], index, _WaveNumbers[sample]), overflow);
        }
    }
    AddSums(held, sample, copy, sums, overflow);
}

#endif
