#ifndef GLINT_HORIZON
#define GLINT_HORIZON

#include "BinaryBvh.hlsl"
#include "Leaf.hlsl"

// Horizons. A ray that leaves the front of a triangle above the triangle's horizon meets nothing else in the same BVH,
// so that its traversal is skipped. Most rays leave a sea or a ship above it; without horizons their traversal visits
// all nodes around their start. Each triangle has eight bytes, one for each sector of azimuth about its normal:
// 255 * (1 - sine of the horizon's elevation); 0 until the kernel FindHorizons finds it.

// Radians by which a sector overlaps its neighbours.
static const float SECTOR_OVERLAP = 0.3;

// A triangle's own frame.
struct TriangleFrame
{
    float3 Corner0, Corner1, Corner2;
    float3 Normal;        // unit vectors: to the front,
    float3 AxisX, AxisY;  // and in the plane
};

TriangleFrame MakeTriangleFrame(Pair pair, bool second)
{
    TriangleFrame frame;
    frame.Corner0 = pair.Corner0;
    frame.Corner1 = second ? pair.Corner2 : pair.Corner1;
    frame.Corner2 = second ? pair.Corner3 : pair.Corner2;
    frame.Normal = normalize(cross(frame.Corner1 - frame.Corner0, frame.Corner2 - frame.Corner0));
    frame.AxisX = normalize(pair.Corner2 - pair.Corner0); // an edge of both triangles
    frame.AxisY = cross(frame.Normal, frame.AxisX);
    return frame;
}

// Sector of a direction in the plane.
uint SectorOf(float2 direction)
{
    return (direction.x < 0.0 ? 1 : 0) + (direction.y < 0.0 ? 2 : 0)
        + (abs(direction.x) < abs(direction.y) ? 4 : 0);
}

// Row of a leaf's horizons: those of the first triangle, then those of the second. The BVH's first row ends with the
// row that leaves are numbered from.
uint HorizonRow(uint page, uint firstRow, uint leafRow)
{
    return firstRow + LoadBvh(page, firstRow).w + leafRow / 3;
}

// Distance from a point in a triangle's plane to an edge, positive inside.
float DistanceToEdge(TriangleFrame frame, float3 p, float3 from, float3 to)
{
    return dot(cross(frame.Normal, to - from), p - from) / length(to - from);
}

// Whether nothing in its BVH, apart from the excluded triangle, is within the errors of a ray in the BVH's frame.
// Displacement: from the ray's origin to the start of its traversal.
bool IsAboveHorizon(TraversalRay ray, float3 origin, uint page, uint firstRow, uint leafRow, bool second,
    float displacement)
{
    TriangleFrame frame = MakeTriangleFrame(LoadPair(page, firstRow + leafRow), second);
    float size = length(ray.Direction), sine = dot(ray.Direction, frame.Normal) / size;
    uint sector = SectorOf(float2(dot(ray.Direction, frame.AxisX), dot(ray.Direction, frame.AxisY)));
    uint4 horizons = LoadBvh(page, HorizonRow(page, firstRow, leafRow));
    uint2 own = second ? horizons.zw : horizons.xy;
    float horizon = 1.0 - ((sector < 4 ? own.x : own.y) >> (8 * (sector & 3)) & 0xff) / 255.0;
    float inside = MinComponent(float3(DistanceToEdge(frame, origin, frame.Corner0, frame.Corner1),
        DistanceToEdge(frame, origin, frame.Corner1, frame.Corner2),
        DistanceToEdge(frame, origin, frame.Corner2, frame.Corner0)));
    // An ambiguous triangle is within sqrt(2) times the position error of the ray's line (HitTriangle). The error grows
    // with the distance and with the triangle's size; what grows with the distance is within HORIZON_SLACK.
    float largest = asfloat(LoadBvh(page, firstRow + ROOT + 2).w);
    float error = ray.PositionError + (ray.DirectionError / size + 2.0 * SEEN_ROUNDING) * 2.0 * largest;
    return min(sine - horizon, SECTOR_OVERLAP) * inside > 1.5 * error + displacement;
}

#endif
