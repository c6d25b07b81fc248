#ifndef GLINT_KERNELS
#define GLINT_KERNELS

#ifdef GLINT_STAGE
#include "Stages.hlsl"
#else

#if defined(GLINT_REFINE) && !defined(GLINT_NOTE_HITS) && !defined(GLINT_ARITHMETIC)
#define GLINT_FOLLOW_MET
#endif

#include "WorkLists.hlsl"
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

// Whole quotient of numbers of tiles, which are below 2^23: a GPU has no instruction for it.
uint Quotient(uint tiles, uint divisor, float inverse)
{
    uint quotient = (uint)((float)tiles * inverse);
    quotient -= quotient * divisor > tiles ? 1 : 0;
    return quotient + (tiles - quotient * divisor >= divisor ? 1 : 0);
}

// Cell of a tile, of those of this dispatch.
uint CellOf(uint tile)
{
    return Quotient(_CellSize.w + tile, _CellSize.x * _CellSize.y, _CellInverse.x);
}

// First tile of a cell: column, row.
uint2 CellCorner(uint cell)
{
    uint corner = _Cells[_CellSize.z + cell];
    return uint2(corner & 0xffff, corner >> 16);
}

// First pixel of a tile. The tiles of a cell go from its top down, as the cells do on a GPU.
uint2 TilePixel(uint tile)
{
    uint tilesPerCell = _CellSize.x * _CellSize.y, cell = CellOf(tile);
    uint inCell = tilesPerCell - 1 - (_CellSize.w + tile - cell * tilesPerCell);
    uint row = Quotient(inCell, _CellSize.x, _CellInverse.y);
    return (CellCorner(cell) + uint2(inCell - row * _CellSize.x, row)) * TILE_SIDE;
}

// A point of a pixel, in rays from _ReferencePixel.
float2 PicturePosition(uint pixel, float2 inPixel)
{
    return float2(pixel % _RaysAcross, pixel / _RaysAcross) - _ReferencePixel.xy + inPixel;
}

