#ifndef GLINT_SCREEN_TARGETS_FILE
#define GLINT_SCREEN_TARGETS_FILE

#include "ScreenEchoes.hlsl"
#include "WorkLists.hlsl"
#include "Identity.hlsl"
#include "Mirror.hlsl"
#include "ScreenLegs.hlsl"

// Echoes of meshes: one thread a point of a surface. The ray from the antenna to the point is followed as from mirrors.
// Roughness spreads the directions in which a bounce leaves over a Gaussian, and the radar gets the part towards it.

static const uint SCREEN_BOUNCES = 3;      // of a path

StructuredBuffer<SurfaceSample> _SurfaceSamples;
uint _SurfaceSampleCount;
// Per instance four rows: the matrix from the mesh's frame to the scene's centre; x: 1 for the own ship.
StructuredBuffer<float4> _SurfaceFrames;
// Per surface: square of twice the slope; gamma; share of the power that is reflected at normal incidence.
StructuredBuffer<float4> _SurfaceScatter;

// Largest exponent of the Gaussian of an echo of several bounces: weaker ones, by 65 dB, are left out.
static const float MAX_EXPONENT = 15.0;

// Of the incidence angle: a ray along a surface leaves it without spread.
static const float MIN_COSINE = 1.0e-4;

// Phases of points, apart from other numbers of the seed.
static const uint PHASE_HASH = 0x54475400;

float3 ToScene(SurfaceSample from)
{
    float4 position = float4(from.Position, 1.0);
    uint row = 4 * from.Instance;
    return float3(dot(_SurfaceFrames[row], position), dot(_SurfaceFrames[row + 1], position),
        dot(_SurfaceFrames[row + 2], position));
}

// What of the power that falls on a tube leaves it towards the radar: 4 pi p, per square metre of the tube's section.
// deviation: from the exit of the mirrors, rad.
float SpecularShare(float deviation, float spread)
{
    return 2.0 / spread * exp(-0.5 * deviation * deviation / spread);
}

// Angle between unit vectors.
float AngleBetween(float3 a, float3 b)
{
    return 2.0 * asin(saturate(0.5 * length(a - b)));
}

// Whether the radar sees the last hit of a path: it looks towards the radar, and no mesh is before it.
bool IsSeen(Path path, float3 normal, Leg leg)
{
    if (dot(normal, leg.Offset) >= 0.0 || IsBehindHorizon(leg))
        return false;
    Ray ray = path.Ray;
    float3 toAntenna = _ScreenAntenna.xyz - ray.Start;
    float reach = length(toAntenna);
    ray.Direction = toAntenna / reach;
    bool isAmbiguous;
    return !AnyHit(ray, reach, isAmbiguous);
}

// Adds the echo of a path that comes back from its last hit.
void AddPath(Path path, Leg first, Leg last, float section, uint spoke, uint number)
{
    float whole = first.Range + path.RelativeLength + last.Range, cells = ShownCell(0.5 * whole / _ScreenEcho.x);
    if (cells >= (float)_ScreenSize.y)
        return;
    float phase = SpeckleHash(uint4(number, path.Bounces, _ScreenSize.w, PHASE_HASH)).x / 4294967296.0
        + frac(whole * _ScreenWaves.x);
    float amplitude = _ScreenEcho.y * sqrt(section) * first.Gain * last.Gain * BeamBetween(first, last)
        * exp(-_RainLoss * path.RelativeLength);
    AddEcho(spoke, (uint)cells, amplitude * Phasor(frac(phase)));
}

// The path from the antenna along a leg.
Path PathAlong(Leg first)
{
    Path path = (Path)0;
    path.Ray.Origin = _ScreenAntenna.xyz;
    path.Ray.Start = path.Ray.Origin;
    path.Ray.Direction = first.Offset / first.Range;
    path.Ray.ExcludedTriangle = NOT_MET;
    path.Ray.DirectionError = ERROR_PER_SEGMENT;
    return path;
}

void FollowTarget(SurfaceSample from, Leg first, uint spoke, uint number)
{
    Path path = PathAlong(first);
    float reach = 1.001 * first.Range, area = 0.0, spread = 0.0, reflected = 1.0;
    bool isForeign = false;
    [loop]
    for (uint bounce = 0; bounce < SCREEN_BOUNCES; bounce++)
    {
        Hit hit = ClosestHit(path.Ray, reach, NO_ENTRY_POINTS, NOT_MET);
        if (IsMiss(hit))
            return;
        Identity identity = Identify(hit);
        // Something is before the point.
        if (bounce == 0 && (identity.Instance != from.Instance || identity.Triangle != from.Triangle))
            return;
        float4 scatter = _SurfaceScatter[identity.Surface];
        float cosine = max(MIN_COSINE, -dot(hit.Normal, path.Ray.Direction));
        isForeign = isForeign || _SurfaceFrames[4 * identity.Instance + 3].x == 0.0;
        MoveTo(path, hit);
        Scatter(path, hit);
        // A tilt across the plane of incidence turns the ray by less than one in it.
        spread += scatter.x * cosine;
        reflected *= scatter.z;
        Leg last = first;
        if (bounce == 0)
        {
            area = from.Area * cosine;
            path.RelativeLength = 0.0;
        }
        else
            last = LegTo(path.Ray.Origin);
        float deviation = AngleBetween(path.Ray.Direction, -last.Offset / last.Range);
        // A path of several bounces and its reverse have the same length: their fields add, which doubles the power.
        float section = area * reflected * SpecularShare(deviation, spread) * (bounce == 0 ? 1.0 : 2.0)
            + (bounce == 0 ? area * scatter.y : 0.0);
        bool isShown = isForeign && (bounce == 0 || 0.5 * deviation * deviation < MAX_EXPONENT * spread);
        if (isShown && bounce > 0)
            isShown = IsSeen(path, hit.Normal, last);
#if defined(GLINT_SCREEN_SEA)
        if (isShown)
            isShown = !IsBehindWaves(ToNorth(last.Offset));
#endif
        if (isShown)
            AddPath(path, first, last, section, spoke, number);
        reach = _ScreenEcho.x * _ScreenSize.y;
    }
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint number = IndexOf(group, thread);
    if (number >= _SurfaceSampleCount)
        return;
    SurfaceSample from = _SurfaceSamples[number];
    float3 position = ToScene(from);
    uint spoke = SpokeOf(TurnsTo(position - _ScreenAntenna.xyz));
    // Most points are on other spokes.
    if (!IsSpokeInSlice(spoke))
        return;
    Leg first = LegTo(position);
    if (first.Range > 0.0 && ShownCell(first.Range / _ScreenEcho.x) < (float)_ScreenSize.y && !IsBehindHorizon(first))
        FollowTarget(from, first, spoke, number);
}

#endif
