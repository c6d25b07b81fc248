#ifndef GLINT_FIND_HORIZONS_INCLUDED
#define GLINT_FIND_HORIZONS_INCLUDED

#include "Horizon.hlsl"

// Sine of the elevation below which horizons are not computed: few rays leave a surface below it.
static const float MIN_HORIZON = 0.05;

// Added to the sine: more than the errors of rays and the rounding here, as fractions of distances.
static const float HORIZON_SLACK = 1.0e-3;

// Sine of a horizon above all rays.
static const float NO_SKY = 2.0;

// Rounding of positions in the plane of a triangle, as a fraction of its size.
static const float PLANE_ROUNDING = 1.0e-5;

static const uint SECTORS = 8;

// Nodes and leaves after which a traversal ends without a result, so that a dispatch ends in time. Software devices end
// a loop after 65,535 steps.
static const uint MAX_HORIZON_STEPS = 8192;

// A triangle and the horizon found so far.
struct HorizonState
{
    TriangleFrame Frame;
    float3 Centre;
    float Radius;         // of the circle about the centre through the farthest corner
    float2 P0, P1, P2;    // corners in the plane, from the centre
    float Margin;         // m: everything is taken to be higher by as much
    float Sine[SECTORS];
    float Lowest;         // of the sines
};

float2 InPlane(HorizonState state, float3 fromCentre)
{
    return float2(dot(fromCentre, state.Frame.AxisX), dot(fromCentre, state.Frame.AxisY));
}

HorizonState BeginHorizon(TriangleFrame frame, float margin)
{
    HorizonState state;
    state.Frame = frame;
    state.Centre = (frame.Corner0 + frame.Corner1 + frame.Corner2) / 3.0;
    float3 a = frame.Corner0 - state.Centre, b = frame.Corner1 - state.Centre, c = frame.Corner2 - state.Centre;
    state.Radius = sqrt(max(dot(a, a), max(dot(b, b), dot(c, c))));
    state.P0 = InPlane(state, a);
    state.P1 = InPlane(state, b);
    state.P2 = InPlane(state, c);
    state.Margin = margin;
    [unroll]
    for (uint sector = 0; sector < SECTORS; sector++)
        state.Sine[sector] = MIN_HORIZON;
    state.Lowest = MIN_HORIZON;
    return state;
}

float2 SectorCentre(uint sector)
{
    float2 centre = (sector & 4) != 0 ? float2(0.38268343, 0.92387953) : float2(0.92387953, 0.38268343);
    return float2((sector & 1) != 0 ? -centre.x : centre.x, (sector & 2) != 0 ? -centre.y : centre.y);
}

// Cosine and sine of half a sector with its overlap: pi / 8 + SECTOR_OVERLAP.
static const float2 HALF_SECTOR = float2(0.76952514, 0.63861652);

// Cosine of the sum of two angles, given by cosine and sine, up to pi.
float CosSum(float2 a, float2 b)
{
    return a.x * b.x - a.y * b.y;
}

// Cosine and sine of half the angle that a circle of this radius subtends; of pi inside it.
float2 HalfAngle(float radius, float distance)
{
    float sine = radius / distance;
    return sine < 1.0 ? float2(sqrt(1.0 - sine * sine), sine) : float2(-1.0, 0.0);
}

float SineOf(float slope)
{
    return slope * rsqrt(1.0 + slope * slope);
}

// Raises the horizon of the sectors within a half angle of a direction. The slope is that along an axis and decreases
// with the cosine of the angle to it; MISS: no sky is left.
void Raise(inout HorizonState state, float slope, float2 axis, float2 direction, float2 halfAngle)
{
    float limit = halfAngle.x < -0.99 ? -2.0 : CosSum(halfAngle, HALF_SECTOR);
    state.Lowest = NO_SKY;
    [unroll]
    for (uint sector = 0; sector < SECTORS; sector++)
    {
        float2 centre = SectorCentre(sector);
        float cosine = dot(axis, centre);
        // of the angle between the axis and the nearest direction of the sector
        float nearest = cosine >= HALF_SECTOR.x || slope >= MISS ? 1.0
            : cosine * HALF_SECTOR.x + sqrt(max(0.0, 1.0 - cosine * cosine)) * HALF_SECTOR.y;
        if (dot(direction, centre) >= limit && nearest > 0.0)
            state.Sine[sector] = max(state.Sine[sector], slope >= MISS ? NO_SKY : SineOf(slope * nearest));
        state.Lowest = min(state.Lowest, state.Sine[sector]);
    }
}

