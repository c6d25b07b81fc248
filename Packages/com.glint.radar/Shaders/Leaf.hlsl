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
    // m, in the scene: so far beside the ray searched may the ray go in truth where the search begins,
    float Slack;
    float SlackAMetre;    // and so much more for each m from there
#ifdef GLINT_EXACT
    ExactLine Line;       // the ray itself, in the frame of the mesh searched
    Two Exact;            // m, along it
    bool IsAtEdge;        // nobody can tell on which side of an edge
    // triangles of one pair that it may hit and that are yet to be tested: 4 * row, 1 for the first, 2 for the second
    uint Waiting;
#else
    float InDoubt;        // m: the nearest triangle that the ray goes by an edge of, and nobody can tell on which side
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

bool Waits(Found found)
{
    return found.Waiting != 0;
}

// Float32 tells which triangles the ray may hit: its search waits for their test. Such a test is dear,
// and threads side by side do theirs together: when each has one or is done.
void TestPair(SearchRay ray, uint instance, uint bank, uint firstRow, uint row, inout Found found)
{
    COUNT_PAIR;
    Pair pair = LoadPair(bank, firstRow + row);
    float reach = found.Distance + DistanceSlack(ray, found.Slack);
    bool mayHitFirst = MayHit(ray, pair.Corner0, pair.Corner1, pair.Corner2, reach),
        mayHitSecond = MayHit(ray, pair.Corner0, pair.Corner2, pair.Corner3, reach);
    if (instance == found.Leaving.x && row == found.Leaving.y >> 1)
    {
        bool isSecond = (found.Leaving.y & 1) != 0;
        mayHitFirst = mayHitFirst && isSecond;
        mayHitSecond = mayHitSecond && !isSecond;
    }
    if (mayHitFirst || mayHitSecond)
        found.Waiting = 4 * row + (mayHitFirst ? 1 : 0) + (mayHitSecond ? 2 : 0);
}

// Two-float arithmetic tells whether the ray hits a triangle that waits.
void TestWaiting(SearchRay ray, uint instance, uint bank, uint firstRow, inout Found found)
{
    if (found.Waiting == 0)
        return;
    uint row = found.Waiting >> 2;
    bool isSecond = (found.Waiting & 1) == 0;
    found.Waiting = isSecond || (found.Waiting & 2) == 0 ? 0 : found.Waiting & ~1u;
    Pair pair = LoadPair(bank, firstRow + row);
    Two toHit;
    bool isAtEdge;
    if (!Hits(ray, found.Line, DistanceSlack(ray, found.Slack), pair.Corner0, isSecond ? pair.Corner2 : pair.Corner1,
        isSecond ? pair.Corner3 : pair.Corner2, toHit, isAtEdge) || Rounded(Minus(toHit, found.Exact)) >= 0.0)
        return;
    found.Exact = toHit;
    found.IsAtEdge = isAtEdge;
    found.Distance = toHit.Hi + found.Line.Back + found.Slack;
    found.Instance = instance;
    found.Row = row;
    found.Second = isSecond;
}

#else

// Float32 tests at once.
bool Waits(Found found)
{
    return false;
}

void TestWaiting(SearchRay ray, uint instance, uint bank, uint firstRow, inout Found found)
{
}

void TestPair(SearchRay ray, uint instance, uint bank, uint firstRow, uint row, inout Found found)
{
    COUNT_PAIR;
    Pair pair = LoadPair(bank, firstRow + row);
    float2 inDoubt, toHit = HitPair(ray, pair.Corner0, pair.Corner1, pair.Corner2, pair.Corner3, inDoubt);
    if (instance == found.Leaving.x && row == found.Leaving.y >> 1)
    {
        bool leavesFirst = (found.Leaving.y & 1) == 0;
        toHit = leavesFirst ? float2(MISS, toHit.y) : float2(toHit.x, MISS);
        inDoubt = leavesFirst ? float2(MISS, inDoubt.y) : float2(inDoubt.x, MISS);
    }
    found.InDoubt = min(found.InDoubt, min(inDoubt.x, inDoubt.y));
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
