#ifndef GLINT_TUBE_BORDERS
#define GLINT_TUBE_BORDERS

#include "TubePieces.hlsl"
#include "TubeDivisions.hlsl"
#include "Sums.hlsl"

// Cuts border cells in two along the border, sums small ones as a whole, and divides those whose border is not straight or
// whose pieces are bent too much. One thread a border cell.

static const uint NO_BORDER = 0xffffffff;

// Element of _Borders: those that are cut fill the first groups.
uint BorderOfThread(uint index)
{
    uint capacity = _ListCapacity.z, cut = CountOfList(TUBE_BORDERS, capacity),
        cutThreads = (cut + GLINT_GROUP - 1) / GLINT_GROUP * GLINT_GROUP;
    if (index < cutThreads)
        return index < cut ? ElementOfList(TUBE_BORDERS, index, 1, capacity) : NO_BORDER;
    uint uncut = index - cutThreads;
    return uncut < CountOfList(TUBE_UNCUT, capacity) ? capacity + ElementOfList(TUBE_UNCUT, uncut, 1, capacity) : NO_BORDER;
}

// Where the border is across the middle of its chord, as far as rays have found it.
struct BorderBend
{
    float Side;            // on which the border lies: 1: that of SignatureBefore; -1: the other one
    float Offset;          // of the border, in widths of the intervals of its ends
};

// Rays that find it: in the middle, a width beside it, and halfway.
static const uint BEND_RAYS = 3;

// Then a ray in each piece, which is followed to find its error, and again to sum it.
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

// The error of a cell that is summed as a whole is that of its corners. If the ray through its middle meets currents
// whose error is above this many times the error that a cell may have, it is divided after all: its error would be the
// same in each attempt.
static const float MAX_HIDDEN_ERROR = 8.0;

// Whether the middle of a cell that is summed as a whole answers far more strongly than its corners.
bool HidesCurrents(TubePath tube, SurfacePoint at, uint receivers, float side)
{
    float strength = Thinning(SteepnessAt(tube, receivers), side) * StrengthAt(tube, at, receivers);
    return CRUDE_ERROR * side * side * strength * WeightAt(tube, at, receivers)
        > MAX_HIDDEN_ERROR * CellError();
}

// Adds the error of a cell whose corners see something, and its centre nothing: what is left out of the sum. A square
// without strength radiates nothing.
void AddMissed(Cell cell)
{
    float side = SideOfCell(cell);
    Tube missed = (Tube)0;
    // Of a thin part between corners that see nothing only the weighted strength is known.
    float2 strengths = LeftAt(LoadCorners(cell), cell).Missed;
    if (strengths.x == 0.0)
        strengths = cell.Thinned * float2(1.0, 1.0 / _Poses[s_pose].CrossWeight);
    missed.CoPolar.x = strengths.x;
    missed.CrossPolar.x = strengths.y;
    missed.Corners01.x = side;
    missed.Error = CRUDE_ERROR * side * side;
    for (uint number = 0; number < _ReceiverCount; number++)
    {
        missed.Tag = SlotOfAll(number) | (cell.FirstBounce + 1) << 8;
        AddTube(missed, 0, 0.0);
    }
}

