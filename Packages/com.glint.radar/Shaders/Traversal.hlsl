#ifndef GLINT_TRAVERSAL
#define GLINT_TRAVERSAL

#include "Real.hlsl"

#ifndef GLINT_WIDE // Wide~/TraceWide.compute includes another search
#include "TraverseBinary.hlsl"
#endif

float3 VectorToLocal(InstanceRecord record, float3 v)
{
    return float3(dot(record.ToLocalX.xyz, v), dot(record.ToLocalY.xyz, v), dot(record.ToLocalZ.xyz, v));
}

// "precise": a start is checked against the plane it leaves with the very numbers that the search then has for it.
float3 PointToLocal(InstanceRecord record, float3 p)
{
    precise float3 local = VectorToLocal(record, p) + float3(record.ToLocalX.w, record.ToLocalY.w, record.ToLocalZ.w);
    return local;
}

#ifdef GLINT_REFINE
DoubleFloat3 VectorToLocal(InstanceRecord record, DoubleFloat3 v)
{
    return MakeDoubleFloat3(
        Dot(MakeReal3(record.ToLocalX.xyz, record.ToLocalXLo.xyz), v),
        Dot(MakeReal3(record.ToLocalY.xyz, record.ToLocalYLo.xyz), v),
        Dot(MakeReal3(record.ToLocalZ.xyz, record.ToLocalZLo.xyz), v));
}

DoubleFloat3 PointToLocal(InstanceRecord record, DoubleFloat3 p)
{
    return Add(VectorToLocal(record, p), MakeReal3(float3(record.ToLocalX.w, record.ToLocalY.w, record.ToLocalZ.w),
        float3(record.ToLocalXLo.w, record.ToLocalYLo.w, record.ToLocalZLo.w)));
}
#endif

// Beside the ray that float32 searches for goes one that is followed exactly,
// by no more than this part of the scene's size.
static const float POSITION_ERROR = 1.0e-6;

// And one followed in float32: of each segment, by this part of the lengths that go into it;
// of the turn at each bounce, by this part of the way from there.
static const float ERROR_PER_SEGMENT = 3.0e-7;

// Start: where the search begins, on the ray or next to it; origin: the hit before.
void TraverseInstance(uint instance, float3 start, Real3 origin, Real3 direction, uint4 entryPoints, inout Hit hit)
{
    InstanceRecord record = LoadInstance(instance);
    float positionError = hit.PositionError * record.Stretch + record.Rounding;
#ifdef GLINT_REFINE
    hit.Ray.SceneExtent = _SceneCentreExtent.w * record.Stretch;
    hit.Ray.Origin = PointToLocal(record, origin);
    hit.Ray.Direction = VectorToLocal(record, direction);
#endif
    TraverseMesh(MakeTraversalRay(PointToLocal(record, start), VectorToLocal(record, Rounded(direction)), positionError,
        hit.DirectionError * record.Stretch), instance, record.Page, record.FirstRow, entryPoints, hit);
}

#ifndef GLINT_INLINE_INSTANCES
void TraverseInstanceBvh(float3 start, Real3 origin, Real3 direction, inout Hit hit)
{
    TraversalRay ray = MakeTraversalRay(start, Rounded(direction), hit.PositionError, hit.DirectionError);
    BoxRay boxRay = MakeBoxRay(ray, asfloat(_InstanceBvh[0].xyz));
    uint stack[STACK_BOTTOM + BINARY_LEVELS];
    stack[0] = DONE;
    stack[1] = DONE;
    uint top = 1;
    uint current = _InstanceBvhRoot;
    [loop]
    while (current != DONE)
    {
        [loop]
        while ((current & LEAF) == 0)
        {
            COUNT_NODE;
            Entered entered =
                EnterChildren(_InstanceBvh[current], _InstanceBvh[current + 1],
                    _InstanceBvh[current + 2].xyz, boxRay, hit.Distance);
            current = entered.Near;
            if (entered.Both)
                stack[++top] = entered.Far;
            if (!entered.Any)
                current = stack[top--];
        }
        if (current != DONE)
        {
            // A leaf holds an instance's number.
            TraverseInstance(_InstanceBvh[current & ~LEAF].x, start, origin, direction, ROOT_ENTRY_POINTS, hit);
            current = stack[top--];
        }
    }
}
#endif

// The nearest triangle that the ray meets before reach, over all instances; not the one it is leaving.
// PositionError: how far beside it float32 may have brought the start, m; the refine kernels have another.
// FirstEntryPoint: where _EntryPoints says where to begin in the BVH of each instance; NO_ENTRY_POINTS: at the roots.
Hit ClosestHit(float3 start, Real3 origin, Real3 direction, float reach, uint firstEntryPoint, uint2 excludedTriangle,
    uint bounces, float positionError)
{
    Hit hit = (Hit)0;
    hit.Distance = reach;
    hit.Instance = NO_INSTANCE;
    hit.ExcludedTriangle = excludedTriangle;
#ifdef GLINT_REFINE
    hit.PositionError = POSITION_ERROR * _SceneCentreExtent.w;
    hit.Ray.Back = dot(Rounded(origin) - start, Rounded(direction));
    hit.Distance += hit.Ray.Back + hit.PositionError;
    hit.RefinedDistance = MakeDoubleFloat(MISS, 0.0);
#else
    hit.DirectionError = ERROR_PER_SEGMENT * (1 + bounces);
    hit.PositionError = positionError + ERROR_PER_SEGMENT * MaxComponent(abs(start));
    hit.AmbiguousDistance = MISS;
#endif
#ifdef GLINT_INLINE_INSTANCES
#ifdef GLINT_SINGLE_INSTANCE
    uint instance = 0; // a loop of one turn costs a software device a tenth of its time
#else
    [loop]
    for (uint instance = 0; instance < _InstanceCount; instance++)
#endif
    {
        uint4 entryPoints = ROOT_ENTRY_POINTS;
        if (firstEntryPoint != NO_ENTRY_POINTS)
            entryPoints = _EntryPoints[firstEntryPoint + instance];
        TraverseInstance(instance, start, origin, direction, entryPoints, hit);
    }
#else
    TraverseInstanceBvh(start, origin, direction, hit);
#endif
    return hit;
}

// From the ray's origin to the nearest triangle, m; MISS or beyond if there is none.
Real HitDistance(Hit hit)
{
#ifdef GLINT_REFINE
    return hit.RefinedDistance;
#else
    return hit.Distance;
#endif
}

#endif
