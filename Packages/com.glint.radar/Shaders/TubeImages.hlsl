#ifndef GLINT_TUBE_IMAGES
#define GLINT_TUBE_IMAGES

#include "TubeGrid.hlsl"
#include "CellMarks.hlsl"
#include "Sums.hlsl"

// Finds the outlines of patches that the radar sees in flat patches, as in mirrors: second bounces meet their parts, which pass
// between the rays through the corners of a cell. One thread a piece of an outline, which tries all mirrors.

// OUTLINE_ROWS a piece: its ends and the third corner of its triangle, relative to the scene's centre, m.
StructuredBuffer<float4> _OutlinePieces;
uint _OutlinePieceCount;

// MIRROR_ROWS a flat patch: rectangle about it: centre, m, and half its length; unit vector along it, and half its width; its
// unit normal.
StructuredBuffer<float4> _Mirrors;
uint _MirrorCount;

// Distance from a plane on which two places are, as a fraction of _SceneCentreExtent.w: 30 times the rounding of float32.
static const float ON_PLANE = 2.0e-6;

// Cosine of the angle between planes that are one.
static const float SAME_PLANE = 0.9999;

// Rays of a thread, whose loops a software device ends.
static const uint MAX_IMAGE_RAYS = 128;

// Side of a cell, beside whose outline a ray looks whether a piece is seen, base cells.
static const float BESIDE_SIDE = 0.25;

struct Mirror
{
    float3 Centre, Along, Normal;
    float2 HalfSize;
};

Mirror LoadMirror(uint index)
{
    float4 centre = _Mirrors[MIRROR_ROWS * index], along = _Mirrors[MIRROR_ROWS * index + 1];
    Mirror mirror;
    mirror.Centre = centre.xyz;
    mirror.Along = along.xyz;
    mirror.Normal = _Mirrors[MIRROR_ROWS * index + 2].xyz;
    mirror.HalfSize = float2(centre.w, along.w);
    return mirror;
}

float3 ImageOf(float3 position, Mirror mirror)
{
    return position - 2.0 * dot(position - mirror.Centre, mirror.Normal) * mirror.Normal;
}

// Whether the radar may see a position in a mirror: on the way to its image it meets the rectangle.
bool MayMirror(Mirror mirror, float3 position)
{
    float3 image = ImageOf(position, mirror), toRadar = ReceiverFrom(_ReceiverCount, image).Direction;
    float facing = dot(toRadar, mirror.Normal), before = dot(position - mirror.Centre, mirror.Normal);
    if (before * facing <= 0.0 || abs(facing) < MIN_COSINE)
        return false;
    float3 aside = image + toRadar * (before / facing) - mirror.Centre;
    float2 place = float2(dot(aside, mirror.Along), dot(aside, cross(mirror.Normal, mirror.Along)));
    return all(abs(place) <= mirror.HalfSize);
}

bool IsOnPlane(Hit hit, Ray ray, float3 onPlane, float3 normal)
{
    float3 from = ray.Origin + hit.Distance * ray.Direction - onPlane;
    return !IsMiss(hit) && abs(dot(hit.Normal, normal)) > SAME_PLANE
        && abs(dot(from, normal)) < ON_PLANE * _SceneCentreExtent.w;
}

// Whether the ray through a position of the grid is reflected by a mirror and then meets a triangle.
bool IsSeenIn(Mirror mirror, float2 position, float3 onTriangle, float3 normal, inout uint rays)
{
    Path path = BeginTube(position).Path;
    rays++;
    Hit hit = ClosestHit(path.Ray, MISS, NO_ENTRY_POINTS, NOT_MET);
    if (!IsOnPlane(hit, path.Ray, mirror.Centre, mirror.Normal))
        return false;
    float3 next = Mirrored(path.Ray.Direction, hit.Normal);
    MoveTo(path, hit);
    Leave(path, next);
    rays++;
    hit = ClosestHit(path.Ray, MISS, NO_ENTRY_POINTS, NOT_MET);
    return IsOnPlane(hit, path.Ray, onTriangle, normal);
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint piece = IndexOf(group, thread), rays = 0;
    if (!TakeOfPose(piece, _OutlinePieceCount))
        return;
    float3 start = _OutlinePieces[OUTLINE_ROWS * piece].xyz, end = _OutlinePieces[OUTLINE_ROWS * piece + 1].xyz,
        third = _OutlinePieces[OUTLINE_ROWS * piece + 2].xyz, middle = 0.5 * (start + end),
        across = cross(end - start, third - start), normal = across / max(length(across), 1.0e-20);
    [loop]
    for (uint index = 0; index < _MirrorCount && rays < MAX_IMAGE_RAYS; index++)
    {
        Mirror mirror = LoadMirror(index);
        if (!MayMirror(mirror, middle))
            continue;
        float2 from = PlaceOnGrid(ImageOf(start, mirror)), to = PlaceOnGrid(ImageOf(end, mirror)),
            inside = PlaceOnGrid(ImageOf(third, mirror));
        if (IsSeenIn(mirror, BesideLine(0.5 * (from + to), from, to, inside, BESIDE_SIDE), middle, normal, rays))
            ListLine(from, to, inside, IMAGE_LINE);
    }
    // Additions to one word wait for each other.
    s_part = group.x % POSE_PARTS;
    if (rays > 0)
        AddTo(CountWord(POSE_RAYS), rays);
}

#endif
