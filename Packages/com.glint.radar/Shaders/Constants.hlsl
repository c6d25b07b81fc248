#ifndef GLINT_CONSTANTS
#define GLINT_CONSTANTS

// All numbers shared by kernels and C#. LayoutTests compares this whole file with its partners in C#.

// Sums over rays (Core/Radar/Channel.cs): first word of each channel in a slot. Behind the slots of the rays come those
// of the sub-rays, one for each number of a sub-ray in its pixel.
static const uint SUM_SLOTS = 64;
static const uint SUB_RAY_SLOTS = 16;
static const uint SUM_WORDS = 64;
static const uint SUM_HITS = 0;
static const uint SUM_BOUNCES = 1;
static const uint SUM_RECEIVED = 2;
static const uint SUM_LENGTH = 3;
static const uint SUM_IN_PHASE = 5;
static const uint SUM_QUADRATURE = 7;
static const uint SUM_NODES = 9;
static const uint SUM_PAIRS = 11;
static const uint SUM_OVERFLOW = 13;
static const uint SUM_HISTOGRAM = 14;
static const uint PHASE_BINS = 36;

// Units of a channel per unit of its quantity, maximum part of one ray, and its bit of SUM_OVERFLOW.
static const float LENGTH_UNITS = 1073741824.0;
static const float PHASOR_UNITS = 16777216.0;
static const float MAX_PHASOR_PART = 1.00000095367431640625;
static const uint LENGTH_OVERFLOW = 8;
static const uint IN_PHASE_OVERFLOW = 16;
static const uint QUADRATURE_OVERFLOW = 32;

// Counts of a slice, in the words of _Sums behind the slots (Core/Radar/WorkCounts.cs); behind them the received rays.
static const uint COUNT_KNOWN = 5120;       // candidates whose triangles are known
static const uint COUNT_SEARCHED = 5121;    // candidates to search again
static const uint COUNT_SUB_KNOWN = 5122;   // the same of sub-rays
static const uint COUNT_SUB_SEARCHED = 5123;
static const uint COUNT_RECEIVED = 5124;
static const uint COUNT_CHOSEN = 5125;      // pixels that get sub-rays
static const uint RECEIVED_RAYS = 5126;     // first word of the received rays, two words each: pixel, length

// Maximum work of a slice (DispatchPlan).
static const uint MAX_REFINED = 262144;     // candidates of a dispatch
static const uint CANDIDATE_PADDING = 64;   // those to search, which take longer, begin a group of as many threads
static const uint SPREAD_THREADS = 32768;   // of candidates to search if each has several
static const uint MAX_CHOSEN = 16000;       // pixels that get sub-rays without another round trip

// Indirect dispatches: byte offsets of their numbers of groups in _Arguments.
static const uint REFINE_ARGUMENTS = 0;
static const uint SUB_RAY_ARGUMENTS = 12;
static const uint REFINE_SUB_RAY_ARGUMENTS = 24;

// Work that may be skipped without changing a result (Culling).
static const uint CULL_REACH = 1;           // traversal ends at the receiver
static const uint CULL_LAST = 2;            // no traversal of a last segment that misses the receiver
static const uint CULL_ENTRY_POINTS = 8;    // first segments start at the entry points of their cell

// Rays written to _Rays (RayReadback).
static const uint READBACK_RECEIVED = 0;    // in the order of arrival
static const uint READBACK_ALL = 1;         // in the order of tiles, 64 per tile
static const uint READBACK_NONE = 2;

// Rays.
static const uint NO_PIXEL = 0xffffffff;    // outside the picture, or not received
static const uint NO_LENGTH = 0xffffffff;   // not received
static const uint RAY_RECEIVED = 0x80000000; // in RayData.Bounces
static const uint TILE_SIDE = 8;
static const uint RAYS_A_TILE = 64;
static const uint GROUPS_A_ROW = 64;        // thread groups along x: a dispatch has at most 65,535 along an axis
static const uint SUB_RAYS = 4;             // sub-rays along the side of a pixel
static const uint MAX_BOUNCES = 16;

// BVHs.
static const uint MAX_INLINE_INSTANCES = 4;  // maximum number of instances without an instance BVH
static const uint ROOT = 1;                  // row of the root of a binary BVH
static const uint BINARY_LEVELS = 28;        // the stack holds one node per level
static const uint MAX_ENTRY_POINTS = 4;      // maximum number of entry points of a cell in one BVH

#endif
