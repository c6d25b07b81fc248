#ifndef GLINT_TUBE_SUMS
#define GLINT_TUBE_SUMS

#include "TubeBindings.hlsl"
#include "Sums.hlsl"
#include "Phasor.hlsl"

// Sums what the tubes radiate, at each receiver and frequency. A group takes TUBES_A_GROUP tubes; its threads take
// frequencies, and share the tubes if there are fewer frequencies than threads. Sums are whole numbers: the same in any
// order. Groups spread over copies of the sums, since additions to one word wait for each other.

uint _FrequenciesAGroup;                   // a power of two up to the size of a group
uint _SumCopies;
float _UnitsPerMetre;                      // of S

static const float MAX_UNITS = 4.0e18;

// A larger squared error is no more than this: it says enough.
static const float MAX_ERROR_UNITS = 1.0e17;
static const float SQRT_4_PI = 3.54490770181103205;

// Of a slot and frequency: see SUM_S.
static const uint TUBE_SUM_COUNT = SUM_TUBE_OVERFLOW / 2;

// A sum of a thread, 64 bits in two's complement.
struct Sum
{
    uint Lower;
    uint Upper;
};

Sum NoSum()
{
    Sum sum;
    sum.Lower = 0;
    sum.Upper = 0;
    return sum;
}

void Accumulate(inout Sum sum, float units, inout uint overflow)
{
    float whole = round(units), magnitude = abs(whole);
    if (IsNaN(units) || magnitude > MAX_UNITS)
    {
        overflow = 1;
        return;
    }
    uint upper = (uint)(magnitude / TWO_TO_32), lower = (uint)(magnitude - upper * TWO_TO_32);
    if (whole < 0.0)
    {
        upper = lower == 0 ? 0 - upper : ~upper;
        lower = 0 - lower;
    }
    sum.Lower += lower;
    sum.Upper += upper + (sum.Lower < lower ? 1 : 0);
}

void Accumulate(inout Sum real, inout Sum imaginary, float2 units, inout uint overflow)
{
    Accumulate(real, units.x, overflow);
    Accumulate(imaginary, units.y, overflow);
}

float Sinc(float x)
{
    float square = x * x;
    return abs(x) < 0.5 ? 1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0)) : PhasorOf(x).y / x;
}

// (sin x - x cos x) / x^3
float SecondBessel(float x, float2 wave)
{
    float s = x * x;
    return abs(x) < 1.0 ? 1.0 / 3.0 - s * (1.0 / 30.0 - s * (1.0 / 840.0 - s / 45360.0))
        : (wave.y - x * wave.x) / (s * x);
}

// ((3 - x^2) sin x - 3 x cos x) / x^5
float ThirdBessel(float x, float2 wave)
{
    float s = x * x;
    return abs(x) < 1.0 ? 1.0 / 15.0 - s * (1.0 / 210.0 - s * (1.0 / 7560.0 - s / 498960.0))
        : ((3.0 - s) * wave.y - 3.0 * x * wave.x) / (s * s * x);
}

// Means over a line, along which a place runs from -1 to 1. The phase is linear but for a bend, which is expanded to second
// order, to first order in Along, and left out of Square.
struct LineMeans
{
    float2 Wave;           // of exp(j phase)
    float2 Along;          // of its product with the place
    float Square;          // of its product with the square of the place
};

// x: half the linear phase over the line; bend: the phase that the curvature adds at its ends.
LineMeans MeansOf(float x, float bend)
{
    float2 wave = PhasorOf(x);
    float zero = Sinc(x), first = SecondBessel(x, wave), second = ThirdBessel(x, wave);
    LineMeans means;
    means.Wave = float2(zero - 4.0 * bend * bend * second, -2.0 * bend * first);
    means.Along = float2(2.0 * bend * x * second, x * first);
    means.Square = zero - 2.0 * first;
    return means;
}

