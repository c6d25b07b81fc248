#ifndef GLINT_TRAVERSAL
#define GLINT_TRAVERSAL

#include "Real.hlsl"

#ifdef GLINT_WIDE
#include "SearchWide.hlsl"
#else
#include "SearchBinary.hlsl"
#endif

float3 VectorToLocal(InstanceRecord place, float3 v)
{
    return float3(dot(place.ToLocalX.xyz, v), dot(place.ToLocalY.xyz, v), dot(place.ToLocalZ.xyz, v));
}

// "precise": a start is checked against the plane it leaves with the very numbers that the search then has for it.
float3 PointToLocal(InstanceRecord place, float3 p)
{
    precise float3 local = VectorToLocal(place, p) + float3(place.ToLocalX.w, place.ToLocalY.w, place.ToLocalZ.w);
    return local;
}

void SearchInstance(uint instance, float3 origin, float3 direction, uint4 starts, inout Found found)
{
    InstanceRecord place = LoadInstance(instance);
    SearchMesh(MakeSearchRay(PointToLocal(place, origin), VectorToLocal(place, direction)), instance, place.Bank, place.FirstRow, starts, found);
}

#ifndef GLINT_FEW
void SearchTop(float3 origin, float3 direction, inout Found found)
{
    SearchRay ray = MakeSearchRay(origin, direction);
    BoxRay boxRay = MakeBoxRay(ray, asfloat(_Top[0].xyz));
    uint stack[STACK_BOTTOM + BINARY_LEVELS];
    stack[0] = DONE;
    stack[1] = DONE;
    uint top = 1;
    uint current = _TopRoot;
    [loop]
    while (current != DONE)
    {
        [loop]
        while ((current & LEAF) == 0)
        {
            COUNT_NODE;
            Entered entered = EnterChildren(_Top[current], _Top[current + 1], _Top[current + 2].xyz, boxRay, found.Distance);
            current = entered.Near;
            if (entered.Both)
                stack[++top] = entered.Far;
            if (!entered.Any)
                current = stack[top--];
        }
        if (current != DONE)
        {
            // A leaf holds an instance's number.
            SearchInstance(_Top[current & ~LEAF].x, origin, direction, FROM_ROOT, found);
            current = stack[top--];
        }
    }
}
#endif

// The nearest triangle that the ray meets before reach, over all instances; not the one it is leaving.
// FirstStart: where _Starts says where to begin in the tree of each instance; NO_STARTS: at the roots.
Found FindNearest(float3 origin, float3 direction, float reach, uint firstStart, uint2 leaving)
{
    Found found;
    found.Distance = reach;
    found.Instance = NO_INSTANCE;
    found.Row = 0;
    found.Second = false;
    found.Leaving = leaving;
#ifdef GLINT_FEW
#ifdef GLINT_ONE
    uint instance = 0; // a loop of one turn costs a software device a tenth of its time
#else
    [loop]
    for (uint instance = 0; instance < _InstanceCount; instance++)
#endif
    {
        uint4 starts = FROM_ROOT;
        if (firstStart != NO_STARTS)
            starts = _Starts[firstStart + instance];
        SearchInstance(instance, origin, direction, starts, found);
    }
#else
    SearchTop(origin, direction, found);
#endif
    return found;
}

// The triangle found, as the ray meets it.
struct Surface
{
    Real Distance;        // from the ray's origin to the triangle's plane, m
    Real3 Normal;         // in the scene, a unit vector by float32; its side is arbitrary
    float Lever;          // from the corner that the plane is known by to the hit: the lever of the normal's rounding, as a height in m
    float ToEdge;         // from the hit to the nearest edge, m
    InstanceRecord Place; // the rest in the mesh's frame
    float3 LocalNormal;   // unit vector
    float3 Corner;
    float Scale;          // height above the plane here, of 1 m in the scene
};

#ifdef GLINT_EXACT
Two3 VectorToLocal(InstanceRecord place, Two3 v)
{
    return MakeTwo3(
        Dot(MakeReal3(place.ToLocalX.xyz, place.RestX.xyz), v),
        Dot(MakeReal3(place.ToLocalY.xyz, place.RestY.xyz), v),
        Dot(MakeReal3(place.ToLocalZ.xyz, place.RestZ.xyz), v));
}

Two3 PointToLocal(InstanceRecord place, Two3 p)
{
    return Plus(VectorToLocal(place, p), MakeReal3(float3(place.ToLocalX.w, place.ToLocalY.w, place.ToLocalZ.w), float3(place.RestX.w, place.RestY.w, place.RestZ.w)));
}
#endif

