#ifndef GLINT_SEA_FACETS
#define GLINT_SEA_FACETS

#include "Footprint.hlsl"
#include "PhysicalOptics.hlsl"
#include "SeaSigma.hlsl"
#include "Speckle.hlsl"
#include "Sums.hlsl"

// The diffuse echo of a sea (Documentation~/clutter.md): the waves that its mesh leaves out scatter back from each facet
// that the radar sees. One thread a facet, or a group of facets far from the radar, and one shadow ray.

// GLINT_SEA_FACET: a triangle of a tile, in the tile's frame (Runtime/Clutter/SeaFacet.cs).
struct SeaFacet
{
    float3 Centre;         // m
    uint IsBreaking;       // 1: it breaks
    float3 Section;        // normal times area, m2
    float LogWind;         // natural logarithm of the wind in its gust over the mean wind
};

// GLINT_SEA_TILE: an instance of the tile (Runtime/Clutter/SeaFacet.cs).
struct SeaTile
{
    float4 X, Y, Z;        // rows of the transform to the scene relative to its centre, m
    float3 SectionX;       // rows of the transform of sections
    int Number;            // of the tile in its sea, for speckle
    float3 SectionY;
    uint Unused;
    float3 SectionZ;
    uint Unused2;
};

StructuredBuffer<SeaFacet> _SeaFacets;
StructuredBuffer<SeaTile> _SeaTiles;
StructuredBuffer<float4> _SeaVelocities;   // of the facets of a tile, in its frame, m/s; only if _SeaElapsed is not 0
float _SeaElapsed;                         // time since the moment of the mesh, s
float _SeaWaveNumber;                      // of the Bragg waves' motion: the same for all frequencies of a band
float2 _SeaTurns;                          // of the echo's phase for each metre of range: the first 12 bits, and the rest
int _SeaMoment;                            // whole coherence times
uint4 _SeaRange;                           // items of a tile; first and number of this dispatch; seed of the speckle

// An item is a facet of a tile near the radar; of one that is far a group of cells, or a breaking facet.
StructuredBuffer<uint> _SeaBreaking;       // numbers of the breaking facets of a tile
uint4 _SeaGroup;                           // cells along a side of a group, a power of 2; groups and cells along a side of
                                           // the tile; first tile of this dispatch
float4 _SeaTime;                           // time, s: a whole number near that of the mesh, and the rest; fraction of a
                                           // coherence time; exponent of ApproachShare

// Cells of the ground whose echoes are summed apart. Each cell has copies of its sums, which reduce contention.
float4 _SeaCellX, _SeaCellY;               // place in cells: dot(xyz, position) + w
uint4 _SeaCells;                           // cells by x and y; copies

// Sums, of three words each, of which fields and areas take two. Those of all cells and copies lie side by side: neighbouring threads, which add to neighbouring
// copies, then share lines of memory.
static const uint SEA_FIELD = 0;           // S of VV, HV and HH: real and imaginary part
static const uint SEA_POWER = 6;           // without speckle: VV, HV, HH
static const uint SEA_AREA = 9;            // of the mean sea below the facets,
static const uint SEA_LIT_AREA = 10;       // and below those that the radar sees
static const uint SEA_OVERFLOW = 11;       // 1: an echo was too large for a sum
static const float SEA_FIELD_UNITS = 16777216.0;       // a metre
static const float SEA_POWER_UNITS = 1099511627776.0;  // a square metre
static const float SEA_AREA_UNITS = 1048576.0;         // a square metre
static const uint SEA_SUM_WORDS = 3;
static const float SEA_MAX_UNITS = 4.0e18;             // of two words
static const float SEA_MAX_POWER_UNITS = 1.0e28;       // of the upper two of three words

// Of Core/Clutter/ClutterMotion.cs.
static const float GRAVITY = 9.81;         // m/s2
static const float TENSION = 7.2e-5;       // m3/s2

// In place of the time of speckle, for the choice of a facet of a group.
static const uint SEA_CHOICE = 0x80000001;

// The facet that an item stands for, and the number of facets that it counts for. Of a group it is one of its facets, by a
// hash of group and tile, for those that do not break; breaking facets are their own items.
uint FacetOf(uint item, SeaTile tile, out float count)
{
    count = 1.0;
    uint side = _SeaGroup.x, groups = _SeaGroup.y * _SeaGroup.y;
    if (side == 1)
        return item;
    if (item >= groups)
        return _SeaBreaking[item - groups];
    uint4 words = SpeckleHash(uint4(item, asuint(tile.Number), _SeaRange.w + side, SEA_CHOICE)) >> 16;
    uint2 group = uint2(item % _SeaGroup.y, item / _SeaGroup.y), cell = side * group + (words.xy & (side - 1));
    uint facet = 2 * (cell.y * _SeaGroup.z + cell.x) + (words.z & 1);
    count = _SeaFacets[facet].IsBreaking != 0 ? 0.0 : 2.0 * side * side;
    return facet;
}

// The speckle of a facet now: Bragg waves that run towards the radar, and away from it.
float2 SpeckleOf(uint facet, SeaTile tile, Receiver radar)
{
    float4 numbers = SpeckleBetween(int2(facet, tile.Number), _SeaRange.w, _SeaMoment, _SeaTime.z);
    float windCosine = ToWind(radar.Direction).x, sine = sqrt(saturate(1.0 - radar.Direction.y * radar.Direction.y));
    float ratio = max(0.0, 1.0 - windCosine) / max(1.0e-6, 1.0 + windCosine);
    float approaching = 1.0 / (1.0 + pow(ratio, _SeaTime.w));
    float bragg = 2.0 * _SeaWaveNumber * sine;
    float rate = sqrt(GRAVITY * bragg + TENSION * bragg * bragg * bragg);
    // Of large times the rounding is the same at each moment of a pose.
    float2 turn = ComplexMul(PhasorOf(rate * _SeaTime.x), PhasorOf(rate * _SeaTime.y));
    return sqrt(approaching) * ComplexMul(numbers.xy, turn)
        + sqrt(1.0 - approaching) * ComplexMul(numbers.zw, float2(turn.x, -turn.y));
}

