#ifndef GLINT_TUBE_PIECES
#define GLINT_TUBE_PIECES

#include "CellCorners.hlsl"

// How phase and strength change over the pieces into which a border cuts a cell, from the ray within each and the rays
// through those corners of the cell that belong to it.

// Largest phase by the bends of a piece that can be expanded, rad; its relative error for a radian (first order), and that of a
// piece whose phase is off by one at a corner.
static const float MAX_PIECE_BEND = 0.7, PIECE_BEND_ERROR = 0.05, CORNER_ERROR = 0.25;

// Largest slope of a strength as a float16: that over the smallest cells.
static const float MAX_SLOPE = 65504.0;

float HalfSquare(float3 bends, float2 x)
{
    return 0.5 * (bends.x * x.x * x.x + bends.y * x.y * x.y) + bends.z * x.x * x.y;
}

// Changes bends as little as makes the gradient at an offset what it is there (Powell's symmetric update).
void FitBends(inout float3 bends, float2 offset, float2 gradient)
{
    float2 missing = gradient - float2(bends.x * offset.x + bends.z * offset.y, bends.z * offset.x + bends.y * offset.y);
    float inverse = 1.0 / dot(offset, offset), both = inverse * inverse * dot(offset, missing);
    bends += inverse * float3(2.0 * missing * offset, missing.x * offset.y + missing.y * offset.x)
        - both * float3(offset * offset, offset.x * offset.y);
}

// Sets the bends of a piece, the slope of its strength, and how wrong it is, relatively. Without a corner on the facets of its
// ray the bends are those of its facet, and what the corners differ by is an error. Without any it is taken as plane, with the
// error of that. piece, origin (of the ray): from the middle of the cell; firstSide: of the cell, which the piece
// begins on; strength: of the ray.
void FitPiece(inout Tube currents, Piece piece, uint firstSide, float2 origin, CellCorners corners, TubePath tube,
    SurfacePoint at, uint index, Receiver receiver, float strength)
{
    float3 curved = PhaseBends(tube, at, receiver), bends = curved;
    if (all(curved == 0.0))
        return;
    uint bounce = tube.Path.Bounces - 1, known = 0, seen = 0;
    float2 slope = 0.0;
    float missed = 0.0, changed = 0.0;
    // Twice, since a corner changes what was right for the one before; then what is left is noted.
    [loop]
    for (uint step = 0; step < 3; step++)
        [loop]
        for (uint i = 1; i + 1 < piece.Count; i++)
        {
            uint number = (firstSide + i) & 3;
            if (bounce >= corners.Bounces[number])
                continue;
            Corner corner = _Corners[corners.Elements[number] + bounce];
            if (corner.Signature != tube.Signature)
                continue;
            if (step < 2 && FacetsOf(corner) != FacetsOf(tube))
                continue;
            Receiver near = NearFrom(index, corner.Position);
            float2 offset = piece.Corners[i] - origin;
            float change = corner.Strength / max(strength, MIN_CURRENTS) - 1.0 - dot(slope, offset);
            if (step < 2)
            {
                float2 gradient = float2(PhaseOf(StepSeenFrom(near, corner.AlongU), receiver),
                    PhaseOf(StepSeenFrom(near, corner.AlongV), receiver));
                FitBends(bends, offset, gradient - currents.Gradient);
                slope += change / dot(offset, offset) * offset;
                known++;
                continue;
            }
            seen++;
            missed = max(missed, abs(PhaseOf(SeenFrom(near, corner.Position), receiver) - currents.Phase
                - dot(currents.Gradient, offset) - HalfSquare(bends, offset)));
            changed = max(changed, abs(change));
        }
    float size = 0.0, most = 0.0, guessed = 0.0;
    [loop]
    for (uint j = 0; j < piece.Count; j++)
    {
        float2 offset = piece.Corners[j] - origin;
        size = max(size, _WaveNumber * abs(HalfSquare(bends, offset)));
        most = max(most, abs(dot(slope, offset)));
        guessed = max(guessed, abs(HalfSquare(bends - curved, offset)));
    }
    // Compilers may take a comparison with NaN for either.
    if (seen == 0 || size > MAX_PIECE_BEND || most > MAX_PIECE_BEND || IsNaN(dot(bends, 1.0)) || IsNaN(slope.x + slope.y))
        return;
    currents.Bends = bends;
    slope = clamp(slope, -MAX_SLOPE, MAX_SLOPE);
    currents.Slope = f32tof16(slope.x) | f32tof16(slope.y) << 16;
    // One corner tells nothing of the bend across its offset.
    if (known == 2)
        missed = max(missed, guessed);
    float error = PIECE_BEND_ERROR * size * size + CORNER_ERROR * (_WaveNumber * missed + changed);
    currents.Bent = IsNaN(error) ? 1.0 : min(1.0, error);
}

#endif
