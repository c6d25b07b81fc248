#ifndef GLINT_SURFACE
#define GLINT_SURFACE

#include "Traversal.hlsl"

// The triangle found, as the ray meets it.
struct Surface
{
    Real Distance;        // from the ray's origin to the triangle's plane, m
    Real3 Normal;         // in the scene, a unit vector by float32; its side is arbitrary
#ifndef GLINT_REFINE
    bool IsNeedle;        // float32 has no normal to speak of
    // from the corner that the plane is known by to the hit: the lever of the normal's rounding, as a height in m
    float Lever;
    InstanceRecord Instance; // the rest in the mesh's frame
    float3 LocalNormal;   // unit vector
    float3 Corner;
    float Scale;          // height above the plane here, of 1 m in the scene
#endif
};

// Normals go by the transpose of the inverse.
Real3 NormalFromLocal(InstanceRecord record, Real3 normal)
{
#ifdef GLINT_REFINE
    DoubleFloat3 x = Mul(MakeReal3(record.ToLocalX.xyz, record.ToLocalXLo.xyz), normal.X);
    DoubleFloat3 y = Mul(MakeReal3(record.ToLocalY.xyz, record.ToLocalYLo.xyz), normal.Y);
    DoubleFloat3 z = Mul(MakeReal3(record.ToLocalZ.xyz, record.ToLocalZLo.xyz), normal.Z);
    return Add(Add(x, y), z);
#else
    return normal.x * record.ToLocalX.xyz + normal.y * record.ToLocalY.xyz + normal.z * record.ToLocalZ.xyz;
#endif
}

#ifdef GLINT_REFINE

// A ray that meets an edge or a corner turns so much before it, as a part of the scene's size: there it is on the right
// side of all surfaces that meet there. No farther than half the way back: there may be one behind it as well.
static const float BEFORE_EDGE = 1.0e-10;

Surface LoadSurface(Hit hit, float3 start, Real3 origin, Real3 direction)
{
    InstanceRecord record = LoadInstance(hit.Instance);
    Pair pair = LoadPair(record.Page, record.FirstRow + hit.Row);
    Real3 normal = Cross(Difference(pair.Corner2, pair.Corner0),
        Difference(hit.Second ? pair.Corner3 : pair.Corner1, pair.Corner0));
    Real3 sceneNormal = NormalFromLocal(record, Mul(normal, 1.0 / length(Rounded(normal))));
    Surface surface;
    surface.Normal = Mul(sceneNormal, 1.0 / length(Rounded(sceneNormal)));
    surface.Distance = hit.RefinedDistance;
    if (hit.IsAtEdge)
        surface.Distance = Sub(hit.RefinedDistance,
            MakeDoubleFloat(min(BEFORE_EDGE * _SceneCentreExtent.w, 0.5 * hit.RefinedDistance.Hi), 0.0));
    return surface;
}

#else

// Sine of the angle between the two shorter edges of a triangle,
// below which its normal is not good enough to tell what may be received.
static const float NEEDLE = 0.1;

// A ray that grazes a plane meets it anywhere, by rounding:
// where the search met it counts when the plane is so much farther off, as a part of the lengths that went into it.
static const float GRAZING = 1.0e-3;

// Origin: the hit before; the search began at start, just before it.
Surface LoadSurface(Hit hit, float3 start, float3 origin, float3 direction)
{
    InstanceRecord record = LoadInstance(hit.Instance);
    Pair pair = LoadPair(record.Page, record.FirstRow + hit.Row);
    float3 third = hit.Second ? pair.Corner3 : pair.Corner1;
    float3 edge1 = pair.Corner2 - pair.Corner0, edge2 = third - pair.Corner0, edge3 = third - pair.Corner2;
    // By the two shorter edges: the normal of a long strip is as good as that of a square.
    float size1 = dot(edge1, edge1), size2 = dot(edge2, edge2), size3 = dot(edge3, edge3);
    bool isFirstLongest = size1 >= size2 && size1 >= size3, isSecondLongest = !isFirstLongest && size2 >= size3;
    float3 side1 = isFirstLongest ? edge3 : edge1, side2 = isSecondLongest ? edge3 : edge2, area = cross(side1, side2);
    float3 normal = normalize(area);
    float3 localOrigin = PointToLocal(record, origin), localDirection = VectorToLocal(record, direction);
    float3 sceneNormal = NormalFromLocal(record, normal);

    Surface surface;
    surface.Instance = record;
    surface.LocalNormal = normal;
    surface.Corner = pair.Corner0;
    surface.Scale = length(sceneNormal);
    surface.Normal = sceneNormal / surface.Scale;
    surface.Distance = ToPlane(localOrigin, localDirection, pair.Corner0, normal);
    float largest = MaxComponent(abs(origin));
    float traversalDistance = hit.Distance + dot(start - origin, direction);
    if (!(abs(surface.Distance - traversalDistance) <= GRAZING * (hit.Distance + largest)))
        surface.Distance = traversalDistance;
    surface.Lever = MaxComponent(abs(localOrigin + surface.Distance * localDirection - pair.Corner0)) / surface.Scale;
    surface.IsNeedle = dot(area, area) < NEEDLE * NEEDLE * dot(side1, side1) * dot(side2, side2);
    return surface;
}

// Rounding of a hit, as a fraction of the lengths that went into it: 4 float32 steps.
static const float HIT_ROUNDING = 2.4e-7;

// How often the way back from a hit is doubled, at most: rays that graze a surface go farther back.
static const uint MAX_DOUBLINGS = 16;

// Where the search after a hit begins: on the ray to it from the start of the last search,
// as near before it as is surely on the ray's side of the plane.
// The way there is free, of this triangle and of those that meet it at an edge:
// a point moved off along the normal may be behind one of them, and lost.
float3 StartBefore(Surface surface, float3 start, float3 direction, float toHit)
{
    float3 position = abs(start + toHit * direction);
    float clear = HIT_ROUNDING * surface.Lever;
    float back = max(clear, HIT_ROUNDING * max(max(toHit, position.x), max(position.y, position.z)));
    bool isBehind = dot(surface.Normal, direction) > 0.0;
    float3 next = start;
    [loop]
    for (uint i = 0; i < MAX_DOUBLINGS; i++)
    {
        next = start + max(toHit - back, 0.0) * direction;
        float height = dot(surface.LocalNormal, PointToLocal(surface.Instance, next) - surface.Corner) / surface.Scale;
        if ((isBehind ? -height : height) >= clear)
            break;
        back *= 2.0;
    }
    return next;
}

#endif

#endif
