#ifndef GLINT_TRAVERSE_WIDE
#define GLINT_TRAVERSE_WIDE

#include "../Leaf.hlsl"
#include "../BinaryBvh.hlsl"

// The stack has one word for each node with pending children: at most 16, for 14 inner levels (WideCollapse.MaxLevels
// in C#) and three further entry points. The upper 20 bits are the record of the node's first child. Below are 4 bits
// for each pending child, the next one lowest: 8 | 4 for a leaf | index of the child. A software device keeps 16 named
// words in registers; an array would double the kernel's time.
struct WideStack
{
    uint4 A, B, C, D;     // the top is A.x
};

static const uint CHILDREN = 0xfff;

// The next child of a stack word: its record, with LEAF for a leaf; DONE if no child is pending.
uint NextOf(uint word)
{
    return (word & 8) == 0 ? DONE : ((word >> 12) + (word & 3)) | ((word & 4) << 29);
}

uint WithoutNext(uint word)
{
    return (word & ~CHILDREN) | (word & CHILDREN) >> 4;
}

WideStack Pushed(WideStack s, uint word)
{
    WideStack r;
    r.A = uint4(word, s.A.xyz);
    r.B = uint4(s.A.w, s.B.xyz);
    r.C = uint4(s.B.w, s.C.xyz);
    r.D = uint4(s.C.w, s.D.xyz);
    return r;
}

WideStack Popped(WideStack s)
{
    WideStack r;
    r.A = uint4(s.A.yzw, s.B.x);
    r.B = uint4(s.B.yzw, s.C.x);
    r.C = uint4(s.C.yzw, s.D.x);
    r.D = uint4(s.D.yzw, 0);
    return r;
}

// Selects one of three, without a branch.
WideStack Choose(bool pushes, WideStack pushed, bool pops, WideStack popped, WideStack unchanged)
{
    WideStack r;
    r.A = pushes ? pushed.A : pops ? popped.A : unchanged.A;
    r.B = pushes ? pushed.B : pops ? popped.B : unchanged.B;
    r.C = pushes ? pushed.C : pops ? popped.C : unchanged.C;
    r.D = pushes ? pushed.D : pops ? popped.D : unchanged.D;
    return r;
}

// One plane of each of the four children of a node, one byte each.
float4 Planes(uint bytes, float step, float at)
{
    return float4(int4(uint4(bytes, bytes >> 8, bytes >> 16, bytes >> 24) & 0xff)) * step + at;
}

// Distances are compared by their bits: integers have the order of positive floats, and for negative ones the sign
// suffices.
uint4 ChildKeys(uint4 a, uint4 b, uint4 c, TraversalRay ray, float reach)
{
    uint3 exponents = uint3(a.w << 23, a.w << 15, a.w << 7) & 0x7f800000;
    float3 at = (asfloat(a.xyz) - ray.Origin) * ray.Inverse, enterAt = at, leaveAt = at;
#ifdef GLINT_REFINE
    enterAt -= ray.PositionError * abs(ray.Inverse);
    leaveAt += ray.PositionError * abs(ray.Inverse);
#endif
    float3 step = asfloat(exponents) * ray.Inverse;
    bool3 backwards = ray.Inverse < 0.0;
    uint3 lower = b.xyz, upper = uint3(b.w, c.xy);
    uint3 first =
        uint3(backwards.x ? upper.x : lower.x, backwards.y ? upper.y : lower.y, backwards.z ? upper.z : lower.z);
    uint3 last =
        uint3(backwards.x ? lower.x : upper.x, backwards.y ? lower.y : upper.y, backwards.z ? lower.z : upper.z);
    int4 enter = max(max(asint(Planes(first.x, step.x, enterAt.x)), asint(Planes(first.y, step.y, enterAt.y))),
        max(asint(Planes(first.z, step.z, enterAt.z)), 0));
    int4 leave = min(min(asint(Planes(last.x, step.x, leaveAt.x)), asint(Planes(last.y, step.y, leaveAt.y))),
        min(asint(Planes(last.z, step.z, leaveAt.z)), asint(reach)));
    leave = asint(asfloat(leave) * LEAVE_LATER);

    uint4 leaf = (a.w >> uint4(22, 23, 24, 25)) & 4;
    uint4 valid = (a.w >> uint4(25, 26, 27, 28)) & 8;
    uint4 keys = ((uint4)enter & ~15u) | valid | leaf | uint4(0, 1, 2, 3);
    return uint4(
        valid.x != 0 && enter.x <= leave.x ? keys.x : 0xfffffff0,
        valid.y != 0 && enter.y <= leave.y ? keys.y : 0xfffffff0,
        valid.z != 0 && enter.z <= leave.z ? keys.z : 0xfffffff0,
        valid.w != 0 && enter.w <= leave.w ? keys.w : 0xfffffff0);
}

uint4 Sorted(uint4 k)
{
    uint a = min(k.x, k.y), b = max(k.x, k.y), c = min(k.z, k.w), d = max(k.z, k.w);
    uint first = min(a, c), last = max(b, d), e = max(a, c), f = min(b, d);
    return uint4(first, min(e, f), max(e, f), last);
}

// The root as the only child of a stack word.
static const uint4 ROOT_ENTRY_POINTS = uint4(8, DONE, DONE, DONE);

// Traverses the BVH of one mesh from up to four entry points in order, the nearest of the four children of a node
// first. The fastest on software devices, where fetches cost most. AnyHit: ends at the first hit.
void TraverseMesh(TraversalRay ray, uint instance, uint page, uint firstRow, uint4 entryPoints, bool anyHit,
    inout TraversalState state)
{
    WideStack stack = (WideStack)0;
    stack.A = uint4(entryPoints.yzw == DONE ? 0 : entryPoints.yzw, 0);
    uint current = entryPoints.x == DONE ? DONE : NextOf(entryPoints.x);
    [loop]
    while (current != DONE || HasPending(state)) // only refine kernels have pending tests
    {
        [loop]
        while (current != DONE && !HasPending(state))
        {
            [loop]
            while ((current & LEAF) == 0)
            {
                COUNT_NODE;
                uint row = firstRow + 3 * current;
                uint4 a = LoadBvh(page, row), b = LoadBvh(page, row + 1), c = LoadBvh(page, row + 2);
                uint4 keys = Sorted(ChildKeys(a, b, c, ray, state.Distance));
                uint pending = (keys.y & 15) | (keys.z & 15) << 4 | (keys.w & 15) << 8;
                bool enters = (keys.x & 8) != 0;

                // Descends to the nearest child, or advances to the next pending one.
                current = NextOf(enters ? c.z << 12 | (keys.x & 15) : stack.A.x);
                bool pushes = pending != 0;
                WideStack taken = stack;
                taken.A.x = enters ? stack.A.x : WithoutNext(stack.A.x);
                bool pops = (taken.A.x & CHILDREN) == 0;
                stack = Choose(pushes, Pushed(stack, c.z << 12 | pending), pops, Popped(stack), taken);
            }
            [loop]
            while (current >= LEAF && current != DONE && !HasPending(state))
            {
                TestPair(ray, instance, page, firstRow, 3 * (current & ~LEAF), state);
                current = IsEnough(state, anyHit) ? DONE : NextOf(stack.A.x);
                stack.A.x = WithoutNext(stack.A.x);
                stack = Choose(false, stack, (stack.A.x & CHILDREN) == 0, Popped(stack), stack);
            }
        }
        TestPending(ray, instance, page, firstRow, state);
        if (IsEnough(state, anyHit))
            return;
    }
}

#endif
