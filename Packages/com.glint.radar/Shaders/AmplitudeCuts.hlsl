#ifndef GLINT_AMPLITUDE_CUTS
#define GLINT_AMPLITUDE_CUTS

#include "AmplitudePath.hlsl"

// Border cells that a straight border cuts in two, and the rays that are followed in them.

// First ray of each kind: beside the centre of the border, and in the centres of the pieces, or of the whole cell.
static const uint BESIDE = 0, WITHIN = 2;

RWStructuredBuffer<Return> _BorderRays;    // BORDER_RAYS elements a border cell of the round

// A border cell, and the parts into which a straight border cuts it.
struct Cut
{
    bool IsCut, CanDivide;
    uint SignatureBefore, SignatureAfter;
    float Side, Width;                     // of the cell; of the interval of each end of the border
    float2 Centre, Chord;                  // of the border
    float2 SideBefore, SideAfter;          // along the sides of the cell that it cuts
    Piece Before, After;                   // without corners: the whole cell
};

Cut CutOf(Cell cell)
{
    Border border = BorderOf(cell);
    Cut cut = (Cut)0;
    cut.Side = SideOfCell(cell);
    cut.CanDivide = CanDivide(cell);
    cut.IsCut = border.IsCut && ((cell.Crossings.x | cell.Crossings.y) & NO_CROSSING) == 0;
    if (cut.IsCut)
    {
        cut.SignatureBefore = border.SignatureBefore;
        cut.SignatureAfter = border.SignatureAfter;
        float fraction = asfloat((127 - BisectionsOf(cell)) << 23);
        float2 first = PlaceOnSide(border, 0, (cell.Crossings.x + 0.5) * fraction, cut.Side),
            second = PlaceOnSide(border, 1, (cell.Crossings.y + 0.5) * fraction, cut.Side);
        cut.Width = cut.Side * fraction;
        cut.Chord = second - first;
        cut.Centre = first + 0.5 * cut.Chord;
        cut.SideBefore = CornerOf((border.Sides.x + 1) & 3) - CornerOf(border.Sides.x);
        cut.SideAfter = CornerOf((border.Sides.y + 1) & 3) - CornerOf(border.Sides.y);
        // To the right of the chord lies the second piece.
        cut.Before = PieceBetween(second, border.Sides.y, first, border.Sides.x, cut.Side);
        cut.After = PieceBetween(first, border.Sides.x, second, border.Sides.y, cut.Side);
    }
    return cut;
}

#endif