// Whether something with this bound would raise a sector.
bool MayRaise(HorizonState state, float sine, float2 direction, float2 halfAngle)
{
    if (sine <= state.Lowest)
        return false;
    float limit = halfAngle.x < -0.99 ? -2.0 : CosSum(halfAngle, HALF_SECTOR);
    bool raises = false;
    [unroll]
    for (uint sector = 0; sector < SECTORS; sector++)
        raises = raises || sine > state.Sine[sector] && dot(direction, SectorCentre(sector)) >= limit;
    return raises;
}

bool MayRaise(HorizonState state, float3 centre, float3 halfSize)
{
    float3 fromCentre = centre - state.Centre;
    float height = dot(fromCentre, state.Frame.Normal),
        top = height + dot(abs(state.Frame.Normal), halfSize) + state.Margin;
    if (top <= 0.0)
        return false;
    float2 inPlane = InPlane(state, fromCentre);
    float distance = length(inPlane), radius = length(halfSize) + state.Radius;
    if (distance <= radius)
        return true;
    return MayRaise(state, SineOf(top / (distance - radius)), inPlane / distance, HalfAngle(radius, distance));
}

// Maximum slope from any point of the triangle to any point of another one, given by heights and positions
// in the plane, along an axis on which nothing of the triangle is past the offset; MISS if the other one is not.
// Height and distance along the axis are linear, so that a corner has the maximum.
float SlopeAlong(float2 axis, float offset, float radius, float3 heights, float2 q0, float2 q1, float2 q2)
{
    float3 distances = float3(dot(axis, q0), dot(axis, q1), dot(axis, q2)) - offset;
    float slope = 0.0;
    [unroll]
    for (uint i = 0; i < 3; i++)
    {
        if (distances[i] < -PLANE_ROUNDING * radius || heights[i] > 0.0 && distances[i] <= PLANE_ROUNDING * radius)
            return MISS;
        if (heights[i] > 0.0)
            slope = max(slope, heights[i] / distances[i]);
    }
    return slope;
}

void TryAxis(HorizonState state, float2 axis, float offset, float3 heights, float2 q0, float2 q1, float2 q2,
    inout float slope, inout float2 best)
{
    float along = SlopeAlong(axis, offset, state.Radius, heights, q0, q1, q2);
    if (along < slope)
    {
        slope = along;
        best = axis;
    }
}

// The outward normal of an edge, in the plane; the centre is at 0.
float2 EdgeAxis(float2 from, float2 to)
{
    float2 normal = normalize(float2(to.y - from.y, from.x - to.x));
    return dot(normal, from) < 0.0 ? -normal : normal;
}

// Height and position of another triangle's corner: those of the triangle's own corner if they are the same.
float3 CornerOf(HorizonState state, float3 corner)
{
    if (all(corner == state.Frame.Corner0))
        return float3(state.P0, 0.0);
    if (all(corner == state.Frame.Corner1))
        return float3(state.P1, 0.0);
    if (all(corner == state.Frame.Corner2))
        return float3(state.P2, 0.0);
    float3 fromCentre = corner - state.Centre;
    return float3(InPlane(state, fromCentre), dot(fromCentre, state.Frame.Normal) + state.Margin);
}

