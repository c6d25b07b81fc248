#ifndef GLINT_SEARCH_BINARY
#define GLINT_SEARCH_BINARY

#include "Leaf.hlsl"
#include "BinaryTree.hlsl"

static const uint4 FROM_ROOT = uint4(0, DONE, DONE, DONE);

// Searches the tree of one mesh from up to four places in order: two children a node, the nearer one first, the farther one waits on a stack. The fastest on GPUs.
void SearchMesh(SearchRay ray, uint instance, uint bank, uint firstRow, uint4 starts, inout Found found)
{
    uint stack[BINARY_LEVELS + 4]; // three starts and a DONE besides
    stack[0] = DONE;
    uint waiting = 0;
    for (uint start = 3; start > 0; start--)
        if (starts[start] != DONE)
            stack[++waiting] = starts[start];
    uint current = starts.x;
    [loop]
    while (current != DONE)
    {
        [loop]
        while ((current & LEAF) == 0)
        {
            COUNT_NODE;
            uint row = firstRow + current;
            Entered entered = EnterChildren(LoadTree(bank, row), LoadTree(bank, row + 1), LoadTree(bank, row + 2), LoadTree(bank, row + 3), ray, found.Distance);
            current = entered.Near;
            if (entered.Far != DONE)
                stack[++waiting] = entered.Far;
            if (current == DONE)
            {
                current = stack[waiting];
                waiting = max(waiting, 1) - 1;
            }
        }
        [loop]
        while (current >= LEAF && current != DONE)
        {
            TestPair(ray, instance, bank, firstRow, current & ~LEAF, found);
            current = stack[waiting];
            waiting = max(waiting, 1) - 1;
        }
    }
}

#endif
