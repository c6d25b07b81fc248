#ifndef GLINT_LEAF
#define GLINT_LEAF

#include "Bindings.hlsl"
#include "Geometry.hlsl"
#include "Real.hlsl"

static const uint NO_INSTANCE = 0xffffffff;

// No triangle: see NumberOf.
static const uint2 NOT_MET = uint2(NO_INSTANCE, 0);

#ifdef GLINT_REFINE
#include "RefineHit.hlsl"
#endif

// State of a traversal: the closest hit so far.
struct TraversalState
{
    float Distance;          // m, from the start of the traversal; the reach if there is no hit
    uint Instance;           // NO_INSTANCE: no hit
    uint Row;                // of the leaf's pair of triangles in its BVH
    bool Second;             // the second triangle of the pair
    uint2 ExcludedTriangle;  // the last triangle hit, which cannot be hit again: see NumberOf
    // Maximum distance between the float32 ray and the true ray at the start of the traversal, m in the scene,
    float PositionError;
    float DirectionError;  // and its growth per metre
#ifdef GLINT_REFINE
    RefineRay Ray;                // the double-float ray, in the frame of the current mesh
    DoubleFloat RefinedDistance;  // m, along that ray
    DoubleFloat3 Normal;          // unit vector, in the frame of the mesh that is hit
    bool IsAtEdge;                // the side of an edge is undecided
    // pending double-float tests of a leaf's triangles: 4 * row, + 1 for the first, + 2 for the second
    uint PendingLeaf;
#else
    // m: smallest distance of a triangle whose edge the ray passes within the edge error
    float AmbiguousDistance;
    float LowerDistance;     // m: lower bound of the true Distance,
    float NextLowerDistance; // and the smallest one of the other triangles that the ray hits
    uint2 Tied;              // another triangle at Distance: see NumberOf; its instance is NO_INSTANCE if there is none
#endif
};

// AnyHit: the traversal ends at the first hit.
bool IsEnough(TraversalState state, bool anyHit)
{
    return anyHit && state.Instance != NO_INSTANCE;
}

// Identifies a triangle by its instance and its row in the BVH.
uint2 NumberOf(uint instance, uint row, bool second)
{
    return uint2(instance, 2 * row + (second ? 1 : 0));
}

// Numbers of a leaf's two triangles in the instance's mesh, the lower first.
uint2 TrianglesOf(InstanceRecord record, uint row)
{
    uint leaf = (row - record.FirstRecordRow) / 3;
    uint4 leaves = LoadBvh(record.Page, record.FirstRow + record.FirstIdentityRow + leaf / 2);
    return leaf % 2 == 0 ? leaves.xy : leaves.zw;
}

// Of triangles at equal distance the one of the lower instance is hit, then the lower one of its mesh, whatever the
// BVH. The triangles are given by NumberOf.
bool IsBefore(uint2 a, uint2 b)
{
    InstanceRecord recordA = LoadInstance(a.x), recordB = LoadInstance(b.x);
    uint2 trianglesA = TrianglesOf(recordA, a.y / 2), trianglesB = TrianglesOf(recordB, b.y / 2);
    uint triangleA = (a.y & 1) != 0 ? trianglesA.y : trianglesA.x,
        triangleB = (b.y & 1) != 0 ? trianglesB.y : trianglesB.x;
    return recordA.Instance < recordB.Instance || recordA.Instance == recordB.Instance && triangleA < triangleB;
}

// Four corners: triangles (0, 1, 2) and (0, 2, 3), the one of the lower number first.
struct Pair
{
    float3 Corner0, Corner1, Corner2, Corner3;
};

Pair LoadPair(uint page, uint row)
{
    float4 a = asfloat(LoadBvh(page, row)), b = asfloat(LoadBvh(page, row + 1)), c = asfloat(LoadBvh(page, row + 2));
    Pair pair;
    pair.Corner0 = a.xyz;
    pair.Corner1 = float3(a.w, b.xy);
    pair.Corner2 = float3(b.zw, c.x);
    pair.Corner3 = c.yzw;
    return pair;
}

#ifdef GLINT_COUNT
static uint s_nodesVisited = 0;
static uint s_pairsTested = 0;
#define COUNT_NODE s_nodesVisited++
#define COUNT_PAIR s_pairsTested++
#else
#define COUNT_NODE
#define COUNT_PAIR
#endif

#ifdef GLINT_REFINE

bool HasPending(TraversalState state)
{
    return state.PendingLeaf != 0;
}

