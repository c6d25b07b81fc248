#ifndef GLINT_BINDINGS
#define GLINT_BINDINGS

#include "Constants.hlsl"
#include "Types.hlsl"

// Input: the scene.
#ifdef GLINT_FEW
// Up to four instances, searched one after the other.
float4 _FewToLocal[16];                     // an instance: three rows, then InstanceRecord.Stretch and Rounding
uint4 _FewFirstRow;
uint _InstanceCount;
#else
StructuredBuffer<uint4> _Top;               // binary tree over the instances
StructuredBuffer<InstanceRecord> _Instances;
uint _TopRoot;                              // where the search starts
#endif

// Input: the radar, about the middle of the scene, m.
// Each number is given by its float32 and by the rest that this leaves out.
// Start and direction of a ray are linear in its place in the picture: in rays to the right of and above _ReferenceRay.
// on a plane between the radar and the scene, at the radar if this is in the scene
float4 _Start, _StartRest;
float4 _StartRight, _StartRightRest;
float4 _StartUp, _StartUpRest;
float4 _Course, _CourseRest;                // direction; a unit vector on the axis of the picture
float4 _CourseRight, _CourseRightRest;
float4 _CourseUp, _CourseUpRest;
float4 _StartDepth;                         // x: from the radar to the plane along the axis; y: the rest
float4 _ReferenceRay;                       // x, y: whole numbers of rays from the left and bottom edge
float4 _ReceiverCentre, _ReceiverCentreRest;
float4 _ReceiverRight, _ReceiverRightRest;  // unit vectors
float4 _ReceiverUp, _ReceiverUpRest;
float4 _ReceiverForward, _ReceiverForwardRest;
float4 _ReceiverHalfSize;                   // x: half its width, y: the rest; z, w: the same of its height
// xyz: of the scene, in the world; w: the scene's size, as lengths that rays go in it, m
float4 _Middle;
uint _RaysAcross;
uint _RaysDown;
// rays traced: first and one past the last across, first and one past the last down
uint4 _Region;
uint _MaxBounces;
float4 _WaveNumberTurns;                    // x: 1 / wavelength, turns per m; y: the rest

// Input: the work of this dispatch.
StructuredBuffer<uint> _Tiles;              // 8 x 8 rays each: column | row << 16
uint _FirstTile;
uint _TileCount;                            // of this dispatch
// where the rays of each tile begin their search, four places a tile: one an instance
StructuredBuffer<uint4> _Starts;
uint _Shortcuts;                            // SHORTCUT_ flags
uint _Keep;                                 // KEEP_ what is written to _Rays
float _LengthUnits;                         // units of length sums a m: the longest path beyond _StartDepth takes 2^30
uint _FirstReturning;                       // rays of _Returning to follow
uint _ReturningCount;
uint _SubRays;                              // along the side of a ray's place: 1 for the ray itself

// Output.
RWStructuredBuffer<RayData> _Rays;
RWStructuredBuffer<uint> _Sums;             // see Sums.hlsl
// rays that may be received: pixel, place in the order of tiles. The exact kernels put instead:
// pixel, or NO_PIXEL if it is not received; length beyond twice _StartDepth, m. The kernels of paths put: bounces;
// from the last hit to the receiver's plane, m, 0 if it is not received
RWStructuredBuffer<uint2> _Returning;
RWStructuredBuffer<HitData> _Hits;          // of the rays of _Returning, _MaxBounces places each
RWStructuredBuffer<uint4> _FoundStarts;     // what the kernels Starts and StartsWide find for _Starts

static const uint NO_STARTS = 0xffffffff;

// The trees over the meshes, in rows of 16 bytes: one buffer, or several where one cannot hold them all.
#if defined(GLINT_BANKS)
StructuredBuffer<uint4> _Tree0;
StructuredBuffer<uint4> _Tree1;
StructuredBuffer<uint4> _Tree2;
StructuredBuffer<uint4> _Tree3;
StructuredBuffer<uint4> _Tree4;
StructuredBuffer<uint4> _Tree5;
StructuredBuffer<uint4> _Tree6;
StructuredBuffer<uint4> _Tree7;
#else
StructuredBuffer<uint4> _Tree0;
#endif

InstanceRecord LoadInstance(uint instance)
{
#ifdef GLINT_FEW
#ifdef GLINT_ONE
    instance = 0;
#endif
    InstanceRecord place = (InstanceRecord)0;
    place.ToLocalX = _FewToLocal[4 * instance];
    place.ToLocalY = _FewToLocal[4 * instance + 1];
    place.ToLocalZ = _FewToLocal[4 * instance + 2];
    place.Stretch = _FewToLocal[4 * instance + 3].x;
    place.Rounding = _FewToLocal[4 * instance + 3].y;
    place.FirstRow = _FewFirstRow[instance];
    return place;
#else
    return _Instances[instance];
#endif
}

uint4 LoadTree(uint bank, uint row)
{
#if defined(GLINT_BANKS)
    uint4 words;
    [branch]
    switch (bank)
    {
        case 0: words = _Tree0[row]; break;
        case 1: words = _Tree1[row]; break;
        case 2: words = _Tree2[row]; break;
        case 3: words = _Tree3[row]; break;
        case 4: words = _Tree4[row]; break;
        case 5: words = _Tree5[row]; break;
        case 6: words = _Tree6[row]; break;
        default: words = _Tree7[row]; break;
    }
    return words;
#else
    return _Tree0[row];
#endif
}

#endif
