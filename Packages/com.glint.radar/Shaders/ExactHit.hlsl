#ifndef GLINT_EXACT_HIT
#define GLINT_EXACT_HIT

#include "Geometry.hlsl"
#include "TwoFloat.hlsl"

// A ray as it is, beside the one of float32 that is searched for: that one goes this line at most SLACK of the scene's size aside.
struct ExactLine
{
    Two3 Origin;          // the hit before
    Two3 Direction;
    float Back;           // m, from where the search began, on the line, to the origin
    float Slack;          // m, in the scene
    float Far;            // the scene's size in the mesh's frame: the origin is rounded as places in the scene are
};

static const float SLACK = 1.0e-6;

// A triangle in whose plane the ray starts is not met: so near, as a part of the lengths that go into the height above it.
static const float ON_SURFACE = 1.0e-13;

// Of the numbers that go into the side of an edge: some steps of two-float numbers.
static const float SIDE_ROUNDING = 4.0e-13;

float Sum(float3 v)
{
    return v.x + v.y + v.z;
}

// Whether a ray of float32 passes an edge on the outer side of a triangle, for both ways around, by more than rounding and slack explain.
bool2 IsOutside(float2 a, float2 b, float slack)
{
    float side = a.x * b.y - a.y * b.x;
    float2 edge = abs(b - a);
    float doubt = slack * (edge.x + edge.y) + 2.4e-7 * (abs(a.x * b.y) + abs(a.y * b.x));
    return bool2(side < -doubt, side > doubt);
}

// Whether the line may hit the triangle. Distances: least and greatest of its corners from where the search began, m.
bool MayHit(SearchRay ray, float3 a, float3 b, float3 c, out float2 distances)
{
    float3 p = AsSeen(ray, a), q = AsSeen(ray, b), r = AsSeen(ray, c);
    distances = float2(min(p.z, min(q.z, r.z)), max(p.z, max(q.z, r.z)));
    float slack = 3.0 * ray.Slack; // seen sheared
    bool2 isOutside = IsOutside(p.xy, q.xy, slack) || IsOutside(q.xy, r.xy, slack) || IsOutside(r.xy, p.xy, slack);
    return !isOutside.x || !isOutside.y;
}

// On which side the line passes the edge between two corners, times four times the area that the edge spans with the origin; 0 where rounding leaves that open.
// So a line through an edge or a corner meets all triangles there, and passes between none. An edge that is short and far away costs no digits.
float SideOfLine(ExactLine ray, float3 a, float3 b)
{
    Two3 between = Plus(MakeTwo3(ExactSum(a.x, b.x), ExactSum(a.y, b.y), ExactSum(a.z, b.z)), Times(ray.Origin, -2.0)), edge = Difference(b, a);
    float side = Rounded(Dot(ray.Direction, Cross(between, edge)));
    float doubt = SIDE_ROUNDING * (Sum(abs(a) + abs(b) + 2.0 * abs(Rounded(ray.Origin))) + ray.Far) * Sum(abs(Rounded(edge))) * Sum(abs(Rounded(ray.Direction)));
    return abs(side) <= doubt ? 0.0 : side;
}

// Whether the line meets the triangle after its origin, and how far along, m.
// Distances: least and greatest of its corners, good to the slack; a triangle seen edge-on is in its plane anywhere, and no farther off than they are.
bool Hits(ExactLine ray, float3 a, float3 b, float3 c, float2 distances, float slack, out Two toHit, out bool isAtEdge)
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
    if (!(toHit.Hi >= distances.x - slack))
        toHit = MakeTwo(distances.x, 0.0);
    if (!(toHit.Hi <= distances.y + slack))
        toHit = MakeTwo(distances.y, 0.0);
    return toHit.Hi > 0.0;
}

#endif
