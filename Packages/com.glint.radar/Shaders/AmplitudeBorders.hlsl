#ifndef GLINT_AMPLITUDE_BORDERS
#define GLINT_AMPLITUDE_BORDERS

#include "AmplitudePath.hlsl"

// Cuts border cells in two along the border, or divides them into four cells of the next round. One thread a cell.

// Error of a piece's shape by a phase that is bent at its corners by one radian in all: its mean is exact.
static const float BENT_PIECE_ERROR = 0.3;

// First ray of each kind: beside the middle of the chord, in the pieces or the whole cell, and at the new points of a
// cell that is divided.
static const uint BESIDE = 0, WITHIN = 2, DIVIDING = 4, RAYS = 9;

// Tells the cell on the other side of a position on a side.
void RevealAcross(float2 position, float2 outward)
{
    // The position may be between two parts.
    for (uint i = 0; i < 2; i++)
    {
        float2 beside = outward + (i == 0 ? -1.0 : 1.0) * float2(outward.y, outward.x);
        int2 part = (int2)floor(REVEALED_PARTS * position + 0.25 * beside);
        uint2 cell = (uint2)(part >> REVEALED_LEVEL), bit = (uint2)(part & (REVEALED_PARTS - 1));
        uint word = REVEALED_PARTS * (cell.x + cell.y * _Grid.x) + bit.y, before;
        if (any(part < 0) || cell.x >= _Grid.x || word >= _RevealedWords)
            continue;
        InterlockedOr(_RevealedByNow[word], 1u << bit.x, before);
        if ((before >> bit.x & 1) == 0)
            InterlockedAdd(_Sums[TUBE_REVEALED], 1);
    }
}

// Position of a new point of a cell that is divided, in sides from its centre: the middles of the sides, or the centre.
float2 FromCentre(uint ray)
{
    return ray == 4 ? (float2)0 : 0.5 * (CornerOf(ray) + CornerOf((ray + 1) & 3));
}

