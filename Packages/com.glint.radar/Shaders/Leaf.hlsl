#ifndef GLINT_LEAF
#define GLINT_LEAF

#include "Bindings.hlsl"
#include "Geometry.hlsl"
#include "Real.hlsl"

static const uint NO_INSTANCE = 0xffffffff;

#ifdef GLINT_EXACT
#include "ExactHit.hlsl"
#endif

// The nearest triangle found so far.
struct Found
{
    float Distance;       // m, from where the search began; where it ends as long as nothing is found
    uint Instance;        // NO_INSTANCE: nothing
    uint Row;             // of the pair of triangles in its tree
    bool Second;          // which of the pair
    uint2 Leaving;        // the triangle that the ray has just left, which it cannot meet again: see NumberOf
#ifdef GLINT_EXACT
    ExactLine Line;       // the ray itself, in the frame of the mesh searched
    Two Exact;            // m, along it
    bool IsAtEdge;        // nobody can tell on which side of an edge
#endif
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

#ifdef GLINT_EXACT

void TestTriangle(SearchRay ray, uint instance, uint row, bool second, float3 a, float3 b, float3 c, inout Found found)
{
    bool isLeft = instance == found.Leaving.x && 2 * row + (second ? 1 : 0) == found.Leaving.y;
    float2 distances;
    if (isLeft || !MayHit(ray, a, b, c, distances))
        return;
    // In a frame that stretches, distances round as its lengths do.
    float slack = max(found.Line.Slack, ray.Slack * abs(ray.Shear.z));
    if (distances.x - slack > found.Distance)
        return;
    Two toHit;
    bool isAtEdge;
    if (!Hits(found.Line, a, b, c, distances - found.Line.Back, slack, toHit, isAtEdge) || Rounded(Minus(toHit, found.Exact)) >= 0.0)
        return;
    found.Exact = toHit;
    found.IsAtEdge = isAtEdge;
    found.Distance = toHit.Hi + found.Line.Back + found.Line.Slack;
    found.Instance = instance;
    found.Row = row;
    found.Second = second;
}

// Float32 tells which triangles the ray may hit, and two-float arithmetic which it does.
void TestPair(SearchRay ray, uint instance, uint bank, uint firstRow, uint row, inout Found found)
{
    COUNT_PAIR;
    Pair pair = LoadPair(bank, firstRow + row);
    [loop]
    for (uint i = 0; i < 2; i++)
        TestTriangle(ray, instance, row, i == 1, pair.Corner0, i == 0 ? pair.Corner1 : pair.Corner2, i == 0 ? pair.Corner2 : pair.Corner3, found);
}

#else

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

#endif