// Integral of a strength times exp(j phase) over a square about its centre, by its area, for a phase that is linear but for
// terms of second order: x half the linear phase over a side, bends the phases that curvatures and twist add at the corners.
// Phases and strengths at the corners are exact, so that neighbouring squares meet; what bends between them is expanded to
// second order, and to first where the strength changes.
float2 SquareIntegral(float2 x, float3 bends, float4 strength)
{
    LineMeans u = MeansOf(x.x, bends.x), v = MeansOf(x.y, bends.y);
    float2 twist = float2(-0.5 * bends.z * bends.z * u.Square * v.Square
        - bends.z * (u.Along.x * v.Along.y + v.Along.x * u.Along.y), -bends.z * u.Along.y * v.Along.y);
    return strength.x * (ComplexMul(u.Wave, v.Wave) + twist)
        + strength.y * (ComplexMul(u.Along, v.Wave) - float2(bends.z * u.Square * v.Along.y, 0.0))
        + strength.z * (ComplexMul(u.Wave, v.Along) - float2(bends.z * v.Square * u.Along.y, 0.0))
        + strength.w * (ComplexMul(u.Along, v.Along) + float2(0.0, bends.z * u.Square * v.Square));
}

// A polynomial over a polygon, by which exp(j w.x) is multiplied: mean + slope.x + j x.H.x / 2, with H the bends by u, by v
// and by both, rad.
struct PieceField
{
    float Mean;
    float3 Bends;
    float2 Slope;
};

float2 BendsTimes(PieceField field, float2 x)
{
    return float2(field.Bends.x * x.x + field.Bends.z * x.y, field.Bends.z * x.x + field.Bends.y * x.y);
}

// Integral over the triangle between 0 and an edge, twice its area apart, for a small phase: powers of w.x are integrated
// along each line from 0, and Gauss's rule takes three of them.
float2 TriangleIntegral(PieceField field, float2 a, float2 b, float2 w)
{
    float2 sum = 0.0;
    [loop]
    for (int place = -1; place <= 1; place++)
    {
        float2 x = lerp(a, b, 0.5 + 0.38729833 * place), power = float2(1.0, 0.0);
        float phase = dot(w, x), slope = dot(field.Slope, x), bend = 0.5 * dot(x, BendsTimes(field, x));
        float weight = place == 0 ? 4.0 / 9.0 : 5.0 / 18.0;
        [loop]
        for (uint n = 0; n < 6; n++)
        {
            // The mean, slope and j bend times s, s^2 and s^3 on the way s from 0 to 1.
            float2 factor = float2(field.Mean / (n + 2.0) + slope / (n + 3.0), bend / (n + 4.0));
            sum += weight * ComplexMul(factor, power);
            power = phase / (n + 1.0) * float2(-power.y, power.x);
        }
    }
    return sum;
}

// Mean over an edge of what has the divergence exp(j w.x) times the polynomial, along w: Gordon's sum (1975) with its
// polynomial, whose derivatives along w end with the second one.
float2 EdgeMean(PieceField field, float2 a, float2 b, float2 w)
{
    float2 middle = 0.5 * (a + b), halfEdge = 0.5 * (b - a), alongEdge = BendsTimes(field, halfEdge),
        alongWave = BendsTimes(field, w);
    float inverse = 1.0 / dot(w, w), x = dot(w, halfEdge);
    float2 wave = PhasorOf(x);
    float first = SecondBessel(x, wave), zero = Sinc(x);
    // By powers of the place on the edge, from -1 to 1.
    float2 constant = inverse * float2(0.5 * dot(middle, BendsTimes(field, middle))
            + inverse * (dot(w, field.Slope) - inverse * dot(w, alongWave)),
        inverse * dot(alongWave, middle) - field.Mean - dot(field.Slope, middle));
    float2 linearPart = inverse * float2(dot(middle, alongEdge),
        inverse * dot(alongWave, halfEdge) - dot(field.Slope, halfEdge));
    float square = 0.5 * inverse * dot(halfEdge, alongEdge);
    float2 mean = constant * zero + x * first * float2(-linearPart.y, linearPart.x)
        + float2(square * (zero - 2.0 * first), 0.0);
    return ComplexMul(mean, PhasorOf(dot(w, middle)));
}

// Phase between 0 and the farthest corner up to which powers of it are integrated, rad.
static const float MAX_POWERS_PHASE = 0.5;

