#ifndef GLINT_BINARY_BVH
#define GLINT_BINARY_BVH

#include "Constants.hlsl"
#include "Geometry.hlsl"

// A reference to a child: its row, or with this bit a leaf.
static const uint LEAF = 0x80000000;

// No reference: the search is over.
static const uint DONE = 0xffffffff;

// Two DONE below what waits: whoever takes the first has no need to look whether there was anything.
static const uint STACK_BOTTOM = 2;

// A ray as boxes want it, which are given by their middles from the BVH's centre and their half sizes.
struct BoxRay
{
    float3 Scale;         // distance along the ray a step along each axis
    float3 ToCentre;      // distance to the planes through the centre
#ifdef GLINT_REFINE
    float PositionError;  // half sizes are larger by this
#endif
};

BoxRay MakeBoxRay(TraversalRay ray, float3 centre)
{
    BoxRay boxRay;
    boxRay.Scale = ray.Inverse;
    boxRay.ToCentre = (centre - ray.Origin) * ray.Inverse;
#ifdef GLINT_REFINE
    boxRay.PositionError = ray.PositionError;
#endif
    return boxRay;
}

// Where a ray enters and leaves a box, as the bits of floats: enter <= leave if it meets it nearer than reach.
// Whole numbers are compared because a GPU takes the larger of three in one step.
// They are in the order of floats unless both are negative.
// Then it is reversed, and of a box behind the ray, where a leave is negative, the leave taken is less than the enter:
// it is missed as it should be.
int2 EnterAndLeave(float3 centre, float3 halfSize, BoxRay ray, float reach)
{
    float3 toCentre = centre * ray.Scale + ray.ToCentre, size = abs(ray.Scale);
#ifdef GLINT_REFINE
    halfSize += ray.PositionError;
#endif
    int3 enter = asint(toCentre - halfSize * size), leave = asint(toCentre + halfSize * size);
    int leaveAll = min(min(leave.x, leave.y), min(leave.z, asint(reach)));
    return int2(max(max(enter.x, enter.y), enter.z), asint(asfloat(leaveAll) * LEAVE_LATER));
}

// Half sizes are the upper halves of floats: those of child a in the upper bits,
// as they are (what stands below makes them larger by less than one step), those of child b in the lower bits.
float3 HalfSizeA(uint3 halfSizes)
{
    return asfloat(halfSizes);
}

float3 HalfSizeB(uint3 halfSizes)
{
    return asfloat(halfSizes << 16);
}

// The children of a node that the ray enters nearer than reach.
struct Entered
{
    bool Any, Both;
    uint Near;            // if it enters any
    uint Far;             // if it enters both
};

// From the three rows of a node: middle and reference of child a, the same of child b, half sizes of both.
Entered EnterChildren(uint4 a, uint4 b, uint3 halfSizes, BoxRay ray, float reach)
{
    int2 throughA = EnterAndLeave(asfloat(a.xyz), HalfSizeA(halfSizes), ray, reach);
    int2 throughB = EnterAndLeave(asfloat(b.xyz), HalfSizeB(halfSizes), ray, reach);
    bool hitsA = throughA.x <= throughA.y, hitsB = throughB.x <= throughB.y;

    Entered entered;
    entered.Any = hitsA || hitsB;
    entered.Both = hitsA && hitsB;
    bool isBNear = entered.Both ? throughB.x < throughA.x : hitsB;
    entered.Near = isBNear ? b.w : a.w;
    entered.Far = isBNear ? a.w : b.w;
    return entered;
}

#endif
