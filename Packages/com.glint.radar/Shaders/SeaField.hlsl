#ifndef GLINT_SEA_FIELD
#define GLINT_SEA_FIELD

// A sea as a height field: the sum of one or two cascades, tiles of different size that repeat. Its frame has x and z
// in metres from the centre of a tile of each cascade, and y upwards from the mean level.

static const uint SEA_SIDE = 256;          // points along a side of a tile
static const uint SEA_LEVELS = 9;          // of bounds: 256 to 1 cells along a side
static const uint SEA_BOUNDS = 87381;      // cells of all levels
static const uint SEA_CASCADES = 2;        // maximum number

// GLINT_SEA_POINT: the sea at a corner of a tile's cells (Runtime/Sea/SeaPoint.cs). Upwards is positive.
struct SeaPoint
{
    float Height;          // m
    float Acceleration;    // of the height, m/s2
};

float4 _SeaCascades[SEA_CASCADES];         // side of the tile, m; cells per metre; levels above the finest cascade's
uint _SeaCascadeCount;

// First element of a level of a cascade's bounds: 4^8 + 4^7 + ... before it.
uint SeaBoundsOf(uint cascade, uint level)
{
    return cascade * SEA_BOUNDS + (0x40000 - (0x40000u >> (2 * level))) / 3;
}

#endif
