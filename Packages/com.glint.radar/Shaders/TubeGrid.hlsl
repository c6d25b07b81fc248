#ifndef GLINT_TUBE_GRID
#define GLINT_TUBE_GRID

#include "PhysicalOptics.hlsl"

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

// Who receives what is painted at a hit: a bit each.
uint ReceiversOf(TubePath tube, SurfacePoint at)
{
    uint receivers = 0;
    [loop]
    for (uint index = 0; index < _ReceiverCount; index++)
        if (Radiates(tube, at, ReceiverFrom(index, tube.Path.Ray.Origin)))
            receivers |= 1u << index;
    return receivers;
}

// Relative error of a piece of a cell by the curvatures of surface and wave at a hit: its phase is taken as linear.
float BentErrorAt(TubePath tube, SurfacePoint at, Receiver receiver, float side)
{
    float3 d = tube.Path.Ray.Direction;
    float surface = (1.0 - dot(receiver.Direction, d)) / dot(at.Normal, d);
    float bendU = surface * dot(at.NormalU, tube.PlaceU) - dot(tube.DirectionU, tube.PlaceU),
        bendV = surface * dot(at.NormalV, tube.PlaceV) - dot(tube.DirectionV, tube.PlaceV);
    return min(1.0, 0.06 * _WaveNumber * side * side * (abs(bendU) + abs(bendV)));
}

// Error of a cell that is summed as a whole although its corners do not see the same, as a fraction of its area.
static const float CRUDE_ERROR = 0.3;

// Whether a cell may be summed as a whole.
bool IsSmall(Cell cell)
{
    float side = SideOfCell(cell);
    return CRUDE_ERROR * side * side * cell.Strength <= _CellError;
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
    float side = SideOfCell(cell);
    border.IsCut = areTwo && changes == 2 && !IsSmall(cell) && side * side * cell.Bent <= _CellError;
    return border;
}

// Bisections of the sides of a cell, each of which halves the error of its border (AreaError).
uint BisectionsOf(Cell cell)
{
    float side = SideOfCell(cell), halvings = ceil(log2(0.4 * side * side * cell.Strength / _CellError));
    return (uint)clamp(halvings, 1.0, max(2.0, (float)_MaxBisections - 2.0 * cell.Level));
}

// A place on a side, from the centre of the cell, at a fraction of its length from its end at the first signature.
float2 PlaceOnSide(Border border, uint which, float fraction, float side)
{
    uint corner = which == 0 ? border.Sides.x : border.Sides.y;
    float2 start = CornerOf(corner), end = CornerOf((corner + 1) & 3);
    return side * (which == 0 ? lerp(start, end, fraction) : lerp(end, start, fraction));
}

#endif