// The phasor of a range out and back. Of a long range float32 has no phase: the product of the first bits is exact.
float2 WaveOver(float range)
{
    float first = asfloat(asuint(range) & 0xfffff000), turns = frac(_SeaTurns.x * first);
    return Phasor(frac(turns + _SeaTurns.x * (range - first) + _SeaTurns.y * range));
}

// No shadow ray is followed from a facet that looks away.
bool IsLit(float3 position, float3 normal, Receiver radar)
{
    if (dot(normal, radar.Direction) <= 0.0)
        return false;
    return IsInSight(position + _SeaWind.w * normal, (uint2)NO_INSTANCE, radar);
}

uint WordOf(uint sum, uint copy)
{
    return SEA_SUM_WORDS * (sum * _SeaCells.x * _SeaCells.y * _SeaCells.z + copy);
}

void AddSea(uint copy, uint sum, float value, float unitsPerValue)
{
    float units = round(value * unitsPerValue);
    if (IsNaN(units) || abs(units) > SEA_MAX_UNITS)
        InterlockedOr(_Sums[WordOf(SEA_OVERFLOW, copy)], 1);
    else
        AddUnits(WordOf(sum, copy), 2, units);
}

// Water just below a radar that looks far has a large power at the range of the phase centre, of which float32 has no digits in
// the lowest word.
void AddPower(uint copy, uint polarisation, float power)
{
    float units = round(power * SEA_POWER_UNITS);
    uint word = WordOf(SEA_POWER + polarisation, copy);
    if (IsNaN(units) || units > SEA_MAX_POWER_UNITS)
        InterlockedOr(_Sums[WordOf(SEA_OVERFLOW, copy)], 1);
    else if (units > SEA_MAX_UNITS)
        AddUnits(word + 1, 2, round(units / TWO_TO_32));
    else
        AddUnits(word, 3, units);
}

[numthreads(GLINT_GROUP, 1, 1)]
void SeaFacets(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread), number = _SeaRange.y + index;
    if (index >= _SeaRange.z)
        return;
    SeaTile tile = _SeaTiles[_SeaGroup.w + number / _SeaRange.x];
    float facets;
    uint facetNumber = FacetOf(number % _SeaRange.x, tile, facets);
    SeaFacet facet = _SeaFacets[facetNumber];
    float4 centre = float4(facet.Centre, 1.0);
    float3 position = float3(dot(tile.X, centre), dot(tile.Y, centre), dot(tile.Z, centre));
    float3 section = float3(dot(tile.SectionX, facet.Section), dot(tile.SectionY, facet.Section),
        dot(tile.SectionZ, facet.Section));
    section *= facets;
    int2 cell = (int2)floor(float2(dot(_SeaCellX.xyz, position) + _SeaCellX.w, dot(_SeaCellY.xyz, position) + _SeaCellY.w));
    float area = length(section);
    if (area == 0.0 || any(cell < 0) || any(cell >= (int2)_SeaCells.xy) || !IsInFootprint(position))
        return;
    uint copy = (cell.x + cell.y * _SeaCells.x) * _SeaCells.z + number % _SeaCells.z;
    float3 normal = section / area;
    Receiver radar = ReceiverFrom(_ReceiverCount, position);
    AddSea(copy, SEA_AREA, section.y, SEA_AREA_UNITS);
    if (!IsLit(position, normal, radar))
        return;
    AddSea(copy, SEA_LIT_AREA, section.y, SEA_AREA_UNITS);
    float3 sigma = BraggSigma(normal, radar.Direction, radar.V, facet.LogWind);
    sigma.xz += SpecularSigma(normal, radar.Direction);
    // Of the grazing angle on the mean sea, which is tilted far from the radar.
    float sine = dot(radar.Direction, float3(tile.SectionX.y, tile.SectionY.y, tile.SectionZ.y));
    if (facet.IsBreaking != 0)
        sigma = BreakingSigma(saturate(sine));
    if (_SeaLevelCount > 0)
        sigma *= LevelAt(sine, 0);
    float3 power = area * sigma * radar.Strength * radar.Strength * radar.Strength * radar.Strength;
    float2 wave = WaveOver(radar.Phase);
    if (_SeaElapsed != 0.0)
    {
        float3 velocity = _SeaVelocities[facetNumber].xyz;
        float nearer = _SeaElapsed * dot(radar.Direction,
            float3(dot(tile.X.xyz, velocity), dot(tile.Y.xyz, velocity), dot(tile.Z.xyz, velocity)));
        wave = ComplexMul(wave, PhasorOf(2.0 * _WaveNumber * nearer));
    }
    float2 field = ComplexMul(SpeckleOf(facetNumber, tile, radar), wave);
    [unroll]
    for (uint i = 0; i < 3; i++)
    {
        AddPower(copy, i, power[i]);
        AddSea(copy, SEA_FIELD + 2 * i, sqrt(power[i]) * field.x, SEA_FIELD_UNITS);
        AddSea(copy, SEA_FIELD + 2 * i + 1, sqrt(power[i]) * field.y, SEA_FIELD_UNITS);
    }
}

#endif
