#ifndef GLINT_KERNELS
#define GLINT_KERNELS

#include "Bindings.hlsl"
#include "Geometry.hlsl"
#include "PathLoop.hlsl"
#include "EntryPoints.hlsl"
#include "Sums.hlsl"
#ifdef GLINT_REFINE
#include "Phasor.hlsl"
#endif
#ifdef GLINT_NOTE_HITS
#include "Identity.hlsl"
#endif
#ifdef GLINT_FIND_HORIZONS
#include "FindHorizons.hlsl"
#endif

// Threads of a group; results do not depend on it.
#ifndef GLINT_GROUP
#define GLINT_GROUP 64
#endif

uint IndexOf(uint3 group, uint thread)
{
    return (group.x + group.y * GROUPS_A_ROW) * GLINT_GROUP + thread;
}

uint2 TilePixel(uint tile)
{
    uint packed = _Tiles[_FirstTile + min(tile, _TileCount - 1)];
    return uint2(packed & 0xffff, packed >> 16) * TILE_SIDE;
}

void CountWork(uint slot)
{
#ifdef GLINT_COUNT
    AddUnsigned(slot + SUM_NODES, s_nodesVisited);
    AddUnsigned(slot + SUM_PAIRS, s_pairsTested);
#endif
}

#if defined(GLINT_ARITHMETIC)

#include "Arithmetic.hlsl"

#elif defined(GLINT_FIND_HORIZONS)

// One thread for each triangle of some leaves.
[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= 2 * _LeafCount)
        return;
    uint leafRow = _BvhFirstLeafRow + 3 * (_FirstLeaf + index / 2);
    bool second = index % 2 != 0;
    uint2 horizon = FindHorizon(_BvhFirstRow, leafRow, second, _HorizonMargin);
    uint row = HorizonRow(0, _BvhFirstRow, leafRow);
    if (second)
        _Bvh0[row].zw = horizon;
    else
        _Bvh0[row].xy = horizon;
}

#elif defined(GLINT_FIND_ENTRY_POINTS)

// One thread for each tile and instance.
[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    uint tile = index / _InstanceCount, instance = index % _InstanceCount;
    if (tile >= _TileCount)
        return;
    float2 corner = float2(TilePixel(tile)) - _ReferencePixel.xy + 0.5 - FRUSTUM_MARGIN;
    InstanceRecord record = LoadInstance(instance);
    _FoundEntryPoints[tile * MAX_INLINE_INSTANCES + instance] =
        FindEntryPoints(MakeTileFrustum(record, corner, TILE_SIDE - 1.0 + 2.0 * FRUSTUM_MARGIN), record.FirstRow);
}

#elif defined(GLINT_NOTE_HITS)

// Traces the rays of _Candidates and records their reflections.
[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint entry = IndexOf(group, thread);
    if (entry >= _CandidateCount)
        return;
    uint pixel = _Candidates[entry].x;
    Path path = BeginPath(float2(pixel % _RaysAcross, pixel / _RaysAcross) - _ReferencePixel.xy + 0.5);
    Hit hit;
    [loop]
    while (Advance(path, NO_ENTRY_POINTS, hit))
    {
        Identity identity = Identify(hit);
        HitData data = (HitData)0;
        data.Position = Rounded(path.Ray.Origin);
        data.Instance = identity.Instance;
        data.Direction = Rounded(path.Ray.Direction);
        data.Triangle = identity.Triangle;
        data.Object = identity.Object;
        data.Surface = identity.Surface;
        _Hits[entry * _MaxBounces + path.Bounces - 1] = data;
    }
    _Candidates[entry] =
        uint2(path.Bounces | (path.IsCandidate ? RAY_RECEIVED : 0), asuint(Rounded(path.WayBack)));
}

#elif defined(GLINT_REFINE)

// Refine pass: traces the rays of _Candidates again, or sub-rays of their pixels, and sums received rays.
[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    uint subRay = index % (_SubRays * _SubRays), inDispatch = index / (_SubRays * _SubRays),
        entry = _FirstCandidate + inDispatch;
    if (inDispatch >= _CandidateCount)
        return;
    uint pixel = _Candidates[entry].x, rayIndex = _Candidates[entry].y;
    float2 inPixel = (float2(subRay % _SubRays, subRay / _SubRays) + 0.5) / _SubRays;
    Path path =
        FollowPath(float2(pixel % _RaysAcross, pixel / _RaysAcross) - _ReferencePixel.xy + inPixel, NO_ENTRY_POINTS);
    // Sub-rays of the same number have their own slot.
    uint slot = (_SubRays == 1 ? index % SUM_SLOTS : subRay) * SUM_WORDS;
    AddPath(slot, path.Bounces, Rounded(path.RelativeLength));
    CountWork(slot);

    RayData ray = DataOf(path, pixel);
    DoubleFloat relativeLength =
        Add(path.RelativeLength, Sub(path.WayBack, MakeDoubleFloat(_OriginDepth.x, _OriginDepth.y)));
    if (path.IsCandidate)
    {
        DoubleFloat whole = Add(Mul(MakeDoubleFloat(_OriginDepth.x, _OriginDepth.y), 2.0), relativeLength);
        float turns = PartOfTurn(Mul(whole, MakeDoubleFloat(_WaveNumberTurns.x, _WaveNumberTurns.y)));
        float2 phasor = Phasor(turns);
        AddReceived(slot, turns, phasor);
        ray.PathLength = whole.Hi;
        ray.PathLengthLo = whole.Lo;
        ray.Bounces |= RAY_RECEIVED;
        ray.InPhase = phasor.x;
        ray.Quadrature = phasor.y;
    }
    if (_SubRays > 1)
        return;
    _Candidates[entry] = uint2(path.IsCandidate ? pixel : NO_PIXEL, asuint(relativeLength.Hi));
    if (_Readback == READBACK_ALL)
        _Rays[rayIndex] = ray;
    else if (_Readback == READBACK_RECEIVED)
        _Rays[inDispatch] = ray;
}

#else

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    uint tile = index / RAYS_A_TILE, ray = index % RAYS_A_TILE;
    uint slot = tile % SUM_SLOTS * SUM_WORDS;
    // Eight consecutive threads trace 4 x 2 rays, which are coherent on devices of that width.
    uint2 inTile = uint2((ray & 3) | (ray >> 1 & 4), (ray >> 2 & 1) | (ray >> 3 & 6));
    uint2 at = TilePixel(tile) + inTile;
    uint pixel = NO_PIXEL;
    Path path = (Path)0;
    if (tile < _TileCount && at.x >= _Region.x && at.x < _Region.y && at.y >= _Region.z && at.y < _Region.w)
    {
        pixel = at.x + at.y * _RaysAcross;
        path = FollowPath(float2(at) + 0.5 - _ReferencePixel.xy,
            (_Culling & CULL_ENTRY_POINTS) != 0 ? tile * MAX_INLINE_INSTANCES : NO_ENTRY_POINTS);
        CountWork(slot);
        if (path.IsCandidate)
        {
            uint entry;
            InterlockedAdd(_Sums[SUM_CANDIDATES], 1, entry);
            _Candidates[entry] = uint2(pixel, index);
        }
        else
            AddPath(slot, path.Bounces, path.RelativeLength);
    }
    if (_Readback == READBACK_ALL && tile < _TileCount && !path.IsCandidate)
        _Rays[index] = DataOf(path, pixel);
}

#endif

#endif
