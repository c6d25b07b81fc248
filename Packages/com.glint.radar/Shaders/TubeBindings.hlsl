#ifndef GLINT_TUBE_BINDINGS
#define GLINT_TUBE_BINDINGS

#include "WorkLists.hlsl"

// Words of _Sums: the counts, then the sums of each copy, pose, slot and frequency.
static const uint TUBE_COUNT = 0;          // tubes; may exceed _ListCapacity
static const uint TUBE_OVERFLOW = 1;       // 1: a list was full
static const uint TUBE_OUTLINES = 2;       // rays beside outlines in this round
// Lists that are filled from both ends: a count of the cells of one bounce at most, then of the deep ones.
static const uint TUBE_CELLS = 3;          // cells of this round
static const uint TUBE_NEXT_CELLS = 5;     // cells of the next round
static const uint TUBE_CENTRES = 7;        // cells of this round whose centre is traced
static const uint TUBE_BORDERS = 9;        // border cells of this round that the border cuts in two,
static const uint TUBE_WHOLES = 11;        // and the others
static const uint TUBE_POINTS = 13;        // points of an amplitude's cells; may exceed _PointCapacity
static const uint MAX_POSES = 128;         // of a dispatch
static const uint POSE_COUNTS = 24;        // counts of each pose:
static const uint POSE_COUNT_WORDS = 4;
static const uint POSE_TUBES = 0;          // tubes,
static const uint POSE_RAYS = 1;           // rays traced in cells and at edges,
static const uint POSE_BORDER_RAYS = 2;    // rays traced at borders,
static const uint POSE_BOUNCES = 3;        // most bounces of a tube
static const uint POSE_PARTS = 16;         // of a slice, by the order of its base cells: each has counts of its own
static const uint TUBE_SUMS = 8216;
static const uint TUBE_SUM_WORDS = 32;     // of a receiver and frequency: see SUM_S
static const uint SUM_S = 0;               // S of VV, HV, VH and HH: real and imaginary part, 64 bits each
static const uint SUM_BENT = 16;           // S of the error of bent phases of VV and HH, 64 bits each part
static const uint SUM_ERROR = 20;          // sum of squared errors of VV and HH, 64 bits
static const uint SUM_CROSS_BENT = 22;     // the same of HV and VH
static const uint SUM_CROSS_ERROR = 26;
static const uint SUM_TUBE_OVERFLOW = 28;  // 1: a contribution was too large for a sum
// Counts of an amplitude, behind the sums, in copies over which threads spread: each of each pose has
static const uint AMPLITUDE_COPIES = 32;
static const uint AMPLITUDE_WORDS = 8;
static const uint AMPLITUDE_RAYS = 0;      // rays,
static const uint AMPLITUDE_HITS = 1;      // those that hit,
static const uint AMPLITUDE_BOUNCES = 2;   // their bounces,
static const uint AMPLITUDE_RECEIVED = 3;  // those received,
static const uint AMPLITUDE_REVEALED = 4;  // parts of cells in which more was found than in attempts before,
static const uint AMPLITUDE_LENGTHS = 6;   // and lengths to the last hit less OriginDepth, in units, 64 bits
static const float AMPLITUDE_LENGTH_UNITS = 256.0;   // a metre
static const uint PART_WORDS = 16;         // of a part: see TubeParts; its words are those of SUM_S

static const uint MAX_RECEIVERS = 16;
static const uint EDGE_CORNERS = 0xff;      // corners in Tube.Tag: a piece of an edge, Gradient.x a metre along it
static const uint REFLECTION_STEPS = 1024; // of a table over the cosine of the incidence angle
static const uint FLAT = 0xffffffff;       // a facet without a field of normals
static const uint BLOCK_CELLS = 4;         // into which a cell is divided
static const uint BLOCK_CORNERS = 9;
static const uint NEW_CORNERS = 5;         // of them: the middles of the sides of the cell, and its centre
static const uint BORDER_RAYS = 4;         // of a border cell of an amplitude, before it is cut or divided
static const uint TUBES_A_GROUP = 256;      // of the kernel that sums
static const uint BAND_FREQUENCIES = 64;   // of a block of frequencies that are summed together, at most
static const uint BAND_ROWS = 3;           // of a block in _Bands

static const uint REVEALED_WORDS = 65536;  // of the bits of a pose (RevealedCells.hlsl)
uint _RevealedWords;                       // the same; an amplitude has others (AmplitudePath.hlsl)

