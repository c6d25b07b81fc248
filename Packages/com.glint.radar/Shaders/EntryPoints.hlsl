#ifndef GLINT_ENTRY_POINTS
#define GLINT_ENTRY_POINTS

#include "Traversal.hlsl"

// Entry points (after Reshetov et al. 2005). The rays of a cell visit the same upper nodes. A frustum around the cell
// is traversed once, and its rays start at the nodes found: at most MAX_ENTRY_POINTS references to nodes or leaves,
// nearest first, that together hold everything the frustum can hit.

// Margin of a frustum around the rays of its cell, in rays: many times the rounding of directions.
static const float FRUSTUM_MARGIN = 0.05;

// The volume between four side planes and the plane of the origins, in the BVH's frame.
struct CellFrustum
{
    float3 Corner;        // origin of the lower left ray
    float3 Axis;          // normals, inward
    float3 Left, Right, Below, Above;
    float2 Width;         // distance from the corner inward to the right and upper planes
    float Rounding;       // of positions in that frame
};

// Normal of the plane through two neighbouring rays, inward.
float3 SideNormal(float3 direction, float3 edge, float3 inward)
{
    float3 normal = normalize(cross(direction, edge));
    return dot(normal, inward) < 0.0 ? -normal : normal;
}

// The frustum around a rectangle of the picture.
// Corner: its lower left corner, in rays from _ReferencePixel; size: in rays.
CellFrustum MakeCellFrustum(InstanceRecord record, float2 corner, float2 size)
{
    float3 originDx = size.x * VectorToLocal(record, _OriginDx.xyz),
        originDy = size.y * VectorToLocal(record, _OriginDy.xyz);
    float3 directionDx = size.x * VectorToLocal(record, _DirectionDx.xyz),
        directionDy = size.y * VectorToLocal(record, _DirectionDy.xyz);
    float3 direction =
        VectorToLocal(record, _Direction.xyz + corner.x * _DirectionDx.xyz + corner.y * _DirectionDy.xyz);
    // Direction from ray to ray, the same at any distance.
    float3 right = originDx + directionDx, up = originDy + directionDy;

    CellFrustum frustum;
    frustum.Corner = PointToLocal(record, _Origin.xyz + corner.x * _OriginDx.xyz + corner.y * _OriginDy.xyz);
    frustum.Axis = SideNormal(right, up, direction);
    frustum.Left = SideNormal(direction, up, right);
    frustum.Right = SideNormal(direction + directionDx, up, -right);
    frustum.Below = SideNormal(direction, right, up);
    frustum.Above = SideNormal(direction + directionDy, right, -up);
    frustum.Rounding = record.Rounding;
    frustum.Width = -float2(dot(frustum.Right, originDx), dot(frustum.Above, originDy));
    return frustum;
}

// Maximum coordinate of a box along a direction.
float Farthest(float3 direction, float3 centre, float3 halfSize)
{
    return dot(direction, centre) + dot(abs(direction), halfSize);
}

// Lower bound of the distance from the plane of the origins at which a ray of the frustum hits the box;
// MISS if none hits it.
float EnterFrustum(CellFrustum frustum, float3 boxMin, float3 boxMax)
{
    float3 centre = 0.5 * (boxMin + boxMax) - frustum.Corner, halfSize = 0.5 * (boxMax - boxMin);
    float3 size = abs(centre) + halfSize;
    float rounding = 1.0e-5 * (size.x + size.y + size.z) + 2.0 * frustum.Rounding;
    float minDistance =
        min(Farthest(frustum.Left, centre, halfSize), Farthest(frustum.Right, centre, halfSize) + frustum.Width.x);
    minDistance =
        min(minDistance, min(Farthest(frustum.Below, centre, halfSize),
            Farthest(frustum.Above, centre, halfSize) + frustum.Width.y));
    minDistance = min(minDistance, Farthest(frustum.Axis, centre, halfSize));
    return minDistance >= -rounding ? -Farthest(-frustum.Axis, centre, halfSize) : MISS;
}

