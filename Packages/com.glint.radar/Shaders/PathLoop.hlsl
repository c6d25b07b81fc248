#ifndef GLINT_PATH_LOOP
#define GLINT_PATH_LOOP

#include "Mirror.hlsl"
#include "ReceiverPlane.hlsl"

// Traces a path to its next bounce; false if there is none.
// FirstEntryPoint: index into _EntryPoints for the first segment.
bool Advance(inout Path path, uint firstEntryPoint, out Hit hit)
{
    hit = (Hit)0;
    LookAhead(path);
    float reach = Reach(path);
    if (reach <= 0.0)
        return false;
    hit = ClosestHit(path.Ray, reach, path.Bounces == 0 ? firstEntryPoint : NO_ENTRY_POINTS);
    if (!Observe(path, hit))
        return false;
    MoveTo(path, hit);
    Scatter(path, hit);
    return true;
}

// Traces a path to its end.
// Pixel: a point of the picture, in rays from _ReferencePixel.
Path FollowPath(float2 pixel, uint firstEntryPoint)
{
    Path path = BeginPath(pixel);
    Hit hit;
    [loop]
    while (Advance(path, firstEntryPoint, hit))
    {
    }
    return path;
}

#endif
