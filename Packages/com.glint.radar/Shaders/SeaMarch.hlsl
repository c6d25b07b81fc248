#ifndef GLINT_SEA_MARCH
#define GLINT_SEA_MARCH

#include "SeaField.hlsl"

// Rays over a sea's height field, bilinear in each cell of each cascade. The earth is curved: the mean level falls with
// the square of the horizontal distance from the radar.

StructuredBuffer<SeaPoint> _SeaPoints;
StructuredBuffer<float2> _SeaBounds;       // minimum and maximum height, cascade by cascade, level by level
float4 _SeaRadar;                          // position, m; w: 1 / (2 effective earth radius), 1/m
uint _SeaTopLevel;                         // the level on which each cascade is one cell

struct SeaCrossing
{
    bool IsHit;
    float Distance;        // along the ray, m
    uint Steps;            // cells and blocks that the march has visited
};

// A position in cells of a cascade, from the corner of a tile.
float2 SeaCellsOf(uint cascade, float2 position)
{
    return position * _SeaCascades[cascade].y + 0.5 * SEA_SIDE;
}

// The heights at the corners of a cell: x and z from 0 to 1 have the height x + y x + z z + w x z of the result.
float4 SeaPatch(uint cascade, float2 corner)
{
    uint2 low = (uint2)(int2)corner & (SEA_SIDE - 1), high = (low + 1) & (SEA_SIDE - 1);
    uint first = cascade * SEA_SIDE * SEA_SIDE, row = first + low.y * SEA_SIDE, next = first + high.y * SEA_SIDE;
    float a = _SeaPoints[row + low.x].Height, b = _SeaPoints[row + high.x].Height,
        c = _SeaPoints[next + low.x].Height, d = _SeaPoints[next + high.x].Height;
    return float4(a, b - a, c - a, d - c - b + a);
}

// Height of the sea above its mean level, m.
float SeaHeight(float2 position)
{
    float height = 0.0;
    for (uint cascade = 0; cascade < _SeaCascadeCount; cascade++)
    {
        float2 cells = SeaCellsOf(cascade, position), corner = floor(cells), within = cells - corner;
        float4 heights = SeaPatch(cascade, corner);
        height += heights.x + dot(heights.yz, within) + heights.w * within.x * within.y;
    }
    return height;
}

// Lowest and highest point of the sea.
float2 SeaReach()
{
    float2 reach = 0.0;
    for (uint cascade = 0; cascade < _SeaCascadeCount; cascade++)
        reach += _SeaBounds[SeaBoundsOf(cascade, SEA_LEVELS - 1)];
    return reach;
}

// Height of a ray above the mean level: x + y t + z t^2 at the distance t.
float3 SeaClearance(float3 origin, float3 direction)
{
    float2 from = origin.xz - _SeaRadar.xz;
    return float3(origin.y + _SeaRadar.w * dot(from, from),
        direction.y + 2.0 * _SeaRadar.w * dot(from, direction.xz), _SeaRadar.w * dot(direction.xz, direction.xz));
}

float SeaLowest(float3 clearance, float from, float to)
{
    float at = clamp(-0.5 * clearance.y / max(clearance.z, 1.0e-30), from, to);
    return clearance.x + at * (clearance.y + at * clearance.z);
}

// Level of a cascade's bounds on a level of the march, whose cells are about equal in all cascades.
uint SeaLevelOf(uint cascade, uint level)
{
    uint above = (uint)_SeaCascades[cascade].z;
    return min(max(level, above) - above, SEA_LEVELS - 1);
}

// The ray's way out of a cell, m.
float SeaExit(float2 within, float side, float2 rate)
{
    float2 exits = rate == 0.0 ? 1.0e30 : ((rate > 0.0 ? side : 0.0) - within) / rate;
    return min(exits.x, exits.y);
}

// The distance from "start", at a position, to where the ray meets the sea if the cells around the position went on;
// -1: none. The ray's height above the sea is a quadratic function of the distance.
float SeaMeeting(float3 clearance, float start, float2 position, float2 direction)
{
    float a = clearance.z, b = clearance.y + 2.0 * clearance.z * start,
        c = clearance.x + start * (clearance.y + start * clearance.z);
    for (uint cascade = 0; cascade < _SeaCascadeCount; cascade++)
    {
        float2 cells = SeaCellsOf(cascade, position), corner = floor(cells), within = cells - corner,
            rate = direction * _SeaCascades[cascade].y;
        float4 heights = SeaPatch(cascade, corner);
        c -= heights.x + dot(heights.yz, within) + heights.w * within.x * within.y;
        b -= dot(heights.yz, rate) + heights.w * (within.x * rate.y + within.y * rate.x);
        a -= heights.w * rate.x * rate.y;
    }
    if (c <= 0.0)
        return 0.0;
    float discriminant = b * b - 4.0 * a * c, divisor = sqrt(max(discriminant, 0.0)) - b;
    return discriminant < 0.0 || divisor <= 0.0 ? -1.0 : 2.0 * c / divisor;
}

// The first point of a ray on or below the sea. A unit direction has distances in metres. Blocks of cells whose highest
// point is below the ray are passed in one step.
SeaCrossing MarchSea(float3 origin, float3 direction, float reach)
{
    SeaCrossing crossing = (SeaCrossing)0;
    float3 clearance = SeaClearance(origin, direction);
    uint level = _SeaTopLevel;
    float from = 0.0;
    [loop]
    while (from < reach)
    {
        crossing.Steps++;
        // Past the rounding of a border, so that each step enters another cell.
        float start = from + 2.4e-7 * from + 1.0e-5;
        float2 position = origin.xz + start * direction.xz;
        float to = reach, highest = 0.0;
        for (uint cascade = 0; cascade < _SeaCascadeCount; cascade++)
        {
            uint own = SeaLevelOf(cascade, level), side = 1u << own;
            float2 cells = SeaCellsOf(cascade, position), corner = side * floor(cells / side);
            uint2 cell = ((uint2)(int2)corner & (SEA_SIDE - 1)) >> own;
            highest += _SeaBounds[SeaBoundsOf(cascade, own) + cell.y * (SEA_SIDE >> own) + cell.x].y;
            // The last level is the whole sea, as tiles repeat.
            if (own < SEA_LEVELS - 1)
                to = min(to, start + SeaExit(cells - corner, side, direction.xz * _SeaCascades[cascade].y));
        }
        to = min(reach, max(to, start));
        bool isAbove = SeaLowest(clearance, from, to) > highest;
        if (!isAbove && level > 0)
        {
            level--;
            continue;
        }
        if (!isAbove)
        {
            float meeting = SeaMeeting(clearance, start, position, direction.xz);
            if (meeting >= 0.0 && meeting <= to - start)
            {
                crossing.IsHit = true;
                crossing.Distance = start + meeting;
                return crossing;
            }
        }
        from = to;
        level = min(level + 1, _SeaTopLevel);
    }
    return crossing;
}

// Whether the radar sees a point that is so far above the sea, m.
bool SeesSeaRadar(float2 position, float above)
{
    float2 from = position - _SeaRadar.xz;
    float3 origin = float3(position.x, SeaHeight(position) - _SeaRadar.w * dot(from, from) + above, position.y),
        way = _SeaRadar.xyz - origin;
    float reach = length(way);
    return !MarchSea(origin, way / reach, reach).IsHit;
}

#endif
