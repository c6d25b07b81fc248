#ifndef GLINT_CELL_MARKS
#define GLINT_CELL_MARKS

#include "TubeShapes.hlsl"

// Lists lines in the base cells that they run through.

RWStructuredBuffer<uint> _WrittenMarks;    // _Marks
RWStructuredBuffer<uint4> _WrittenLinks;   // _Links

// Lists a side in a base cell.
void MarkSide(uint side, int2 cell)
{
    uint link, next;
    if (any(cell < 0) || any((uint2)cell >= _Poses[s_pose].Cells))
        return;
    InterlockedAdd(_WrittenMarks[SideCountWord()], 1, link);
    if (link >= SideLinks())
        return;
    link += s_pose * _LinkCapacity + VERTEX_LINKS * _VertexCount;
    InterlockedExchange(_WrittenMarks[OutlineWord(cell)], 1 + link, next);
    _WrittenLinks[link] = uint4(side, 0, next, 0);
}

// Lists a line on the grid in a base cell.
void MarkLine(float2 start, float2 end, uint kind, int2 cell)
{
    uint link, next;
    if (any(cell < 0) || any((uint2)cell >= _Poses[s_pose].Cells))
        return;
    InterlockedAdd(_WrittenMarks[LineCountWord()], LINE_LINKS, link);
    if (link + LINE_LINKS > _LineCapacity)
        return;
    link += (s_pose + 1) * _LinkCapacity - _LineCapacity;
    InterlockedExchange(_WrittenMarks[OutlineWord(cell)], 1 + link, next);
    _WrittenLinks[link] = uint4(asuint(start), next, kind);
    _WrittenLinks[link + 1] = uint4(asuint(end), 0, 0);
}

// Base cells along a line, by the axis on which it is longer.
struct CellWalk
{
    float2 Start, End;     // along that axis, and across it
    float Slope;
    bool IsUpright;
    float First, Last;     // cells along the axis
};

CellWalk BeginWalk(float2 a, float2 b)
{
    CellWalk walk;
    walk.IsUpright = abs(b.y - a.y) > abs(b.x - a.x);
    walk.Start = walk.IsUpright ? a.yx : a;
    walk.End = walk.IsUpright ? b.yx : b;
    walk.Slope = (walk.End.y - walk.Start.y) / (walk.End.x == walk.Start.x ? 1.0 : walk.End.x - walk.Start.x);
    float cells = walk.IsUpright ? _Poses[s_pose].Cells.y : _Poses[s_pose].Cells.x;
    walk.First = max(0.0, floor(min(walk.Start.x, walk.End.x)));
    walk.Last = min(cells - 1.0, floor(max(walk.Start.x, walk.End.x)));
    return walk;
}

// First and last cell across the axis, at a cell along it.
int2 CellsAcross(CellWalk walk, float along)
{
    float2 across = walk.Start.y + walk.Slope * (clamp(float2(along, along + 1.0), min(walk.Start.x, walk.End.x),
        max(walk.Start.x, walk.End.x)) - walk.Start.x);
    int from = (int)floor(min(across.x, across.y)), to = (int)floor(max(across.x, across.y));
    return int2(from, min(to, from + 1));
}

int2 CellOf(CellWalk walk, float along, int other)
{
    return walk.IsUpright ? int2(other, along) : int2(along, other);
}

// Base cells along a line that is listed, at most: what is seen at a flatter angle is not.
static const float MAX_LINE_CELLS = 32.0;

// Lists a line on the grid in the base cells that it runs through, so that a place lies to its left.
void ListLine(float2 start, float2 end, float2 aside, uint kind)
{
    bool isLeft = Cross2(end - start, aside - start) > 0.0;
    CellWalk walk = BeginWalk(start, end);
    // Compilers may take a comparison with NaN for either.
    if (IsNaN(start.x + start.y + end.x + end.y) || walk.Last - walk.First >= MAX_LINE_CELLS)
        return;
    [loop]
    for (float along = walk.First; along <= walk.Last; along += 1.0)
    {
        int2 others = CellsAcross(walk, along);
        for (int other = others.x; other <= others.y; other++)
            MarkLine(isLeft ? start : end, isLeft ? end : start, kind, CellOf(walk, along, other));
    }
}

#endif
