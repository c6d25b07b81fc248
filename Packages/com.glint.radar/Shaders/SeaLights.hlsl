#ifndef GLINT_SEA_LIGHTS_FILE
#define GLINT_SEA_LIGHTS_FILE

#include "Footprint.hlsl"
#include "PhysicalOptics.hlsl"

// Where what ships reflect lights the sea: one thread a ray through a uniform grid over all that is no sea and its image in
// the sea. Each ray that meets the sea after something else is a light, also if the sea has mirrored it before;
// Core/Clutter/ShipSeaEcho.cs sums what the sea scatters of it.

// GLINT_SEA_LIGHT: rows of a light (Runtime/Clutter/ShipSeaKernel.cs), bits of floats unless said.
static const uint LIGHT_PLACE = 0;         // relative to the scene's centre, m; 1 + instance: 0 is no light
static const uint LIGHT_DIRECTION = 1;     // of the ray; part of the triangle
static const uint LIGHT_V = 2;             // polarisations sent, mirrored with the ray; 1: the radar sees the place
static const uint LIGHT_H = 3;             // and section of the tube, m2
static const uint LIGHT_FIELD_V = 4;       // as in TubePath
static const uint LIGHT_FIELD_H = 5;
static const uint LIGHT_NORMAL = 6;        // of the facet; section of the tube where its field is 1, m2
static const uint LIGHT_RADAR = 7;         // towards the radar; Receiver.Phase
static const uint LIGHT_RADAR_V = 8;       // and Path.RelativeLength
static const uint LIGHT_RADAR_H = 9;       // and Receiver.Strength
static const uint LIGHT_ROWS = 10;

RWStructuredBuffer<uint4> _SeaLights;
uint _SeaLightCount;

void Store(uint light, uint row, float3 xyz, uint last)
{
    _SeaLights[LIGHT_ROWS * light + row] = uint4(asuint(xyz), last);
}

void StoreLight(uint light, TubePath tube, SurfacePoint at, float startSection)
{
    float3 place = tube.Path.Ray.Origin, d = tube.Path.Ray.Direction;
    Receiver radar = ReceiverFrom(0, place);
    Store(light, LIGHT_PLACE, place, 1 + at.Instance);
    Store(light, LIGHT_DIRECTION, d, at.Part);
    Store(light, LIGHT_V, tube.V, Radiates(tube, at, radar) ? 1 : 0);
    Store(light, LIGHT_H, tube.H, asuint(abs(Section(tube.PlaceU, tube.PlaceV, d))));
    Store(light, LIGHT_FIELD_V, tube.FieldV.xyz, asuint(tube.FieldV.w));
    Store(light, LIGHT_FIELD_H, tube.FieldH.xyz, asuint(tube.FieldH.w));
    Store(light, LIGHT_NORMAL, at.FacetNormal, asuint(startSection));
    Store(light, LIGHT_RADAR, radar.Direction, asuint(radar.Phase));
    Store(light, LIGHT_RADAR_V, radar.V, asuint(tube.Path.RelativeLength));
    Store(light, LIGHT_RADAR_H, radar.H, asuint(radar.Strength));
}

[numthreads(GLINT_GROUP, 1, 1)]
void SeaLights(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= _SeaLightCount)
        return;
    _SeaLights[LIGHT_ROWS * index] = 0;
    uint across = _Poses[0].Cells.x;
    TubePath tube = BeginTube(float2(index % across, index / across) + 0.5);
    float startSection = abs(tube.StartSection);
    SurfacePoint at;
    [loop]
    while (AdvanceTube(tube, at))
    {
        if (at.IsLost || tube.Path.Bounces == 1 && !IsInFootprint(tube.Path.Ray.Origin))
            return;
        if (at.IsSea && tube.HasMetTarget)
        {
            StoreLight(index, tube, at, startSection);
            return;
        }
        if (!ScatterTube(tube, at))
            return;
    }
}

#endif
