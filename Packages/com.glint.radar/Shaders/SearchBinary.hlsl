#ifndef GLINT_SEARCH_BINARY
#define GLINT_SEARCH_BINARY

#include "Leaf.hlsl"
#include "BinaryTree.hlsl"

static const uint4 FROM_ROOT = uint4(ROOT, DONE, DONE, DONE);

// Searches the tree of one mesh from up to four places in order: two children a node, the nearer one first,
// the farther one waits on a stack. The fastest on GPUs.
void SearchMesh(SearchRay ray, uint instance, uint bank, uint firstRow, uint4 starts, inout Found found)
{
    uint stack[STACK_BOTTOM + 3 + BINARY_LEVELS]; // three starts besides
    stack[0] = DONE;
    stack[1] = DONE;
    uint top = 1;
    for (uint start = 3; start > 0; start--)
        if (starts[start] != DONE)
            stack[++top] = starts[start];
    uint current = starts.x;
    BoxRay boxRay = MakeBoxRay(ray, asfloat(LoadTree(bank, firstRow).xyz));
    [loop]
    while (current != DONE || Waits(found)) // only exact kernels ever wait
    {
        [loop]
        while (current != DONE && !Waits(found))
        {
            [loop]
            while ((current & LEAF) == 0)
            {
                COUNT_NODE;
                uint row = firstRow + current;
                Entered entered = EnterChildren(LoadTree(bank, row), LoadTree(bank, row + 1),
                    LoadTree(bank, row + 2).xyz, boxRay, found.Distance);
                current = entered.Near;
                if (entered.Both)
                    stack[++top] = entered.Far;
                if (!entered.Any)
                    current = stack[top--];
            }
            [loop]
            while (current >= LEAF && current != DONE && !Waits(found))
            {
                TestPair(ray, instance, bank, firstRow, current & ~LEAF, found);
                current = stack[top--];
            }
        }
        TestWaiting(ray, instance, bank, firstRow, found);
    }
}

#endif