// Lists the four parts of a cell, between its corners and the five new points from the first on.
void Divide(Cell cell, uint4 corners, uint first, bool isReceived)
{
    float side = SideOfCell(cell);
    // What the last level finds in cells of which no corner is received, the next would find again, in parts as large.
    if (isReceived && cell.Level + 1 == _EmptyLevel && all(cell.Signatures == 0))
    {
        float error = CRUDE_ERROR * 0.25 * side * side;
        AddUnsigned(TUBE_SUMS + SUM_ERROR, (uint)(_UnitsPerSquareMetre * error * error));
    }
    uint part = AddToList(TUBE_NEXT_CELLS, false, BLOCK_CELLS, _ListCapacity.y);
    if (part == _ListCapacity.y)
        return;
    for (uint corner = 0; corner < BLOCK_CELLS; corner++)
    {
        Cell quarter = (Cell)0;
        quarter.Position = 2 * cell.Position + uint2(corner == 1 || corner == 2 ? 1 : 0, corner >> 1);
        quarter.Level = cell.Level + 1;
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

[numthreads(GLINT_GROUP, 1, 1)]
void AmplitudeBorders(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= CountOfList(TUBE_BORDERS, _ListCapacity.z))
        return;
    Cell cell = LoadBorder(index);
    uint4 corners = _Borders[index].Signatures;
    Border border = BorderOf(cell);
    float side = SideOfCell(cell);
    bool canDivide = CanDivide(cell), isCut = border.IsCut
        && ((cell.Crossings.x | cell.Crossings.y) & NO_CROSSING) == 0;
    float fraction = asfloat((127 - BisectionsOf(cell)) << 23), width = side * fraction;
    float2 first = PlaceOnSide(border, 0, (cell.Crossings.x + 0.5) * fraction, side),
        second = PlaceOnSide(border, 1, (cell.Crossings.y + 0.5) * fraction, side), chord = second - first;
    float2 directions[2] = { CornerOf((border.Sides.x + 1) & 3) - CornerOf(border.Sides.x),
        CornerOf((border.Sides.y + 1) & 3) - CornerOf(border.Sides.y) };
    float size = length(chord);
    float2 beside = size > 0.0 ? width * float2(-chord.y, chord.x) / size : 0.0;
    Return returns[2];
    returns[0] = (Return)0;
    returns[1] = (Return)0;
    Piece pieces[2];
    pieces[0] = (Piece)0;
    pieces[1] = (Piece)0;
    if (isCut)
    {
        // To the right of the chord lies the second piece.
        pieces[0] = PieceBetween(second, border.Sides.y, first, border.Sides.x, side);
        pieces[1] = PieceBetween(first, border.Sides.x, second, border.Sides.y, side);
    }
    float bendErrors[2] = { 0.0, 0.0 };
    bool isStraight = isCut, isDivided = false, isReceived = false;
    uint rays = 0, firstPoint = 0;
    // One loop for all kinds, so that the code of a path is compiled once.
    [loop]
    for (uint ray = isCut ? BESIDE : canDivide ? DIVIDING : WITHIN; ray < RAYS; ray++)
    {
        if (ray == DIVIDING)
        {
            [unroll]
            for (uint i = 0; i < 2; i++)
                isStraight = isStraight && (bendErrors[i] <= CellError() || returns[i].Signature == 0);
            isDivided = !isStraight && canDivide;
            if (!isDivided)
                break;
            InterlockedAdd(_Sums[TUBE_POINTS], RAYS - DIVIDING, firstPoint);
            if (firstPoint + RAYS - DIVIDING > _PointCapacity)
            {
                _Sums[TUBE_OVERFLOW] = 1;
                return;
            }
        }
        uint which = ray & 1, expected = which == 0 ? border.SignatureBefore : border.SignatureAfter;
        bool isWithin = ray >= WITHIN && !isDivided;
        if (isWithin && (isCut ? !isStraight && canDivide || expected == 0 : which == 1))
            continue;
        Piece piece = pieces[0];
        if (which == 1)
            piece = pieces[1];
        uint newPoint = ray - DIVIDING, recorded = NO_POINT;
        float2 position = first + 0.5 * chord + (which == 0 ? beside : -beside);
        if (isWithin)
            position = MiddleOf(piece);
        if (isDivided)
        {
            position = side * FromCentre(newPoint);
            recorded = firstPoint + newPoint;
        }
        Return found = Follow(CentreOfCell(cell) + position, recorded);
        rays++;
        if (isDivided)
        {
            isReceived = isReceived || found.Signature != 0;
            if (newPoint < 4 && found.Signature != cell.Signatures[newPoint & 3]
                && found.Signature != cell.Signatures[(newPoint + 1) & 3])
                RevealAcross(CentreOfCell(cell) + position, 2.0 * FromCentre(newPoint));
            continue;
        }
        isStraight = isStraight && found.Signature == expected;
        float3 bends = abs(BendsOf(found, side));
        float bendError = min(1.0, BENT_PIECE_ERROR * _WaveNumber * (bends.x + bends.y + bends.z))
            * AreaOf(piece, side);
        if (which == 0)
        {
            returns[0] = found;
            bendErrors[0] = bendError;
        }
        else
        {
            returns[1] = found;
            bendErrors[1] = bendError;
        }
    }
    AddTo(CountWord(POSE_BORDER_RAYS), rays);
    if (isDivided)
    {
        Divide(cell, corners, firstPoint, isReceived);
        return;
    }
    [loop]
    for (uint number = 0; number < 2; number++)
    {
        Return ray = returns[0];
        Piece piece = pieces[0];
        float bendError = bendErrors[0];
        if (number == 1)
        {
            ray = returns[1];
            piece = pieces[1];
            bendError = bendErrors[1];
        }
        if (ray.Signature == 0)
            continue;
        float2 position = MiddleOf(piece);
        Tube tube = TubeOf(ray);
        tube.Tag = piece.Count << 16;
        tube.Phase += MeanBend(piece, position, side, ray.Bend);
        tube.Corners01 = float4(piece.Corners[0] - position, piece.Corners[1] - position);
        tube.Corners23 = float4(piece.Corners[2] - position, piece.Corners[3] - position);
        tube.Corner4 = piece.Corners[4] - position;
        if (piece.Count == 0)
        {
            tube.Corners01 = float4(side, 0.0, 0.0, 0.0);
            tube.Corners23 = float4(1.0, 0.0, 0.0, 0.0);
        }
        float area = isStraight ? AreaError(chord, directions, width, ray.Gradient)
            : CRUDE_ERROR * AreaOf(piece, side);
        tube.Error = sqrt(area * area + bendError * bendError);
        AddTube(tube);
    }
}

#endif
