#ifndef GLINT_TUBE_BORDERS
#define GLINT_TUBE_BORDERS

#include "TubePieces.hlsl"
#include "TubeDivisions.hlsl"
#include "Sums.hlsl"

// Cuts border cells in two along the border, and divides those whose border is not straight or whose pieces are bent too much.
// One thread a border cell.

// Where the border is across the middle of its chord, as far as rays have found it.
struct BorderBend
{
    float Side;            // on which the border lies: 1: that of SignatureBefore; -1: the other one
    float Offset;          // of the border, in widths of the intervals of its ends
};

// Rays that find it: in the middle, a width beside it, and halfway.
static const uint BEND_RAYS = 3;

// Then a ray in each piece, which is followed to sum it. The second one is followed before, to find from which bounce on it
// is bent too much: up to there the first one is summed as far as itself is not.
static const uint PIECES = 2;
static const uint ALL_BOUNCES = 0xffffffff;

// Where the next ray looks, widths from the chord.
float NextOffset(BorderBend bend, uint ray)
{
    return ray == 0 ? 0.0 : ray == 1 ? bend.Side : 0.5 * bend.Side;
}

// Takes what the ray has met; false if the border is not within a width of the chord.
bool FindBend(inout BorderBend bend, uint ray, Border border, uint signature)
{
    bool isBefore = signature == border.SignatureBefore;
    if (ray == 0)
        bend.Side = isBefore ? -1.0 : 1.0;
    // The ray in the middle is on the near side of the border.
    bool isBeyond = isBefore == (bend.Side > 0.0);
    bend.Offset = (isBeyond ? 0.25 : 0.75) * bend.Side;
    return (isBefore || signature == border.SignatureAfter) && (ray != 1 || isBeyond);
}

// Sets the polygon of a tube, about its ray.
void SetPiece(inout Tube currents, Piece piece, float2 origin)
{
    currents.Tag |= piece.Count << 16;
    currents.Corners01 = float4(piece.Corners[0] - origin, piece.Corners[1] - origin);
    currents.Corners23 = float4(piece.Corners[2] - origin, piece.Corners[3] - origin);
    currents.Corner4 = piece.Corners[4] - origin;
}

