#ifndef GLINT_BINARY_BVH
#define GLINT_BINARY_BVH

#include "Constants.hlsl"
#include "Geometry.hlsl"

// Bit of a reference to a child that is a leaf; the rest is its row.
static const uint LEAF = 0x80000000;

// No reference: end of the traversal.
static const uint DONE = 0xffffffff;

// Sentinels at the bottom of the stack: two DONE, so that a pop needs no test for an empty stack.
static const uint STACK_BOTTOM = 2;

// A ray for the slab test of boxes given by centre, relative to the BVH's centre, and half size.
struct BoxRay
{
    float3 Scale;         // distance along the ray per metre along each axis
    float3 ToCentre;      // distance to the planes through the BVH's centre
#ifdef GLINT_REFINE
    float PositionError;  // added to half sizes
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

// Distances at which a ray enters and leaves a box, as the bits of floats; enter <= leave if it hits the box nearer
// than reach. Integers are compared because a GPU computes the maximum of three in one instruction. Their order is that
// of the floats unless both are negative, where it is reversed. For a box behind the ray leave is then less than enter,
// which is a miss, as it should be.
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

// Half sizes are the upper halves of floats. Those of child a are in the upper bits and used unmasked: the bits below
// enlarge them by less than one step. Those of child b are in the lower bits.
float3 HalfSizeA(uint3 halfSizes)
{
    return asfloat(halfSizes);
}

float3 HalfSizeB(uint3 halfSizes)
{
    return asfloat(halfSizes << 16);
}

// Children of a node that the ray enters nearer than reach.
struct Entered
{
    bool Any, Both;
    uint Near;            // if Any
    uint Far;             // if Both
};

// Tests the children of a node from its three rows: centre and reference of child a, the same of child b, half sizes.
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
