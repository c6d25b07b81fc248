#ifndef GLINT_RECEIVER_PLANE
#define GLINT_RECEIVER_PLANE

#include "Path.hlsl"

// Observes whether a path passes through the receiver's rectangle, and its length.

// True if a position, relative to the receiver's centre, is within half its size along an axis.
bool IsWithin(Real3 position, Real3 axis, float2 halfSize, float positionError)
{
    Real there = Dot(position, axis), half = MakeReal(halfSize.x, halfSize.y);
    return Rounded(Sub(there, half)) <= positionError && Rounded(Add(there, half)) >= -positionError;
}

// True if a ray meets the receiver's rectangle, travelling against its axis. Called only after a bounce, since the
// receiver is no obstacle.
bool MeetsReceiver(Real3 origin, Real3 direction, out Real distance)
{
    Real3 centre = MakeReal3(_ReceiverCentre.xyz, _ReceiverCentreLo.xyz),
        forward = MakeReal3(_ReceiverForward.xyz, _ReceiverForwardLo.xyz);
    distance = ToPlane(origin, direction, centre, forward);
    Real3 position = Sub(Add(origin, Mul(direction, distance)), centre);
    // positions have the error of the direction
    float positionError = DIRECTION_ERROR * (Rounded(distance) + _SceneCentreExtent.w);
    return Rounded(Dot(direction, forward)) < 0.0 && Rounded(distance) > 0.0
        && IsWithin(position, MakeReal3(_ReceiverRight.xyz, _ReceiverRightLo.xyz), _ReceiverHalfSize.xy, positionError)
        && IsWithin(position, MakeReal3(_ReceiverUp.xyz, _ReceiverUpLo.xyz), _ReceiverHalfSize.zw, positionError);
}

// Tests the segment from the last hit against the receiver, which may limit its traversal.
void LookAhead(inout Path path)
{
    path.MeetsReceiver = MeetsReceiver(path.Ray.Origin, path.Ray.Direction, path.WayBack) && path.Bounces > 0;
}

// Float32 searches farther than the receiver by this fraction of the scene's size, a bound of the errors of distances:
// so that it is sure of what is before the receiver.
static const float REACH_MARGIN = 3.0e-5;

// Reach of the query for the next hit, m; 0: no hit can change the result.
float Reach(Path path)
{
    if (IsLast(path) && !path.MeetsReceiver && (_Culling & CULL_LAST) != 0)
        return 0.0;
    float reach = Rounded(path.WayBack);
#ifndef GLINT_REFINE
    reach += REACH_MARGIN * _SceneCentreExtent.w;
#endif
    return path.MeetsReceiver && (_Culling & CULL_REACH) != 0 ? reach : MISS;
}

// False if the path ends: it is received, leaves the scene or has made its last bounce.
bool Observe(inout Path path, Hit hit)
{
    if (path.MeetsReceiver && Rounded(Sub(path.WayBack, hit.TraversalDistance)) <= 0.0)
        path.IsCandidate = true;
    else if (!IsLast(path))
        path.IsCandidate = hit.IsAmbiguous;
#ifndef GLINT_REFINE
    else
        path.IsCandidate = path.MeetsReceiver; // float32 may have hit an obstacle that the true ray passes
#endif
    return !path.IsCandidate && !IsLast(path) && !IsMiss(hit);
}

#endif
