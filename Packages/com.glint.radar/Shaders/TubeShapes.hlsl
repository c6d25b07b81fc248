#ifndef GLINT_TUBE_SHAPES
#define GLINT_TUBE_SHAPES

#include "TubeBindings.hlsl"
#include "Geometry.hlsl"
#include "Trigonometry.hlsl"

// The cells of the grid, the borders through them, and the pieces into which borders cut them.

// Corners of a cell in order around it, from its centre.
float2 CornerOf(uint corner)
{
    return float2(corner == 1 || corner == 2 ? 0.5 : -0.5, corner >= 2 ? 0.5 : -0.5);
}

float SideOfCell(Cell cell)
{
    return asfloat((127 - cell.Level) << 23);
}

float2 CentreOfCell(Cell cell)
{
    return (float2(cell.Position) + 0.5) * SideOfCell(cell);
}

// Of a cell: the error that it may have, p.C times area in m2, or a phasor's times area in base cells; the level at which it is
// not divided; the bisections of the sides of a base cell towards a border, at most.
float CellError()
{
    return _Poses[s_pose].CellError;
}

uint MaxLevel()
{
    return _Poses[s_pose].MaxLevel;
}

uint MaxBisections()
{
    return _Poses[s_pose].MaxBisections;
}

// Error of a cell that is summed as a whole although its corners do not see the same, as a fraction of its area: of a straight
// border anywhere in it the root mean square is 0.22 to 0.29 by its direction.
static const float CRUDE_ERROR = 0.25;

// Factor by which a phase gradient, m a base cell, makes the integral over part of a square of a side less than its area.
float Thinning(float gradient, float side)
{
    return min(1.0, 3.0 / max(_WaveNumber * gradient * side, 1.0e-6));
}

// Largest phase over a cell along an edge of slow phase, rad, that is summed as a point. A point errs to both sides, by all that
// it is; a square errs to one side, by ThinningAlongEdge.
static const float MAX_POINT_PHASE = 100.0;

// The same along an edge, whose parts in neighbouring cells do not cancel. Of a strip across which the phase runs fast, its two
// edges are left.
float ThinningAlongEdge(float gradient, float side)
{
    float phase = _WaveNumber * gradient * side;
    return phase > MAX_POINT_PHASE ? 2.0 / phase : 1.0;
}

// The same in a cell.
float ThinningIn(Cell cell, float gradient, float side)
{
    return IsAlongEdge(cell) ? ThinningAlongEdge(gradient, side) : Thinning(gradient, side);
}

// Whether a cell may be summed as a whole.
bool IsSmall(Cell cell)
{
    float side = SideOfCell(cell);
    return CRUDE_ERROR * side * side * cell.Thinned <= CellError();
}

// Relative error of a piece whose bends are known, from that of one that is taken as linear.
float BentPieceError(float bent)
{
    return min(bent, min(1.0, 0.2 * bent * bent));
}

// Notes whether bent phases make the error of a piece too large. bent: the largest one, as a fraction of its area, times the
// strength.
void SetBent(inout Cell cell, float bent)
{
    float side = SideOfCell(cell);
    if (side * side * bent > CellError())
        cell.Traits |= BENT_CELL;
}

bool CanDivide(Cell cell)
{
    return cell.Level < MaxLevel() && !IsSmall(cell);
}

// Lists a cell among those through which a border runs.
void ListBorder(Cell cell)
{
    uint border = AddToList(TUBE_BORDERS, IsDeep(cell), 1, _ListCapacity.z);
    if (border < _ListCapacity.z)
        _Borders[border] = cell;
}

// The border through a cell, which cuts two of its sides.
struct Border
{
    bool IsCut;            // the corners see two things, and the border separates them once
    uint2 Sides;           // first corner of each side cut
    uint SignatureBefore;  // at the first corner of the first side
    uint SignatureAfter;   // at its second corner
};

// Bits of Cell.Crossings, which is the number of intervals before that of the border, a bit a bisection.
static const uint NO_CROSSING = 0x80000000;

