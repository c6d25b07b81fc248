#ifndef GLINT_LEAF
#define GLINT_LEAF

#include "Bindings.hlsl"
#include "Geometry.hlsl"
#include "Real.hlsl"

static const uint NO_INSTANCE = 0xffffffff;

#ifdef GLINT_REFINE
#include "RefineHit.hlsl"
#endif

// A search through the BVHs: the nearest triangle that it has met so far.
struct TraversalState
{
    float Distance;          // m, from where the search began; where it ends as long as nothing is found
    uint Instance;           // NO_INSTANCE: nothing
    uint Row;                // of the pair of triangles in its BVH
    bool Second;             // which of the pair
    uint2 ExcludedTriangle;  // the triangle that the ray has just left, which it cannot meet again: see NumberOf
    // m, in the scene: so far beside the ray searched may the ray go in truth where the search begins,
    float PositionError;
    float DirectionError;  // and so much more for each m from there
#ifdef GLINT_REFINE
    RefineRay Ray;                // the ray itself, in the frame of the mesh searched
    DoubleFloat RefinedDistance;  // m, along it
    bool IsAtEdge;                // nobody can tell on which side of an edge
    // triangles of one pair that it may hit and that are yet to be tested: 4 * row, 1 for the first, 2 for the second
    uint PendingLeaf;
#else
    // m: the nearest triangle that the ray goes by an edge of, and nobody can tell on which side
    float AmbiguousDistance;
#endif
};

// AnyHit: the search may end at the first triangle that it meets.
bool IsEnough(TraversalState state, bool anyHit)
{
    return anyHit && state.Instance != NO_INSTANCE;
}

// A triangle by its instance and its number in the BVH.
uint2 NumberOf(uint instance, uint row, bool second)
{
    return uint2(instance, 2 * row + (second ? 1 : 0));
}

// Four corners: triangles (0, 1, 2) and (0, 2, 3).
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

// Float32 tells which triangles the ray may hit: its search waits for their test. Such a test is dear,
// and threads side by side do theirs together: when each has one or is done.
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

// Double-float arithmetic tells whether the ray hits a triangle that waits.
void TestPending(TraversalRay ray, uint instance, uint page, uint firstRow, inout TraversalState state)
{
    if (state.PendingLeaf == 0)
        return;
    uint row = state.PendingLeaf >> 2;
    bool isSecond = (state.PendingLeaf & 1) == 0;
    state.PendingLeaf = isSecond || (state.PendingLeaf & 2) == 0 ? 0 : state.PendingLeaf & ~1u;
    Pair pair = LoadPair(page, firstRow + row);
    DoubleFloat toHit;
    bool isAtEdge;
    if (!Hits(ray, state.Ray, DistanceError(ray, state.PositionError), pair.Corner0,
        isSecond ? pair.Corner2 : pair.Corner1,
        isSecond ? pair.Corner3 : pair.Corner2, toHit, isAtEdge) || Rounded(Sub(toHit, state.RefinedDistance)) >= 0.0)
        return;
    state.RefinedDistance = toHit;
    state.IsAtEdge = isAtEdge;
    state.Distance = toHit.Hi + state.Ray.Back + state.PositionError;
    state.Instance = instance;
    state.Row = row;
    state.Second = isSecond;
}

#else

// Float32 tests at once.
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
    float2 ambiguousDistance,
        toHit = HitPair(ray, pair.Corner0, pair.Corner1, pair.Corner2, pair.Corner3, ambiguousDistance);
    if (instance == state.ExcludedTriangle.x && row == state.ExcludedTriangle.y >> 1)
    {
        bool excludesFirst = (state.ExcludedTriangle.y & 1) == 0;
        toHit = excludesFirst ? float2(MISS, toHit.y) : float2(toHit.x, MISS);
        ambiguousDistance = excludesFirst ? float2(MISS, ambiguousDistance.y) : float2(ambiguousDistance.x, MISS);
    }
    state.AmbiguousDistance = min(state.AmbiguousDistance, min(ambiguousDistance.x, ambiguousDistance.y));
    float nearer = min(toHit.x, toHit.y);
    // Of equally near triangles the first in the BVH, in whatever order they are tested.
    bool isFirst = instance < state.Instance || instance == state.Instance && row < state.Row;
    if (nearer < state.Distance || nearer == state.Distance && state.Instance != NO_INSTANCE && isFirst)
    {
        state.Distance = nearer;
        state.Instance = instance;
        state.Row = row;
        state.Second = toHit.y < toHit.x;
    }
}

#endif

#endif
