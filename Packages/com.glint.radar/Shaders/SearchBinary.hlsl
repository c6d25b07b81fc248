#ifndef GLINT_SEARCH_BINARY
#define GLINT_SEARCH_BINARY

#include "Leaf.hlsl"
#include "BinaryTree.hlsl"

// Searches the tree of one mesh: two children a node, the nearer one first, the farther one waits on a stack. The fastest on GPUs.
void SearchMesh(SearchRay ray, uint instance, uint bank, uint firstRow, inout Found found)
{
    uint stack[BINARY_LEVELS + 1];
    stack[0] = DONE;
    uint waiting = 0;
    uint current = 0;
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
