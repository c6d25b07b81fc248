#ifndef GLINT_TYPES
#define GLINT_TYPES

// Structs shared with C#, in rows of 16 bytes. The tag above each is found in both languages; a test compares the layouts.

// GLINT_RAY_DATA: one ray as the kernel writes it (Core/Radar/RayData.cs).
struct RayData
{
    float3 LastHit;       // m; the camera for a ray that hit nothing
    float PathLength;     // m; received: camera to last hit to receiver plane, else camera to last hit
    float3 Direction;     // of the last segment
    float Phase;          // rad, 0 to 2 pi; 0 if not received
    float InPhase;        // cos(phase), 0 if not received
    float Quadrature;     // sin(phase), 0 if not received
    uint Pixel;           // x + y * rays across
    uint Bounces;
};

// GLINT_BVH_NODE: a box of the tree (Core/Geometry/BvhNode.cs).
struct BvhNode
{
    float3 Min;           // m
    uint First;           // leaf: first triangle; inner node: left child, the right one follows it
    float3 Max;           // m
    uint Count;           // leaf: triangles, at least 1; inner node: 0
};

// GLINT_TRIANGLE: a triangle in the order of the leaves (Core/Geometry/TriangleRecord.cs).
struct TriangleRecord
{
    float3 Corner;        // m
    uint Unused0;
    float3 Edge1;         // from the first corner to the second, m
    uint Unused1;
    float3 Edge2;         // from the first corner to the third, m
    uint Unused2;
};

// GLINT_GROUP_SUM: what one thread group adds to the totals (Core/Radar/GroupSum.cs).
struct GroupSum
{
    uint Hits;            // rays whose first segment hits
    uint Bounces;
    float PathLength;     // sum of lengths up to the last hit, m
    uint Unused;
};

#endif