void AddTriangle(inout HorizonState state, float3 corner0, float3 corner1, float3 corner2)
{
    float3 q0 = CornerOf(state, corner0), q1 = CornerOf(state, corner1), q2 = CornerOf(state, corner2);
    float3 heights = float3(q0.z, q1.z, q2.z);
    if (MaxComponent(heights) <= 0.0)
        return;
    float2 middle = (q0.xy + q1.xy + q2.xy) / 3.0;
    float distance = length(middle);
    float radius = max(length(q0.xy - middle), max(length(q1.xy - middle), length(q2.xy - middle))) + state.Radius;
    float2 direction = distance > 0.0 ? middle / distance : float2(1.0, 0.0);

    float slope = MISS;
    float2 axis = direction, p0 = state.P0, p1 = state.P1, p2 = state.P2;
    float2 edge0 = EdgeAxis(p0, p1), edge1 = EdgeAxis(p1, p2), edge2 = EdgeAxis(p2, p0);
    TryAxis(state, edge0, dot(edge0, p0), heights, q0.xy, q1.xy, q2.xy, slope, axis);
    TryAxis(state, edge1, dot(edge1, p1), heights, q0.xy, q1.xy, q2.xy, slope, axis);
    TryAxis(state, edge2, dot(edge2, p2), heights, q0.xy, q1.xy, q2.xy, slope, axis);
    TryAxis(state, direction, max(dot(direction, p0), max(dot(direction, p1), dot(direction, p2))), heights,
        q0.xy, q1.xy, q2.xy, slope, axis);
    float2 halfAngle = HalfAngle(radius, distance);
    Raise(state, slope, axis, direction, halfAngle);
}

void AddLeaf(inout HorizonState state, uint firstRow, uint leafRow, uint ownRow, bool ownSecond)
{
    Pair pair = LoadPair(0, firstRow + leafRow);
    bool isOwn = leafRow == ownRow;
    if (!isOwn || ownSecond)
        AddTriangle(state, pair.Corner0, pair.Corner1, pair.Corner2);
    if ((!isOwn || !ownSecond) && any(pair.Corner2 != pair.Corner3))
        AddTriangle(state, pair.Corner0, pair.Corner2, pair.Corner3);
}

// The eight bytes of a triangle.
uint2 FindHorizon(uint firstRow, uint ownRow, bool second, float margin)
{
    HorizonState state = BeginHorizon(MakeTriangleFrame(LoadPair(0, firstRow + ownRow), second), margin);
    float3 bvhCentre = asfloat(LoadBvh(0, firstRow).xyz);
    uint stack[1 + BINARY_LEVELS];
    stack[0] = DONE;
    uint top = 0, current = ROOT;
    [loop]
    for (uint steps = 0; steps < MAX_HORIZON_STEPS && current != DONE && state.Lowest < 1.0; steps++)
    {
        if ((current & LEAF) != 0)
        {
            AddLeaf(state, firstRow, current & ~LEAF, ownRow, second);
            current = stack[top--];
            continue;
        }
        uint row = firstRow + current;
        uint4 a = LoadBvh(0, row), b = LoadBvh(0, row + 1);
        uint3 halfSizes = LoadBvh(0, row + 2).xyz;
        float3 centreA = bvhCentre + asfloat(a.xyz), centreB = bvhCentre + asfloat(b.xyz);
        bool opensA = MayRaise(state, centreA, HalfSizeA(halfSizes)),
            opensB = b.w != a.w && MayRaise(state, centreB, HalfSizeB(halfSizes));
        // The nearer child first: it raises the horizon most.
        bool isBFirst = opensB && (!opensA || length(centreB - state.Centre) < length(centreA - state.Centre));
        if (opensA && opensB)
            stack[++top] = isBFirst ? a.w : b.w;
        if (opensA || opensB)
            current = isBFirst ? b.w : a.w;
        else
            current = stack[top--];
    }
    uint2 bytes = 0;
    if (current != DONE)
        return bytes;
    [unroll]
    for (uint sector = 0; sector < SECTORS; sector++)
    {
        uint byte = (uint)(255.0 * saturate(1.0 - state.Sine[sector] - HORIZON_SLACK));
        if (sector < 4)
            bytes.x |= byte << (8 * sector);
        else
            bytes.y |= byte << (8 * (sector - 4));
    }
    return bytes;
}

#endif
