#ifndef GLINT_GEOMETRY
#define GLINT_GEOMETRY

#include "Types.hlsl"

// Distance of a miss, m.
static const float MISS = 3.0e38;

// Minimum magnitude of a direction's component: its inverse stays finite, and an axis-parallel ray on a box's face
// gives no 0 * infinity.
static const float MIN_COMPONENT = 1.0e-20;

// Factor on the distance at which a ray leaves a box, so that rounding loses no grazing ray: 16 float32 steps.
static const float LEAVE_LATER = 1.000002;

// Tests the bits. FXC takes !(a <= b) for b < a, and Metal's fast math assumes that there is no NaN.
bool IsNaN(float a)
{
    return (asuint(a) & 0x7fffffff) > 0x7f800000;
}

// A ray in the frame of a BVH; the direction is not normalised.
struct TraversalRay
{
    float3 Origin;
    float3 Direction;
    float3 Inverse;        // 1 / direction
    uint Axis;             // the direction's largest component
    float3 Shear;          // shears that axis into the ray's direction, and scales it to distances
    float PositionError;   // maximum distance between the float32 ray and the true ray at the origin,
    float DirectionError;  // and its growth per metre
};

// Permutes components so that the given axis is last.
float3 AxisLast(float3 v, uint axis)
{
    return axis == 0 ? v.yzx : axis == 1 ? v.zxy : v;
}

TraversalRay MakeTraversalRay(float3 origin, float3 direction, float positionError, float directionError)
{
    TraversalRay ray;
    ray.Origin = origin;
    ray.Direction = direction;
    float3 size = abs(direction);
    float3 inverse = 1.0 / max(size, MIN_COMPONENT);
    ray.Inverse = float3(direction.x < 0.0 ? -inverse.x : inverse.x, direction.y < 0.0 ? -inverse.y : inverse.y,
        direction.z < 0.0 ? -inverse.z : inverse.z);
    ray.Axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    float3 d = AxisLast(direction, ray.Axis);
    ray.Shear = float3(d.xy, 1.0) / d.z;
    ray.PositionError = positionError;
    ray.DirectionError = directionError;
    return ray;
}

// A corner in the ray's coordinates: x and y across the ray, z the distance along it. All triangles at a corner must
// get bit-identical coordinates: "precise" keeps the compiler from fusing operations in only some of them.
float3 AsSeen(TraversalRay ray, float3 corner)
{
    float3 p = AxisLast(corner - ray.Origin, ray.Axis);
    precise float3 seen = float3(p.x - ray.Shear.x * p.z, p.y - ray.Shear.y * p.z, ray.Shear.z * p.z);
    return seen;
}

// Edge function: twice the projected area of an edge and the ray. Its sign is the side on which the ray passes; it is
// correct or the result is 0, as the products are rounded before the comparison. Swapping the corners negates it
// exactly.
float SideOf(float3 a, float3 b)
{
    precise float side = a.x * b.y - a.y * b.x;
    return side;
}

// Rounding of a corner's coordinates across the ray: 4 float32 steps.
static const float SEEN_ROUNDING = 2.4e-7;

// Relative rounding of a distance interpolated between corners: 16 float32 steps.
static const float DISTANCE_ROUNDING = 1.0e-6;

float SumOfSizes(float2 v)
{
    return abs(v.x) + abs(v.y);
}

float MinComponent(float3 v)
{
    return min(v.x, min(v.y, v.z));
}

float MaxComponent(float3 v)
{
    return max(v.x, max(v.y, v.z));
}

