#ifndef GLINT_TUBE_STAGES
#define GLINT_TUBE_STAGES

#include "CellMarks.hlsl"

// The small kernels between those that trace tubes.

RWByteAddressBuffer _Arguments;            // groups of the indirect dispatches
uint _ClearedWords;
uint _FrequencyGroups;                     // of the kernel that sums

[numthreads(GLINT_GROUP, 1, 1)]
void ClearTubes(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint word = IndexOf(group, thread);
    if (word < _ClearedWords)
        _Sums[word] = 0;
}

void StoreGroups(uint offset, uint groups, uint deep)
{
    _Arguments.Store3(offset, uint3(min(groups, GROUPS_A_ROW), (groups + GROUPS_A_ROW - 1) / GROUPS_A_ROW, deep));
}

uint GroupsOf(uint count, uint list, uint size)
{
    if (count > list)
        _Sums[TUBE_OVERFLOW] = 1;
    return (min(count, list) + size - 1) / size;
}

[numthreads(GLINT_GROUP, 1, 1)]
void ClearMarks(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint word = IndexOf(group, thread);
    if (word < _PoseCount * _MarkWords)
        _WrittenMarks[word] = 0;
}

// Lists the corners of patches that are seen in or near base cells.
[numthreads(GLINT_GROUP, 1, 1)]
void MarkVertices(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (!TakeOfPose(index, _VertexCount))
        return;
    uint2 cells = _Poses[s_pose].Cells;
    float2 at = PlaceOnGrid(_Vertices[index].xyz);
    int2 first = (int2)floor(at - 0.5);
    for (uint i = 0; i < VERTEX_LINKS; i++)
    {
        int2 cell = first + int2(i & 1, i >> 1);
        uint link = s_pose * _LinkCapacity + VERTEX_LINKS * index + i, next;
        if (any(cell < 0) || any((uint2)cell >= cells))
            continue;
        InterlockedExchange(_WrittenMarks[VertexWord(cell)], 1 + link, next);
        _WrittenLinks[link] = uint4(asuint(at), next, 0);
    }
}

// Lists the sides on outlines of patches in the base cells that they run through. One thread a side.
[numthreads(GLINT_GROUP, 1, 1)]
void MarkOutlines(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (!TakeOfPose(index, _SideCount))
        return;
    CellWalk walk = BeginWalk(PlaceOnGrid(_Sides[SIDE_ROWS * index].xyz), PlaceOnGrid(_Sides[SIDE_ROWS * index + 1].xyz));
    [loop]
    for (float along = walk.First; along <= walk.Last; along += 1.0)
    {
        int2 others = CellsAcross(walk, along);
        for (int other = others.x; other <= others.y; other++)
            MarkSide(index, CellOf(walk, along, other));
    }
}

// The instance of a triangle that is counted through all instances.
uint InstanceOfTriangle(uint triangleIndex)
{
    uint first = 0, end = _PlacedCount;
    while (end - first > 1)
    {
        uint middle = (first + end) / 2;
        if (_InstanceFacets[middle].z <= triangleIndex)
            first = middle;
        else
            end = middle;
    }
    return first;
}

// A sphere about such a triangle, relative to the scene's centre, m; w: radius.
float4 SphereOf(uint triangleIndex)
{
    uint instance = InstanceOfTriangle(triangleIndex), row = PLACE_ROWS * instance;
    uint4 first = _InstanceFacets[instance];
    float4 sphere = _Spheres[first.x + triangleIndex - first.z], atCentre = float4(sphere.xyz, 1), last = _Places[row + 3];
    return float4(dot(_Places[row], atCentre), dot(_Places[row + 1], atCentre), dot(_Places[row + 2], atCentre),
        last.x * sphere.w + last.y);
}

