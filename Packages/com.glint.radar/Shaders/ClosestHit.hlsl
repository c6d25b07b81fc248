#ifndef GLINT_CLOSEST_HIT
#define GLINT_CLOSEST_HIT

#include "Traversal.hlsl"

// What a segment meets first. The same in float32 and in double-float arithmetic.
struct Hit
{
    uint Instance;          // record of _Instances; NO_INSTANCE: nothing within reach
    uint Row;               // of the pair of triangles in its BVH
    bool Second;            // which of the pair
    Real SearchDistance;    // m, where the search met it; the reach or more if it met nothing
    Real Distance;          // m, from the ray's origin to the triangle's plane
    Real3 Normal;           // unit vector by float32, in the scene, towards the ray
    bool IsAmbiguous;       // float32 cannot tell whether this is what the ray meets
#ifndef GLINT_REFINE
    float3 NextStart;       // where the search after it begins
#endif
};

bool IsMiss(Hit hit)
{
    return hit.Instance == NO_INSTANCE;
}

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

Hit LoadHit(TraversalState state, Ray ray)
{
    InstanceRecord record = LoadInstance(state.Instance);
    Pair pair = LoadPair(record.Page, record.FirstRow + state.Row);
    Real3 normal = Cross(Difference(pair.Corner2, pair.Corner0),
        Difference(state.Second ? pair.Corner3 : pair.Corner1, pair.Corner0));
    Real3 sceneNormal = NormalFromLocal(record, Mul(normal, 1.0 / length(Rounded(normal))));
    Hit hit = (Hit)0;
    hit.Normal = Mul(sceneNormal, 1.0 / length(Rounded(sceneNormal)));
    hit.Distance = state.RefinedDistance;
    if (state.IsAtEdge)
        hit.Distance = Sub(state.RefinedDistance,
            MakeDoubleFloat(min(BEFORE_EDGE * _SceneCentreExtent.w, 0.5 * state.RefinedDistance.Hi), 0.0));
    return hit;
}

#else

// Sine of the angle between the two shorter edges of a triangle,
// below which its normal is not good enough to tell what may be received.
static const float NEEDLE = 0.1;

// A ray that grazes a plane meets it anywhere, by rounding:
// where the search met it counts when the plane is so much farther off, as a part of the lengths that went into it.
static const float GRAZING = 1.0e-3;

// Rounding of a hit, as a fraction of the lengths that went into it: 4 float32 steps.
static const float HIT_ROUNDING = 2.4e-7;

// How often the way back from a hit is doubled, at most: rays that graze a surface go farther back.
static const uint MAX_DOUBLINGS = 16;

// The plane of a triangle that was hit, in the mesh's frame.
struct Plane
{
    InstanceRecord Instance;
    float3 Corner;
    float3 Normal;        // unit vector
    bool IsBehind;        // the ray comes from the side that the normal points away from
    float Scale;          // height above the plane here, of 1 m in the scene
    float Lever;          // from the corner to the hit: the lever of the normal's rounding, as a height in m
};

// Where the search after a hit begins: on the ray to it from the start of the last search,
// as near before it as is surely on the ray's side of the plane.
// The way there is free, of this triangle and of those that meet it at an edge:
// a point moved off along the normal may be behind one of them, and lost.
float3 StartBefore(Plane plane, float3 start, float3 direction, float toHit)
{
    float3 position = abs(start + toHit * direction);
    float clear = HIT_ROUNDING * plane.Lever;
    float back = max(clear, HIT_ROUNDING * max(max(toHit, position.x), max(position.y, position.z)));
    float3 next = start;
    [loop]
    for (uint i = 0; i < MAX_DOUBLINGS; i++)
    {
        next = start + max(toHit - back, 0.0) * direction;
        float height = dot(plane.Normal, PointToLocal(plane.Instance, next) - plane.Corner) / plane.Scale;
        if ((plane.IsBehind ? -height : height) >= clear)
            break;
        back *= 2.0;
    }
    return next;
}

