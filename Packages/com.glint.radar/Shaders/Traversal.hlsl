#ifndef GLINT_TRAVERSAL
#define GLINT_TRAVERSAL

#include "Real.hlsl"

#ifndef GLINT_WIDE // Wide~/TraceWide.compute includes another search
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
    return Plus(VectorToLocal(place, p), MakeReal3(float3(place.ToLocalX.w, place.ToLocalY.w, place.ToLocalZ.w),
        float3(place.RestX.w, place.RestY.w, place.RestZ.w)));
}
#endif

// Beside the ray that float32 searches for goes one that is followed exactly,
// by no more than this part of the scene's size.
static const float SLACK = 1.0e-6;

// And one followed in float32: of each segment, by this part of the lengths that go into it;
// of the turn at each bounce, by this part of the way from there.
static const float SLACK_A_SEGMENT = 3.0e-7;

// Start: where the search begins, on the ray or next to it; origin: the hit before.
void SearchInstance(uint instance, float3 start, Real3 origin, Real3 direction, uint4 starts, inout Found found)
{
    InstanceRecord place = LoadInstance(instance);
    float slack = found.Slack * place.Stretch + place.Rounding;
#ifdef GLINT_EXACT
    found.Line.Far = _Middle.w * place.Stretch;
    found.Line.Origin = PointToLocal(place, origin);
    found.Line.Direction = VectorToLocal(place, direction);
#endif
    SearchMesh(MakeSearchRay(PointToLocal(place, start), VectorToLocal(place, Rounded(direction)), slack,
        found.SlackAMetre * place.Stretch), instance, place.Bank, place.FirstRow, starts, found);
}

#ifndef GLINT_FEW
void SearchTop(float3 start, Real3 origin, Real3 direction, inout Found found)
{
    SearchRay ray = MakeSearchRay(start, Rounded(direction), found.Slack, found.SlackAMetre);
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
            Entered entered =
                EnterChildren(_Top[current], _Top[current + 1], _Top[current + 2].xyz, boxRay, found.Distance);
            current = entered.Near;
            if (entered.Both)
                stack[++top] = entered.Far;
            if (!entered.Any)
                current = stack[top--];
        }
        if (current != DONE)
        {
            // A leaf holds an instance's number.
            SearchInstance(_Top[current & ~LEAF].x, start, origin, direction, FROM_ROOT, found);
            current = stack[top--];
        }
    }
}
#endif

// The nearest triangle that the ray meets before reach, over all instances; not the one it is leaving.
// Slack: how far beside it float32 may have brought the start, m; the exact kernels have another.
// FirstStart: where _Starts says where to begin in the tree of each instance; NO_STARTS: at the roots.
Found FindNearest(float3 start, Real3 origin, Real3 direction, float reach, uint firstStart, uint2 leaving,
    uint bounces, float slack)
{
    Found found = (Found)0;
    found.Distance = reach;
    found.Instance = NO_INSTANCE;
    found.Leaving = leaving;
#ifdef GLINT_EXACT
    found.Slack = SLACK * _Middle.w;
    found.Line.Back = dot(Rounded(origin) - start, Rounded(direction));
    found.Distance += found.Line.Back + found.Slack;
    found.Exact = MakeTwo(MISS, 0.0);
#else
    found.SlackAMetre = SLACK_A_SEGMENT * (1 + bounces);
    found.Slack = slack + SLACK_A_SEGMENT * Greatest(abs(start));
    found.InDoubt = MISS;
#endif
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
        SearchInstance(instance, start, origin, direction, starts, found);
    }
#else
    SearchTop(start, origin, direction, found);
#endif
    return found;
}

// From the ray's origin to the nearest triangle, m; MISS or beyond if there is none.
Real ToNearest(Found found)
{
#ifdef GLINT_EXACT
    return found.Exact;
#else
    return found.Distance;
#endif
}

#endif
