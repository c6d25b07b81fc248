#ifndef GLINT_SCREEN_SEA_LEVELS
#define GLINT_SCREEN_SEA_LEVELS

// The published level of a screen's sea, and the mean of its own: Runtime/Screen/ScreenSeaLevels.cs. A part of
// ScreenSea.hlsl.

// Directions of the published levels: a table in _SeaLevels each, from the sea's Z on with its rotation about Y.
static const uint SEA_DIRECTIONS = 8;

float4 _SeaMeanView;                       // of a mean: direction to the radar; number of the view
RWStructuredBuffer<float> _SeaMeans;       // sigma0 of facets, 0 in the shadow, view by view
static const uint SEA_MEAN_FACETS = 4096;  // of a view

// Factor of the power that brings it to a published level. sine: of the grazing angle on the mean sea.
float LevelOf(float turns, float sine)
{
    if (_SeaLevelCount == 0)
        return 1.0;
    turns += _ScreenSea.x;
    float place = SEA_DIRECTIONS * (turns - floor(turns));
    uint low = (uint)place % SEA_DIRECTIONS, high = (low + 1) % SEA_DIRECTIONS;
    float3 factors = lerp(LevelAt(sine, low * _SeaLevelCount), LevelAt(sine, high * _SeaLevelCount), place - floor(place));
    return _ScreenSeaCorner.z > 0.0 ? factors.z : factors.x;
}

// Facets of the tile for the mean under a plane wave, per area of the mean sea.
[numthreads(64, 1, 1)]
void ScreenSeaMean(uint3 id : SV_DispatchThreadID)
{
    if (id.x >= SEA_MEAN_FACETS)
        return;
    // Evenly spread: Roberts' sequence in two dimensions.
    float2 position = _SeaCascades[0].x * (frac((id.x + 0.5) * float2(0.7548776662, 0.5698402910)) - 0.5);
    float3 origin = float3(position.x, SeaHeight(position) + SEA_CLEARANCE, position.y), toRadar = _SeaMeanView.xyz;
    float reach = 1.0 + max(0.0, SeaReach().y - origin.y) / toRadar.y;
    ScreenFacet facet = FacetAt(position);
    bool isLit = dot(facet.Normal, toRadar) > 0.0 && !MarchSea(origin, toRadar, reach).IsHit;
    _SeaMeans[(uint)_SeaMeanView.w * SEA_MEAN_FACETS + id.x] = isLit ? SigmaOf(facet, toRadar) / facet.Normal.y : 0.0;
}

#endif