Hit LoadHit(TraversalState state, Ray ray)
{
    InstanceRecord record = LoadInstance(state.Instance);
    Pair pair = LoadPair(record.Page, record.FirstRow + state.Row);
    float3 third = state.Second ? pair.Corner3 : pair.Corner1;
    float3 edge1 = pair.Corner2 - pair.Corner0, edge2 = third - pair.Corner0, edge3 = third - pair.Corner2;
    // By the two shorter edges: the normal of a long strip is as good as that of a square.
    float size1 = dot(edge1, edge1), size2 = dot(edge2, edge2), size3 = dot(edge3, edge3);
    bool isFirstLongest = size1 >= size2 && size1 >= size3, isSecondLongest = !isFirstLongest && size2 >= size3;
    float3 side1 = isFirstLongest ? edge3 : edge1, side2 = isSecondLongest ? edge3 : edge2, area = cross(side1, side2);
    float3 localOrigin = PointToLocal(record, ray.Origin), localDirection = VectorToLocal(record, ray.Direction);
    Plane plane;
    plane.Instance = record;
    plane.Normal = normalize(area);
    plane.Corner = pair.Corner0;
    float3 sceneNormal = NormalFromLocal(record, plane.Normal);
    plane.Scale = length(sceneNormal);

    Hit hit = (Hit)0;
    hit.Normal = sceneNormal / plane.Scale;
    hit.Distance = ToPlane(localOrigin, localDirection, plane.Corner, plane.Normal);
    float largest = MaxComponent(abs(ray.Origin));
    float searchDistance = state.Distance + dot(ray.Start - ray.Origin, ray.Direction);
    if (!(abs(hit.Distance - searchDistance) <= GRAZING * (state.Distance + largest)))
        hit.Distance = searchDistance;
    plane.Lever = MaxComponent(abs(localOrigin + hit.Distance * localDirection - plane.Corner)) / plane.Scale;
    plane.IsBehind = dot(hit.Normal, ray.Direction) > 0.0;
    hit.IsAmbiguous = dot(area, area) < NEEDLE * NEEDLE * dot(side1, side1) * dot(side2, side2);
    hit.NextStart = StartBefore(plane, ray.Start, ray.Direction, state.Distance);
    return hit;
}

#endif

// What the ray meets first, no farther than reach, m.
// FirstEntryPoint: where _EntryPoints says where to begin in the BVH of each instance; NO_ENTRY_POINTS: at the roots.
Hit ClosestHit(Ray ray, float reach, uint firstEntryPoint)
{
    TraversalState state = Traverse(ray, reach, firstEntryPoint, false);
    Hit hit = (Hit)0;
    if (state.Instance != NO_INSTANCE)
    {
        hit = LoadHit(state, ray);
        if (Rounded(Dot(hit.Normal, ray.Direction)) > 0.0)
            hit.Normal = Mul(hit.Normal, -1.0);
    }
    hit.Instance = state.Instance;
    hit.Row = state.Row;
    hit.Second = state.Second;
#ifdef GLINT_REFINE
    hit.SearchDistance = state.RefinedDistance;
#else
    hit.SearchDistance = state.Distance;
    // What a ray goes by an edge of may keep it in truth from going farther.
    bool isByEdge = state.AmbiguousDistance < MISS && state.AmbiguousDistance <= state.Distance;
    hit.IsAmbiguous = hit.IsAmbiguous || isByEdge;
#endif
    return hit;
}

// The shadow query: whether the ray meets anything, no farther than reach, m.
// IsAmbiguous: float32 cannot tell.
bool AnyHit(Ray ray, float reach, out bool isAmbiguous)
{
    TraversalState state = Traverse(ray, reach, NO_ENTRY_POINTS, true);
#ifdef GLINT_REFINE
    isAmbiguous = false;
#else
    isAmbiguous = state.AmbiguousDistance <= reach && state.AmbiguousDistance < MISS;
#endif
    return state.Instance != NO_INSTANCE;
}

#endif
