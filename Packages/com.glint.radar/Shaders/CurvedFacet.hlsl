#ifndef GLINT_CURVED_FACET
#define GLINT_CURVED_FACET

#include "TubeBindings.hlsl"
#include "ClosestHit.hlsl"

// The curved surface that a facet of a smooth patch stands for: mean normals at the corners, linear between them, and a
// height over the facet that is 0 at its corners. Along a side from i to j the surface leaves the facet by half of
// (n_j - n_i).(j - i), and returns as steeply: what lies over a side is the same for both facets.

// In the mesh's frame. Heights are in the scene's metres, times the size of the mean normal there.
struct CurvedFacet
{
    float3 Centre;
    float3 WeightB, WeightC;  // gradients of the weights of the second and third corner; that of the first is the rest
    float3 Rises;             // of the sides from the first to the second corner, first to third, second to third
    float4 X, Y, Z;           // rows of _NormalFields
};

float3 ChangeOfNormal(CurvedFacet facet, float3 step)
{
    return float3(dot(facet.X.xyz, step), dot(facet.Y.xyz, step), dot(facet.Z.xyz, step));
}

CurvedFacet LoadCurvedFacet(InstanceRecord record, Hit hit, uint row)
{
    CurvedFacet facet;
    facet.X = _NormalFields[row];
    facet.Y = _NormalFields[row + 1];
    facet.Z = _NormalFields[row + 2];
    Pair pair = LoadPair(record.Page, record.FirstRow + hit.Row);
    float3 toB = pair.Corner2 - pair.Corner0, toC = (hit.Second ? pair.Corner3 : pair.Corner1) - pair.Corner0;
    float3 area = cross(toB, toC);
    float square = dot(area, area);
    facet.Centre = pair.Corner0 + (toB + toC) / 3.0;
    facet.WeightB = cross(toC, area) / square;
    facet.WeightC = cross(area, toB) / square;
    float3 toCFromB = toC - toB;
    facet.Rises = 0.5 * float3(dot(toB, ChangeOfNormal(facet, toB)), dot(toC, ChangeOfNormal(facet, toC)),
        dot(toCFromB, ChangeOfNormal(facet, toCFromB)));
    return facet;
}

// The mean normal over a position on the facet's plane, from its centre; not of unit length.
float3 MeanNormal(CurvedFacet facet, InstanceRecord record, float3 fromCentre)
{
    return NormalFromLocal(record, float3(facet.X.w, facet.Y.w, facet.Z.w) + ChangeOfNormal(facet, fromCentre));
}

// Weights of the corners from those of the second and third.
float3 Weights(float2 ofBC)
{
    return float3(1.0 - ofBC.x - ofBC.y, ofBC);
}

// Height, from the weights of the corners.
float HeightOf(CurvedFacet facet, float3 weights)
{
    return weights.x * (weights.y * facet.Rises.x + weights.z * facet.Rises.y) + weights.y * weights.z * facet.Rises.z;
}

// Derivatives of the height by the weights of the second and third corner.
float2 SlopesOf(CurvedFacet facet, float3 weights)
{
    return float2(facet.Rises.x * (weights.x - weights.y) + weights.z * (facet.Rises.z - facet.Rises.y),
        facet.Rises.y * (weights.x - weights.z) + weights.y * (facet.Rises.z - facet.Rises.x));
}

// Distance by which a ray meets a surface before the facet, m. height: of the surface where the ray meets the facet;
// closing: by which they approach each other a metre back along the ray; bend: by which that grows a metre; reach: the
// largest distance, m.
float LeadOf(float height, float closing, float bend, float reach)
{
    float square = closing * closing + 2.0 * bend * height, lead = 0.0;
    if (closing > 0.0)
        lead = 2.0 * height / (closing + sqrt(max(square, 0.25 * closing * closing)));
    // A ray that meets the part of a facet where the surface looks away has met it before.
    else if (bend > 0.0 && square > 0.0)
        lead = (sqrt(square) - closing) / bend;
    return clamp(lead, -reach, reach);
}

// Where a ray meets the curved surface.
struct CurvedHit
{
    float Lead;               // distance before the facet, m
    float3 Normal;            // mean normal on the side of the facet's
    float Size;               // by which it was divided
    float3 Tangent;           // normal of the plane in which rays beside it meet the surface
};

// The size of a mean normal, below 0 if it is on the far side of the facet. Normals of a sharp ridge may cancel each other.
float SizeOf(float3 mean, float3 facetNormal)
{
    return max(length(mean), 1.0e-6) * (dot(mean, facetNormal) < 0.0 ? -1.0 : 1.0);
}

// position: where the ray meets the facet.
CurvedHit MeetCurved(CurvedFacet facet, InstanceRecord record, float3 position, float3 d, float3 facetNormal)
{
    float3 from = PointToLocal(record, position) - facet.Centre;
    float size = SizeOf(MeanNormal(facet, record, from), facetNormal), cosine = dot(d, facetNormal);
    float3 ahead = VectorToLocal(record, d - cosine * facetNormal);
    float2 weights = 1.0 / 3.0 + float2(dot(from, facet.WeightB), dot(from, facet.WeightC)),
        steps = float2(dot(ahead, facet.WeightB), dot(ahead, facet.WeightC));
    float3 allSteps = float3(-steps.x - steps.y, steps);
    CurvedHit hit;
    // The surface is known over the facet only.
    hit.Lead = LeadOf(HeightOf(facet, Weights(weights)) / size,
        dot(SlopesOf(facet, Weights(weights)), steps) / size - cosine, -2.0 * HeightOf(facet, allSteps) / size,
        1.0 / max(MaxComponent(abs(allSteps)), 1.0e-20));
    float2 slopes = SlopesOf(facet, Weights(weights - hit.Lead * steps)) / size;
    float3 slope = NormalFromLocal(record, slopes.x * facet.WeightB + slopes.y * facet.WeightC);
    hit.Tangent = normalize(facetNormal - slope + facetNormal * dot(slope, facetNormal));
    if (dot(hit.Tangent, d) > 0.5 * cosine)
        hit.Tangent = facetNormal;
    hit.Normal = MeanNormal(facet, record, from - hit.Lead * ahead);
    hit.Size = SizeOf(hit.Normal, facetNormal);
    hit.Normal /= hit.Size;
    return hit;
}

// The derivative of the mean normal over a step on the surface.
float3 ChangeAlong(CurvedFacet facet, InstanceRecord record, CurvedHit hit, float3 step, float3 facetNormal)
{
    float3 onFacet = VectorToLocal(record, step - facetNormal * dot(step, facetNormal));
    float3 change = NormalFromLocal(record, ChangeOfNormal(facet, onFacet)) / hit.Size;
    return change - hit.Normal * dot(hit.Normal, change);
}

#endif