// Normals go by the transpose of the inverse.
Real3 NormalFromLocal(InstanceRecord place, Real3 normal)
{
#ifdef GLINT_EXACT
    Two3 x = Times(MakeReal3(place.ToLocalX.xyz, place.RestX.xyz), normal.X);
    Two3 y = Times(MakeReal3(place.ToLocalY.xyz, place.RestY.xyz), normal.Y);
    Two3 z = Times(MakeReal3(place.ToLocalZ.xyz, place.RestZ.xyz), normal.Z);
    return Plus(Plus(x, y), z);
#else
    return normal.x * place.ToLocalX.xyz + normal.y * place.ToLocalY.xyz + normal.z * place.ToLocalZ.xyz;
#endif
}

// From a place in a triangle's plane to the line of an edge: the place as seen from one of the edge's corners.
float ToLine(float3 place, float3 edge, float3 normal)
{
    return abs(dot(cross(edge, place), normal)) * rsqrt(dot(edge, edge));
}

// A ray that grazes a plane meets it anywhere, by rounding: where the search met it counts when the plane is so much farther off, as a part of the lengths that went into it.
static const float GRAZING = 1.0e-3;

// Origin: the hit before; the search began at start, just before it.
Surface LoadSurface(Found found, float3 start, Real3 origin, Real3 direction)
{
    InstanceRecord place = LoadInstance(found.Instance);
    Pair pair = LoadPair(place.Bank, place.FirstRow + found.Row);
    Real3 normal = Cross(Difference(pair.Corner2, pair.Corner0), Difference(found.Second ? pair.Corner3 : pair.Corner1, pair.Corner0));
    normal = Times(normal, 1.0 / length(Rounded(normal)));
    Real3 localOrigin = PointToLocal(place, origin), localDirection = VectorToLocal(place, direction);
    Real3 sceneNormal = NormalFromLocal(place, normal);

    Surface surface;
    surface.Place = place;
    surface.LocalNormal = Rounded(normal);
    surface.Corner = pair.Corner0;
    surface.Scale = length(Rounded(sceneNormal));
    surface.Normal = Times(sceneNormal, 1.0 / surface.Scale);
    surface.Distance = ToPlane(localOrigin, localDirection, MakeReal3(pair.Corner0, 0.0), normal);
    float3 from = Rounded(origin), size = abs(from);
    float searched = found.Distance + dot(start - from, Rounded(direction));
    if (!(abs(Rounded(surface.Distance) - searched) <= GRAZING * (found.Distance + max(size.x, max(size.y, size.z)))))
        surface.Distance = MakeReal(searched, 0.0);
    float3 hit = Rounded(localOrigin) + Rounded(surface.Distance) * Rounded(localDirection) - pair.Corner0, lever = abs(hit);
    surface.Lever = max(lever.x, max(lever.y, lever.z)) / surface.Scale;
    float3 edge1 = pair.Corner2 - pair.Corner0, edge2 = (found.Second ? pair.Corner3 : pair.Corner1) - pair.Corner0;
    float toEdge1 = ToLine(hit, edge1, surface.LocalNormal), toEdge2 = ToLine(hit, edge2, surface.LocalNormal), toEdge3 = ToLine(hit - edge1, edge2 - edge1, surface.LocalNormal);
    surface.ToEdge = min(toEdge1, min(toEdge2, toEdge3)) / surface.Scale;
    return surface;
}

// Rounding of a hit, as a fraction of the lengths that went into it: 4 float32 steps.
static const float HIT_ROUNDING = 2.4e-7;

// A hit so near to an edge, as a fraction of the same lengths, may belong to the triangle beyond it: the search after it begins farther back, on that one's side as well.
static const float NEAR_EDGE = 1.0e-6;
static const float FARTHER_BACK = 8.0;

// How often the way back from a hit is doubled, at most: rays that graze a surface go farther back.
static const uint MOST_DOUBLINGS = 16;

// Where the search after a hit begins: on the ray to it from the start of the last search, as near before it as is surely on the ray's side of the plane.
// The way there is free, of this triangle and of those that meet it at an edge: a point moved off along the normal may be behind one of them, and lost.
float3 StartBefore(Surface surface, float3 start, float3 direction, float toHit)
{
    float3 place = abs(start + toHit * direction);
    float size = max(max(toHit, place.x), max(place.y, place.z));
    float clear = HIT_ROUNDING * surface.Lever;
    float back = max(clear, HIT_ROUNDING * size) * (surface.ToEdge < NEAR_EDGE * size ? FARTHER_BACK : 1.0);
    bool isBehind = dot(Rounded(surface.Normal), direction) > 0.0;
    float3 next = start;
    [loop]
    for (uint i = 0; i < MOST_DOUBLINGS; i++)
    {
        next = start + max(toHit - back, 0.0) * direction;
        float height = dot(surface.LocalNormal, PointToLocal(surface.Place, next) - surface.Corner) / surface.Scale;
        if ((isBehind ? -height : height) >= clear)
            break;
        back *= 2.0;
    }
    return next;
}

#endif