// Where the border crosses a side, in parts of it; if that was not found, the middle.
float CrossingOf(uint crossing, float fraction)
{
    return (crossing & NO_CROSSING) != 0 ? 0.5 : (crossing + 0.5) * fraction;
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= CountOfList(TUBE_BORDERS, _ListCapacity.z))
        return;
    Cell cell = LoadBorder(ElementOfList(TUBE_BORDERS, index, 1, _ListCapacity.z));
    Border border = BorderOf(cell);
    bool canDivide = cell.Level < MaxLevel(), isStraight = ((cell.Crossings.x | cell.Crossings.y) & NO_CROSSING) == 0;
    if (canDivide && !isStraight)
    {
        Divide(cell);
        return;
    }
    float side = SideOfCell(cell), fraction = asfloat((127 - BisectionsOf(cell)) << 23), width = side * fraction;
    float2 first = PlaceOnSide(border, 0, CrossingOf(cell.Crossings.x, fraction), side),
        second = PlaceOnSide(border, 1, CrossingOf(cell.Crossings.y, fraction), side), chord = second - first;
    float2 directions[2] = { CornerOf((border.Sides.x + 1) & 3) - CornerOf(border.Sides.x),
        CornerOf((border.Sides.y + 1) & 3) - CornerOf(border.Sides.y) };
    // Unit vector across the chord, to the side of SignatureBefore.
    float2 across = float2(-chord.y, chord.x) / max(length(chord), 1.0e-20);
    Cell known = cell;
    CellCorners corners = LoadCorners(known);
    BorderBend bend = (BorderBend)0;
    uint checks = isStraight ? BEND_RAYS : 0, fits = canDivide ? 1 : 0;
    // end: bounce from which on a piece is bent too much to be summed
    uint rays = 0, end = ALL_BOUNCES;
    bool isBent = false;
    [loop]
    for (uint ray = 0; ray < checks + fits + PIECES; ray++)
    {
        if (ray == checks && canDivide && !isStraight || end <= cell.FirstBounce)
            break;
        // Pieces of flat facets have no bends.
        if (ray == checks && !isBent)
            fits = 0;
        // Across the middle of the chord, to whose right the piece between lies; then in the two pieces.
        bool isCheck = ray < checks, isFit = !isCheck && ray < checks + fits, isFirst = ray == checks + fits;
        float2 shift = isStraight ? BEND_AREA * width * bend.Offset * across : 0.0;
        uint startSide = isFirst ? border.Sides.y : border.Sides.x, stopSide = isFirst ? border.Sides.x : border.Sides.y;
        Piece piece = PieceBetween((isFirst ? second : first) + shift, startSide, (isFirst ? first : second) + shift,
            stopSide, side);
        float2 place = isCheck ? first + 0.5 * chord + width * NextOffset(bend, ray) * across : MiddleOf(piece);
        TubePath tube = BeginTube(CentreOfCell(cell) + place);
        SurfacePoint at;
        rays++;
        [loop]
        while (AdvanceTube(tube, at))
        {
            uint receivers = ReceiversOf(tube, at), bounce = tube.Path.Bounces - 1;
            Sign(tube, receivers);
            if (bounce >= end)
                break;
            bool isLeft = bounce >= cell.FirstBounce;
            isBent = isBent || isLeft && BentErrorAt(tube, at, ReceiverFrom(0, tube.Path.Ray.Origin), side) > 0.0;
            if (!isCheck && isLeft)
            {
                bool findsErrors = isFit || isFirst && fits > 0;
                float strength = StrengthAt(tube, at, receivers), weight = 1.0;
                if (findsErrors)
                    weight = WeightAt(tube, at, receivers);
                Incidence incidence = IncidenceAt(tube, at);
                // The errors of all receivers, then the sums.
                uint stop = isFit ? _ReceiverCount : 2 * _ReceiverCount;
                [loop]
                for (uint turn = findsErrors ? 0 : _ReceiverCount; turn < stop; turn++)
                {
                    bool isSum = turn >= _ReceiverCount;
                    uint number = isSum ? turn - _ReceiverCount : turn;
                    if ((receivers >> number & 1) == 0 || bounce >= end)
                        continue;
                    Receiver receiver = ReceiverFrom(number, tube.Path.Ray.Origin);
                    Tube currents = CurrentsAt(incidence, tube, number, receiver);
                    currents.Bent = BentErrorAt(tube, at, receiver, side);
                    if (isStraight)
                        FitPiece(currents, piece, startSide, place, corners, tube, at, number, receiver, strength);
                    float area = AreaOf(piece, side) * ThinningIn(cell, length(currents.Gradient), side);
                    if (!isSum)
                    {
                        if (currents.Bent * area * strength * weight > CellError())
                            end = bounce;
                        continue;
                    }
                    SetPiece(currents, piece, place);
                    currents.Error = isStraight ? BentAreaError(chord, directions, width, currents.Gradient)
                        : CRUDE_ERROR * area;
                    AddTubeOf(currents, CentreOfCell(cell) + place, tube, at, receiver, side);
                }
            }
            if (!ScatterTube(tube, at))
                break;
        }
        if (isCheck)
            isStraight = isStraight && FindBend(bend, ray, border, SignatureIn(cell, tube));
    }
    // What was met before is summed.
    if (end != ALL_BOUNCES)
        cell.FirstBounce = end;
    if (canDivide && (end != ALL_BOUNCES || !isStraight))
        Divide(cell);
    AddTo(CountWord(POSE_BORDER_RAYS), rays);
}

#endif
