#ifndef GLINT_TYPES
#define GLINT_TYPES

// Structs shared with C#, in rows of 16 bytes. The tag above each is the same in both languages; a test compares the
// layouts.

// GLINT_RAY_DATA: one ray as the kernel writes it (Core/Radar/RayData.cs).
struct RayData
{
    float3 LastHit;       // m, in the world; the ray's start if it hit nothing
    float PathLength;     // m; received: radar to last hit to receiver plane, else radar to last hit
    float3 Direction;     // of the last segment
    float PathLengthLo; // m; Lo of the path length if received
    float InPhase;        // cos(phase), 0 if not received
    float Quadrature;     // sin(phase), 0 if not received
    uint Pixel;           // x + y * rays across; NO_PIXEL outside the picture
    uint Bounces;         // with RAY_RECEIVED if it is received
};

// GLINT_HIT_DATA: a reflection of one ray as the kernel writes it (Core/Radar/HitData.cs).
struct HitData
{
    float3 Position;      // m, relative to the scene's centre
    uint Instance;        // index in the scene
    float3 Direction;     // unit vector, after the reflection
    uint Triangle;        // index in the instance's mesh
    int Object;           // -1: unknown
    uint Surface;         // index in the scene
    uint2 Unused;
};

// GLINT_INSTANCE: an instance of a mesh BVH (Runtime/Tracing/InstanceRecord.cs).
struct InstanceRecord
{
    float4 ToLocalX;      // rows of the matrix from the scene's centre to the mesh's frame
    float4 ToLocalY;
    float4 ToLocalZ;
    float4 ToLocalXLo;    // their Lo parts
    float4 ToLocalYLo;
    float4 ToLocalZLo;
    uint FirstRow;        // of the BVH in its page, in rows of 16 bytes
    uint Page;
    float Stretch;        // maximum scale of lengths into the mesh's frame
    float Rounding;       // of positions transformed into that frame, m
    uint FirstRecordRow;  // of the record that the BVH's leaves are numbered from, after FirstRow
    uint FirstIdentityRow; // first row with numbers of triangles, after FirstRow
    uint FirstRange;      // the instance's objects and surfaces in _Ranges
    uint RangeCount;
    uint Instance;        // index in the scene
    uint Unused[3];
};

// GLINT_SURFACE_SAMPLE: a point of a surface, of which a radar screen takes an echo (Core/Screen/SurfaceSamples.cs).
struct SurfaceSample
{
    float3 Position;      // in the mesh's frame
    float Area;           // of the surface that it stands for, m2
    uint Instance;        // index in the scene
    uint Triangle;        // index in the instance's mesh
    uint2 Unused;
};

#endif
