#ifndef GLINT_GEOMETRY
#define GLINT_GEOMETRY

#include "Types.hlsl"

// Distance of a segment that hits nothing, m.
static const float MISS = 3.0e38;

// Least size of a direction's component, so that its inverse stays finite and an axis-parallel ray on a box's face is no 0 * infinity.
static const float LEAST_COMPONENT = 1.0e-20;

// A ray leaves a box this much later, so that rounding does not lose one that grazes it: 16 float32 steps.
static const float LEAVE_LATER = 1.000002;

// A ray as the search wants it: in the frame of a tree, the direction of any length.
struct SearchRay
{
    float3 Origin;
    float3 Direction;
    float3 Inverse;       // 1 / direction
    uint Axis;            // along which the direction is longest
    float3 Shear;         // what shears that axis into the ray's direction, and scales it to distances
#ifdef GLINT_EXACT
    float Slack;          // boxes are larger by this, and triangles that are so near are tested exactly
#endif
};

// The components in the order that puts the given axis last.
float3 AxisLast(float3 v, uint axis)
{
    return axis == 0 ? v.yzx : axis == 1 ? v.zxy : v;
}

SearchRay MakeSearchRay(float3 origin, float3 direction, float slack)
{
    SearchRay ray;
    ray.Origin = origin;
    ray.Direction = direction;
    float3 size = abs(direction);
    float3 inverse = 1.0 / max(size, LEAST_COMPONENT);
    ray.Inverse = float3(direction.x < 0.0 ? -inverse.x : inverse.x, direction.y < 0.0 ? -inverse.y : inverse.y, direction.z < 0.0 ? -inverse.z : inverse.z);
    ray.Axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    float3 d = AxisLast(direction, ray.Axis);
    ray.Shear = float3(d.xy, 1.0) / d.z;
#ifdef GLINT_EXACT
    ray.Slack = slack;
#endif
    return ray;
}

// A corner as the ray sees it: x and y across the ray, z the distance along it.
// Every triangle at a corner gets the same numbers for it, to the last bit: "precise" keeps the compiler from fusing operations here and not there.
float3 AsSeen(SearchRay ray, float3 corner)
{
    float3 p = AxisLast(corner - ray.Origin, ray.Axis);
    precise float3 seen = float3(p.x - ray.Shear.x * p.z, p.y - ray.Shear.y * p.z, ray.Shear.z * p.z);
    return seen;
}

// Twice the area, seen along the ray, that an edge spans with the ray: its sign says on which side the ray passes.
// The sign is right or the result 0, as the products are rounded before they are compared. Swapped corners give exactly the opposite.
float SideOf(float3 a, float3 b)
{
    precise float side = a.x * b.y - a.y * b.x;
    return side;
}

// Distance to a triangle with these sides opposite to its corners; MISS outside. A ray through an edge or a corner, where a side is 0, is inside.
float HitTriangle(float3 sides, float3 distances)
{
    bool inside = min(sides.x, min(sides.y, sides.z)) >= 0.0 || max(sides.x, max(sides.y, sides.z)) <= 0.0;
    float sum = sides.x + sides.y + sides.z;
    float toHit = dot(sides, distances) / sum;
    return inside && sum != 0.0 && toHit > 0.0 ? toHit : MISS;
}

// Distances to the triangles (0, 1, 2) and (0, 2, 3) of a pair. Watertight: a ray cannot pass between triangles that share corners (after Woop, Benthin and Wald 2013).
float2 HitPair(SearchRay ray, float3 corner0, float3 corner1, float3 corner2, float3 corner3)
{
    float3 p0 = AsSeen(ray, corner0), p1 = AsSeen(ray, corner1), p2 = AsSeen(ray, corner2), p3 = AsSeen(ray, corner3);
    float diagonal = SideOf(p2, p0);
    float first = HitTriangle(float3(SideOf(p1, p2), diagonal, SideOf(p0, p1)), float3(p0.z, p1.z, p2.z));
    float second = HitTriangle(float3(SideOf(p2, p3), SideOf(p3, p0), -diagonal), float3(p0.z, p2.z, p3.z));
    return float2(first, second);
}

#endif