// Byte offsets of the indirect dispatches in _Arguments.
static const uint BORDER_ARGUMENTS = 0;
static const uint CELL_ARGUMENTS = 12;
static const uint TUBE_ARGUMENTS = 24;
static const uint BISECT_ARGUMENTS = 36;
static const uint CORNER_ARGUMENTS = 48;
static const uint CENTRE_ARGUMENTS = 60;
static const uint OUTLINE_ARGUMENTS = 72;
static const uint WHOLE_ARGUMENTS = 84;
static const uint CHANGE_ARGUMENTS = 96;
static const uint BORDER_RAY_ARGUMENTS = 108;

// GLINT_TUBE: the currents of a piece of a ray tube at one hit, towards one receiver (Runtime/CrossSection/Tube.cs).
// The piece is a polygon in the plane of the grid, whose unit is a base cell.
struct Tube
{
    float2 Gradient;      // of the phase along the grid, m a base cell
    float Phase;          // distance to the receiver less path length at the place of the ray, m
    uint Tag;             // slot of all poses (SlotOf) | bounce << 8 | corners << 16 (none: a square about the ray) |
                          // CHANGES: its currents change along it, by _TubeExtras
    float4 CoPolar;       // p.C times area a base cell, m2: VV, HH
    float4 CrossPolar;    // HV, VH
    float4 Corners01;     // of the polygon, from the place of the ray; of a square its side and bends, m; of an edge its
                          // length and bend, m
    float4 Corners23;     // of a square its strength, as a fraction of p.C: mean, change by u and v, twist
    float2 Corner4;
    float Error;          // area by which the piece may be off, base cells; of an edge its length, m
    float Bent;           // relative error by the bent phase, at the highest frequency
    float3 Bends;         // of a polygon: second derivatives of the phase by u, by v and by both, m a base cell squared
    uint Slope;           // of a polygon: of its strength by u and v, as a fraction of p.C a base cell, two float16
};

static const uint CHANGES = 0x1000000;

// EDGE_CORNERS: an edge.
uint CornersOf(Tube tube)
{
    return tube.Tag >> 16 & 0xff;
}

uint BounceOf(Tube tube)
{
    return tube.Tag >> 8 & 0xff;
}

bool HasChanges(Tube tube)
{
    return (tube.Tag & CHANGES) != 0;
}

// Larger magnitude of two complex numbers.
float LargerOf(float4 pair)
{
    return sqrt(max(dot(pair.xy, pair.xy), dot(pair.zw, pair.zw)));
}

// Largest magnitudes of p.C times area a base cell, m2: of VV and HH, of HV and VH.
float2 MagnitudesOf(Tube tube)
{
    return float2(LargerOf(tube.CoPolar), LargerOf(tube.CrossPolar));
}

static const uint DEEP_CELL = 1;           // bits of Cell.Traits
static const uint BENT_CELL = 2;
static const uint KINKED_CELL = 4;
static const uint EDGE_CELL = 8;

// A cross-polarised part, 0 to 1, as a whole number of eight bits, rounded up.
uint UnitsOfPart(float part)
{
    return (uint)ceil(255.0 * part);
}

float PartOfUnits(uint units)
{
    return (units & 0xff) / 255.0;
}

// A cell of the grid.
struct Cell
{
    uint2 Position;       // in cells of its level
    uint Level;           // its side is 2^-Level base cells
    uint FirstBounce;     // bounces before it are summed already
    uint4 Signatures;     // of the rays through its corners, in order around it
    float Strength;       // of what is left to sum: largest weighted p.C, m2 a base cell
    float Thinned;        // the same times ThinningIn
    uint2 Crossings;      // of the border with two sides: see BorderOf
    uint Pose;            // of this dispatch
    uint Number;          // in its round
    uint Whole;           // number in the round before of the cell that it is a part of
    uint Traits;          // DEEP_CELL: a ray through a corner of it, or of the cell that it is a part of, bounces more than
                          // once; BENT_CELL: bent phases make the error of a piece too large; KINKED_CELL: the rays through its
                          // corners met the same patches, but several facets: its signatures tell facets apart; EDGE_CELL:
                          // the phase is slow along an outline through it, or through the cell that it is a part of; the
                          // upper eight: ThinPartOf
};

static const uint THIN_PART_SHIFT = 24;

// The cross-polarised part of Thinned where its corners see nothing.
float ThinPartOf(Cell cell)
{
    return PartOfUnits(cell.Traits >> THIN_PART_SHIFT);
}