// Integral over the polygon of a tube, convex and about 0, of exp(j w.x) times a polynomial, w rad a base cell.
float2 PolygonIntegral(Tube tube, float2 w, PieceField field)
{
    uint count = CornersOf(tube);
    float2 corners[5] = { tube.Corners01.xy, tube.Corners01.zw, tube.Corners23.xy, tube.Corners23.zw, tube.Corner4 };
    float2 sum = 0.0;
    float area = 0.0, reach = 0.0;
    uint i;
    [loop]
    for (i = 0; i < count; i++)
        reach = max(reach, dot(corners[i], corners[i]));
    bool isSmall = dot(w, w) * reach < MAX_POWERS_PHASE * MAX_POWERS_PHASE;
    [loop]
    for (i = 0; i < count; i++)
    {
        float2 a = corners[i], b = corners[i + 1 == count ? 0 : i + 1], edge = b - a;
        float twice = a.x * b.y - a.y * b.x;
        area += twice;
        if (isSmall)
            sum += twice * TriangleIntegral(field, a, b, w);
        else
            sum += (w.x * edge.y - w.y * edge.x) * EdgeMean(field, a, b, w);
    }
    // The polygon may go round either way.
    return area < 0.0 ? -sum : sum;
}

// What a tube radiates at a wave number, beside its phase.
struct TubeShape
{
    float2 Integral;       // of exp(j phase) over the piece, base cells; of an edge m
    float2 Factor;         // that the coefficients do not contain
    float Scale;           // S of an error of p.C times area, 1/m
    float Cancelled;       // of a square: the part of its area that its phase cancels
};

// w: k times the gradient, rad a base cell.
TubeShape ShapeOf(Tube tube, float k, float2 w)
{
    uint count = CornersOf(tube);
    bool isEdge = count == EDGE_CORNERS;
#ifdef GLINT_AMPLITUDE
    bool isPlain = true;
#else
    bool isPlain = isEdge;
#endif
    TubeShape shape;
    // - j k / sqrt(4 pi), which the coefficients of edges contain
    shape.Scale = isPlain ? 1.0 : k / SQRT_4_PI;
    shape.Factor = isPlain ? float2(1.0, 0.0) : float2(0.0, -1.0);
    shape.Cancelled = 0.0;
    if (isEdge)
        shape.Integral = tube.Corners01.x
            * MeansOf(0.5 * tube.Corners01.x * w.x, k * tube.Corners01.y).Wave;
    else if (count == 0)
    {
        float side = tube.Corners01.x;
        shape.Integral = side * side * SquareIntegral(0.5 * side * w, k * tube.Corners01.yzw, tube.Corners23);
        shape.Cancelled = max(0.0, 1.0 - length(shape.Integral) / (side * side));
    }
    else
    {
        PieceField field;
        field.Mean = 1.0;
        field.Bends = k * tube.Bends;
        field.Slope = float2(f16tof32(tube.Slope), f16tof32(tube.Slope >> 16));
        shape.Integral = PolygonIntegral(tube, w, field);
    }
    return shape;
}

// S of a tube at a frequency and time, in units.
struct Radiation
{
    float2 VV, HV, VH, HH;
    float Scale;           // S of an error of p.C times area, 1/m
    float2 Cancelled;      // of a square: the part of its area that its phase cancels, times exp(j phase) at the middle
};

// Adds what the currents of a piece change along it: see _TubeExtras. unit: S of an integral of 1.
void AddSlopes(inout Radiation radiation, Tube tube, uint index, float k, float2 w, float2 unit)
{
    float size = tube.Corners01.x;
    float2 x = 0.5 * size * w, alongU = 0.0, alongV = 0.0;
    if (CornersOf(tube) == EDGE_CORNERS)
        alongU = size * MeansOf(x.x, k * tube.Corners01.y).Along;
    else if (CornersOf(tube) == 0)
    {
        float3 bends = k * tube.Corners01.yzw;
        alongU = size * size * SquareIntegral(x, bends, float4(0.0, 1.0, 0.0, 0.0));
        alongV = size * size * SquareIntegral(x, bends, float4(0.0, 0.0, 1.0, 0.0));
    }
    else
    {
        PieceField field = (PieceField)0;
        field.Slope = float2(1.0, 0.0);
        alongU = PolygonIntegral(tube, w, field);
        field.Slope = field.Slope.yx;
        alongV = PolygonIntegral(tube, w, field);
    }
    alongU = ComplexMul(alongU, unit);
    alongV = ComplexMul(alongV, unit);
    uint row = _ExtraRows * index + 1;
    float4 coPolarU = _TubeExtras[row], coPolarV = _TubeExtras[row + 1], crossPolarU = _TubeExtras[row + 2],
        crossPolarV = _TubeExtras[row + 3];
    radiation.VV += ComplexMul(alongU, coPolarU.xy) + ComplexMul(alongV, coPolarV.xy);
    radiation.HV += ComplexMul(alongU, crossPolarU.xy) + ComplexMul(alongV, crossPolarV.xy);
    radiation.VH += ComplexMul(alongU, crossPolarU.zw) + ComplexMul(alongV, crossPolarV.zw);
    radiation.HH += ComplexMul(alongU, coPolarU.zw) + ComplexMul(alongV, coPolarV.zw);
}