// Marks the blocks of base cells in which triangles may be seen.
[numthreads(GLINT_GROUP, 1, 1)]
void MarkCover(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (!TakeOfPose(index, _TriangleCount))
        return;
    float4 sphere = SphereOf(index);
    float4 gridX = _Poses[s_pose].GridX, gridY = _Poses[s_pose].GridY, gridDepth = _Poses[s_pose].GridDepth;
    uint2 blocks = _Poses[s_pose].Blocks;
    float depth = dot(sphere.xyz, gridDepth.xyz) + gridDepth.w, deep = sphere.w * length(gridDepth.xyz);
    float2 at = float2(dot(sphere.xyz, gridX.xyz) + gridX.w, dot(sphere.xyz, gridY.xyz) + gridY.w) / depth;
    float2 reach = (sphere.w * float2(length(gridX.xyz), length(gridY.xyz)) + abs(at) * deep) / max(depth - deep, 1.0e-6);
    int2 first = (int2)max(0.0, floor((at - reach - 0.1) / COVER_SIDE));
    int2 last = (int2)min((float2)blocks - 1.0, floor((at + reach + 0.1) / COVER_SIDE)), size = last - first + 1;
    if (any(size <= 0))
        return;
    if (depth <= deep || (uint)size.x * size.y > MAX_COVERED)
    {
        _WrittenMarks[AllCoveredWord()] = 1;
        return;
    }
    for (uint i = 0; i < (uint)size.x * size.y; i++)
    {
        uint2 block = (uint2)first + uint2(i % size.x, i / size.x);
        uint bit = block.x + block.y * blocks.x;
        InterlockedOr(_WrittenMarks[CoverWord(bit)], 1u << (bit & 31));
    }
}

RWStructuredBuffer<uint> _WrittenRevealed; // _Revealed
RWStructuredBuffer<uint> _RevealedByNow;
StructuredBuffer<uint> _Beginning;         // poses that begin an attempt
uint _BeginningCount;

[numthreads(GLINT_GROUP, 1, 1)]
void ClearRevealed(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint word = IndexOf(group, thread);
    if (word < _PoseCount * _RevealedWords)
        _RevealedByNow[word] = 0;
}

// Takes what the attempts before have revealed.
[numthreads(GLINT_GROUP, 1, 1)]
void TakeRevealed(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= _BeginningCount * _RevealedWords)
        return;
    uint word = _Beginning[index / _RevealedWords] * _RevealedWords + index % _RevealedWords;
    _WrittenRevealed[word] = _RevealedByNow[word];
}

// Cells of a list that is filled from both ends.
uint GroupsOfList(uint count, uint capacity)
{
    return GroupsOf(_Sums[count] + _Sums[count + 1], capacity, GLINT_GROUP);
}

void ClearList(uint count)
{
    _Sums[count] = 0;
    _Sums[count + 1] = 0;
}

// Groups for the rays that the cells of this round have listed.
[numthreads(1, 1, 1)]
void PrepareRays()
{
    StoreGroups(OUTLINE_ARGUMENTS, GroupsOf(_Sums[TUBE_OUTLINES], _ListCapacity.x, GLINT_GROUP), 1);
    StoreGroups(CENTRE_ARGUMENTS, GroupsOfList(TUBE_CENTRES, _ListCapacity.w), 1);
}

// Groups for the border cells of this round.
[numthreads(1, 1, 1)]
void PrepareBorders()
{
    uint cut = GroupsOfList(TUBE_BORDERS, _ListCapacity.z);
    StoreGroups(BISECT_ARGUMENTS, 2 * cut, 1);
    StoreGroups(BORDER_ARGUMENTS, cut, 1);
    StoreGroups(BORDER_RAY_ARGUMENTS, BORDER_RAYS * cut, 1);
    StoreGroups(WHOLE_ARGUMENTS, GroupsOfList(TUBE_WHOLES, _ListCapacity.z), 1);
}

// Groups for the cells of the next round, and for the tubes so far; new lists begin.
[numthreads(1, 1, 1)]
void PrepareCells()
{
    uint cells = _Sums[TUBE_NEXT_CELLS] + _Sums[TUBE_NEXT_CELLS + 1];
    StoreGroups(CELL_ARGUMENTS, GroupsOf(cells, _ListCapacity.y, GLINT_GROUP), 1);
    StoreGroups(CORNER_ARGUMENTS, GroupsOf(NEW_CORNERS * (cells / BLOCK_CELLS),
        NEW_CORNERS * (_ListCapacity.y / BLOCK_CELLS), GLINT_GROUP), 1);
    StoreGroups(TUBE_ARGUMENTS, GroupsOf(_Sums[TUBE_COUNT], _ListCapacity.x, TUBES_A_GROUP), _FrequencyGroups);
    StoreGroups(CHANGE_ARGUMENTS, GroupsOf(_Sums[TUBE_COUNT], _ListCapacity.x, GLINT_GROUP), 1);
    _Sums[TUBE_CELLS] = _Sums[TUBE_NEXT_CELLS];
    _Sums[TUBE_CELLS + 1] = _Sums[TUBE_NEXT_CELLS + 1];
    ClearList(TUBE_NEXT_CELLS);
    ClearList(TUBE_CENTRES);
    ClearList(TUBE_BORDERS);
    ClearList(TUBE_WHOLES);
    _Sums[TUBE_OUTLINES] = 0;
}

#endif
