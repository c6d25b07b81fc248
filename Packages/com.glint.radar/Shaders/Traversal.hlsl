#ifndef GLINT_TRAVERSAL
#define GLINT_TRAVERSAL

#ifdef GLINT_WIDE
#include "SearchWide.hlsl"
#else
#include "SearchBinary.hlsl"
#endif

float3 VectorToLocal(InstanceRecord place, float3 v)
{
    return float3(dot(place.ToLocalX.xyz, v), dot(place.ToLocalY.xyz, v), dot(place.ToLocalZ.xyz, v));
}

float3 PointToLocal(InstanceRecord place, float3 p)
{
    return VectorToLocal(place, p) + float3(place.ToLocalX.w, place.ToLocalY.w, place.ToLocalZ.w);
}

void SearchInstance(uint instance, float3 origin, float3 direction, inout Found found)
{
    InstanceRecord place = LoadInstance(instance);
    SearchMesh(MakeSearchRay(PointToLocal(place, origin), VectorToLocal(place, direction)), instance, place.Bank, place.FirstRow, found);
}

#ifndef GLINT_ONE_INSTANCE
void SearchTop(float3 origin, float3 direction, inout Found found)
{
    SearchRay ray = MakeSearchRay(origin, direction);
    uint stack[BINARY_LEVELS + 1];
    stack[0] = DONE;
    uint waiting = 0;
    uint current = _TopRoot;
    [loop]
    while (current != DONE)
    {
        [loop]
        while ((current & LEAF) == 0)
        {
            COUNT_NODE;
            Entered entered = EnterChildren(_Top[current], _Top[current + 1], _Top[current + 2], _Top[current + 3], ray, found.Distance);
            current = entered.Near;
            if (entered.Far != DONE)
                stack[++waiting] = entered.Far;
            if (current == DONE)
            {
                current = stack[waiting];
                waiting = max(waiting, 1) - 1;
            }
        }
        if (current != DONE)
        {
            // A leaf holds an instance's number.
            SearchInstance(_Top[current & ~LEAF].x, origin, direction, found);
            current = stack[waiting];
            waiting = max(waiting, 1) - 1;
        }
    }
}
#endif

// The nearest triangle that the ray meets before reach, over all instances.
Found FindNearest(float3 origin, float3 direction, float reach)
{
    Found found;
    found.Distance = reach;
    found.Instance = NO_INSTANCE;
    found.Row = 0;
    found.Second = false;
#ifdef GLINT_ONE_INSTANCE
    SearchInstance(0, origin, direction, found);
#else
    SearchTop(origin, direction, found);
#endif
    return found;
}

// The triangle found, as the ray meets it.
struct Surface
{
    float Distance;       // from the ray's origin to the triangle's plane, m
    float3 Normal;        // unit vector in the world; its side is arbitrary
    float Lever;          // from the corner that the plane is known by to the hit, m: the lever of the normal's rounding
};

// Origin may lie on the start of the search or before it.
Surface LoadSurface(Found found, float3 origin, float3 direction)
{
    InstanceRecord place = LoadInstance(found.Instance);
    Pair pair = LoadPair(place.Bank, place.FirstRow + found.Row);
    float3 third = found.Second ? pair.Corner3 : pair.Corner1;
    float3 normal = normalize(cross(pair.Corner2 - pair.Corner0, third - pair.Corner0));
    float3 localOrigin = PointToLocal(place, origin), localDirection = VectorToLocal(place, direction);

    Surface surface;
    surface.Distance = HitPlane(localOrigin, localDirection, pair.Corner0, normal);
    float3 lever = abs(localOrigin + surface.Distance * localDirection - pair.Corner0);
    surface.Lever = max(lever.x, max(lever.y, lever.z)) / length(localDirection);
    // Normals go by the transpose of the inverse.
    surface.Normal = normalize(normal.x * place.ToLocalX.xyz + normal.y * place.ToLocalY.xyz + normal.z * place.ToLocalZ.xyz);
    return surface;
}

#endif