Border BorderOf(Cell cell)
{
    Border border = (Border)0;
    uint first = cell.Signatures.x, other = first, changes = 0;
    bool areTwo = true;
    [unroll]
    for (uint corner = 0; corner < 4; corner++)
    {
        uint signature = cell.Signatures[corner];
        if (signature != first)
        {
            areTwo = areTwo && (other == first || other == signature);
            other = signature;
        }
        if (signature != cell.Signatures[(corner + 1) & 3])
        {
            if (changes == 0)
            {
                border.Sides.x = corner;
                border.SignatureBefore = signature;
                border.SignatureAfter = cell.Signatures[(corner + 1) & 3];
            }
            else
                border.Sides.y = corner;
            changes++;
        }
    }
    border.IsCut = areTwo && changes == 2 && !IsSmall(cell) && (cell.Traits & BENT_CELL) == 0;
    return border;
}

// What BisectionsOf halves, as a fraction of a cell's area: of a cross section a ray across the middle halves it once.
#ifdef GLINT_AMPLITUDE
static const float FIRST_ERROR = 1.6;
#else
static const float FIRST_ERROR = 0.8;
#endif

// Bisections of the sides of a cell, each of which halves the error of its border (AreaError). A border is found to an
// eighth of a cell's error: two rays more, where a division takes twenty.
uint BisectionsOf(Cell cell)
{
    float side = SideOfCell(cell), halvings = ceil(log2(FIRST_ERROR * side * side * cell.Strength / CellError()));
    return (uint)clamp(halvings, 1.0, max(2.0, (float)MaxBisections() - 2.0 * cell.Level));
}

// A place on a side, from the centre of the cell, at a fraction of its length from its end at the first signature.
float2 PlaceOnSide(Border border, uint which, float fraction, float side)
{
    uint corner = which == 0 ? border.Sides.x : border.Sides.y;
    float2 start = CornerOf(corner), end = CornerOf((corner + 1) & 3);
    return side * (which == 0 ? lerp(start, end, fraction) : lerp(end, start, fraction));
}

static const float BENT_BORDER = 1.4;

// Area between a bent border and its chord, times their distance in the middle: that of a parabola. A chord that is moved by
// as much has the same area on either side.
static const float BEND_AREA = 2.0 / 3.0;

// A convex piece of a cell: corners from its centre, in base cells.
struct Piece
{
    float2 Corners[5];
    uint Count;            // 0: the whole cell
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

// Area by which the border may be off, for a phase gradient: its ends lie within an interval of this width on the sides
// of the cell. Neighbouring cells share the ends, so that the error along the border is a sum of hat functions. Between
// the ends the border may bend by as much again (BENT_BORDER).
float AreaError(float2 chord, float2 sides[2], float width, float2 gradient)
{
    float x = 0.5 * _WaveNumber * dot(gradient, chord);
    float hat = abs(x) < 0.01 ? 1.0 : PhasorOf(x).y / x;
    float first = Cross2(chord, sides[0]), second = Cross2(chord, sides[1]);
    return BENT_BORDER * sqrt((first * first + second * second) / 24.0) * width * hat * hat;
}

// Area by which a border may be off whose middle was found too, to an interval of half the width: a parabola through three
// places. Those at its ends count a third of what they do on a chord.
float BentAreaError(float2 chord, float2 sides[2], float width, float2 gradient)
{
    float x = 0.5 * _WaveNumber * dot(gradient, chord);
    float hat = abs(x) < 0.01 ? 1.0 : PhasorOf(x).y / x;
    float first = Cross2(chord, sides[0]), second = Cross2(chord, sides[1]);
    return sqrt((first * first + second * second) / 216.0 + dot(chord, chord) / 108.0) * width * hat * hat;
}

// A phase bent by this at the corners of a square, its bends added up, cannot be expanded, rad.
static const float MAX_BENDS = 1.5;

// Relative error of a square's integral by bends of a size, rad (SquareIntegral): their third power is left out.
float BentError(float size)
{
    return min(1.0, 0.05 * size * size * size);
}

#endif