Radiation RadiationOf(Tube tube, uint index, float4 waveNumber)
{
    float k = waveNumber.x;
    DoubleFloat turnsPerMetre = MakeDoubleFloat(waveNumber.y, waveNumber.z), phase = Mul(turnsPerMetre, tube.Phase);
    float2 w = k * tube.Gradient;
#ifndef GLINT_AMPLITUDE
    if (_IsMoving != 0)
    {
        float3 rate = _TubeExtras[_ExtraRows * index].xyz;
        phase = Add(phase, Mul(Mul(turnsPerMetre, waveNumber.w), rate.z));
        w += k * waveNumber.w * rate.xy;
    }
#endif
    TubeShape shape = ShapeOf(tube, k, w);
    float2 phasor = Phasor(PartOfTurn(phase));
    float2 wave = _UnitsPerMetre * shape.Scale * ComplexMul(ComplexMul(shape.Integral, phasor), shape.Factor);
    Radiation radiation;
    radiation.Cancelled = shape.Cancelled * phasor;
    radiation.VV = ComplexMul(wave, tube.CoPolar.xy);
    radiation.HV = ComplexMul(wave, tube.CrossPolar.xy);
    radiation.VH = ComplexMul(wave, tube.CrossPolar.zw);
    radiation.HH = ComplexMul(wave, tube.CoPolar.zw);
    radiation.Scale = shape.Scale;
#ifndef GLINT_AMPLITUDE
    if (HasChanges(tube))
        AddSlopes(radiation, tube, index, k, w, _UnitsPerMetre * shape.Scale * ComplexMul(phasor, shape.Factor));
#endif
    return radiation;
}

// Of a squared error and that of a bent phase, in units.
float SquaresOf(float error, float2 bent)
{
    float squares = error * error + dot(bent, bent) / (_UnitsPerMetre * _UnitsPerMetre);
    return min(_UnitsPerSquareMetre * squares, MAX_ERROR_UNITS);
}

void AccumulateS(inout Sum sums[TUBE_SUM_COUNT], Radiation radiation, inout uint overflow)
{
    Accumulate(sums[0], sums[1], radiation.VV, overflow);
    Accumulate(sums[2], sums[3], radiation.HV, overflow);
    Accumulate(sums[4], sums[5], radiation.VH, overflow);
    Accumulate(sums[6], sums[7], radiation.HH, overflow);
}

// S of the error by a tube's bent phase, in units: of the one of two polarisations with the larger S. error: of a piece, m.
// Errors of bent phases may add up or not. At a silhouette, where the phase runs fast, a linear one errs to the same side in
// each cell.
float2 BentS(float bent, float2 first, float2 second, float error, float2 cancelled)
{
    return bent * ((dot(first, first) > dot(second, second) ? first : second) + _UnitsPerMetre * error * cancelled);
}

// Adds S of a tube, and its errors.
void AccumulateTube(inout Sum sums[TUBE_SUM_COUNT], Tube tube, Radiation radiation, inout uint overflow)
{
    AccumulateS(sums, radiation, overflow);
    float2 errors = tube.Error * radiation.Scale * MagnitudesOf(tube),
        bent = BentS(tube.Bent, radiation.VV, radiation.HH, errors.x, radiation.Cancelled),
        crossBent = BentS(tube.Bent, radiation.HV, radiation.VH, errors.y, radiation.Cancelled);
    Accumulate(sums[8], sums[9], bent, overflow);
    Accumulate(sums[10], SquaresOf(errors.x, bent), overflow);
    Accumulate(sums[11], sums[12], crossBent, overflow);
    Accumulate(sums[13], SquaresOf(errors.y, crossBent), overflow);
}

