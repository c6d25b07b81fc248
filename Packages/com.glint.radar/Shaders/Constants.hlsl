#ifndef GLINT_CONSTANTS
#define GLINT_CONSTANTS

// All numbers shared by kernels and C#. LayoutTests compares this whole file with its partners in C#.

// Sums over rays (Core/Radar/Channel.cs): first word of each channel in a slot.
static const uint SUM_SLOTS = 64;
static const uint SUM_WORDS = 64;
static const uint SUM_HITS = 0;
static const uint SUM_BOUNCES = 1;
static const uint SUM_RECEIVED = 2;
static const uint SUM_CANDIDATES = 3;
static const uint SUM_LENGTH = 4;
static const uint SUM_IN_PHASE = 6;
static const uint SUM_QUADRATURE = 8;
static const uint SUM_NODES = 10;
static const uint SUM_PAIRS = 12;
static const uint SUM_OVERFLOW = 14;
static const uint SUM_HISTOGRAM = 15;
static const uint PHASE_BINS = 36;

// Units of a channel per unit of its quantity, maximum part of one ray, and its bit of SUM_OVERFLOW.
static const float LENGTH_UNITS = 1073741824.0;
static const float PHASOR_UNITS = 16777216.0;
static const float MAX_PHASOR_PART = 1.00000095367431640625;
static const uint LENGTH_OVERFLOW = 16;
static const uint IN_PHASE_OVERFLOW = 32;
static const uint QUADRATURE_OVERFLOW = 64;

// Work that may be skipped without changing a result (Culling).
static const uint CULL_REACH = 1;           // traversal ends at the receiver
static const uint CULL_LAST = 2;            // no traversal of a last segment that misses the receiver
static const uint CULL_ENTRY_POINTS = 8;    // first segments start at the entry points of their tile
static const uint CULL_HORIZONS = 16;       // no traversal of a BVH by rays that leave it above the horizon

// Rays written to _Rays (RayReadback).
static const uint READBACK_RECEIVED = 0;    // in the order of _Candidates, including those not received
static const uint READBACK_ALL = 1;         // in the order of tiles, 64 per tile
static const uint READBACK_NONE = 2;

// Rays.
static const uint NO_PIXEL = 0xffffffff;    // outside the picture, or not received
static const uint RAY_RECEIVED = 0x80000000; // in RayData.Bounces
static const uint TILE_SIDE = 8;
static const uint RAYS_A_TILE = 64;
static const uint GROUPS_A_ROW = 64;        // thread groups along x: a dispatch has at most 65,535 along an axis

// BVHs.
static const uint MAX_INLINE_INSTANCES = 4;  // maximum number of instances without an instance BVH
static const uint ROOT = 1;                  // row of the root of a binary BVH
static const uint BINARY_LEVELS = 28;        // the stack holds one node per level
static const uint MAX_ENTRY_POINTS = 4;      // maximum number of entry points of a tile in one BVH

#endif
