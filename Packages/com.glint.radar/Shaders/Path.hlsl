#ifndef GLINT_PATH
#define GLINT_PATH

#include "ClosestHit.hlsl"

// State of a path.
struct Path
{
    Ray Ray;              // the current segment
    uint Bounces;
    Real RelativeLength;  // path length up to the last hit less _OriginDepth, m
    bool MeetsReceiver;   // the segment meets the receiver unless it hits something
    Real WayBack;         // if so, distance from the last hit to the receiver's plane, m
    bool IsCandidate;     // received; in float32: possibly received, or undecided
#ifdef GLINT_REFINE
    uint FirstMet;        // first of its triangles in _Met
    bool IsKnown;         // all of them are there
#else
    bool IsSure;          // float32 is sure of every triangle that the path has met
    uint SureBounces;     // bounces off the first ones of which it is sure
#endif
};

static const uint NOTHING_MET = 0xffffffff;

// Evaluates a linear function of the pixel. Pixels are exact: whole rays, halves or eighths.
Real3 AtPixel(float2 pixel, float4 value, float4 valueLo, float4 dx, float4 dxLo, float4 dy, float4 dyLo)
{
    Real3 across = Mul(MakeReal3(dx.xyz, dxLo.xyz), pixel.x),
        along = Mul(MakeReal3(dy.xyz, dyLo.xyz), pixel.y);
    return Add(MakeReal3(value.xyz, valueLo.xyz), Add(across, along));
}

// A ray. Direction: a unit vector; relativeLength: of the path at its origin.
Path BeginPath(Real3 origin, Real3 direction, Real relativeLength)
{
    Path path = (Path)0;
    path.Ray.Origin = origin;
    path.Ray.Direction = direction;
    path.Ray.Start = Rounded(origin);
    path.Ray.ExcludedTriangle = NO_INSTANCE;
    path.Ray.DirectionError = ERROR_PER_SEGMENT;
#ifdef GLINT_REFINE
    path.FirstMet = NOTHING_MET;
#else
    path.IsSure = true;
#endif
    path.RelativeLength = relativeLength;
    return path;
}

// The ray through a point of the picture, in rays from _ReferencePixel.
Path BeginPath(float2 pixel)
{
    Real3 direction =
        AtPixel(pixel, _Direction, _DirectionLo, _DirectionDx, _DirectionDxLo, _DirectionDy, _DirectionDyLo);
    Real size = Sqrt(Dot(direction, direction));
    return BeginPath(AtPixel(pixel, _Origin, _OriginLo, _OriginDx, _OriginDxLo, _OriginDy, _OriginDyLo),
        Mul(direction, Div(MakeReal(1.0, 0.0), size)),
        Mul(MakeReal(_OriginDepth.x, _OriginDepth.y), Sub(size, MakeReal(1.0, 0.0))));
}

bool IsLast(Path path)
{
    return path.Bounces == _MaxBounces;
}

// Moves a path to its hit. Lengths are measured from surface to surface, not from the starts of traversals.
void MoveTo(inout Path path, Hit hit)
{
    // Next to an edge rounding may put the other surface behind.
    if (Rounded(hit.Distance) > 0.0)
    {
        path.RelativeLength = Add(path.RelativeLength, hit.Distance);
        path.Ray.Origin = Add(path.Ray.Origin, Mul(path.Ray.Direction, hit.Distance));
    }
    path.Bounces++;
    path.Ray.ExcludedTriangle = NumberOf(hit.Instance, hit.Row, hit.Second);
#ifndef GLINT_REFINE
    path.Ray.PositionError += ERROR_PER_SEGMENT * (MaxComponent(abs(path.Ray.Start)) + hit.TraversalDistance);
    path.Ray.DirectionError = ERROR_PER_SEGMENT * (1 + path.Bounces);
    path.Ray.Start = hit.NextStart;
#endif
}

// Continues from the last hit in another direction, a unit vector up to rounding.
void Leave(inout Path path, Real3 direction)
{
    path.Ray.Direction = UnitAgain(direction);
#ifdef GLINT_REFINE
    path.Ray.Start =
        Rounded(Sub(path.Ray.Origin, Mul(path.Ray.Direction, POSITION_ERROR * _SceneCentreExtent.w)));
#endif
}

// The data of a ray that is not received.
RayData DataOf(Path path, uint pixel)
{
    RayData ray = (RayData)0;
    ray.Pixel = pixel;
    ray.Bounces = path.Bounces;
    ray.Direction = Rounded(path.Ray.Direction);
    // For a miss, from the ray's origin back to the radar.
    float back = path.Bounces > 0 ? 0.0 : _OriginDepth.x + Rounded(path.RelativeLength);
    ray.LastHit = Rounded(path.Ray.Origin) - back * ray.Direction + _SceneCentreExtent.xyz;
    ray.PathLength = path.Bounces > 0 ? _OriginDepth.x + Rounded(path.RelativeLength) : 0.0;
    return ray;
}

#endif
