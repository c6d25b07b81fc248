#ifndef GLINT_TUBE_BORDERS
#define GLINT_TUBE_BORDERS

#include "TubeGrid.hlsl"
#include "Sums.hlsl"

// Cuts border cells in two along the border, or divides them into four cells of the next round. One thread a border cell.

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

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= min(_Sums[TUBE_BORDERS], _ListCapacity.z))
        return;
    Cell cell = _Borders[index];
    Border border = BorderOf(cell);
    float side = SideOfCell(cell);
    bool canDivide = cell.Level < _MaxLevel && !IsSmall(cell);
    bool isStraight = ((cell.Crossings.x | cell.Crossings.y) & NO_CROSSING) == 0;
    if (canDivide && (!border.IsCut || !isStraight))
    {
        Divide(cell);
        return;
    }
    bool isCut = border.IsCut && isStraight;
    float fraction = asfloat((127 - BisectionsOf(cell)) << 23), width = side * fraction;
    float2 first = PlaceOnSide(border, 0, (cell.Crossings.x + 0.5) * fraction, side),
        second = PlaceOnSide(border, 1, (cell.Crossings.y + 0.5) * fraction, side), chord = second - first;
    float2 directions[2] = { CornerOf((border.Sides.x + 1) & 3) - CornerOf(border.Sides.x),
        CornerOf((border.Sides.y + 1) & 3) - CornerOf(border.Sides.y) };
    float size = length(chord);
    float2 checkOffset = size > 0.0 ? width * float2(-chord.y, chord.x) / size : 0.0;
    Piece around = (Piece)0, between = (Piece)0;
    if (isCut)
    {
        between = PieceBetween(first, border.Sides.x, second, border.Sides.y, side);
        around = PieceBetween(second, border.Sides.y, first, border.Sides.x, side);
    }
    uint checks = isCut ? 2 : 0, end = isCut ? 4 : 1;
    uint rays = 0;
    [loop]
    for (uint ray = 0; ray < end; ray++)
    {
        if (ray == checks && !isStraight && canDivide)
            break;
        // Beside the middle of the chord, to whose right the piece between lies; then in the two pieces.
        Piece piece = around;
        if (ray > checks)
            piece = between;
        float2 place = MiddleOf(piece);
        if (ray < checks)
            place = first + 0.5 * chord + (ray == 0 ? checkOffset : -checkOffset);
        TubePath tube = BeginTube(CentreOfCell(cell) + place);
        SurfacePoint at;
        rays++;
        [loop]
        while (AdvanceTube(tube, at))
        {
            uint receivers = ReceiversOf(tube, at), bounce = tube.Path.Bounces - 1;
            Sign(tube, receivers);
            [loop]
            for (uint number = 0; number < _ReceiverCount && ray >= checks && bounce >= cell.FirstBounce; number++)
                if ((receivers >> number & 1) != 0)
                {
                    Receiver receiver = ReceiverFrom(number, tube.Path.Ray.Origin);
                    Tube currents = CurrentsAt(tube, at, number, receiver);
                    currents.Tag |= piece.Count << 16;
                    currents.Corners01 = float4(piece.Corners[0] - place, piece.Corners[1] - place);
                    currents.Corners23 = float4(piece.Corners[2] - place, piece.Corners[3] - place);
                    currents.Corner4 = piece.Corners[4] - place;
                    if (piece.Count == 0)
                    {
                        currents.Corners01 = float4(side, 0.0, 0.0, 0.0);
                        currents.Corners23 = float4(1.0, 0.0, 0.0, 0.0);
                    }
                    float area = isCut && isStraight
                        ? AreaError(chord, directions, width, currents.Gradient)
                        : CRUDE_ERROR * AreaOf(piece, side) * Thinning(currents.Gradient, side);
                    currents.Error = area * MagnitudeOf(currents);
                    currents.Bent = BentErrorAt(tube, at, receiver, side);
                    AddTube(currents, at.Part, RateTo(receiver, tube, at));
                }
            if (!ScatterTube(tube, at))
                break;
        }
        if (ray < checks)
            isStraight = isStraight && tube.Signature == (ray == 0 ? border.SignatureBefore : border.SignatureAfter);
    }
    if (!isStraight && canDivide)
        Divide(cell);
    AddTo(TUBE_BORDER_RAYS, rays);
}

#endif