bool IsDeep(Cell cell)
{
    return (cell.Traits & DEEP_CELL) != 0;
}

bool IsAlongEdge(Cell cell)
{
    return (cell.Traits & EDGE_CELL) != 0;
}

// Input: what the tracer does not need.
StructuredBuffer<uint2> _Facets;           // per triangle: patch, first row in _NormalFields or FLAT
StructuredBuffer<float4> _NormalFields;    // three rows a facet: gradient of a component of the normal; its value at
                                           // the centroid
StructuredBuffer<uint4> _InstanceFacets;   // per instance: first element of _Facets, first patch, first
                                           // part; 1: a sea with a diffuse echo
StructuredBuffer<float4> _Motions;         // per instance two rows: velocity at the scene's centre, m/s; angular
                                           // velocity, rad/s
uint _IsMoving;                            // 1: an instance moves
StructuredBuffer<float4> _Reflections;     // per surface REFLECTION_STEPS + 1 elements: R_s, R_p over the cosine

// Input: the radar and the receivers. At a finite range places are relative to the scene's centre.
// GLINT_TUBE_POSE: what differs between the poses of a dispatch (Runtime/CrossSection/TubePose.cs). The rays of a grid are
// linear functions of the position on it.
struct TubePose
{
    float4 Origin, OriginDx, OriginDy;           // relative to the scene's centre, m
    float4 Direction, DirectionDx, DirectionDy;
    float3 SentV;
    float CrossWeight;                           // of HV and VH: factor of their strength against CellError, at least 1
    float4 SentH;
    float4 GridX, GridY, GridDepth;              // base cell of a place: (X.place) / (Depth.place), w constant
    uint4 Slice;                                 // base cells: first and number of this dispatch, a rectangle; its
                                                 // cells across; first of its cells in the dispatch
    uint2 Cells;                                 // base cells of the grid, across and up
    uint2 Blocks;                                // of the cover, across and up
    float2 Reference;                            // position at which the rays' functions have their constants
    uint FirstCorner;                            // of its corners in the dispatch
    float OriginDepth;                           // distance from the radar to the grid, m
    float RadarPhase;                            // that the phases of the grid's paths have beside ReceiverFrom, m
    float CellError;                             // of weighted p.C times area that a cell may have, m2
    uint MaxLevel;                               // cells at it are not divided
    uint MaxBisections;                          // of the sides of a base cell towards a border
};

StructuredBuffer<TubePose> _Poses;
uint _PoseCount;
uint2 _BaseCounts;                         // base cells of this dispatch, and their corners
static uint s_pose = 0;                    // of this thread

// The receivers of each pose, then its radar. Three rows each; far: unit vector to it; near: its place, w: its distance
// from 0; then its V and H.
static const uint RECEIVER_ROWS = 3;
StructuredBuffer<float4> _Receivers;
uint _ReceiverCount;
uint _SlotCount;                           // of the sums of a pose: receivers, and again if there is a sea with a diffuse
                                           // echo
uint _IsMonostatic;                        // 1: the only receiver is at the radar
uint _IsNear;                              // 1: finite range
float _Range;                              // at which the field is 1 at a finite range, m
float _WaveNumber;                         // of the highest frequency, rad/m
uint _FadesShadows;
uint _OnlyBounce;                          // 0: all

// Input: the work.
uint4 _ListCapacity;                       // tubes, cells, borders of a kind, centres
uint2 _BisectSteps;                        // bisections of earlier dispatches, and with those of this one
uint _Round;                               // 0: the base cells
uint _FrequencyCount;
float _UnitsPerSquareMetre;                // of sums of squared errors
StructuredBuffer<float4> _WaveNumbers;     // per frequency: k rad/m; k / 2 pi: float32 and its Lo part; time, s

static const uint MAX_LISTED = 4096;       // elements of a list of a base cell that are read: of corners, of sides

// Places where borders may turn, which rays through corners of cells can miss: corners of patches, relative to the scene's
// centre, m. Each base cell has a list of those within half a cell of it.
static const uint VERTEX_LINKS = 4;        // lists that a corner is in
uint _VertexCount;
uint _MarkWords;                           // of a pose
StructuredBuffer<float4> _Vertices;
StructuredBuffer<uint> _Marks;             // per pose and base cell 1 + first element of _Links, or 0: of corners, then
                                           // of outlines; then the words of the cover
