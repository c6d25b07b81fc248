#ifndef GLINT_CANDIDATES
#define GLINT_CANDIDATES

#include "WorkLists.hlsl"
#include "Path.hlsl"

// Candidates: rays that the refine pass follows. It intersects the triangles of which float32 is sure instead of
// searching: all that a known candidate meets, and the first ones of the others.

#ifndef GLINT_REFINE

// Triangles that this thread's path has met: see NumberOf.
static uint2 s_met[MAX_BOUNCES];

// Notes the triangle of a path's last hit.
void NoteMet(inout Path path)
{
    s_met[path.Bounces - 1] = path.Ray.ExcludedTriangle;
    path.SureBounces = path.Bounces;
}

// Adds a ray to the list for the refine pass.
// Number: index in the order of tiles, or number of the sub-ray.
void AddCandidate(Path path, uint pixel, uint number)
{
    uint entry = 0;
    if (path.IsSure)
        InterlockedAdd(_Sums[_HasSubRays != 0 ? COUNT_SUB_KNOWN : COUNT_KNOWN], 1, entry);
    if (!path.IsSure || entry >= SearchedList())
    {
        InterlockedAdd(_Sums[_HasSubRays != 0 ? COUNT_SUB_SEARCHED : COUNT_SEARCHED], 1, entry);
        entry += SearchedList();
    }
    _Candidates[entry] = uint2(pixel, number);
    if (!HasMet(entry))
        return;
    [loop]
    for (uint bounce = 0; bounce < _MaxBounces; bounce++)
        _Met[entry * _MaxBounces + bounce] = bounce < path.SureBounces ? s_met[bounce] : NOT_MET;
}

#endif

#ifdef GLINT_FOLLOW_MET

// The triangle that a path meets next; its instance is NO_INSTANCE if float32 does not know.
uint2 MetNext(Path path)
{
    bool isNoted = path.FirstMet != NOTHING_MET && path.Bounces < _MaxBounces;
    uint2 met = _Met[isNoted ? path.FirstMet + path.Bounces : 0]; // both sides of ? are evaluated
    return isNoted ? met : NOT_MET;
}

// Whether float32 is sure that nothing is between the last hit and the receiver.
bool IsWayBackClear(Path path)
{
    return path.IsKnown && path.MeetsReceiver && MetNext(path).x == NO_INSTANCE;
}

#endif

#endif
