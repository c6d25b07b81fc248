#ifndef GLINT_PATH
#define GLINT_PATH

#include "Surface.hlsl"

// A ray on its way, about the middle of the scene.
struct Path
{
    Real3 LastHit;        // m; before the first hit the start
    Real3 Direction;      // unit vector
    // where the next search begins, just before the last hit: in float32 on the way to it, else on the way on
    float3 Start;
    uint2 ExcludedTriangle;  // the triangle last hit
    float PositionError;     // in float32: how far beside its place in truth the last hit may be, m
    uint Bounces;
    Real RelativeLength;  // length up to the last hit less _OriginDepth, m
    bool IsCandidate;     // received; in float32: it may be, or nobody can tell
    Real WayBack;         // then from the last hit to the receiver's plane, m
};

// The number of a ray's place in the picture where x and y begin;
// exact, as are the halves and eighths of rays that are added.
Real3 AtPixel(float2 pixel, float4 value, float4 valueLo, float4 dx, float4 dxLo, float4 dy, float4 dyLo)
{
    Real3 across = Mul(MakeReal3(dx.xyz, dxLo.xyz), pixel.x),
        along = Mul(MakeReal3(dy.xyz, dyLo.xyz), pixel.y);
    return Add(MakeReal3(value.xyz, valueLo.xyz), Add(across, along));
}

// The ray through a place in the picture, in rays from _ReferencePixel.
Path BeginPath(float2 pixel)
{
    Real3 direction =
        AtPixel(pixel, _Direction, _DirectionLo, _DirectionDx, _DirectionDxLo, _DirectionDy, _DirectionDyLo);
    Real size = Sqrt(Dot(direction, direction));
    Path path = (Path)0;
    path.LastHit = AtPixel(pixel, _Origin, _OriginLo, _OriginDx, _OriginDxLo, _OriginDy, _OriginDyLo);
    path.Direction = Mul(direction, Div(MakeReal(1.0, 0.0), size));
    path.Start = Rounded(path.LastHit);
    path.ExcludedTriangle = NO_INSTANCE;
    path.RelativeLength = Mul(MakeReal(_OriginDepth.x, _OriginDepth.y), Sub(size, MakeReal(1.0, 0.0)));
    return path;
}

// True if a place, from the receiver's middle, is within half its size along an axis.
bool IsWithin(Real3 position, Real3 axis, float2 halfSize, float positionError)
{
    Real there = Dot(position, axis), half = MakeReal(halfSize.x, halfSize.y);
    return Rounded(Sub(there, half)) <= positionError && Rounded(Add(there, half)) >= -positionError;
}

// True if a ray meets the receiver's rectangle, travelling against its axis. The receiver is no obstacle:
// only rays after a bounce are asked.
bool MeetsReceiver(Real3 origin, Real3 direction, out Real distance)
{
    Real3 centre = MakeReal3(_ReceiverCentre.xyz, _ReceiverCentreLo.xyz),
        forward = MakeReal3(_ReceiverForward.xyz, _ReceiverForwardLo.xyz);
    distance = ToPlane(origin, direction, centre, forward);
    Real3 position = Sub(Add(origin, Mul(direction, distance)), centre);
    // places are as far off as the directions that led there
    float positionError = DIRECTION_ERROR * (Rounded(distance) + _SceneCentreExtent.w);
    return Rounded(Dot(direction, forward)) < 0.0 && Rounded(distance) > 0.0
        && IsWithin(position, MakeReal3(_ReceiverRight.xyz, _ReceiverRightLo.xyz), _ReceiverHalfSize.xy, positionError)
        && IsWithin(position, MakeReal3(_ReceiverUp.xyz, _ReceiverUpLo.xyz), _ReceiverHalfSize.zw, positionError);
}