// Children of a node that the frustum hits, and lower bounds of their distances.
static uint s_child[4];
static float s_childNear[4];
static uint s_children = 0;

void AddChild(CellFrustum frustum, float3 boxMin, float3 boxMax, uint reference)
{
    float near = EnterFrustum(frustum, boxMin, boxMax);
    if (near != MISS)
    {
        s_child[s_children] = reference;
        s_childNear[s_children] = near;
        s_children++;
    }
}

#ifdef GLINT_WIDE

// References of a wide BVH are stack words with one child (Wide~/TraverseWide.hlsl).
bool IsLeaf(uint reference)
{
    return (reference & 4) != 0;
}

void FindChildren(CellFrustum frustum, uint firstRow, uint reference)
{
    uint row = firstRow + 3 * (reference >> 12);
    uint4 a = LoadBvh(0, row), b = LoadBvh(0, row + 1), c = LoadBvh(0, row + 2);
    float3 origin = asfloat(a.xyz), step = asfloat(uint3(a.w << 23, a.w << 15, a.w << 7) & 0x7f800000);
    s_children = 0;
    [unroll]
    for (uint child = 0; child < 4; child++)
        if ((a.w >> (28 + child) & 1) != 0)
        {
            float3 boxMin = origin + step * float3((b.xyz >> (8 * child)) & 0xff),
                boxMax = origin + step * float3((uint3(b.w, c.xy) >> (8 * child)) & 0xff);
            AddChild(frustum, boxMin, boxMax, (c.z + child) << 12 | 8 | (a.w >> (24 + child) & 1) << 2);
        }
}

#else

bool IsLeaf(uint reference)
{
    return (reference & LEAF) != 0;
}

void FindChildren(CellFrustum frustum, uint firstRow, uint reference)
{
    uint row = firstRow + reference;
    uint4 a = LoadBvh(0, row), b = LoadBvh(0, row + 1);
    uint3 halfSizes = LoadBvh(0, row + 2).xyz;
    float3 centre = asfloat(LoadBvh(0, firstRow).xyz);
    float3 centreA = centre + asfloat(a.xyz), centreB = centre + asfloat(b.xyz);
    s_children = 0;
    AddChild(frustum, centreA - HalfSizeA(halfSizes), centreA + HalfSizeA(halfSizes), a.w);
    if (b.w != a.w)
        AddChild(frustum, centreB - HalfSizeB(halfSizes), centreB + HalfSizeB(halfSizes), b.w);
}

#endif

// Opens nodes, breadth first, while there is room for their children.
uint4 FindEntryPoints(CellFrustum frustum, uint firstRow)
{
    uint entry[MAX_ENTRY_POINTS];
    float near[MAX_ENTRY_POINTS];
    entry[0] = ROOT_ENTRY_POINTS.x;
    near[0] = 0.0;
    uint count = 1, at = 0, unopened = 0;
    [loop]
    while (unopened < count)
    {
        at = at < count ? at : 0;
        s_children = 0;
        bool isNode = !IsLeaf(entry[at]);
        if (isNode)
            FindChildren(frustum, firstRow, entry[at]);
        if (!isNode || count + s_children > MAX_ENTRY_POINTS + 1)
        {
            unopened++;
            at++;
            continue;
        }
        // The last reference replaces the node, then its children are appended.
        unopened = 0;
        count--;
        entry[at] = entry[count];
        near[at] = near[count];
        [loop]
        for (uint child = 0; child < s_children; child++)
        {
            entry[count] = s_child[child];
            near[count] = s_childNear[child];
            count++;
        }
        at++;
    }

    uint sorted[MAX_ENTRY_POINTS];
    [loop]
    for (uint rank = 0; rank < MAX_ENTRY_POINTS; rank++)
    {
        uint nearest = rank;
        [loop]
        for (uint other = rank + 1; other < count; other++)
            nearest = near[other] < near[nearest] ? other : nearest;
        sorted[rank] = rank < count ? entry[nearest] : DONE;
        entry[nearest] = entry[rank];
        near[nearest] = near[rank];
    }
    return uint4(sorted[0], sorted[1], sorted[2], sorted[3]);
}

#endif
