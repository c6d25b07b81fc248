#ifndef GLINT_TUBE_BORDERS
#define GLINT_TUBE_BORDERS

#include "TubeGrid.hlsl"
#include "Sums.hlsl"

// Cuts border cells in two along the border, which is found by bisection on two sides of the cell, or divides them into
// four cells of the next round. One thread a border cell.

// Error of a cell that can be neither cut nor divided, as a fraction of its area.
static const float CRUDE_ERROR = 0.3;

// A convex piece of a cell: corners from its centre, in base cells.
struct Piece
{
    float2 Corners[5];
    uint Count;            // 0: the whole cell
    uint Signature;        // of the rays in it
};

float Cross2(float2 a, float2 b)
{
    return a.x * b.y - a.y * b.x;
}

float AreaOf(Piece piece, float side)
{
    float twice = 0.0;
    for (uint i = 2; i < piece.Count; i++)
        twice += Cross2(piece.Corners[i - 1] - piece.Corners[0], piece.Corners[i] - piece.Corners[0]);
    return piece.Count == 0 ? side * side : 0.5 * abs(twice);
}

float2 MiddleOf(Piece piece)
{
    float2 sum = 0.0;
    for (uint i = 0; i < piece.Count; i++)
        sum += piece.Corners[i];
    return piece.Count == 0 ? sum : sum / piece.Count;
}

// The piece between the crossings of two sides: from the corner after the first to the second.
Piece PieceBetween(float2 firstCrossing, uint firstSide, float2 secondCrossing, uint secondSide, float side)
{
    Piece piece = (Piece)0;
    piece.Corners[0] = firstCrossing;
    uint count = (secondSide - firstSide) & 3;
    [unroll]
    for (uint i = 1; i <= 3; i++)
        if (i <= count)
            piece.Corners[i] = side * CornerOf((firstSide + i) & 3);
        else if (i == count + 1)
            piece.Corners[i] = secondCrossing;
    if (count == 3)
        piece.Corners[4] = secondCrossing;
    piece.Count = count + 2;
    return piece;
}

void Divide(Cell cell)
{
    uint first;
    InterlockedAdd(_Sums[TUBE_CELLS], 4, first);
    for (uint i = 0; i < 4; i++)
        if (first + i < _ListCapacity.y)
        {
            Cell part = (Cell)0;
            part.Position = 2 * cell.Position + uint2(i & 1, i >> 1);
            part.Level = cell.Level + 1;
            part.FirstBounce = cell.FirstBounce;
            _TubeCells[first + i] = part;
        }
}

