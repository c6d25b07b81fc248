#ifndef GLINT_IDENTITY
#define GLINT_IDENTITY

#include "ClosestHit.hlsl"

// Identity of the hit triangle.
struct Identity
{
    uint Instance;        // index in the scene
    uint Triangle;        // index in the instance's mesh
    int Object;           // -1: unknown
    uint Surface;         // index in the scene
};

// Binary search: the last range that begins at or before the triangle.
uint4 FindRange(uint first, uint count, uint triangleNumber)
{
    uint end = first + count;
    [loop]
    while (end - first > 1)
    {
        uint middle = (first + end) / 2;
        if (_Ranges[middle].x <= triangleNumber)
            first = middle;
        else
            end = middle;
    }
    return _Ranges[first];
}

Identity Identify(Hit hit)
{
    InstanceRecord record = LoadInstance(hit.Instance);
    uint2 triangles = TrianglesOf(record, hit.Row);
    Identity identity;
    identity.Instance = record.Instance;
    identity.Triangle = hit.Second ? triangles.y : triangles.x;
    uint4 range = FindRange(record.FirstRange, record.RangeCount, identity.Triangle);
    identity.Object = asint(range.y);
    identity.Surface = range.z;
    return identity;
}

#endif