// The tubes of a group: the first one, and the end.
uint2 TubesOf(uint3 group)
{
    uint first = (group.x + group.y * GROUPS_A_ROW) * TUBES_A_GROUP;
    return uint2(first, min(first + TUBES_A_GROUP, min(_Sums[TUBE_COUNT], _ListCapacity.x)));
}

void Clear(out Sum sums[TUBE_SUM_COUNT])
{
    for (uint i = 0; i < TUBE_SUM_COUNT; i++)
        sums[i] = NoSum();
}

static const uint NO_SLOT = 0xffffffff;

// Adds the sums of a thread to those of a slot of all poses.
void AddSums(uint slot, uint frequency, uint copy, Sum sums[TUBE_SUM_COUNT], uint overflow)
{
    if (slot == NO_SLOT)
        return;
    uint first = TUBE_SUMS + ((copy * _PoseCount * _SlotCount + slot) * _FrequencyCount + frequency) * TUBE_SUM_WORDS;
    for (uint sum = 0; sum < TUBE_SUM_COUNT; sum++)
        AddWords(first + SUM_S + 2 * sum, 2, sums[sum].Lower, sums[sum].Upper, 0);
    if (overflow != 0)
        InterlockedOr(_Sums[first + SUM_TUBE_OVERFLOW], 1);
}

[numthreads(GLINT_GROUP, 1, 1)]
void TubeSums(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint frequency = group.z * _FrequenciesAGroup + thread % _FrequenciesAGroup;
    uint share = thread / _FrequenciesAGroup, shares = GLINT_GROUP / _FrequenciesAGroup;
    uint2 tubes = TubesOf(group);
    uint copy = (group.x + group.y * GROUPS_A_ROW) % _SumCopies;
    if (frequency >= _FrequencyCount)
        return;
    float4 waveNumber = _WaveNumbers[frequency];
    [loop]
    for (uint slot = 0; slot < _SlotCount; slot++)
    {
        Sum sums[TUBE_SUM_COUNT];
        Clear(sums);
        uint overflow = 0, held = NO_SLOT;
        [loop]
        for (uint i = tubes.x + share; i < tubes.y; i += shares)
        {
            Tube tube = _Tubes[i];
            uint slotOfAll = tube.Tag & 0xff;
            if (slotOfAll % _SlotCount != slot)
                continue;
            // Tubes of a pose lie together: its sums change seldom.
            if (slotOfAll != held)
            {
                AddSums(held, frequency, copy, sums, overflow);
                Clear(sums);
                overflow = 0;
                held = slotOfAll;
            }
            AccumulateTube(sums, tube, RadiationOf(tube, i, waveNumber), overflow);
        }
        AddSums(held, frequency, copy, sums, overflow);
    }
}

uint4 _Parts;                              // receiver; frequency; first word of the parts; part of no bounce

// Sums what the tubes radiate at one receiver and frequency by their parts: the triangle or edges, and the bounce.
// TubeSums has refused contributions that are too large.
[numthreads(GLINT_GROUP, 1, 1)]
void TubeParts(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint2 tubes = TubesOf(group);
    if (group.z > 0)
        return;
    [loop]
    for (uint i = tubes.x + thread; i < tubes.y; i += GLINT_GROUP)
    {
        Tube tube = _Tubes[i];
        if ((tube.Tag & 0xff) % _ReceiverCount != _Parts.x)
            continue;
        Sum sums[TUBE_SUM_COUNT];
        Clear(sums);
        uint overflow = 0;
        AccumulateS(sums, RadiationOf(tube, i, _WaveNumbers[_Parts.y]), overflow);
        uint2 parts = uint2(_TubeParts[i], _Parts.w + BounceOf(tube));
        for (uint sum = 0; sum < PART_WORDS / 2; sum++)
        {
            AddWords(_Parts.z + parts.x * PART_WORDS + 2 * sum, 2, sums[sum].Lower, sums[sum].Upper, 0);
            AddWords(_Parts.z + parts.y * PART_WORDS + 2 * sum, 2, sums[sum].Lower, sums[sum].Upper, 0);
        }
    }
}

#endif
