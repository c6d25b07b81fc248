#ifndef GLINT_TRAVERSE_BINARY
#define GLINT_TRAVERSE_BINARY

#include "Leaf.hlsl"
#include "BinaryBvh.hlsl"

static const uint4 ROOT_ENTRY_POINTS = uint4(ROOT, DONE, DONE, DONE);

// Traverses the BVH of one mesh from up to four entry points in order. The near child of a node is visited first, the
// far one is put on the stack. The fastest on GPUs. AnyHit: ends at the first hit.
void TraverseMesh(TraversalRay ray, uint instance, uint page, uint firstRow, uint4 entryPoints, bool anyHit,
    inout TraversalState state)
{
    uint stack[STACK_BOTTOM + 3 + BINARY_LEVELS]; // and three further entry points
    stack[0] = DONE;
    stack[1] = DONE;
    uint top = 1;
    for (uint entry = 3; entry > 0; entry--)
        if (entryPoints[entry] != DONE)
            stack[++top] = entryPoints[entry];
    uint current = entryPoints.x;
    BoxRay boxRay = MakeBoxRay(ray, asfloat(LoadBvh(page, firstRow).xyz));
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
                uint row = firstRow + current;
                Entered entered = EnterChildren(LoadBvh(page, row), LoadBvh(page, row + 1),
                    LoadBvh(page, row + 2).xyz, boxRay, state.Distance);
                current = entered.Near;
                if (entered.Both)
                    stack[++top] = entered.Far;
                if (!entered.Any)
                    current = stack[top--];
            }
            [loop]
            while (current >= LEAF && current != DONE && !HasPending(state))
            {
                TestPair(ray, instance, page, firstRow, current & ~LEAF, state);
                current = IsEnough(state, anyHit) ? DONE : stack[top--];
            }
        }
        TestPending(ray, instance, page, firstRow, state);
        if (IsEnough(state, anyHit))
            return;
    }
}

#endif
