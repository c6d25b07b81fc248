#ifndef GLINT_EXACT_HIT
#define GLINT_EXACT_HIT

#include "Geometry.hlsl"
#include "TwoFloat.hlsl"

// A ray as it is, beside the one of float32 that is searched for.
struct ExactLine
{
    Two3 Origin;          // the hit before
    Two3 Direction;
    float Back;           // m, from where the search began, on the line, to the origin
    float Far;            // the scene's size in the mesh's frame: the origin is rounded as places in the scene are
};

// A triangle in whose plane the ray starts is not met:
// so near, as a part of the lengths that go into the height above it.
static const float ON_SURFACE = 1.0e-13;

// Of the numbers that go into the side of an edge: some steps of two-float numbers.
static const float SIDE_ROUNDING = 4.0e-13;

float Sum(float3 v)
{
    return v.x + v.y + v.z;
}

// Whether a ray of float32 passes an edge on the inner side of a triangle, for both ways around,
// or beyond it by no more than rounding and slack explain. Not if a corner is no number.
bool2 IsInside(float2 a, float2 b, float slack)
{
    float side = a.x * b.y - a.y * b.x;
    float2 edge = abs(b - a);
    float doubt = slack * (edge.x + edge.y) + 2.4e-7 * (abs(a.x * b.y) + abs(a.y * b.x));
    return bool2(side >= -doubt, side <= doubt);
}

// In a frame that stretches, distances round as its lengths do.
float DistanceSlack(SearchRay search, float slack)
{
    return max(slack, search.Slack * abs(search.Shear.z));
}

// Whether the line may hit the triangle, no farther from where the search began than reach, m.
bool MayHit(SearchRay ray, float3 a, float3 b, float3 c, float reach)
{
    float3 p = AsSeen(ray, a), q = AsSeen(ray, b), r = AsSeen(ray, c);
    float slack = 3.0 * ray.Slack; // seen sheared
    bool2 isInside = IsInside(p.xy, q.xy, slack) && IsInside(q.xy, r.xy, slack) && IsInside(r.xy, p.xy, slack);
    return (isInside.x || isInside.y) && min(p.z, min(q.z, r.z)) <= reach;
}

// On which side the line passes the edge between two corners, times four times the area that the edge spans with
// the origin; 0 where rounding leaves that open.
// So a line through an edge or a corner meets all triangles there, and passes between none.
// An edge that is short and far away costs no digits.
float SideOfLine(ExactLine ray, float3 a, float3 b)
{
    Two3 between = Plus(MakeTwo3(ExactSum(a.x, b.x), ExactSum(a.y, b.y), ExactSum(a.z, b.z)), Times(ray.Origin, -2.0)),
        edge = Difference(b, a);
    float side = Rounded(Dot(ray.Direction, Cross(between, edge)));
    float doubt = SIDE_ROUNDING * (Sum(abs(a) + abs(b) + 2.0 * abs(Rounded(ray.Origin))) + ray.Far)
        * Sum(abs(Rounded(edge))) * Sum(abs(Rounded(ray.Direction)));
    return abs(side) <= doubt ? 0.0 : side;
}

// Whether the line meets the triangle after its origin, and how far along, m:
// at its nearest or farthest corner where rounding says nearer or farther, as of a triangle seen edge-on.
bool Hits(SearchRay search, ExactLine ray, float slack, float3 a, float3 b, float3 c, out Two toHit, out bool isAtEdge)
{
    toHit = MakeTwo(MISS, 0.0);
    float3 sides = float3(SideOfLine(ray, b, c), SideOfLine(ray, c, a), SideOfLine(ray, a, b));
    isAtEdge = sides.x == 0.0 || sides.y == 0.0 || sides.z == 0.0;
    if (min(sides.x, min(sides.y, sides.z)) < 0.0 && max(sides.x, max(sides.y, sides.z)) > 0.0)
        return false;
    Two3 normal = Cross(Difference(b, a), Difference(c, a));
    normal = Times(normal, 1.0 / length(Rounded(normal)));
    Two3 toCorner = Minus(MakeTwo3(MakeTwo(a.x, 0.0), MakeTwo(a.y, 0.0), MakeTwo(a.z, 0.0)), ray.Origin);
    Two height = Dot(normal, toCorner), facing = Dot(normal, ray.Direction);
    if (!(abs(facing.Hi) > 0.0)) // nor a number, of the second triangle of a pair that has but one
        return false;
    if (abs(height.Hi) <= ON_SURFACE * (Sum(abs(Rounded(toCorner)) + abs(Rounded(ray.Origin))) + ray.Far))
        return false;
    toHit = Over(height, facing);
    float3 distances = float3(AsSeen(search, a).z, AsSeen(search, b).z, AsSeen(search, c).z) - ray.Back;
    float nearest = min(distances.x, min(distances.y, distances.z)),
        farthest = max(distances.x, max(distances.y, distances.z));
    if (!(toHit.Hi >= nearest - slack))
        toHit = MakeTwo(nearest, 0.0);
    if (!(toHit.Hi <= farthest + slack))
        toHit = MakeTwo(farthest, 0.0);
    return toHit.Hi > 0.0;
}

#endif
