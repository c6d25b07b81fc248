#ifndef GLINT_SCREEN_SEA_FILE
#define GLINT_SCREEN_SEA_FILE

#include "SeaMarch.hlsl"
#include "SeaSigma.hlsl"
#include "ScreenPattern.hlsl"

// The diffuse echo of a sea's height field: one thread a facet, some facets a cell. A facet stands for the sea in its
// part of the cell, with the slope of the field at its middle.

float4 _ScreenSea;                         // from bearing to the sea's rotation about Y, turns; facets of a cell; vertical
                                           // acceleration below which a crest breaks, m/s2
uint _ScreenSeaSeed;                       // of the speckle
float4 _ScreenSeaCorner;                   // corner of a grid cell against the wind: 0 or 1 along x and z; polarisation of
                                           // Sigma0: 0 VV, 2 HH; factor of the field

// Clearance of a shadow ray's start, m: bilinear heights differ from the facets', and float32 rounds 20 km to 1 mm.
static const float SEA_CLEARANCE = 0.01;

// Cells of speckle, apart from those of noise and rain.
static const int SEA_SPECKLE = 0x40000000;

// Direction of a bearing in the sea's frame: x, z.
float2 SeaDirection(float turns)
{
    turns += _ScreenSea.x;
    return Phasor(turns - floor(turns)).yx;
}

struct ScreenFacet
{
    float3 Normal;
    bool IsBreaking;
};

// The triangle of the field's mesh at a position.
ScreenFacet FacetAt(float2 position)
{
    float2 cells = SeaCellsOf(0, position), corner = floor(cells), within = cells - corner;
    float4 heights = SeaPatch(0, corner);
    float2 slope = _SeaCascades[0].y * (within.x + within.y < 1.0 ? heights.yz : heights.yz + heights.w);
    uint2 crest = (uint2)((int2)corner + (int2)_ScreenSeaCorner.xy) & (SEA_SIDE - 1);
    ScreenFacet facet;
    facet.Normal = normalize(float3(-slope.x, 1.0, -slope.y));
    facet.IsBreaking = _SeaPoints[crest.y * SEA_SIDE + crest.x].Acceleration < _ScreenSea.z;
    return facet;
}

// Sigma0 of a facet in the radar's polarisation.
float SigmaOf(ScreenFacet facet, float3 toRadar)
{
    float3 v = normalize(float3(0.0, 1.0, 0.0) - toRadar.y * toRadar);
    float3 sigma = BraggSigma(facet.Normal, toRadar, v, 0.0);
    float smooth = (_ScreenSeaCorner.z > 0.0 ? sigma.z : sigma.x) + SpecularSigma(facet.Normal, toRadar);
    return facet.IsBreaking ? BreakingSigma(saturate(toRadar.y)).x : smooth;
}

#include "ScreenSeaLevels.hlsl"

[numthreads(64, 1, 1)]
void ScreenSea(uint3 id : SV_DispatchThreadID)
{
    float depth = _ScreenEcho.x / _ScreenSea.y, range = (id.x + 0.5) * depth, height = _SeaRadar.y;
    uint cell = id.x / (uint)_ScreenSea.y, spoke = SpokeAt(id.y);
    if (cell >= _ScreenSize.y || range <= height)
        return;
    float ground = sqrt(range * range - height * height), width = TWO_PI / _ScreenSize.x;
    // Waves only shorten what the earth leaves.
    float2 highest = max(0.0, float2(height, SeaReach().y) - SeaReach().x);
    if (ground > (sqrt(highest.x) + sqrt(highest.y)) * rsqrt(_SeaRadar.w))
        return;
    float2 direction = SeaDirection((float)spoke / _ScreenSize.x), position = _SeaRadar.xz + ground * direction;
    // The vertical at the facet is turned by the curvature of the earth.
    float drop = _SeaRadar.w * ground * ground, rise = height - SeaHeight(position) - drop;
    float3 toRadar = normalize(float3(-ground * direction.x, rise, -ground * direction.y));
    ScreenFacet facet = FacetAt(position);
    if (dot(facet.Normal, toRadar) <= 0.0 || !SeesSeaRadar(position, SEA_CLEARANCE))
        return;
    float sigma = SigmaOf(facet, toRadar) * LevelOf((float)spoke / _ScreenSize.x, (height - drop) / range)
        * range * width * depth / facet.Normal.y;
    // "rise" is the antenna's height over the facet's horizontal plane; the facet is lower than the antenna's plane by
    // two drops more.
    float elevation = -atan((rise + 2.0 * drop) / ground);
    float field = ElevationField(elevation) * exp(-_RainLoss * range);
    float amplitude = _ScreenSeaCorner.w * _ScreenEcho.y * field * field * sqrt(sigma) / (range * range);
    // Speckle decorrelates within a tenth of a second, long before the next turn.
    float2 number = SpeckleAt(int2(SEA_SPECKLE + (int)id.x, spoke), _ScreenSeaSeed, TurnAt(id.y)).xy;
    AddEcho(spoke, cell, amplitude * number);
}

// Whether a wave is before a place. offset: from the antenna to the east, up and to the north, m.
bool IsBehindWaves(float3 offset)
{
    float2 x = SeaDirection(0.25), z = SeaDirection(0.0), ground = offset.x * x + offset.z * z;
    float3 bent = float3(ground.x, offset.y - _SeaRadar.w * dot(ground, ground), ground.y);
    float reach = length(bent);
    return MarchSea(_SeaRadar.xyz, bent / reach, reach).IsHit;
}

// Points that the waves may hide.
[numthreads(64, 1, 1)]
void ScreenPointsOverSea(uint3 id : SV_DispatchThreadID)
{
    if (id.x >= _ScreenPointCount)
        return;
    ScreenPoint echo = _ScreenPoints[id.x];
    if (!IsInSlice(echo))
        return;
    if (!IsBehindWaves(echo.Position))
        AddEcho(echo.Spoke, echo.Cell, echo.Field);
}

#endif
