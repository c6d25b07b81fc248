#ifndef GLINT_TUBE_SHADOWS
#define GLINT_TUBE_SHADOWS

#include "TubeGrid.hlsl"
#include "CellMarks.hlsl"
#include "Sums.hlsl"

// Finds where the radar sees the border of what a receiver apart from it sees: a silhouette of a body, as the receiver sees it,
// is cast on what lies behind. One thread a receiver and a piece of an edge.

// SILHOUETTE_ROWS a piece: its ends, and the other corners of the triangles at it, relative to the scene's centre, m; w of the
// first row 1: there is one triangle.
StructuredBuffer<float4> _Silhouettes;
uint2 _SilhouetteRange;                    // of this dispatch: first piece and number

// Distance of a ray from the edge that it passes, as a fraction of _SceneCentreExtent.w: 30 times the rounding of float32.
static const float BESIDE_SILHOUETTE = 2.0e-6;

struct Silhouette
{
    float3 Start, End;
    float3 Outward;        // unit vector away from the body, as the receiver sees it
    bool IsSeen;           // both triangles lie on the same side of the edge
};

Silhouette LoadSilhouette(uint piece, uint receiver)
{
    uint row = SILHOUETTE_ROWS * piece;
    float4 start = _Silhouettes[row];
    Silhouette edge;
    edge.Start = start.xyz;
    edge.End = _Silhouettes[row + 1].xyz;
    float3 first = _Silhouettes[row + 2].xyz - edge.Start, second = _Silhouettes[row + 3].xyz - edge.Start;
    float3 across = cross(edge.End - edge.Start, ReceiverFrom(receiver, 0.5 * (edge.Start + edge.End)).Direction);
    float size = length(across), side = dot(first, across);
    edge.Outward = across * ((side > 0.0 ? -1.0 : 1.0) / max(size, 1.0e-20));
    edge.IsSeen = size > 0.0 && (start.w != 0.0 || side * dot(second, across) > 0.0);
    return edge;
}

// Where the sight from a receiver past a position meets a plane.
float3 CastOn(float3 position, float3 onPlane, float3 normal, uint receiver)
{
    float3 direction = ReceiverFrom(receiver, position).Direction;
    return position - direction * (dot(position - onPlane, normal) / max(dot(direction, normal), MIN_COSINE));
}

// Lists the border in the base cells that it runs through.
void ListShadow(Silhouette edge, float3 onPlane, float3 normal, uint receiver)
{
    float2 start = PlaceOnGrid(CastOn(edge.Start, onPlane, normal, receiver)),
        end = PlaceOnGrid(CastOn(edge.End, onPlane, normal, receiver)),
        outside = PlaceOnGrid(CastOn(edge.Start + length(edge.End - edge.Start) * edge.Outward, onPlane, normal, receiver));
    ListLine(start, end, 2.0 * start - outside, SHADOW_LINE);
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint number = IndexOf(group, thread);
    if (!TakeOfPose(number, _SilhouetteRange.y * _ReceiverCount))
        return;
    uint index = number % _ReceiverCount;
    Silhouette edge = LoadSilhouette(_SilhouetteRange.x + number / _ReceiverCount, index);
    if (!edge.IsSeen)
        return;
    float3 middle = 0.5 * (edge.Start + edge.End) + BESIDE_SILHOUETTE * _SceneCentreExtent.w * edge.Outward;
    Receiver receiver = ReceiverFrom(index, middle);
    Ray ray = BeginPath(middle, -receiver.Direction, 0.0).Ray;
    Hit hit = ClosestHit(ray, MISS, NO_ENTRY_POINTS, NOT_MET);
    uint rays = 1;
    float3 onPlane = middle + hit.Distance * ray.Direction;
    // The radar sees the side that the receiver sees.
    if (!IsMiss(hit) && dot(hit.Normal, ReceiverFrom(_ReceiverCount, onPlane).Direction) > 0.0)
    {
        rays += 2;
        if (IsInSight(middle, ray.ExcludedTriangle, receiver)
            && IsInSight(hit.NextStart, NumberOf(hit.Instance, hit.Row, hit.Second),
                ReceiverFrom(_ReceiverCount, hit.NextStart)))
            ListShadow(edge, onPlane, hit.Normal, index);
    }
    // Additions to one word wait for each other.
    s_part = group.x % POSE_PARTS;
    AddTo(CountWord(POSE_RAYS), rays);
}

#endif
