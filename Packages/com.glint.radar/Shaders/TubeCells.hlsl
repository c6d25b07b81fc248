#ifndef GLINT_TUBE_CELLS
#define GLINT_TUBE_CELLS

#include "TubeSquares.hlsl"
#include "Sums.hlsl"

// Sums the cells whose corners see the same, as one tube each, and lists the others as borders. Cells come in blocks of
// 2 x 2, which share corners. A thread takes a ray: those of a group take the 9 corners of each of its blocks, and behind
// them the 4 centres of each. A bounce is one step of all.

static const uint BLOCKS_A_GROUP = GLINT_GROUP / 16, BLOCK_CORNERS = 9, BLOCK_CELLS = 4;
static const uint GROUP_CORNERS = BLOCKS_A_GROUP * BLOCK_CORNERS, GROUP_CELLS = BLOCKS_A_GROUP * BLOCK_CELLS;

// What the ray through a corner of a block has met at a bounce.
struct Corner
{
    uint Signature;
    bool HasHit;
    float2 Strength;       // and its product with the error by bent phases
    float4 Place;          // PlaceOf
    float4 AlongU;         // its differentials
    float4 AlongV;
};

groupshared Corner s_corners[GROUP_CORNERS];
groupshared bool s_isTraced[GROUP_CELLS];
groupshared uint s_rays;

// The cell of a block.
bool LoadCell(uint block, uint number, out Cell cell)
{
    cell = (Cell)0;
    if (_Round > 0)
    {
        if (4 * block >= min(_Sums[TUBE_CELLS], _ListCapacity.y))
            return false;
        cell = _TubeCells[4 * block + number];
        return true;
    }
    uint at = _Grid.y / 4 + block, across = _Grid.x / 2;
    cell.Position = 2 * uint2(at % across, at / across) + uint2(number & 1, number >> 1);
    return 4 * block < _Grid.z;
}

void AddBorder(Cell cell)
{
    uint border;
    InterlockedAdd(_Sums[TUBE_BORDERS], 1, border);
    if (border < _ListCapacity.z)
        _Borders[border] = cell;
}

// Whether a corner of a patch is seen in the cell or within half its side: between rays it may reach into it.
bool HasVertex(Cell cell)
{
    if (cell.Level >= _MaxLevel)
        return false;
    float side = SideOfCell(cell);
    float2 centre = CentreOfCell(cell);
    uint2 base = cell.Position >> cell.Level;
    uint link = _Marks[base.x + base.y * _Grid.x];
    bool isNear = false;
    [loop]
    for (uint read = 0; read < MAX_VERTICES && link != 0 && !isNear; read++)
    {
        uint4 vertex = _Links[link - 1];
        isNear = all(abs(asfloat(vertex.xy) - centre) <= side);
        link = vertex.z;
    }
    // A longer list is not read: its corners may be anywhere.
    return isNear || link != 0;
}

// Whether a triangle may be seen in the base cell.
bool IsCovered(uint2 cell)
{
    uint bit = cell.x / COVER_SIDE + cell.y / COVER_SIDE * _Blocks.x;
    return _Marks[_MarkWords - 1] != 0 || (_Marks[FirstCoverWord() + (bit >> 5)] >> (bit & 31) & 1) != 0;
}

// The corner of a block at a corner of a cell.
uint CornerOfBlock(uint number, uint corner)
{
    uint2 at = uint2(number & 1, number >> 1) + uint2(CornerOf(corner) > 0.0);
    return at.x + 3 * at.y;
}

// Adds what the ray through a corner has met.
void AddCorner(inout Bounce bounce, Corner corner, float2 fromCentre)
{
    float4 position = 0.25 * corner.Place;
    float2 sides = fromCentre > 0.0 ? 1.0 : -1.0;
    bounce.AlongU += fromCentre.x * corner.AlongU;
    bounce.AlongV += fromCentre.y * corner.AlongV;
    bounce.Mean += position;
    bounce.SlopeU += sides.x * position;
    bounce.SlopeV += sides.y * position;
    bounce.Twist += sides.x * sides.y * position;
    bounce.Strength += 0.25 * corner.Strength.x * float4(1.0, sides, sides.x * sides.y);
}

// What the rays through the corners of a cell have met at a bounce. first: the block's first corner in the group.
Bounce BounceOf(uint first, uint number, float side)
{
    Bounce bounce = (Bounce)0;
    bounce.IsCommon = true;
    bounce.Signature = s_corners[first + CornerOfBlock(number, 0)].Signature;
    for (uint i = 0; i < 4; i++)
    {
        Corner corner = s_corners[first + CornerOfBlock(number, i)];
        bounce.IsCommon = bounce.IsCommon && corner.HasHit && corner.Signature == bounce.Signature;
        AddCorner(bounce, corner, side * CornerOf(i));
    }
    return bounce;
}

// What is known of a cell.
struct CellState
{
    bool IsCommon;         // the rays through its corners have met the same so far,
    bool AreSame;          // and that through its centre too
    bool IsWhole;          // all that they have met is summed
    uint Done;             // bounces summed
    float2 Left;           // largest strength of those that are not (Corner.Strength)
};

