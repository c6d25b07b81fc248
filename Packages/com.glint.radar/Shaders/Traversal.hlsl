#ifndef GLINT_TRAVERSAL
#define GLINT_TRAVERSAL

#include "Bindings.hlsl"
#include "Geometry.hlsl"

// Bvh.MaxDepth in C#: a tree of that many levels never has more boxes waiting.
static const uint STACK_DEPTH = 48;

static const uint NO_HIT = 0xffffffff;

// The nearest triangle that the ray meets: its place in _Triangles, NO_HIT if none. Nearer child first; the farther one waits on the stack.
uint FindNearest(float3 origin, float3 direction, out float nearest)
{
    nearest = MISS;
    uint hit = NO_HIT;
    if (_TriangleCount == 0)
        return hit;

    float3 inverse = SafeInverse(direction);
    uint stack[STACK_DEPTH];
    uint waiting = 0;
    BvhNode node = _Nodes[0];
    [loop]
    while (true)
    {
        [loop]
        for (uint i = node.First; i < node.First + node.Count; i++)
        {
            float toHit = HitTriangle(_Triangles[i], origin, direction);
            if (toHit < nearest)
            {
                nearest = toHit;
                hit = i;
            }
        }

        bool descend = false;
        if (node.Count == 0)
        {
            uint left = node.First;
            BvhNode a = _Nodes[left];
            BvhNode b = _Nodes[left + 1];
            float enterA = EnterBox(a, origin, inverse, nearest);
            float enterB = EnterBox(b, origin, inverse, nearest);
            bool leftFirst = enterA <= enterB;
            descend = min(enterA, enterB) < MISS;
            if (max(enterA, enterB) < MISS)
                stack[waiting++] = leftFirst ? left + 1 : left;
            if (leftFirst)
                node = a;
            else
                node = b;
        }
        if (!descend)
        {
            if (waiting == 0)
                return hit;
            node = _Nodes[stack[--waiting]];
        }
    }
    return hit; // not reached; FXC asks for it
}

#endif
