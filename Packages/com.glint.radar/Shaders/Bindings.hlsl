#ifndef GLINT_BINDINGS
#define GLINT_BINDINGS

#include "Constants.hlsl"
#include "Types.hlsl"

// Input: the scene.
#ifdef GLINT_INLINE_INSTANCES
// Up to four instances, traversed in a loop. Their number is the first of all constants: Mesa 22.3's lavapipe compiles a kernel
// anew for each value of the first one.
uint _InstanceCount;
float4 _InlineToLocal[16];                  // per instance: three rows, then InstanceRecord.Stretch and Rounding
uint4 _InlineRows[4];                       // FirstRow, FirstRecordRow, FirstIdentityRow and Instance of each
#else
StructuredBuffer<uint4> _InstanceBvh;       // binary BVH over the instances
StructuredBuffer<InstanceRecord> _Instances;
uint _InstanceBvhRoot;                      // reference to the root
// ranges of the instances' triangles, in order: first triangle, object, surface
StructuredBuffer<uint4> _Ranges;
#endif

// Input: the radar, relative to the scene's centre, m. Numbers are double-floats: the float32 and its Lo part.
// Origin and direction of a ray are linear in its position in the picture, in rays to the right of and above
// _ReferencePixel.
// on a plane between the radar and the scene; at the radar if it is in the scene
float4 _Origin, _OriginLo;
float4 _OriginDx, _OriginDxLo;
float4 _OriginDy, _OriginDyLo;
float4 _Direction, _DirectionLo;            // unit vector on the axis of the picture
float4 _DirectionDx, _DirectionDxLo;
float4 _DirectionDy, _DirectionDyLo;
float4 _OriginDepth;                        // x: distance from the radar to that plane along the axis; y: Lo
float4 _ReferencePixel;                     // x, y: whole rays from the left and bottom edge
float4 _ReceiverCentre, _ReceiverCentreLo;
float4 _ReceiverRight, _ReceiverRightLo;    // unit vectors
float4 _ReceiverUp, _ReceiverUpLo;
float4 _ReceiverForward, _ReceiverForwardLo;
float4 _ReceiverHalfSize;                   // x: half its width, y: Lo; z, w: half its height
// xyz: the scene's centre in the world; w: bound of segment lengths, m
float4 _SceneCentreExtent;
uint _RaysAcross;
// rays traced: first and end across, first and end down
uint4 _Region;
uint _MaxBounces;
float4 _WaveNumberTurns;                    // x: 1 / wavelength, turns per m; y: Lo

// Input: the work of this dispatch.
StructuredBuffer<uint> _Cells;              // first tile (8 x 8 rays) of each: column | row << 16
uint4 _CellSize;                            // tiles across a cell, and down; first cell of this dispatch, and its tile there
float4 _CellInverse;                        // x: 1 / tiles of a cell, y: 1 / tiles across
uint _TileCount;                            // of this dispatch
// entry points of each cell of this dispatch, four elements a cell: one per instance
StructuredBuffer<uint4> _EntryPoints;
uint _Culling;                              // CULL_ flags
uint _Readback;                             // READBACK_ mode of _Rays
float _LengthUnits;                         // units of length sums per m: the maximum relative length is 2^30
uint _HasSubRays;                           // 1: the rays of this dispatch are sub-rays
StructuredBuffer<uint> _SubRayPixels;       // pixels with sub-rays
uint4 _KnownCapacity;                       // candidates with known triangles; x: of rays, y: of sub-rays
uint _MaxSpread;                            // maximum number of threads of a candidate to search
uint _FirstSearched;                        // candidates searched in earlier dispatches
uint _PathCount;                            // rays of _Candidates whose paths are recorded
uint _ReceivedCapacity;                     // received rays that _Sums can hold
uint _FirstReceived;                        // received rays of earlier dispatches
uint _HasLengths;                           // 1: the lengths of received rays are kept in _Lengths

// Output.
RWStructuredBuffer<RayData> _Rays;
RWStructuredBuffer<uint> _Sums;             // see Sums.hlsl, and COUNT_ in Constants.hlsl
// Candidates: pixel, then index in the order of tiles or number of the sub-ray. The first _KnownCapacity
// are those of which float32 knows every triangle; behind them are those to search. The refine kernels replace them by pixel, or NO_PIXEL if not received, and path length less
// twice _OriginDepth, m. The kernels of paths write bounces, with RAY_RECEIVED if received, and the distance from the
// last hit to the receiver's plane, m.
RWStructuredBuffer<uint2> _Candidates;
// The triangles that a candidate meets first (see NumberOf), _MaxBounces elements each; fewer end with NO_INSTANCE.
// The first 2 * _KnownCapacity candidates have them.
RWStructuredBuffer<uint2> _Met;
// By pixel of the region, row by row: length of a received ray as in _Candidates, else NO_LENGTH.
RWStructuredBuffer<uint> _Lengths;
RWStructuredBuffer<HitData> _Hits;            // _MaxBounces elements for each ray of _Candidates
RWStructuredBuffer<uint4> _FoundEntryPoints;  // output of the kernels EntryPoints and EntryPointsWide

static const uint NO_ENTRY_POINTS = 0xffffffff;

// The mesh BVHs, in rows of 16 bytes: one page, or several if one cannot hold them.
#if defined(GLINT_PAGED)
StructuredBuffer<uint4> _Bvh0;
StructuredBuffer<uint4> _Bvh1;
StructuredBuffer<uint4> _Bvh2;
StructuredBuffer<uint4> _Bvh3;
StructuredBuffer<uint4> _Bvh4;
StructuredBuffer<uint4> _Bvh5;
StructuredBuffer<uint4> _Bvh6;
StructuredBuffer<uint4> _Bvh7;
#else
StructuredBuffer<uint4> _Bvh0;
#endif

InstanceRecord LoadInstance(uint instance)
{
#ifdef GLINT_INLINE_INSTANCES
#ifdef GLINT_SINGLE_INSTANCE
    instance = 0;
#endif
    InstanceRecord record = (InstanceRecord)0;
    record.ToLocalX = _InlineToLocal[4 * instance];
    record.ToLocalY = _InlineToLocal[4 * instance + 1];
    record.ToLocalZ = _InlineToLocal[4 * instance + 2];
    record.Stretch = _InlineToLocal[4 * instance + 3].x;
    record.Rounding = _InlineToLocal[4 * instance + 3].y;
    record.FirstRow = _InlineRows[instance].x;
    record.FirstRecordRow = _InlineRows[instance].y;
    record.FirstIdentityRow = _InlineRows[instance].z;
    record.Instance = _InlineRows[instance].w;
    return record;
#else
    return _Instances[instance];
#endif
}

uint4 LoadBvh(uint page, uint row)
{
#if defined(GLINT_PAGED)
    uint4 values;
    [branch]
    switch (page)
    {
        case 0: values = _Bvh0[row]; break;
        case 1: values = _Bvh1[row]; break;
        case 2: values = _Bvh2[row]; break;
        case 3: values = _Bvh3[row]; break;
        case 4: values = _Bvh4[row]; break;
        case 5: values = _Bvh5[row]; break;
        case 6: values = _Bvh6[row]; break;
        default: values = _Bvh7[row]; break;
    }
    return values;
#else
    return _Bvh0[row];
#endif
}

#endif