// Follows a ray to its next bounce; false if there is none:
// it is received, leaves the scene or has made its last bounce.
// FirstEntryPoint: where _EntryPoints says where the search of the first segment begins.
bool Advance(inout Path path, uint firstEntryPoint)
{
    Real toReceiver;
    bool meetsReceiver = MeetsReceiver(path.LastHit, path.Direction, toReceiver) && path.Bounces > 0;
    bool isLast = path.Bounces == _MaxBounces;
    if (isLast && !meetsReceiver && (_Culling & CULL_LAST) != 0)
        return false;
#ifndef GLINT_REFINE
    float3 direction = path.Direction;
#endif
    float reach = meetsReceiver && (_Culling & CULL_REACH) != 0 ? Rounded(toReceiver) : MISS;
    Hit hit = ClosestHit(path.Start, path.LastHit, path.Direction, reach,
        path.Bounces == 0 ? firstEntryPoint : NO_ENTRY_POINTS, path.ExcludedTriangle, path.Bounces, path.PositionError);
    if (meetsReceiver && Rounded(Sub(toReceiver, HitDistance(hit))) <= 0.0)
    {
        path.IsCandidate = true;
        path.WayBack = toReceiver;
        return false;
    }
#ifdef GLINT_REFINE
    if (hit.Instance == NO_INSTANCE || isLast)
        return false;
#else
    if (isLast && !meetsReceiver)
        return false;
    // What keeps a last segment from the receiver may pass it in truth.
    path.IsCandidate = hit.AmbiguousDistance < MISS && hit.AmbiguousDistance <= hit.Distance || isLast;
    if (path.IsCandidate || hit.Instance == NO_INSTANCE)
        return false;
#endif

    // The length is measured from the surface to the surface, not from the start.
    // Next to an edge the other surface may lie behind by rounding.
    Surface surface = LoadSurface(hit, path.Start, path.LastHit, path.Direction);
#ifndef GLINT_REFINE
    path.IsCandidate = surface.IsNeedle;
    if (surface.IsNeedle)
        return false;
#endif
    if (Rounded(surface.Distance) > 0.0)
    {
        path.RelativeLength = Add(path.RelativeLength, surface.Distance);
        path.LastHit = Add(path.LastHit, Mul(path.Direction, surface.Distance));
    }
    path.Bounces++;
    path.ExcludedTriangle = NumberOf(hit.Instance, hit.Row, hit.Second);
#ifndef GLINT_REFINE
    path.PositionError += ERROR_PER_SEGMENT * (MaxComponent(abs(path.Start)) + hit.Distance);
    path.Start = StartBefore(surface, path.Start, direction, hit.Distance);
#endif
    Real share = Div(Dot(surface.Normal, path.Direction), Dot(surface.Normal, surface.Normal));
    path.Direction = UnitAgain(Sub(path.Direction, Mul(surface.Normal, Add(share, share))));
#ifdef GLINT_REFINE
    path.Start = Rounded(Sub(path.LastHit, Mul(path.Direction, POSITION_ERROR * _SceneCentreExtent.w)));
#endif
    return true;
}

Path FollowPath(float2 pixel, uint firstEntryPoint)
{
    Path path = BeginPath(pixel);
    [loop]
    while (Advance(path, firstEntryPoint))
    {
    }
    return path;
}

// Of a ray that is not received.
RayData DataOf(Path path, uint pixel)
{
    RayData ray = (RayData)0;
    ray.Pixel = pixel;
    ray.Bounces = path.Bounces;
    ray.Direction = Rounded(path.Direction);
    // Back from the start to the radar when nothing was hit.
    float back = path.Bounces > 0 ? 0.0 : _OriginDepth.x + Rounded(path.RelativeLength);
    ray.LastHit = Rounded(path.LastHit) - back * ray.Direction + _SceneCentreExtent.xyz;
    ray.PathLength = path.Bounces > 0 ? _OriginDepth.x + Rounded(path.RelativeLength) : 0.0;
    return ray;
}

#endif