StructuredBuffer<uint4> _Links;            // place of a corner, base cells, or number of a side; 1 + next element, or 0; kind
                                           // of a line

// Sides of triangles on the outlines of patches: ends and third corner of the triangle, relative to the scene's centre, m.
// Each base cell has a list of those that run through it, behind the links of the corners.
static const uint SIDE_ROWS = 3;
static const uint MAX_SIDES = 8;           // beside which rays look: long loops end on a software device
uint _SideCount;
uint _LinkCapacity;                        // of a pose
StructuredBuffer<float4> _Sides;

// Lines on the grid, in the same lists of base cells, with two elements of _Links each at the end of those of a pose: start,
// next and kind; end. To the left of a line lies the shadow, or the patch.
static const uint SHADOW_LINE = 1;         // border of a shadow: a receiver apart from the radar begins to see a surface
static const uint IMAGE_LINE = 2;          // outline of a patch, seen in a flat patch as in a mirror
static const uint LINE_LINKS = 2;
static const uint SILHOUETTE_ROWS = 4;     // of a piece of an edge that may cast one
static const uint MAX_SHADOWS = 16;         // beside which rays look
static const uint OUTLINE_ROWS = 3;        // of a piece of an outline that flat patches may mirror
static const uint MIRROR_ROWS = 3;         // of such a patch
static const uint MAX_IMAGES = 8;          // beside which rays look
uint _LineCapacity;                        // of a pose: elements of _Links

// Cover: a bit for each block of base cells in which triangles may be seen, then a word that is not 0 if all may be. The
// last words of all count the elements of lines, and the links of outlines.
static const uint COVER_SIDE = 8;           // of a block, in base cells
static const uint MAX_COVERED = 4096;       // blocks that one thread marks
uint _TriangleCount;                       // of all instances
uint _PlacedCount;                         // instances
StructuredBuffer<float4> _Spheres;         // about the triangles, as in _Facets, in the mesh's frame; w: radius
static const uint PLACE_ROWS = 4;
StructuredBuffer<float4> _Places;          // per instance: rows of the matrix from the mesh's frame to the scene's centre; then
                                           // x: stretch of lengths, y: rounding, m

uint BaseCellCount()
{
    return _Poses[s_pose].Cells.x * _Poses[s_pose].Cells.y;
}

// Words of the marks of this thread's pose.
uint VertexWord(uint2 cell)
{
    return s_pose * _MarkWords + cell.x + cell.y * _Poses[s_pose].Cells.x;
}

uint OutlineWord(uint2 cell)
{
    return VertexWord(cell) + BaseCellCount();
}

uint CoverWord(uint bit)
{
    return s_pose * _MarkWords + 2 * BaseCellCount() + (bit >> 5);
}

uint SideCountWord()
{
    return (s_pose + 1) * _MarkWords - 1;
}

uint LineCountWord()
{
    return (s_pose + 1) * _MarkWords - 2;
}

uint AllCoveredWord()
{
    return (s_pose + 1) * _MarkWords - 3;
}

// Links that outlines may have.
uint SideLinks()
{
    return _LinkCapacity - _LineCapacity - VERTEX_LINKS * _VertexCount;
}

// Whether the links of the outlines suffice.
bool HasAllSides()
{
    return _Marks[SideCountWord()] <= SideLinks();
}

// Whether those of shadows do.
bool HasAllLines()
{
    return _Marks[LineCountWord()] <= _LineCapacity;
}

// The place on the grid of a position relative to the scene's centre, base cells.
float2 PlaceOnGrid(float3 position)
{
    float4 x = _Poses[s_pose].GridX, y = _Poses[s_pose].GridY, depth = _Poses[s_pose].GridDepth;
    return float2(dot(position, x.xyz) + x.w, dot(position, y.xyz) + y.w)
        / (dot(position, depth.xyz) + depth.w);
}

// Takes a thread for each of a number of things of each pose: makes a number of all poses that of the thing, and its pose
// that of the thread. False if there is none.
bool TakeOfPose(inout uint number, uint count)
{
    if (number >= _PoseCount * count)
        return false;
    s_pose = number / count;
    number %= count;
    return true;
}

// Of a slot of this thread's pose, among those of all poses.
uint SlotOfAll(uint slot)
{
    return s_pose * _SlotCount + slot;
}

static uint s_part = 0;                    // of the slice, in which this thread counts

