#ifndef GLINT_BINARY_TREE
#define GLINT_BINARY_TREE

#include "Geometry.hlsl"

// A reference to a child: its row, or with this bit a leaf.
static const uint LEAF = 0x80000000;

// No reference: the search is over.
static const uint DONE = 0xffffffff;

// Inner levels a tree may have (BoxTreeBuilder.MaxLevels in C#): no more children wait at once.
static const uint BINARY_LEVELS = 28;

// The children of a node that the ray enters nearer than reach.
struct Entered
{
    uint Near;            // DONE if it enters none
    uint Far;             // DONE unless it enters both
};

Entered EnterChildren(uint4 a, uint4 b, uint4 zs, uint4 references, SearchRay ray, float reach)
{
    // lower x, upper x, lower y, upper y of each child; lower and upper z of both
    float4 ax = (asfloat(a) - ray.Origin.xxyy) * ray.Inverse.xxyy;
    float4 bx = (asfloat(b) - ray.Origin.xxyy) * ray.Inverse.xxyy;
    float4 z = (asfloat(zs) - ray.Origin.z) * ray.Inverse.z;
    float enterA = max(max(min(ax.x, ax.y), min(ax.z, ax.w)), max(min(z.x, z.y), 0.0));
    float leaveA = min(min(max(ax.x, ax.y), max(ax.z, ax.w)), min(max(z.x, z.y), reach));
    float enterB = max(max(min(bx.x, bx.y), min(bx.z, bx.w)), max(min(z.z, z.w), 0.0));
    float leaveB = min(min(max(bx.x, bx.y), max(bx.z, bx.w)), min(max(z.z, z.w), reach));
    bool hitsA = enterA <= leaveA * LEAVE_LATER;
    bool hitsB = enterB <= leaveB * LEAVE_LATER;

    Entered entered;
    bool aFirst = hitsA && !(hitsB && enterB < enterA);
    entered.Near = aFirst ? references.x : hitsB ? references.y : DONE;
    entered.Far = hitsA && hitsB ? (aFirst ? references.y : references.x) : DONE;
    return entered;
}

#endif
