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
    uint2 Leaving;        // the triangle last hit
    float Slack;          // in float32: how far beside its place in truth the last hit may be, m
    uint Bounces;
    Real Beyond;          // length up to the last hit less _StartDepth, m
    bool Returns;         // received; in float32: it may be, or nobody can tell
    Real WayBack;         // then from the last hit to the receiver's plane, m
};

// The number of a ray's place in the picture where x and y begin;
// exact, as are the halves and eighths of rays that are added.
Real3 AtPlace(float2 place, float4 middle, float4 middleRest, float4 right, float4 rightRest, float4 up, float4 upRest)
{
    Real3 across = Times(MakeReal3(right.xyz, rightRest.xyz), place.x),
        along = Times(MakeReal3(up.xyz, upRest.xyz), place.y);
    return Plus(MakeReal3(middle.xyz, middleRest.xyz), Plus(across, along));
}

// The ray through a place in the picture, in rays from _ReferenceRay.
Path BeginPath(float2 place)
{
    Real3 course = AtPlace(place, _Course, _CourseRest, _CourseRight, _CourseRightRest, _CourseUp, _CourseUpRest);
    Real size = Root(Dot(course, course));
    Path path = (Path)0;
    path.LastHit = AtPlace(place, _Start, _StartRest, _StartRight, _StartRightRest, _StartUp, _StartUpRest);
    path.Direction = Times(course, Over(MakeReal(1.0, 0.0), size));
    path.Start = Rounded(path.LastHit);
    path.Leaving = NO_INSTANCE;
    path.Beyond = Times(MakeReal(_StartDepth.x, _StartDepth.y), Minus(size, MakeReal(1.0, 0.0)));
    return path;
}

// True if a place, from the receiver's middle, is within half its size along an axis.
bool IsWithin(Real3 place, Real3 axis, float2 halfSize, float slack)
{
    Real there = Dot(place, axis), half = MakeReal(halfSize.x, halfSize.y);
    return Rounded(Minus(there, half)) <= slack && Rounded(Plus(there, half)) >= -slack;
}

// True if a ray meets the receiver's rectangle, travelling against its axis. The receiver is no obstacle:
// only rays after a bounce are asked.
bool MeetsReceiver(Real3 origin, Real3 direction, out Real distance)
{
    Real3 centre = MakeReal3(_ReceiverCentre.xyz, _ReceiverCentreRest.xyz),
        forward = MakeReal3(_ReceiverForward.xyz, _ReceiverForwardRest.xyz);
    distance = ToPlane(origin, direction, centre, forward);
    Real3 place = Minus(Plus(origin, Times(direction, distance)), centre);
    // places are as far off as the directions that led there
    float slack = DIRECTION_ERROR * (Rounded(distance) + _Middle.w);
    return Rounded(Dot(direction, forward)) < 0.0 && Rounded(distance) > 0.0
        && IsWithin(place, MakeReal3(_ReceiverRight.xyz, _ReceiverRightRest.xyz), _ReceiverHalfSize.xy, slack)
        && IsWithin(place, MakeReal3(_ReceiverUp.xyz, _ReceiverUpRest.xyz), _ReceiverHalfSize.zw, slack);
}

// Follows a ray to its next bounce; false if there is none:
// it is received, leaves the scene or has made its last bounce.
// FirstStart: where _Starts says where the search of the first segment begins.
bool Advance(inout Path path, uint firstStart)
{
    Real toReceiver;
    bool meetsReceiver = MeetsReceiver(path.LastHit, path.Direction, toReceiver) && path.Bounces > 0;
    bool isLast = path.Bounces == _MaxBounces;
    if (isLast && !meetsReceiver && (_Shortcuts & SHORTCUT_LAST) != 0)
        return false;
#ifndef GLINT_EXACT
    float3 direction = path.Direction;
#endif
    float reach = meetsReceiver && (_Shortcuts & SHORTCUT_REACH) != 0 ? Rounded(toReceiver) : MISS;
    Found found = FindNearest(path.Start, path.LastHit, path.Direction, reach,
        path.Bounces == 0 ? firstStart : NO_STARTS, path.Leaving, path.Bounces, path.Slack);
    if (meetsReceiver && Rounded(Minus(toReceiver, ToNearest(found))) <= 0.0)
    {
        path.Returns = true;
        path.WayBack = toReceiver;
        return false;
    }
#ifdef GLINT_EXACT
    if (found.Instance == NO_INSTANCE || isLast)
        return false;
#else
    if (isLast && !meetsReceiver)
        return false;
    // What keeps a last segment from the receiver may pass it in truth.
    path.Returns = found.InDoubt < MISS && found.InDoubt <= found.Distance || isLast;
    if (path.Returns || found.Instance == NO_INSTANCE)
        return false;
#endif

    // The length is measured from the surface to the surface, not from the start.
    // Next to an edge the other surface may lie behind by rounding.
    Surface surface = LoadSurface(found, path.Start, path.LastHit, path.Direction);
#ifndef GLINT_EXACT
    path.Returns = surface.IsNeedle;
    if (surface.IsNeedle)
        return false;
#endif
    if (Rounded(surface.Distance) > 0.0)
    {
        path.Beyond = Plus(path.Beyond, surface.Distance);
        path.LastHit = Plus(path.LastHit, Times(path.Direction, surface.Distance));
    }
    path.Bounces++;
    path.Leaving = NumberOf(found.Instance, found.Row, found.Second);
#ifndef GLINT_EXACT
    path.Slack += SLACK_A_SEGMENT * (Greatest(abs(path.Start)) + found.Distance);
    path.Start = StartBefore(surface, path.Start, direction, found.Distance);
#endif
    Real share = Over(Dot(surface.Normal, path.Direction), Dot(surface.Normal, surface.Normal));
    path.Direction = UnitAgain(Minus(path.Direction, Times(surface.Normal, Plus(share, share))));
#ifdef GLINT_EXACT
    path.Start = Rounded(Minus(path.LastHit, Times(path.Direction, SLACK * _Middle.w)));
#endif
    return true;
}

Path FollowPath(float2 place, uint firstStart)
{
    Path path = BeginPath(place);
    [loop]
    while (Advance(path, firstStart))
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
    float back = path.Bounces > 0 ? 0.0 : _StartDepth.x + Rounded(path.Beyond);
    ray.LastHit = Rounded(path.LastHit) - back * ray.Direction + _Middle.xyz;
    ray.PathLength = path.Bounces > 0 ? _StartDepth.x + Rounded(path.Beyond) : 0.0;
    return ray;
}

#endif