// Counts what this thread does beside a base cell of its pose's slice, or beside a corner of one.
void CountAt(uint2 position)
{
    uint4 slice = _Poses[s_pose].Slice;
    uint across = _Poses[s_pose].Cells.x;
    uint2 inSlice = position - uint2(slice.x % across, slice.x / across);
    s_part = min((inSlice.x + inSlice.y * slice.z) * POSE_PARTS / slice.y, POSE_PARTS - 1);
}

// Word of a count of this thread's pose.
uint CountWord(uint count)
{
    return POSE_COUNTS + POSE_COUNT_WORDS * (s_part * MAX_POSES + s_pose) + count;
}

RWStructuredBuffer<Tube> _Tubes;

// Parts, whose contributions are summed apart: the triangles of all instances, the edges of each object, the bounces.
RWStructuredBuffer<uint> _TubeParts;       // of each tube: the triangle, or the edges of an object
uint _HasParts;                            // 0: they are not asked for

// Rows of each tube. Its rate, if something moves: see RateOf. If it has CHANGES, those of CoPolar along u and along v, then of
// CrossPolar: over half of a square or edge, or over a base cell.
RWStructuredBuffer<float4> _TubeExtras;
static const uint TUBE_EXTRAS = 5;         // at a finite range
uint _ExtraRows;                           // TUBE_EXTRAS, or 1 where no tube has CHANGES

// GLINT_CORNER: what the ray through a corner of a cell has met at a bounce (Runtime/CrossSection/Tube.cs).
struct Corner
{
    uint Signature;       // of the path up to it
    uint Traits;          // in the first element of a corner: bounces of its ray; eight bits: CrossPartAt; sixteen: FacetsOf
    float Strength;
    uint Changes;         // as float16: SteepnessAt, and BentOf in the upper half
    float4 Position;      // relative to the scene's centre, m; w: RelativeLength of the path
    float4 AlongU;        // its differentials, m a base cell
    float4 AlongV;
};

uint BouncesOf(Corner corner)
{
    return corner.Traits & 0xff;
}

float CrossPartOf(Corner corner)
{
    return PartOfUnits(corner.Traits >> 8);
}

uint FacetsOf(Corner corner)
{
    return corner.Traits >> 16;
}

RWStructuredBuffer<Corner> _Corners;       // _MaxBounces elements a corner
StructuredBuffer<Corner> _CornersBefore;   // those of the round before
StructuredBuffer<Cell> _TubeCells;         // of this round
RWStructuredBuffer<Cell> _NextCells;       // of the next one
RWStructuredBuffer<Cell> _Borders;         // border cells: in the first half those that are cut
// Of each cell whose centre is traced: its number; strength of its thin parts; strength beside outlines along which the phase
// is slow, or 0; strength of thin parts that only images of outlines tell of, which the first bounce does not meet;
// UnitsOfPart of all thin parts.
static const uint CENTRE_WORDS = 5;
RWStructuredBuffer<uint> _Centres;
// Of each ray beside an outline: number in _Centres, number of the side; of one beside another line its link and these bits.
static const uint SHADOW_RAY = 0x80000000;
static const uint LIT_RAY = 0x40000000;    // outside the shadow
static const uint IMAGE_RAY = 0x20000000;  // beside an image of an outline
RWStructuredBuffer<uint2> _Outlines;

// Adds a cell to a list that is filled from both ends, so that neighbouring threads follow rays of as many bounces. Returns its
// element, or no smaller a number than the list has. count: word of the list's counts.
uint AddToList(uint count, bool isDeep, uint cells, uint capacity)
{
    uint before;
    InterlockedAdd(_Sums[isDeep ? count + 1 : count], cells, before);
    return before + cells > capacity ? capacity : isDeep ? capacity - cells - before : before;
}

uint CountOfList(uint count, uint capacity)
{
    return min(_Sums[count] + _Sums[count + 1], capacity);
}

// Element of a list, of which the deep ones come first: a dispatch waits for its slowest threads. cells: that are added at once.
uint ElementOfList(uint count, uint index, uint cells, uint capacity)
{
    uint deep = CountOfList(count, capacity) - min(_Sums[count], capacity);
    return index < deep ? capacity - cells - index / cells * cells + index % cells : index - deep;
}

uint Mixed(uint hash, uint value)
{
    uint mixed = (hash ^ value) * 16777619u;
    return (mixed ^ (mixed >> 13)) * 2246822519u;
}

#endif
