#ifndef GLINT_AMPLITUDE_BORDERS
#define GLINT_AMPLITUDE_BORDERS

#include "AmplitudeCuts.hlsl"

// Cuts border cells in two along the border, or divides them into four cells of the next round. One thread a cell, which
// traces no ray.

// Lists the four parts of a cell, between the points of its corners and five new ones, which the next round follows.
void Divide(Cell cell, uint4 corners)
{
    uint first;
    InterlockedAdd(_Sums[TUBE_POINTS], NEW_CORNERS, first);
    if (first + NEW_CORNERS > _PointCapacity)
    {
        _Sums[TUBE_OVERFLOW] = 1;
        return;
    }
    uint part = AddToList(TUBE_NEXT_CELLS, false, BLOCK_CELLS, _ListCapacity.y);
    if (part == _ListCapacity.y)
        return;
    for (uint corner = 0; corner < BLOCK_CELLS; corner++)
    {
        Cell quarter = (Cell)0;
        quarter.Position = 2 * cell.Position + uint2(corner == 1 || corner == 2 ? 1 : 0, corner >> 1);
        quarter.Level = cell.Level + 1;
        quarter.Pose = cell.Pose;
        // Around it: this corner of the cell, the middles of the two sides there, and the centre.
        uint4 around = uint4(corners[corner], first + corner, first + 4, first + ((corner + 3) & 3));
        quarter.Signatures = uint4(around[(0 - corner) & 3], around[(1 - corner) & 3], around[(2 - corner) & 3],
            around[(3 - corner) & 3]);
        _NextCells[part + corner] = quarter;
    }
}

// The mean of what bends the phase over a piece, m.
float MeanBend(Piece piece, float2 position, float side, float3 bend)
{
    if (piece.Count == 0)
        return (bend.x + bend.y) * side * side / 24.0;
    float3 moments = 0.0;
    float area = 0.0;
    for (uint i = 0; i < piece.Count; i++)
    {
        float2 a = piece.Corners[i] - position, b = piece.Corners[i + 1 == piece.Count ? 0 : i + 1] - position;
        float twice = Cross2(a, b);
        area += 0.5 * twice;
        moments += twice / 12.0 * float3(a.x * a.x + a.x * b.x + b.x * b.x, a.y * a.y + a.y * b.y + b.y * b.y,
            a.x * a.y + b.x * b.y + 0.5 * (a.x * b.y + a.y * b.x));
    }
    return area == 0.0 ? 0.0 : dot(moments / area, bend * float3(0.5, 0.5, 1.0));
}

// What a piece returns.
void AddPiece(Cut cut, Piece piece, Return ray, bool isStraight)
{
    if (ray.Signature == 0)
        return;
    float2 position = MiddleOf(piece), directions[2] = { cut.SideBefore, cut.SideAfter };
    Tube tube = TubeOf(ray);
    tube.Tag |= piece.Count << 16;
    tube.Phase += MeanBend(piece, position, cut.Side, ray.Bend);
    tube.Corners01 = float4(piece.Corners[0] - position, piece.Corners[1] - position);
    tube.Corners23 = float4(piece.Corners[2] - position, piece.Corners[3] - position);
    tube.Corner4 = piece.Corners[4] - position;
    if (piece.Count == 0)
    {
        tube.Corners01 = float4(cut.Side, 0.0, 0.0, 0.0);
        tube.Corners23 = float4(1.0, 0.0, 0.0, 0.0);
    }
    float area = isStraight ? AreaError(cut.Chord, directions, cut.Width, ray.Gradient)
        : CRUDE_ERROR * AreaOf(piece, cut.Side);
    tube.Error = sqrt(area * area + ray.BendError * ray.BendError);
    AddTube(tube);
}

// Sums what the rays of a cell return, or divides it. first: element of the first one.
void Decide(Cell cell, uint4 corners, uint first)
{
    Cut cut = CutOf(cell);
    Return before = (Return)0, after = (Return)0;
    bool isStraight = cut.IsCut;
    if (cut.IsCut)
    {
        before = _BorderRays[first + BESIDE];
        after = _BorderRays[first + BESIDE + 1];
        isStraight = before.Signature == cut.SignatureBefore && after.Signature == cut.SignatureAfter;
    }
    if (cut.IsCut ? (isStraight || !cut.CanDivide) && cut.SignatureBefore != 0 : !cut.CanDivide)
    {
        before = _BorderRays[first + WITHIN];
        isStraight = isStraight && before.Signature == cut.SignatureBefore;
    }
    if (cut.IsCut && (isStraight || !cut.CanDivide) && cut.SignatureAfter != 0)
    {
        after = _BorderRays[first + WITHIN + 1];
        isStraight = isStraight && after.Signature == cut.SignatureAfter;
    }
    isStraight = isStraight && (before.BendError <= CellError() || before.Signature == 0)
        && (after.BendError <= CellError() || after.Signature == 0);
    if (!isStraight && cut.CanDivide)
    {
        Divide(cell, corners);
        return;
    }
    AddPiece(cut, cut.Before, before, isStraight);
    AddPiece(cut, cut.After, after, isStraight);
}

[numthreads(GLINT_GROUP, 1, 1)]
void AmplitudeBorders(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= CountOfList(TUBE_BORDERS, _ListCapacity.z))
        return;
    Cell cell = LoadBorder(index);
    Decide(cell, _Borders[index].Signatures, BORDER_RAYS * index);
}

#endif
