#ifndef GLINT_STARTS
#define GLINT_STARTS

#include "Traversal.hlsl"

// The rays of a tile go down the same nodes before they part. A beam around them goes there once,
// and they all start from where it ends:
// at most MOST_STARTS references to nodes or leaves that together hold all that the beam can meet, nearest first.

// So much wider than the rays of its tile is a beam, in rays: many times the rounding of directions.
static const float BEAM_MARGIN = 0.05;

// What lies between four planes beside the rays, and beyond the one where they start, in the tree's frame.
struct Beam
{
    float3 Corner;        // the start of the lower left ray
    float3 Axis;          // normals, inward
    float3 Left, Right, Below, Above;
    float2 Width;         // from the corner inward to the planes on the right and above
    float Rounding;       // of places in that frame
};

// The plane that two rays lie in, with all between them.
float3 SideNormal(float3 course, float3 edge, float3 inward)
{
    float3 normal = normalize(cross(course, edge));
    return dot(normal, inward) < 0.0 ? -normal : normal;
}

// Around the rays of a square of the picture.
// Low: its lower left corner, in rays from _ReferenceRay.
Beam MakeBeam(InstanceRecord place, float2 low, float side)
{
    float3 startRight = side * VectorToLocal(place, _StartRight.xyz),
        startUp = side * VectorToLocal(place, _StartUp.xyz);
    float3 courseRight = side * VectorToLocal(place, _CourseRight.xyz),
        courseUp = side * VectorToLocal(place, _CourseUp.xyz);
    float3 course = VectorToLocal(place, _Course.xyz + low.x * _CourseRight.xyz + low.y * _CourseUp.xyz);
    // From ray to ray, at the start or beyond: the same direction.
    float3 right = startRight + courseRight, up = startUp + courseUp;

    Beam beam;
    beam.Corner = PointToLocal(place, _Start.xyz + low.x * _StartRight.xyz + low.y * _StartUp.xyz);
    beam.Axis = SideNormal(right, up, course);
    beam.Left = SideNormal(course, up, right);
    beam.Right = SideNormal(course + courseRight, up, -right);
    beam.Below = SideNormal(course, right, up);
    beam.Above = SideNormal(course + courseUp, right, -up);
    beam.Rounding = place.Rounding;
    beam.Width = -float2(dot(beam.Right, startRight), dot(beam.Above, startUp));
    return beam;
}

// The farthest that a box reaches along a direction.
float Farthest(float3 direction, float3 centre, float3 halfSize)
{
    return dot(direction, centre) + dot(abs(direction), halfSize);
}

// A distance, from the plane of the starts, that no ray of the beam is nearer to the box than; MISS if none meets it.
float EnterBeam(Beam beam, float3 low, float3 high)
{
    float3 centre = 0.5 * (low + high) - beam.Corner, halfSize = 0.5 * (high - low);
    float3 size = abs(centre) + halfSize;
    float rounding = 1.0e-5 * (size.x + size.y + size.z) + 2.0 * beam.Rounding;
    float least = min(Farthest(beam.Left, centre, halfSize), Farthest(beam.Right, centre, halfSize) + beam.Width.x);
    least =
        min(least, min(Farthest(beam.Below, centre, halfSize), Farthest(beam.Above, centre, halfSize) + beam.Width.y));
    least = min(least, Farthest(beam.Axis, centre, halfSize));
    return least >= -rounding ? -Farthest(-beam.Axis, centre, halfSize) : MISS;
}

// The children of a node that the beam meets, and the distances that its rays meet them at or later.
static uint s_child[4];
static float s_childNear[4];
static uint s_children = 0;

void AddChild(Beam beam, float3 low, float3 high, uint reference)
{
    float near = EnterBeam(beam, low, high);
    if (near != MISS)
    {
        s_child[s_children] = reference;
        s_childNear[s_children] = near;
        s_children++;
    }
}

#ifdef GLINT_WIDE

// References of a wide tree are words of its stack with one child (Wide~/SearchWide.hlsl).
bool IsLeaf(uint reference)
{
    return (reference & 4) != 0;
}

void FindChildren(Beam beam, uint firstRow, uint reference)
{
    uint row = firstRow + 3 * (reference >> 12);
    uint4 a = LoadTree(0, row), b = LoadTree(0, row + 1), c = LoadTree(0, row + 2);
    float3 origin = asfloat(a.xyz), step = asfloat(uint3(a.w << 23, a.w << 15, a.w << 7) & 0x7f800000);
    s_children = 0;
    [unroll]
    for (uint child = 0; child < 4; child++)
        if ((a.w >> (28 + child) & 1) != 0)
        {
            float3 low = origin + step * float3((b.xyz >> (8 * child)) & 0xff),
                high = origin + step * float3((uint3(b.w, c.xy) >> (8 * child)) & 0xff);
            AddChild(beam, low, high, (c.z + child) << 12 | 8 | (a.w >> (24 + child) & 1) << 2);
        }
}

#else

bool IsLeaf(uint reference)
{
    return (reference & LEAF) != 0;
}

void FindChildren(Beam beam, uint firstRow, uint reference)
{
    uint row = firstRow + reference;
    uint4 a = LoadTree(0, row), b = LoadTree(0, row + 1);
    uint3 halfSizes = LoadTree(0, row + 2).xyz;
    float3 centre = asfloat(LoadTree(0, firstRow).xyz);
    float3 middleA = centre + asfloat(a.xyz), middleB = centre + asfloat(b.xyz);
    s_children = 0;
    AddChild(beam, middleA - HalfSizeA(halfSizes), middleA + HalfSizeA(halfSizes), a.w);
    if (b.w != a.w)
        AddChild(beam, middleB - HalfSizeB(halfSizes), middleB + HalfSizeB(halfSizes), b.w);
}

#endif

// Opens nodes in turn as long as there is room for what they hold.
uint4 FindStarts(Beam beam, uint firstRow)
{
    uint start[MOST_STARTS];
    float near[MOST_STARTS];
    start[0] = FROM_ROOT.x;
    near[0] = 0.0;
    uint count = 1, at = 0, unopened = 0;
    [loop]
    while (unopened < count)
    {
        at = at < count ? at : 0;
        s_children = 0;
        bool isNode = !IsLeaf(start[at]);
        if (isNode)
            FindChildren(beam, firstRow, start[at]);
        if (!isNode || count + s_children > MOST_STARTS + 1)
        {
            unopened++;
            at++;
            continue;
        }
        // The last one takes the place of the node, then the children follow.
        unopened = 0;
        count--;
        start[at] = start[count];
        near[at] = near[count];
        [loop]
        for (uint child = 0; child < s_children; child++)
        {
            start[count] = s_child[child];
            near[count] = s_childNear[child];
            count++;
        }
        at++;
    }

    uint sorted[MOST_STARTS];
    [loop]
    for (uint place = 0; place < MOST_STARTS; place++)
    {
        uint nearest = place;
        [loop]
        for (uint other = place + 1; other < count; other++)
            nearest = near[other] < near[nearest] ? other : nearest;
        sorted[place] = place < count ? start[nearest] : DONE;
        start[nearest] = start[place];
        near[nearest] = near[place];
    }
    return uint4(sorted[0], sorted[1], sorted[2], sorted[3]);
}

#endif
