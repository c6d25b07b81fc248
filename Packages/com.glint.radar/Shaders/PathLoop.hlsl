#ifndef GLINT_PATH_LOOP
#define GLINT_PATH_LOOP

#include "Mirror.hlsl"
#include "ReceiverPlane.hlsl"
#include "Candidates.hlsl"

// Traces a path to its next bounce; false if there is none.
// FirstEntryPoint: index into _EntryPoints for the first segment.
bool Advance(inout Path path, uint firstEntryPoint, out Hit hit)
{
    hit = (Hit)0;
    LookAhead(path);
    float reach = Reach(path);
    if (reach <= 0.0)
        return false;
#ifdef GLINT_FOLLOW_MET
    hit = NoHit();
    if (!IsWayBackClear(path))
        hit = ClosestHit(path.Ray, reach, NO_ENTRY_POINTS, MetNext(path));
#else
    hit = ClosestHit(path.Ray, reach, path.Bounces == 0 ? firstEntryPoint : NO_ENTRY_POINTS, NOT_MET);
#endif
    bool goesOn = Observe(path, hit);
#ifndef GLINT_REFINE
    path.IsSure = path.IsSure && hit.IsSure && (goesOn || IsMiss(hit));
#endif
    if (!goesOn)
        return false;
    MoveTo(path, hit);
#ifndef GLINT_REFINE
    if (path.IsSure)
        NoteMet(path);
#endif
    Scatter(path, hit);
    return true;
}

// Traces a path to its end.
void FollowPath(inout Path path, uint firstEntryPoint)
{
    Hit hit;
    [loop]
    while (Advance(path, firstEntryPoint, hit))
    {
    }
}

#endif
