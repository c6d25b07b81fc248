#ifndef GLINT_REFINE_HIT
#define GLINT_REFINE_HIT

#include "Geometry.hlsl"
#include "DoubleFloat.hlsl"

// The double-float ray beside the float32 ray of the traversal.
struct RefineRay
{
    DoubleFloat3 Origin;  // the last hit
    DoubleFloat3 Direction;
    float Back;           // m, along the line, from the start of the traversal to the origin
    float SceneExtent;    // the scene's size in the mesh's frame: the origin has the rounding of positions in the scene
};

// Maximum height of the origin above a triangle's plane, as a fraction of the lengths in its computation, at which the
// ray starts in the plane and does not hit the triangle.
static const float ON_SURFACE = 1.0e-13;

// Relative rounding of an edge function: some steps of double-float numbers.
static const float SIDE_ROUNDING = 4.0e-13;

float Sum(float3 v)
{
    return v.x + v.y + v.z;
}

// Whether a float32 ray passes an edge on the inner side of a triangle, for both orientations, or outside by at most
// rounding and the position error. False if a corner is NaN.
bool2 IsInside(float2 a, float2 b, float positionError)
{
    float side = a.x * b.y - a.y * b.x;
    float2 edge = abs(b - a);
    float edgeError = positionError * (edge.x + edge.y) + 2.4e-7 * (abs(a.x * b.y) + abs(a.y * b.x));
    return bool2(side >= -edgeError, side <= edgeError);
}

// Error of distances in a frame that stretches lengths.
float DistanceError(TraversalRay ray, float positionError)
{
    return max(positionError, ray.PositionError * abs(ray.Shear.z));
}

// Whether the line may hit the triangle within reach of the start of the traversal, m.
bool MayHit(TraversalRay ray, float3 a, float3 b, float3 c, float reach)
{
    float3 p = AsSeen(ray, a), q = AsSeen(ray, b), r = AsSeen(ray, c);
    float positionError = 3.0 * ray.PositionError; // seen sheared
    bool2 isInside = IsInside(p.xy, q.xy, positionError) && IsInside(q.xy, r.xy, positionError)
        && IsInside(r.xy, p.xy, positionError);
    return (isInside.x || isInside.y) && min(p.z, min(q.z, r.z)) <= reach;
}

// Edge function of the line and the edge between two corners, times four times the area of edge and origin; 0 if
// rounding leaves the side undecided. A line through an edge or a corner then hits all triangles there and passes
// between none. Short distant edges lose no digits.
float SideOfLine(RefineRay ray, float3 a, float3 b)
{
    DoubleFloat3 between =
        Add(MakeDoubleFloat3(TwoSum(a.x, b.x), TwoSum(a.y, b.y), TwoSum(a.z, b.z)), Mul(ray.Origin, -2.0)),
        edge = Difference(b, a);
    float side = Rounded(Dot(ray.Direction, Cross(between, edge)));
    float edgeError = SIDE_ROUNDING * (Sum(abs(a) + abs(b) + 2.0 * abs(Rounded(ray.Origin))) + ray.SceneExtent)
        * Sum(abs(Rounded(edge))) * Sum(abs(Rounded(ray.Direction)));
    return abs(side) <= edgeError ? 0.0 : side;
}

// Whether the line hits the triangle after its origin, the distance, m, and the triangle's unit normal. The distance is
// clamped to that of the nearest and farthest corner, which rounding may exceed for a triangle seen edge-on.
bool Hits(TraversalRay traversalRay, RefineRay ray, float positionError, float3 a, float3 b, float3 c,
    out DoubleFloat toHit, out DoubleFloat3 normal, out bool isAtEdge)
{
    normal = (DoubleFloat3)0;
    toHit = MakeDoubleFloat(MISS, 0.0);
    // A loop, because a GPU waits for the instructions of long code.
    float3 sides = 0.0, from = b, to = c, next = a;
    [loop]
    for (uint edge = 0; edge < 3; edge++)
    {
        sides = float3(sides.yz, SideOfLine(ray, from, to));
        float3 last = from;
        from = to;
        to = next;
        next = last;
    }
    isAtEdge = sides.x == 0.0 || sides.y == 0.0 || sides.z == 0.0;
    if (min(sides.x, min(sides.y, sides.z)) < 0.0 && max(sides.x, max(sides.y, sides.z)) > 0.0)
        return false;
    normal = Cross(Difference(b, a), Difference(c, a));
    normal = Mul(normal, 1.0 / length(Rounded(normal)));
    DoubleFloat3 toCorner = Sub(
        MakeDoubleFloat3(MakeDoubleFloat(a.x, 0.0), MakeDoubleFloat(a.y, 0.0), MakeDoubleFloat(a.z, 0.0)), ray.Origin);
    DoubleFloat height = Dot(normal, toCorner), facing = Dot(normal, ray.Direction);
    if (IsNaN(facing.Hi) || facing.Hi == 0.0) // NaN for the absent second triangle of a pair
        return false;
    if (abs(height.Hi) <= ON_SURFACE * (Sum(abs(Rounded(toCorner)) + abs(Rounded(ray.Origin))) + ray.SceneExtent))
        return false;
    toHit = Div(height, facing);
    float3 distances =
        float3(AsSeen(traversalRay, a).z, AsSeen(traversalRay, b).z, AsSeen(traversalRay, c).z) - ray.Back;
    float nearest = min(distances.x, min(distances.y, distances.z)),
        farthest = max(distances.x, max(distances.y, distances.z));
    if (IsNaN(toHit.Hi) || toHit.Hi < nearest - positionError)
        toHit = MakeDoubleFloat(nearest, 0.0);
    if (toHit.Hi > farthest + positionError)
        toHit = MakeDoubleFloat(farthest, 0.0);
    return toHit.Hi > 0.0;
}

#endif
