#ifndef GLINT_MIRROR
#define GLINT_MIRROR

#include "Path.hlsl"

// Continues a path from a hit: every surface is a mirror.
void Scatter(inout Path path, Hit hit)
{
    Real share = Div(Dot(hit.Normal, path.Ray.Direction), Dot(hit.Normal, hit.Normal));
    Leave(path, Sub(path.Ray.Direction, Mul(hit.Normal, Add(share, share))));
}

#endif
