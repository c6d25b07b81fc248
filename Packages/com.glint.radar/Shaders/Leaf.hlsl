#ifndef GLINT_LEAF
#define GLINT_LEAF

#include "Bindings.hlsl"
#include "Geometry.hlsl"

static const uint NO_INSTANCE = 0xffffffff;

// The nearest triangle found so far.
struct Found
{
    float Distance;       // m; where the search ends as long as nothing is found
    uint Instance;        // NO_INSTANCE: nothing
    uint Row;             // of the pair of triangles in its tree
    bool Second;          // which of the pair
    uint2 Leaving;        // the triangle that the ray has just left, which it cannot meet again: see NumberOf
};

// A triangle by its instance and its number in the tree.
uint2 NumberOf(uint instance, uint row, bool second)
{
    return uint2(instance, 2 * row + (second ? 1 : 0));
}

// Four corners: triangles (0, 1, 2) and (0, 2, 3).
struct Pair
{
    float3 Corner0, Corner1, Corner2, Corner3;
};

Pair LoadPair(uint bank, uint row)
{
    float4 a = asfloat(LoadTree(bank, row)), b = asfloat(LoadTree(bank, row + 1)), c = asfloat(LoadTree(bank, row + 2));
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

void TestPair(SearchRay ray, uint instance, uint bank, uint firstRow, uint row, inout Found found)
{
    COUNT_PAIR;
    Pair pair = LoadPair(bank, firstRow + row);
    float2 toHit = HitPair(ray, pair.Corner0, pair.Corner1, pair.Corner2, pair.Corner3);
    if (instance == found.Leaving.x && row == found.Leaving.y >> 1)
        toHit = (found.Leaving.y & 1) == 0 ? float2(MISS, toHit.y) : float2(toHit.x, MISS);
    float nearer = min(toHit.x, toHit.y);
    // Of equally near triangles the first in the tree, in whatever order they are tested.
    bool isFirst = instance < found.Instance || instance == found.Instance && row < found.Row;
    if (nearer < found.Distance || nearer == found.Distance && found.Instance != NO_INSTANCE && isFirst)
    {
        found.Distance = nearer;
        found.Instance = instance;
        found.Row = row;
        found.Second = toHit.y < toHit.x;
    }
}

#endif