// Float32 selects the triangles that the ray may hit, and defers their double-float test. The test is expensive; the
// threads of a group run it together, when each has a pending one or is done.
void TestPair(TraversalRay ray, uint instance, uint page, uint firstRow, uint row, inout TraversalState state)
{
    COUNT_PAIR;
    Pair pair = LoadPair(page, firstRow + row);
    float reach = state.Distance + DistanceError(ray, state.PositionError);
    bool mayHitFirst = MayHit(ray, pair.Corner0, pair.Corner1, pair.Corner2, reach),
        mayHitSecond = MayHit(ray, pair.Corner0, pair.Corner2, pair.Corner3, reach);
    if (instance == state.ExcludedTriangle.x && row == state.ExcludedTriangle.y >> 1)
    {
        bool isSecond = (state.ExcludedTriangle.y & 1) != 0;
        mayHitFirst = mayHitFirst && isSecond;
        mayHitSecond = mayHitSecond && !isSecond;
    }
    if (mayHitFirst || mayHitSecond)
        state.PendingLeaf = 4 * row + (mayHitFirst ? 1 : 0) + (mayHitSecond ? 2 : 0);
}

// Tests the pending triangles in double-float arithmetic.
void TestPending(TraversalRay ray, uint instance, uint page, uint firstRow, inout TraversalState state)
{
    if (state.PendingLeaf == 0)
        return;
    uint row = state.PendingLeaf >> 2;
    bool isSecond = (state.PendingLeaf & 1) == 0;
    state.PendingLeaf = isSecond || (state.PendingLeaf & 2) == 0 ? 0 : state.PendingLeaf & ~1u;
    Pair pair = LoadPair(page, firstRow + row);
    DoubleFloat toHit;
    DoubleFloat3 normal;
    bool isAtEdge;
    if (!Hits(ray, state.Ray, DistanceError(ray, state.PositionError), pair.Corner0,
        isSecond ? pair.Corner2 : pair.Corner1,
        isSecond ? pair.Corner3 : pair.Corner2, toHit, normal, isAtEdge))
        return;
    float farther = Rounded(Sub(toHit, state.RefinedDistance));
    bool isTied = false;
    [branch]
    if (farther == 0.0 && state.Instance != NO_INSTANCE)
        isTied = IsBefore(NumberOf(instance, row, isSecond), NumberOf(state.Instance, state.Row, state.Second));
    if (farther >= 0.0 && !isTied)
        return;
    state.RefinedDistance = toHit;
    state.Normal = normal;
    state.IsAtEdge = isAtEdge;
    state.Distance = toHit.Hi + state.Ray.Back + state.PositionError;
    state.Instance = instance;
    state.Row = row;
    state.Second = isSecond;
}

#else

// Float32 tests are immediate.
bool HasPending(TraversalState state)
{
    return false;
}

void TestPending(TraversalRay ray, uint instance, uint page, uint firstRow, inout TraversalState state)
{
}

void TestPair(TraversalRay ray, uint instance, uint page, uint firstRow, uint row, inout TraversalState state)
{
    COUNT_PAIR;
    Pair pair = LoadPair(page, firstRow + row);
    float2 ambiguousDistance, lowerDistance,
        toHit = HitPair(ray, pair.Corner0, pair.Corner1, pair.Corner2, pair.Corner3, ambiguousDistance, lowerDistance);
    if (instance == state.ExcludedTriangle.x && row == state.ExcludedTriangle.y >> 1)
    {
        bool excludesFirst = (state.ExcludedTriangle.y & 1) == 0;
        toHit = excludesFirst ? float2(MISS, toHit.y) : float2(toHit.x, MISS);
        ambiguousDistance = excludesFirst ? float2(MISS, ambiguousDistance.y) : float2(ambiguousDistance.x, MISS);
        lowerDistance = excludesFirst ? float2(MISS, lowerDistance.y) : float2(lowerDistance.x, MISS);
    }
    state.AmbiguousDistance = min(state.AmbiguousDistance, min(ambiguousDistance.x, ambiguousDistance.y));
    bool isSecond = toHit.y < toHit.x;
    float nearer = isSecond ? toHit.y : toHit.x, lower = isSecond ? lowerDistance.y : lowerDistance.x,
        otherLower = isSecond ? lowerDistance.x : lowerDistance.y;
    bool isNearer = nearer < state.Distance;
    state.NextLowerDistance =
        min(state.NextLowerDistance, min(otherLower, isNearer ? state.LowerDistance : lower));
    if (isNearer)
    {
        state.Distance = nearer;
        state.LowerDistance = lower;
        state.Instance = instance;
        state.Row = row;
        state.Second = isSecond;
        state.Tied.x = NO_INSTANCE;
    }
    else if (nearer == state.Distance && state.Instance != NO_INSTANCE)
    {
        // The refine pass decides between more than two.
        if (state.Tied.x != NO_INSTANCE)
            state.AmbiguousDistance = min(state.AmbiguousDistance, nearer);
        state.Tied = NumberOf(instance, row, isSecond);
    }
}

// Decides between two triangles at equal distance. It is left to the end of a traversal because a software device
// would load the numbers of both for every pair.
void DecideTie(inout TraversalState state)
{
    [branch]
    if (state.Tied.x != NO_INSTANCE)
    {
        [branch]
        if (IsBefore(state.Tied, NumberOf(state.Instance, state.Row, state.Second)))
        {
            state.Instance = state.Tied.x;
            state.Row = state.Tied.y / 2;
            state.Second = (state.Tied.y & 1) != 0;
        }
    }
}

#endif

#endif