// Sets the polygon of a tube, about its ray.
void SetPiece(inout Tube currents, Piece piece, float2 origin, float side)
{
    if (piece.Count == 0)
    {
        currents.Corners01 = float4(side, 0.0, 0.0, 0.0);
        currents.Corners23 = float4(1.0, 0.0, 0.0, 0.0);
        return;
    }
    currents.Tag |= piece.Count << 16;
    currents.Corners01 = float4(piece.Corners[0] - origin, piece.Corners[1] - origin);
    currents.Corners23 = float4(piece.Corners[2] - origin, piece.Corners[3] - origin);
    currents.Corner4 = piece.Corners[4] - origin;
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = BorderOfThread(IndexOf(group, thread));
    if (index == NO_BORDER)
        return;
    Cell cell = LoadBorder(index);
    Border border = BorderOf(cell);
    float side = SideOfCell(cell);
    bool canDivide = CanDivide(cell);
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
    // Unit vector across the chord, to the side of SignatureBefore.
    float2 across = float2(-chord.y, chord.x) / max(length(chord), 1.0e-20);
    BorderBend bend = (BorderBend)0;
    uint checks = isCut ? BEND_RAYS : 0, fits = isCut && canDivide ? PIECES : 0;
    CellCorners corners = (CellCorners)0;
    if (isCut)
    {
        Cell known = cell;
        corners = LoadCorners(known);
    }
    // end: bounce from which on a piece is bent too much to be summed
    uint rays = 0, end = ALL_BOUNCES;
    bool isSummed = false, isHidden = false, isBent = false;
    [loop]
    for (uint ray = 0; ray < checks + fits + (isCut ? PIECES : 1); ray++)
    {
        if (ray == checks && !isStraight && canDivide)
            break;
        // Pieces of flat facets have no bends.
        if (ray == checks && !isBent)
            fits = 0;
        // Across the middle of the chord, to whose right the piece between lies; then in the two pieces.
        bool isFit = ray >= checks && ray < checks + fits, isFirst = (ray - checks & 1) == 0;
        float2 shift = isStraight ? BEND_AREA * width * bend.Offset * across : 0.0;
        Piece piece = (Piece)0;
        float2 start = isFirst ? second : first, stop = isFirst ? first : second;
        uint startSide = isFirst ? border.Sides.y : border.Sides.x, stopSide = isFirst ? border.Sides.x : border.Sides.y;
        if (isCut && ray >= checks)
            piece = PieceBetween(start + shift, startSide, stop + shift, stopSide, side);
        float2 place = MiddleOf(piece);
        if (ray < checks)
            place = first + 0.5 * chord + width * NextOffset(bend, ray) * across;
        TubePath tube = BeginTube(CentreOfCell(cell) + place);
        SurfacePoint at;
        rays++;
        [loop]
        while (AdvanceTube(tube, at))
        {
            uint receivers = ReceiversOf(tube, at), bounce = tube.Path.Bounces - 1;
            Sign(tube, receivers);
            if (!isCut && bounce >= cell.FirstBounce && cell.Level < MaxLevel() && HidesCurrents(tube, at, receivers, side))
            {
                // What it has met before is summed for the whole cell.
                cell.FirstBounce = bounce;
                isHidden = true;
                break;
            }
            if (bounce >= end)
                break;
            bool isLeft = bounce >= cell.FirstBounce;
            isBent = isBent || isLeft && BentErrorAt(tube, at, ReceiverFrom(0, tube.Path.Ray.Origin), side) > 0.0;
            float strength = StrengthAt(tube, at, receivers);
            [loop]
            for (uint number = 0; number < _ReceiverCount && ray >= checks && isLeft; number++)
                if ((receivers >> number & 1) != 0)
                {
                    Receiver receiver = ReceiverFrom(number, tube.Path.Ray.Origin);
                    Tube currents = (Tube)0;
                    if (!isFit)
                        currents = CurrentsAt(tube, at, number, receiver);
                    currents.Gradient = PhaseSlope(tube, receiver);
                    currents.Phase = receiver.Phase - tube.Path.RelativeLength;
                    currents.Bent = BentErrorAt(tube, at, receiver, side);
                    if (isCut && isStraight)
                        FitPiece(currents, piece, startSide, place, corners, tube, at, number, receiver,
                            strength);
                    if (isFit)
                    {
                        float area = AreaOf(piece, side) * Thinning(length(currents.Gradient), side);
                        if (currents.Bent * area * strength * WeightAt(tube, at, receivers) > CellError())
                            end = bounce;
                        continue;
                    }
                    SetPiece(currents, piece, place, side);
                    currents.Error = isCut && isStraight
                        ? BentAreaError(chord, directions, width, currents.Gradient)
                        : CRUDE_ERROR * AreaOf(piece, side) * Thinning(length(currents.Gradient), side);
                    AddChangingTube(currents, tube, at, number, receiver, receivers, strength, side,
                        isCut ? 1.0 : 0.5 * side);
                    isSummed = true;
                }
            if (!ScatterTube(tube, at))
                break;
        }
        if (ray < checks)
            isStraight = isStraight && FindBend(bend, ray, border, SignatureIn(cell, tube));
    }
    // What was met before is summed.
    if (end != ALL_BOUNCES)
        cell.FirstBounce = end;
    if (end != ALL_BOUNCES || isHidden || !isStraight && canDivide)
        Divide(cell);
    else if (!isCut && !isSummed)
        AddMissed(cell);
    AddTo(CountWord(POSE_BORDER_RAYS), rays);
}

#endif
