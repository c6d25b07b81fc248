#ifndef GLINT_CLOSEST_HIT
#define GLINT_CLOSEST_HIT

#include "Traversal.hlsl"

// The closest hit of a segment. The same struct in float32 and in double-float arithmetic.
struct Hit
{
    uint Instance;          // index into _Instances; NO_INSTANCE: no hit within reach
    uint Row;               // of the leaf's pair of triangles in its BVH
    bool Second;            // the second triangle of the pair
    Real TraversalDistance;  // m, found by the traversal; at least the reach if there is no hit
    Real Distance;          // m, from the ray's origin along the ray to the triangle's plane
    Real3 Normal;           // unit vector in the scene, towards the ray
    bool IsAmbiguous;       // float32 cannot decide whether this is the closest hit
#ifndef GLINT_REFINE
    bool IsSure;            // no other triangle is hit at this distance within its error
    float3 NextStart;       // start of the traversal after it
#endif
};

bool IsMiss(Hit hit)
{
    return hit.Instance == NO_INSTANCE;
}

Hit NoHit()
{
    Hit hit = (Hit)0;
    hit.Instance = NO_INSTANCE;
    hit.TraversalDistance = MakeReal(MISS, 0.0);
    return hit;
}

// Normals transform by the transpose of the inverse.
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

// Distance before an edge or corner at which a ray that hits it is reflected, as a fraction of the scene's size: there
// it is on the right side of all adjacent surfaces. At most half the way back, as there may be a surface behind it too.
static const float BEFORE_EDGE = 1.0e-10;

Hit LoadHit(TraversalState state, Ray ray)
{
    InstanceRecord record = LoadInstance(state.Instance);
    Real3 sceneNormal = NormalFromLocal(record, state.Normal);
    Hit hit = (Hit)0;
    hit.Normal = Mul(sceneNormal, 1.0 / length(Rounded(sceneNormal)));
    hit.Distance = state.RefinedDistance;
    if (state.IsAtEdge)
        hit.Distance = Sub(state.RefinedDistance,
            MakeDoubleFloat(min(BEFORE_EDGE * _SceneCentreExtent.w, 0.5 * state.RefinedDistance.Hi), 0.0));
    return hit;
}

#else

// Sine of the angle between the two shorter edges of a triangle, below which float32 has no normal that could decide
// reception.
static const float NEEDLE = 0.1;

// Maximum difference between the distance to the plane and that of the traversal, as a fraction of the lengths in the
// computation. Above it the traversal's distance is used: rounding makes a grazing ray hit the plane anywhere.
static const float GRAZING = 1.0e-3;

// Rounding of a hit, as a fraction of the lengths in the computation: 4 float32 steps.
static const float HIT_ROUNDING = 2.4e-7;

// Maximum number of doublings of the distance from a hit back to the next start: grazing rays need more.
static const uint MAX_DOUBLINGS = 16;

// The plane of the hit triangle, in the mesh's frame.
struct Plane
{
    InstanceRecord Instance;
    float3 Corner;
    float3 Normal;        // unit vector
    bool IsBehind;        // the ray comes from the back of the normal
    float Scale;          // height above the plane in this frame per metre in the scene
    float Lever;          // distance from the corner to the hit: lever of the normal's rounding, m in the scene
};

// Start of the traversal after a hit: the point of the incoming ray nearest to the hit that is certainly on the ray's
// side of the plane. The incoming segment is free of this triangle and of its neighbours, while a point offset along
// the normal may be behind one of them.
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
    // Computed from the two shorter edges, so that the normal of a long strip is as accurate as that of a square.
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
    if (IsNaN(hit.Distance) || abs(hit.Distance - searchDistance) > GRAZING * (state.Distance + largest))
        hit.Distance = searchDistance;
    plane.Lever = MaxComponent(abs(localOrigin + hit.Distance * localDirection - plane.Corner)) / plane.Scale;
    plane.IsBehind = dot(hit.Normal, ray.Direction) > 0.0;
    hit.IsAmbiguous = dot(area, area) < NEEDLE * NEEDLE * dot(side1, side1) * dot(side2, side2);
    hit.NextStart = StartBefore(plane, ray.Start, ray.Direction, state.Distance);
    return hit;
}

#endif

// The closest hit of a ray within reach, m.
// FirstEntryPoint: index into _EntryPoints of the first instance; NO_ENTRY_POINTS: traversal from the roots.
// Met: the triangle that is hit, if it is known; else its instance is NO_INSTANCE.
Hit ClosestHit(Ray ray, float reach, uint firstEntryPoint, uint2 met)
{
    TraversalState state = BeginTraversal(ray, reach, false);
    Traverse(ray, firstEntryPoint, met, false, state);
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
    hit.TraversalDistance = state.RefinedDistance;
#else
    hit.TraversalDistance = state.Distance;
    // A triangle whose edge the ray passes within the edge error may be the true hit.
    bool isByEdge = state.AmbiguousDistance < MISS && state.AmbiguousDistance <= state.Distance;
    hit.IsAmbiguous = hit.IsAmbiguous || isByEdge;
    float upper = IsMiss(hit) ? state.Distance : 2.0 * state.Distance - state.LowerDistance;
    hit.IsSure = !hit.IsAmbiguous && state.NextLowerDistance > upper;
#endif
    return hit;
}

// The any-hit query of shadow rays: whether the ray hits anything within reach, m.
// IsAmbiguous: float32 cannot decide.
bool AnyHit(Ray ray, float reach, out bool isAmbiguous)
{
    TraversalState state = BeginTraversal(ray, reach, true);
    Traverse(ray, NO_ENTRY_POINTS, NOT_MET, true, state);
#ifdef GLINT_REFINE
    isAmbiguous = false;
#else
    isAmbiguous = state.AmbiguousDistance <= reach && state.AmbiguousDistance < MISS;
#endif
    return state.Instance != NO_INSTANCE;
}

#endif
