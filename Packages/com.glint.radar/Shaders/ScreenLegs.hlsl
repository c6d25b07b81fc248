#ifndef GLINT_SCREEN_LEGS
#define GLINT_SCREEN_LEGS

#include "Trigonometry.hlsl"
#include "ScreenPattern.hlsl"

// The way from the antenna to a place of the scene: Core/Screen/ScreenGeometry.cs has the same of a point, in double
// precision.

float4 _ScreenAntenna;                     // position relative to the scene's centre, m; w: height above the sea
float4 _ScreenNorth;                       // cosine and sine of the rotation about Y from the scene's Z to north;
                                           // z: ln 2 over the square of the beam's width, 1/rad2
float4 _ScreenWaves;                       // x: 1 / wavelength, 1/m; y: amplitude of the sea's reflection; z: 1 / (2
                                           // effective earth radius), 1/m

// Halvings of the way to the point of the sea's reflection: as many as float32 has bits.
static const uint SEA_HALVINGS = 24;

struct Leg
{
    float3 Offset;         // from the antenna, m
    float Range;           // its length
    float Ground;          // its horizontal length
    float Turns;           // true bearing
    float Gain;            // field of the vertical pattern, the rain and the sea's interference one way, over range
};

// From the scene's axes to east, up, north.
float3 ToNorth(float3 v)
{
    return float3(v.x * _ScreenNorth.x - v.z * _ScreenNorth.y, v.y, v.x * _ScreenNorth.y + v.z * _ScreenNorth.x);
}

// True bearing, -0.5 to 0.5 turns.
float TurnsTo(float3 offset)
{
    float3 north = ToNorth(offset);
    return atan2(north.x, north.z) / TWO_PI;
}

uint SpokeOf(float turns)
{
    return (uint)(int)floor(turns * _ScreenSize.x + 0.5) & (_ScreenSize.x - 1);
}

float HeightOverTangent(float height, float distance)
{
    return height - _ScreenWaves.z * distance * distance;
}

// Magnitude of F: Core/Screen/SeaFactor.cs. A place below the mean level counts as on it.
float SeaInterference(float height, float ground)
{
    if (_ScreenWaves.y == 0.0 || _ScreenAntenna.w <= 0.0)
        return 1.0;
    height = max(height, 0.0);
    float near = 0.0, far = ground;
    for (uint halving = 0; halving < SEA_HALVINGS; halving++)
    {
        float middle = 0.5 * (near + far);
        bool isSteep = HeightOverTangent(_ScreenAntenna.w, middle) * (ground - middle)
            > HeightOverTangent(height, ground - middle) * middle;
        near = isSteep ? middle : near;
        far = isSteep ? far : middle;
    }
    float a = HeightOverTangent(_ScreenAntenna.w, near), b = HeightOverTangent(height, ground - near);
    float detour = a > 0.0 && b > 0.0
        ? 4.0 * a * b / (length(float2(ground, a + b)) + length(float2(ground, a - b))) : 0.0;
    return length(float2(1.0, 0.0) - _ScreenWaves.y * Phasor(frac(detour * _ScreenWaves.x)));
}

Leg LegTo(float3 position)
{
    Leg leg;
    leg.Offset = position - _ScreenAntenna.xyz;
    leg.Range = length(leg.Offset);
    leg.Ground = length(leg.Offset.xz);
    leg.Turns = TurnsTo(leg.Offset);
    float elevation = atan2(HeightOverTangent(leg.Offset.y, leg.Ground), leg.Ground);
    leg.Gain = ElevationField(elevation) * exp(-_RainLoss * leg.Range)
        * SeaInterference(_ScreenAntenna.w + leg.Offset.y, leg.Ground) / leg.Range;
    return leg;
}

float DistanceToHorizon(float height)
{
    return sqrt(max(0.0, height) / _ScreenWaves.z);
}

bool IsBehindHorizon(Leg leg)
{
    return leg.Ground > DistanceToHorizon(_ScreenAntenna.w) + DistanceToHorizon(_ScreenAntenna.w + leg.Offset.y);
}

// What the two ways of a Gaussian beam lose where a path comes back from another bearing than that to which it left.
float BeamBetween(Leg first, Leg last)
{
    float turns = first.Turns - last.Turns, angle = TWO_PI * (turns - round(turns));
    return exp(-_ScreenNorth.z * angle * angle);
}

#endif