// Distance to a triangle, from its corners in the ray's coordinates and the edge functions opposite to them; MISS
// outside. A ray through an edge or a corner, where an edge function is 0, is inside. AmbiguousDistance: lower bound of
// the true distance if an edge function is within its error, else MISS; MISS too where no refine pass follows.
// LowerDistance: lower bound of the true distance if the ray hits, else MISS. MaxEdgeError: bound of the errors of all edge
// functions.
float HitTriangle(float3 a, float3 b, float3 c, float3 sides, float positionError, float maxEdgeError,
    out float ambiguousDistance, out float lowerDistance)
{
    float3 distances = float3(a.z, b.z, c.z);
    float sum = sides.x + sides.y + sides.z;
    float toHit = dot(sides, distances) / sum;
    bool isInside = (MinComponent(sides) >= 0.0 || MaxComponent(sides) <= 0.0) && abs(sum) > 0.0;
    ambiguousDistance = MISS;
#ifndef GLINT_UNREFINED
    if (MinComponent(abs(sides)) <= maxEdgeError)
    {
        float3 edgeErrors =
            positionError * float3(SumOfSizes(c.xy - b.xy), SumOfSizes(a.xy - c.xy), SumOfSizes(b.xy - a.xy));
        bool mayBeInside = MinComponent(sides + edgeErrors) >= 0.0 || MaxComponent(sides - edgeErrors) <= 0.0;
        bool surelyInside = MinComponent(sides - edgeErrors) > 0.0 || MaxComponent(sides + edgeErrors) < 0.0;
        // Edge-on, rounding leaves no distance, and the ray may be collinear with edges far beside it: the bounds
        // decide.
        float2 lower = min(a.xy, min(b.xy, c.xy)), upper = max(a.xy, max(b.xy, c.xy));
        bool isBeside = max(lower.x, lower.y) > positionError || min(upper.x, upper.y) < -positionError;
        float nearest = MinComponent(distances), farthest = MaxComponent(distances),
            edgeError = edgeErrors.x + edgeErrors.y + edgeErrors.z;
        if (mayBeInside && !surelyInside && !isBeside && farthest > 0.0)
        {
            toHit = clamp(toHit, nearest, farthest);
            ambiguousDistance =
                max(0.0,
                    abs(sum) > edgeError ? max(nearest, toHit - (farthest - nearest) * edgeError / abs(sum)) : nearest);
        }
    }
#endif
    bool isHit = isInside && toHit > 0.0;
    lowerDistance = MISS;
    if (isHit)
    {
        float nearestCorner = MinComponent(distances), farthestCorner = MaxComponent(distances);
        lowerDistance = toHit - 3.0 * maxEdgeError * (farthestCorner - nearestCorner) / abs(sum) - positionError
            - DISTANCE_ROUNDING * farthestCorner;
    }
    return isHit ? toHit : MISS;
}

// Distances to the triangles (0, 1, 2) and (0, 2, 3) of a pair, their ambiguous and lower distances. Watertight: no ray
// passes between triangles that share corners (after Woop, Benthin and Wald 2013).
float2 HitPair(TraversalRay ray, float3 corner0, float3 corner1, float3 corner2, float3 corner3,
    out float2 ambiguousDistance, out float2 lowerDistance)
{
    float3 p0 = AsSeen(ray, corner0), p1 = AsSeen(ray, corner1), p2 = AsSeen(ray, corner2), p3 = AsSeen(ray, corner3);
    float diagonal = SideOf(p2, p0);
    float farthest = max(max(p0.z, p1.z), max(p2.z, p3.z)),
        widest = max(max(SumOfSizes(p0.xy), SumOfSizes(p1.xy)), max(SumOfSizes(p2.xy), SumOfSizes(p3.xy)));
    float positionError = ray.PositionError + ray.DirectionError * farthest + SEEN_ROUNDING * widest;
    float maxEdgeError = 2.0 * positionError * widest;
    bool isAlone = all(corner2 == corner3);
    float first =
        HitTriangle(p0, p1, p2, float3(SideOf(p1, p2), diagonal, SideOf(p0, p1)), positionError,
            maxEdgeError, ambiguousDistance.x, lowerDistance.x);
    float second = HitTriangle(p0, p2, p3, float3(SideOf(p2, p3), SideOf(p3, p0), -diagonal), positionError,
        isAlone ? -1.0 : maxEdgeError, ambiguousDistance.y, lowerDistance.y);
    return float2(first, second);
}

#endif