// Place of a sub-ray in its pixel.
float2 InPixel(uint subRay)
{
    return (float2(subRay % SUB_RAYS, subRay / SUB_RAYS) + 0.5) / SUB_RAYS;
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

#elif defined(GLINT_FIND_ENTRY_POINTS)

// One thread for each cell and instance.
[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    uint cell = index / _InstanceCount, instance = index % _InstanceCount;
    if (cell > CellOf(_TileCount - 1))
        return;
    float2 corner = float2(CellCorner(cell) * TILE_SIDE) - _ReferencePixel.xy + 0.5 - FRUSTUM_MARGIN,
        size = float2(_CellSize.xy * TILE_SIDE) - 1.0 + 2.0 * FRUSTUM_MARGIN;
    InstanceRecord record = LoadInstance(instance);
    _FoundEntryPoints[cell * MAX_INLINE_INSTANCES + instance] =
        FindEntryPoints(MakeCellFrustum(record, corner, size), record.FirstRow);
}

#elif defined(GLINT_NOTE_HITS)

// Traces the rays of _Candidates and records their reflections.
[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint entry = IndexOf(group, thread);
    if (entry >= _PathCount)
        return;
    uint pixel = _Candidates[entry].x;
    Path path = BeginPath(PicturePosition(pixel, 0.5));
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

// Refine pass: follows the candidates in double-float arithmetic, and sums received rays.
[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread), entry = CandidateOf(index);
    if (entry == NO_CANDIDATE)
        return;
    uint pixel = _Candidates[entry].x, rayIndex = _Candidates[entry].y;
    bool isSubRay = _HasSubRays != 0;
    float2 inPixel = isSubRay ? InPixel(rayIndex) : 0.5;
    Path path = BeginPath(PicturePosition(pixel, inPixel));
    path.FirstMet = HasMet(entry) ? entry * _MaxBounces : NOTHING_MET;
    path.IsKnown = entry < SearchedList();
    FollowPath(path, NO_ENTRY_POINTS);

    DoubleFloat relativeLength =
        Add(path.RelativeLength, Sub(path.WayBack, MakeDoubleFloat(_OriginDepth.x, _OriginDepth.y)));
    DoubleFloat whole = Add(Mul(MakeDoubleFloat(_OriginDepth.x, _OriginDepth.y), 2.0), relativeLength);
    float turns = PartOfTurn(Mul(whole, MakeDoubleFloat(_WaveNumberTurns.x, _WaveNumberTurns.y)));
    float2 phasor = Phasor(turns);
    if (isSubRay)
    {
        if (path.IsCandidate)
            AddReceived((SUM_SLOTS + rayIndex) * SUM_WORDS, turns, phasor);
        return;
    }
    uint slot = index % SUM_SLOTS * SUM_WORDS;
    AddPath(slot, path.Bounces, Rounded(path.RelativeLength));
    CountWork(slot);
    RayData ray = DataOf(path, pixel);
    if (path.IsCandidate)
    {
        AddReceived(slot, turns, phasor);
        ray.PathLength = whole.Hi;
        ray.PathLengthLo = whole.Lo;
        ray.Bounces |= RAY_RECEIVED;
        ray.InPhase = phasor.x;
        ray.Quadrature = phasor.y;
        if (_HasLengths != 0)
            _Lengths[InRegion(pixel)] = asuint(relativeLength.Hi);
        uint received = ListReceived(pixel, relativeLength.Hi);
        if (_Readback == READBACK_RECEIVED)
            _Rays[received - _FirstReceived] = ray;
    }
    _Candidates[entry] = uint2(path.IsCandidate ? pixel : NO_PIXEL, asuint(relativeLength.Hi));
    if (_Readback == READBACK_ALL)
        _Rays[rayIndex] = ray;
}

#else

// A ray of the picture, or a sub-ray.
struct EmittedRay
{
    uint Pixel;           // NO_PIXEL: none
    float2 Position;      // in the picture, in rays from _ReferencePixel
    uint Slot;            // word of its sums
    uint FirstEntryPoint;
    uint Number;          // index in the order of tiles, or number of the sub-ray in its pixel
};

EmittedRay RayOfTile(uint index)
{
    uint tile = index / RAYS_A_TILE, inTile = index % RAYS_A_TILE;
    // Eight consecutive threads trace 4 x 2 rays, which are coherent on devices of that width.
    uint2 at = TilePixel(min(tile, _TileCount - 1)) + uint2((inTile & 3) | (inTile >> 1 & 4), (inTile >> 2 & 1) | (inTile >> 3 & 6));
    EmittedRay ray;
    ray.Pixel = tile < _TileCount && IsInRegion((int2)at) ? at.x + at.y * _RaysAcross : NO_PIXEL;
    ray.Position = float2(at) + 0.5 - _ReferencePixel.xy;
    ray.Slot = tile % SUM_SLOTS * SUM_WORDS;
    ray.FirstEntryPoint = (_Culling & CULL_ENTRY_POINTS) != 0 ? CellOf(tile) * MAX_INLINE_INSTANCES : NO_ENTRY_POINTS;
    ray.Number = index;
    return ray;
}

EmittedRay SubRay(uint index)
{
    uint pixel = index / (SUB_RAYS * SUB_RAYS);
    EmittedRay ray;
    ray.Pixel = pixel < min(_Sums[COUNT_CHOSEN], MAX_CHOSEN) ? _SubRayPixels[pixel] : NO_PIXEL;
    ray.Number = index % (SUB_RAYS * SUB_RAYS);
    ray.Position = PicturePosition(ray.Pixel, InPixel(ray.Number));
    ray.Slot = 0;
    ray.FirstEntryPoint = NO_ENTRY_POINTS;
    return ray;
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    EmittedRay ray;
    if (_HasSubRays != 0)
        ray = SubRay(index);
    else
        ray = RayOfTile(index);
    Path path = (Path)0;
    if (ray.Pixel != NO_PIXEL)
    {
        path = BeginPath(ray.Position);
        FollowPath(path, ray.FirstEntryPoint);
        if (path.IsCandidate)
            AddCandidate(path, ray.Pixel, ray.Number);
        else if (_HasSubRays == 0)
            AddPath(ray.Slot, path.Bounces, path.RelativeLength);
        if (_HasSubRays == 0)
            CountWork(ray.Slot);
    }
    if (_Readback == READBACK_ALL && _HasSubRays == 0 && index / RAYS_A_TILE < _TileCount && !path.IsCandidate)
        _Rays[index] = DataOf(path, ray.Pixel);
}

#endif

#endif

#endif
