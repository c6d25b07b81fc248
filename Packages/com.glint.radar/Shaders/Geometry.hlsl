#ifndef GLINT_GEOMETRY
#define GLINT_GEOMETRY

#include "Types.hlsl"

// Distance of a segment that hits nothing, m.
static const float MISS = 3.0e38;

// Least size of a direction's component, so that its inverse stays finite and an axis-parallel ray on a box's face is no 0 * infinity.
static const float LEAST_COMPONENT = 1.0e-20;

// A ray starts off the surface it leaves, on the side it came from, by this fraction (64 float32 steps) of the largest length that went into the hit.
static const float ORIGIN_OFFSET = 4.0e-6;

float3 SafeInverse(float3 d)
{
    float3 size = max(abs(d), LEAST_COMPONENT);
    return float3(d.x < 0.0 ? -1.0 : 1.0, d.y < 0.0 ? -1.0 : 1.0, d.z < 0.0 ? -1.0 : 1.0) / size;
}

// Distance at which the ray enters the box, 0 inside it, MISS if it does not enter nearer than reach.
float EnterBox(BvhNode box, float3 origin, float3 inverse, float reach)
{
    float3 a = (box.Min - origin) * inverse;
    float3 b = (box.Max - origin) * inverse;
    float3 first = min(a, b);
    float3 last = max(a, b);
    float enter = max(max(first.x, first.y), max(first.z, 0.0));
    float leave = min(min(last.x, last.y), min(last.z, reach));
    // Rounding must not lose a ray that grazes the box: 4 float32 steps.
    return enter <= leave * 1.0000005 ? enter : MISS;
}

// Distance to the triangle (Moeller and Trumbore 1997), both sides; MISS outside it, behind the origin or when the triangle has no area.
float HitTriangle(TriangleRecord t, float3 origin, float3 direction)
{
    float3 p = cross(direction, t.Edge2);
    float determinant = dot(t.Edge1, p);
    if (determinant == 0.0)
        return MISS;
    float inverse = 1.0 / determinant;
    float3 s = origin - t.Corner;
    float u = dot(s, p) * inverse;
    float3 q = cross(s, t.Edge1);
    float v = dot(direction, q) * inverse;
    float toHit = dot(t.Edge2, q) * inverse;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && toHit > 0.0 ? toHit : MISS;
}

// Distance along the ray to a plane through point, m.
float HitPlane(float3 origin, float3 direction, float3 onPlane, float3 normal)
{
    return dot(normal, onPlane - origin) / dot(normal, direction);
}

#endif