// Area by which the border may be off, for a phase gradient: its ends lie within an interval of this width on the sides
// of the cell. Neighbouring cells share the ends, so that the error along the border is a sum of hat functions.
float AreaError(float2 chord, float2 sides[2], float width, float2 gradient)
{
    float x = 0.5 * _WaveNumber * dot(gradient, chord);
    float hat = abs(x) < 0.01 ? 1.0 : sin(x) / x;
    float first = Cross2(chord, sides[0]), second = Cross2(chord, sides[1]);
    return sqrt((first * first + second * second) / 24.0) * width * hat * hat;
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= min(_Sums[TUBE_BORDERS], _ListCapacity.z))
        return;
    Cell cell = _Borders[index];
    float side = SideOfCell(cell);
    uint changes[2] = { 0, 0 };
    uint changeCount = 0;
    uint firstSignature = cell.Signatures.x, otherSignature = firstSignature;
    bool areTwo = cell.MustDivide == 0;
    for (uint corner = 0; corner < 4; corner++)
    {
        uint signature = cell.Signatures[corner];
        if (signature != firstSignature)
        {
            areTwo = areTwo && (otherSignature == firstSignature || otherSignature == signature);
            otherSignature = signature;
        }
        if (signature != cell.Signatures[(corner + 1) & 3])
        {
            changes[min(changeCount, 1)] = corner;
            changeCount++;
        }
    }
    bool isCut = areTwo && changeCount == 2, canDivide = cell.Level < _MaxLevel;
    if (!isCut && canDivide)
    {
        Divide(cell);
        return;
    }

    // Ends of the intervals on two sides: near the corner before and after the change.
    float2 before[2], after[2];
    float2 directions[2];
    uint signatureBefore = cell.Signatures[changes[0]], signatureAfter = cell.Signatures[(changes[0] + 1) & 3];
    before[0] = side * CornerOf(changes[0]);
    after[0] = side * CornerOf((changes[0] + 1) & 3);
    before[1] = side * CornerOf((changes[1] + 1) & 3);
    after[1] = side * CornerOf(changes[1]);
    directions[0] = (after[0] - before[0]) / side;
    directions[1] = (after[1] - before[1]) / side;
    uint steps = isCut ? max(_BisectLevel, cell.Level + 1) - cell.Level : 0;
    float width = side * asfloat((127 - steps) << 23);
    uint checks = 2 * steps, pieces = checks + (isCut ? 2 : 0), end = pieces + (isCut ? 2 : 1);
    float2 chord = 0.0, checkOffset = 0.0;
    Piece around = (Piece)0, between = (Piece)0;
    bool isStraight = true;
    uint rays = 0;
    [loop]
    for (uint ray = 0; ray < end; ray++)
    {
        uint which = ray < steps ? 0 : 1;
        float2 place;
        Piece piece = around;
        if (ray < checks)
            place = 0.5 * (before[which] + after[which]);
        else
        {
            if (ray == checks && isCut)
            {
                float2 first = 0.5 * (before[0] + after[0]), second = 0.5 * (before[1] + after[1]);
                chord = second - first;
                float size = length(chord);
                checkOffset = size > 0.0 ? width * float2(-chord.y, chord.x) / size : 0.0;
                between = PieceBetween(first, changes[0], second, changes[1], side);
                between.Signature = signatureAfter;
                around = PieceBetween(second, changes[1], first, changes[0], side);
                around.Signature = signatureBefore;
                piece = around;
            }
            if (ray < pieces)
            {
                // Beside the middle of the chord; the piece between lies to its right.
                float2 middle = between.Corners[0] + 0.5 * chord;
                place = middle + (ray == checks ? checkOffset : -checkOffset);
            }
            else
            {
                if (ray > pieces)
                    piece = between;
                if (ray == pieces && !isStraight && canDivide)
                {
                    Divide(cell);
                    break;
                }
                place = MiddleOf(piece);
            }
        }
        TubePath tube = BeginTube(CentreOfCell(cell) + place);
        SurfacePoint at;
        rays++;
        bool goesOn = true;
        [loop]
        while (goesOn && AdvanceTube(tube, at))
        {
            uint receivers = ReceiversOf(tube, at), bounce = tube.Path.Bounces - 1;
            Sign(tube, receivers);
            [loop]
            for (uint number = 0; number < _ReceiverCount && ray >= pieces && bounce >= cell.FirstBounce; number++)
                if ((receivers >> number & 1) != 0)
                {
                    Tube currents = CurrentsAt(tube, at, number, ReceiverFrom(number, tube.Path.Ray.Origin));
                    currents.Tag |= piece.Count << 16;
                    currents.Corners01 = float4(piece.Corners[0] - place, piece.Corners[1] - place);
                    currents.Corners23 = float4(piece.Corners[2] - place, piece.Corners[3] - place);
                    currents.Corner4 = piece.Corners[4] - place;
                    if (piece.Count == 0)
                        currents.Corners01.x = side;
                    float area = isCut && isStraight
                        ? AreaError(chord, directions, width, currents.Gradient)
                        : CRUDE_ERROR * AreaOf(piece, side);
                    currents.Error = bounce >= cell.FirstDifference || !isCut ? area * MagnitudeOf(currents) : 0.0;
                    AddTube(currents);
                }
            goesOn = ScatterTube(tube, at);
        }
        if (ray < checks)
        {
            if (tube.Signature == signatureBefore)
                before[which] = place;
            else if (tube.Signature == signatureAfter)
                after[which] = place;
            else
            {
                isStraight = false;
                after[which] = place;
            }
        }
        else if (ray < pieces)
            isStraight = isStraight && tube.Signature == (ray == checks ? signatureBefore : signatureAfter);
    }
    AddUnsigned(TUBE_RAYS, rays);
}

#endif
