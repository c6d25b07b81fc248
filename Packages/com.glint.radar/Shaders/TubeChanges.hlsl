#ifndef GLINT_TUBE_CHANGES
#define GLINT_TUBE_CHANGES

#include "TubeGrid.hlsl"
#include "Sums.hlsl"

// Finds how the currents of tubes change along them at a finite range, where directions and polarisations are those of each
// place. One thread a tube, which follows its ray again.

// What a ray beside a hit meets, some base cells away: the same, to first order.
void MoveBeside(inout TubePath tube, inout SurfacePoint at, float2 step)
{
    float3 d = tube.Path.Ray.Direction, turn = step.x * tube.DirectionU + step.y * tube.DirectionV, v = tube.V;
    float roll = dot(step, tube.Roll);
    tube.Path.Ray.Origin += step.x * tube.PlaceU + step.y * tube.PlaceV;
    tube.Path.Ray.Direction = normalize(d + turn);
    tube.V += roll * tube.H - d * dot(turn, tube.V);
    tube.H -= roll * v + d * dot(turn, tube.H);
    at.Normal = normalize(at.Normal + step.x * at.NormalU + step.y * at.NormalV);
}

// How the currents of a tube change over a length by u and v, base cells, for the strength of its ray. reach: that length; side:
// of the cell. isKnown: they are not past a silhouette.
Changes FindChanges(TubePath tube, SurfacePoint at, uint index, float side, float reach, out bool isKnown)
{
    Changes changes = (Changes)0;
    uint receivers = ReceiversOf(tube, at);
    float strength = StrengthAt(tube, at, receivers);
    isKnown = true;
    [loop]
    for (uint place = 0; place < 4; place++)
    {
        float sense = 2.0 * (place & 1) - 1.0;
        float2 step = place < 2 ? float2(sense, 0.0) : float2(0.0, sense);
        TubePath beside = tube;
        SurfacePoint there = at;
        MoveBeside(beside, there, 0.5 * side * step);
        float strengthThere = StrengthAt(beside, there, receivers);
        // Past a silhouette there is nothing.
        isKnown = isKnown && !IsNaN(strengthThere) && strengthThere > max(MIN_STRENGTH * strength, MIN_CURRENTS);
        Tube currents = CurrentsAt(IncidenceAt(beside, there), beside, index,
            ReceiverFrom(index, beside.Path.Ray.Origin));
        float2 part = isKnown ? reach / side * strength / strengthThere * step : 0.0;
        changes.CoPolarU += part.x * currents.CoPolar;
        changes.CoPolarV += part.y * currents.CoPolar;
        changes.CrossPolarU += part.x * currents.CrossPolar;
        changes.CrossPolarV += part.y * currents.CrossPolar;
    }
    return changes;
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= min(_Sums[TUBE_COUNT], _ListCapacity.x))
        return;
    Tube currents = _Tubes[index];
    if (!HasChanges(currents))
        return;
    uint slot = currents.Tag & 0xff;
    s_pose = slot / _SlotCount;
    float4 left = _TubeExtras[_ExtraRows * index + 1];
    TubePath tube = BeginTube(left.xy);
    SurfacePoint at;
    // Additions to one word wait for each other.
    s_part = group.x % POSE_PARTS;
    AddTo(CountWord(POSE_RAYS), 1);
    bool goesOn = AdvanceTube(tube, at);
    [loop]
    while (goesOn && tube.Path.Bounces < BounceOf(currents))
        goesOn = ScatterTube(tube, at) && AdvanceTube(tube, at);
    bool isKnown = false;
    Changes changes = (Changes)0;
    if (goesOn)
        changes = FindChanges(tube, at, slot % _SlotCount % _ReceiverCount, left.z, CornersOf(currents) == 0 ? 0.5 * left.z : 1.0,
            isKnown);
    if (isKnown)
        SetChanges(index, changes);
    else
        _Tubes[index].Tag = currents.Tag & ~CHANGES;
}

#endif
