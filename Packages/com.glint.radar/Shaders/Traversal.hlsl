#ifndef GLINT_TRAVERSAL
#define GLINT_TRAVERSAL

#include "Real.hlsl"

#ifndef GLINT_WIDE // Wide~/TraceWide.compute includes another traversal
#include "TraverseBinary.hlsl"
#endif

float3 VectorToLocal(InstanceRecord record, float3 v)
{
    return float3(dot(record.ToLocalX.xyz, v), dot(record.ToLocalY.xyz, v), dot(record.ToLocalZ.xyz, v));
}

// "precise": the check of a start against the plane it leaves must use the same bits as the traversal.
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

// Maximum distance between the float32 ray of the traversal and the double-float ray, as a fraction of the scene's
// size.
static const float POSITION_ERROR = 1.0e-6;

// Error of a float32 path: of positions, per segment, as a fraction of the lengths in the computation; of directions,
// per bounce, in radians.
static const float ERROR_PER_SEGMENT = 3.0e-7;

// A segment of a path, relative to the scene's centre.
struct Ray
{
    Real3 Origin;            // m: the last hit, or the path's origin
    Real3 Direction;         // unit vector
    // start of the traversal: in float32 on the incoming segment just before the origin, else on this segment
    float3 Start;
    uint2 ExcludedTriangle;  // the last triangle hit, which cannot be hit again: see NumberOf
    float PositionError;     // in float32: maximum distance between the origin and the true origin, m,
    float DirectionError;    // and its growth per metre
};

// The ray in the frame of an instance's mesh.
TraversalRay EnterInstance(InstanceRecord record, Ray ray, inout TraversalState state)
{
    float positionError = state.PositionError * record.Stretch + record.Rounding;
#ifdef GLINT_REFINE
    state.Ray.SceneExtent = _SceneCentreExtent.w * record.Stretch;
    state.Ray.Origin = PointToLocal(record, ray.Origin);
    state.Ray.Direction = VectorToLocal(record, ray.Direction);
#endif
    return MakeTraversalRay(PointToLocal(record, ray.Start), VectorToLocal(record, Rounded(ray.Direction)),
        positionError, state.DirectionError * record.Stretch);
}

void TraverseInstance(uint instance, Ray ray, uint4 entryPoints, bool anyHit, inout TraversalState state)
{
    InstanceRecord record = LoadInstance(instance);
    TraverseMesh(EnterInstance(record, ray, state), instance, record.Page, record.FirstRow, entryPoints, anyHit, state);
}

#ifndef GLINT_INLINE_INSTANCES
// Scenes of several poses lie one behind the other: of this thread's scene the first instance, and the first row of the BVH
// over its instances.
#ifdef GLINT_AMPLITUDE
static uint s_firstInstance = 0, s_firstRow = 0;
#else
static const uint s_firstInstance = 0, s_firstRow = 0;
#endif

// Met: the triangle that float32 has hit, which is tested alone, before a search if the ray misses it; NO_INSTANCE: not
// known. Both are one call, because the code of the double-float tests is long.
void TraverseInstanceBvh(Ray ray, uint2 met, bool anyHit, inout TraversalState state)
{
    TraversalRay traversalRay =
        MakeTraversalRay(ray.Start, Rounded(ray.Direction), state.PositionError, state.DirectionError);
    BoxRay boxRay = MakeBoxRay(traversalRay, asfloat(_InstanceBvh[s_firstRow].xyz));
    uint stack[STACK_BOTTOM + BINARY_LEVELS];
    stack[0] = DONE;
    stack[1] = DONE;
    uint top = 1;
    bool isMet = met.x != NO_INSTANCE;
    uint current = isMet ? LEAF : _InstanceBvhRoot;
    [loop]
    while (current != DONE)
    {
        [loop]
        while ((current & LEAF) == 0)
        {
            COUNT_NODE;
            uint row = s_firstRow + current;
            Entered entered = EnterChildren(_InstanceBvh[row], _InstanceBvh[row + 1], _InstanceBvh[row + 2].xyz, boxRay,
                state.Distance);
            current = entered.Near;
            if (entered.Both)
                stack[++top] = entered.Far;
            if (!entered.Any)
                current = stack[top--];
        }
        if (current != DONE)
        {
            // A leaf holds the index of an instance.
            uint instance = isMet ? met.x : s_firstInstance + _InstanceBvh[s_firstRow + (current & ~LEAF)].x;
#ifdef GLINT_REFINE
            if (isMet)
                state.PendingLeaf = 4 * (met.y / 2) + ((met.y & 1) != 0 ? 2 : 1);
#endif
            TraverseInstance(instance, ray, isMet ? (uint4)DONE : ROOT_ENTRY_POINTS, anyHit, state);
            if (isMet)
                current = state.Instance == NO_INSTANCE ? _InstanceBvhRoot : DONE;
            else
                current = IsEnough(state, anyHit) ? DONE : stack[top--];
            isMet = false;
        }
    }
}
#endif

// The state before a traversal up to reach, m from ray.Start.
TraversalState BeginTraversal(Ray ray, float reach, bool anyHit)
{
    TraversalState state = (TraversalState)0;
    state.Distance = reach;
    state.Instance = NO_INSTANCE;
    state.ExcludedTriangle = ray.ExcludedTriangle;
#ifdef GLINT_REFINE
    state.PositionError = POSITION_ERROR * _SceneCentreExtent.w;
    state.Ray.Back = dot(Rounded(ray.Origin) - ray.Start, Rounded(ray.Direction));
    state.Distance += state.Ray.Back + state.PositionError;
    state.RefinedDistance = MakeDoubleFloat(anyHit ? reach : MISS, 0.0);
#else
    state.DirectionError = ray.DirectionError;
    state.PositionError = ray.PositionError + ERROR_PER_SEGMENT * MaxComponent(abs(ray.Start));
    state.AmbiguousDistance = MISS;
    state.LowerDistance = MISS;
    state.NextLowerDistance = MISS;
    state.Tied.x = NO_INSTANCE;
#endif
    return state;
}

// Traverses all instances, without the excluded triangle.
// FirstEntryPoint: index into _EntryPoints of the first instance; NO_ENTRY_POINTS: traversal from the roots.
// Met: a triangle to test first (see TraverseInstanceBvh).
void Traverse(Ray ray, uint firstEntryPoint, uint2 met, bool anyHit, inout TraversalState state)
{
#ifdef GLINT_INLINE_INSTANCES
#ifdef GLINT_SINGLE_INSTANCE
    uint instance = 0; // a loop of one iteration costs a software device a tenth of its time
#else
    [loop]
    for (uint instance = 0; instance < _InstanceCount && !IsEnough(state, anyHit); instance++)
#endif
    {
        uint4 entryPoints = ROOT_ENTRY_POINTS;
        if (firstEntryPoint != NO_ENTRY_POINTS)
            entryPoints = _EntryPoints[firstEntryPoint + instance];
        if (entryPoints.x != DONE)
            TraverseInstance(instance, ray, entryPoints, anyHit, state);
    }
#else
    TraverseInstanceBvh(ray, met, anyHit, state);
#endif
#ifndef GLINT_REFINE
    // Shadow rays ask for any triangle.
    if (!anyHit)
        DecideTie(state);
#endif
}

#endif