// Sums a cell at a bounce, if all its rays have met the same. goesOn: whether the ray through its centre has a hit; false
// afterwards if the others have not met it, or if the cell must be divided.
void AddBounce(inout CellState state, Cell cell, uint number, uint bounce, uint first, TubePath tube, SurfacePoint at,
    uint receivers, float2 strength, inout bool goesOn)
{
    float side = SideOfCell(cell);
    Bounce met = BounceOf(first, number, side);
    state.IsCommon = state.IsCommon && met.IsCommon;
    bool isSame = state.IsCommon && goesOn && met.Signature == tube.Signature;
    state.AreSame = state.AreSame && isSame == (state.IsCommon || goesOn);
    if (isSame && bounce >= cell.FirstBounce)
    {
        isSame = AddSquare(met, tube, at, receivers, strength.x, side, cell.Level < _MaxLevel);
        state.Done = isSame ? bounce + 1 : state.Done;
    }
    state.IsWhole = state.IsWhole && (isSame || !state.IsCommon);
    if (bounce >= state.Done)
    {
        state.Left = max(state.Left, strength);
        for (uint i = 0; i < 4; i++)
            state.Left = max(state.Left, s_corners[first + CornerOfBlock(number, i)].Strength);
    }
    goesOn = isSame;
}

// Whether the cell is to be traced. One that may hide a corner of a patch is listed without.
bool IsToTrace(Cell cell)
{
    if (_Round == 0 && !IsCovered(cell.Position))
        return false;
    if (!HasVertex(cell))
        return true;
    cell.Strength = MISS;
    cell.Bent = MISS;
    AddBorder(cell);
    return false;
}

// Whether a cell at a corner of a block is traced. first: the block's first cell in the group.
bool HasTracedCell(uint first, uint corner)
{
    bool isTraced = false;
    for (uint i = 0; i < 4 * BLOCK_CELLS; i++)
        isTraced = isTraced || CornerOfBlock(i >> 2, i & 3) == corner && s_isTraced[first + (i >> 2)];
    return isTraced;
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    bool isCorner = thread < GROUP_CORNERS, isCentre = !isCorner && thread < GROUP_CORNERS + GROUP_CELLS;
    uint place = isCorner ? thread % BLOCK_CORNERS : (thread - GROUP_CORNERS) % BLOCK_CELLS;
    uint block = isCorner ? thread / BLOCK_CORNERS : (thread - GROUP_CORNERS) / BLOCK_CELLS, first = BLOCK_CORNERS * block;
    Cell cell;
    bool isTraced = LoadCell(IndexOf(group, 0) / 16 + block, isCentre ? place : 0, cell) && isCentre;
    if (isTraced)
        isTraced = IsToTrace(cell);
    if (isCentre)
        s_isTraced[thread - GROUP_CORNERS] = isTraced;
    if (thread == 0)
        s_rays = 0;
    GroupMemoryBarrierWithGroupSync();

    float2 corner = float2(cell.Position) + float2(place % 3, place / 3);
    TubePath tube = BeginTube(isCorner ? SideOfCell(cell) * corner : CentreOfCell(cell));
    bool goesOn = isTraced;
    if (isCorner)
        goesOn = HasTracedCell(BLOCK_CELLS * block, place);
    if (goesOn)
        InterlockedAdd(s_rays, 1);
    CellState state = (CellState)0;
    state.IsCommon = true;
    state.AreSame = true;
    state.IsWhole = true;
    state.Done = cell.FirstBounce;
    [loop]
    for (uint bounce = 0; bounce < _MaxBounces; bounce++)
    {
        SurfacePoint at = (SurfacePoint)0;
        Corner met = (Corner)0;
        uint receivers = 0;
        if (goesOn)
            goesOn = AdvanceTube(tube, at);
        if (goesOn)
        {
            receivers = ReceiversOf(tube, at);
            Sign(tube, receivers);
            met.Signature = tube.Signature;
            met.HasHit = true;
            met.Strength = StrengthAt(tube, at, receivers)
                * float2(1.0, BentErrorAt(tube, at, ReceiverFrom(0, tube.Path.Ray.Origin), SideOfCell(cell)));
            met.Place = PlaceOf(tube);
            met.AlongU = DifferentialOf(tube, tube.PlaceU);
            met.AlongV = DifferentialOf(tube, tube.PlaceV);
        }
        if (isCorner)
            s_corners[thread] = met;
        GroupMemoryBarrierWithGroupSync();
        if (isTraced)
            AddBounce(state, cell, place, bounce, first, tube, at, receivers, met.Strength, goesOn);
        if (goesOn)
            goesOn = ScatterTube(tube, at);
        GroupMemoryBarrierWithGroupSync();
    }
    if (isCorner)
        s_corners[thread].Signature = tube.Signature;
    GroupMemoryBarrierWithGroupSync();
    if (thread == 0 && s_rays > 0)
        AddUnsigned(TUBE_RAYS, s_rays);
    if (!isTraced)
        return;
    bool areSame = state.AreSame && state.IsWhole;
    [unroll]
    for (uint i = 0; i < 4; i++)
    {
        cell.Signatures[i] = s_corners[first + CornerOfBlock(place, i)].Signature;
        areSame = areSame && cell.Signatures[i] == cell.Signatures[0];
    }
    if (areSame)
        return;
    cell.FirstBounce = state.Done;
    cell.Strength = state.Left.x;
    cell.Bent = state.IsWhole ? state.Left.y : MISS;
    AddBorder(cell);
}

#endif
