#ifndef GLINT_PATH_LOOP
#define GLINT_PATH_LOOP

#include "Mirror.hlsl"
#include "ReceiverPlane.hlsl"

// Follows a path to its next bounce; false if there is none.
// FirstEntryPoint: where _EntryPoints says where the search of the first segment begins.
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

// Follows a ray to its end.
// Pixel: a place in the picture, in rays from _ReferencePixel.
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
