#ifndef GLINT_AMPLITUDE_RAYS
#define GLINT_AMPLITUDE_RAYS

#include "AmplitudeCuts.hlsl"

// Follows the rays that tell whether the border through a cell is straight, and what its pieces return. One thread a ray.

// Error of a piece's shape by a phase that is bent at its corners by one radian in all: its mean is exact.
static const float BENT_PIECE_ERROR = 0.3;

// Follows a ray of a cell, if the cell needs it: BESIDE or WITHIN, and 1 for the second piece.
Return RayOf(Cell cell, uint ray)
{
    Return result = (Return)0;
    Cut cut = CutOf(cell);
    bool isSecond = (ray & 1) != 0, isWithin = ray >= WITHIN;
    uint expected = isSecond ? cut.SignatureAfter : cut.SignatureBefore;
    if (cut.IsCut ? isWithin && expected == 0 : cut.CanDivide || ray != WITHIN)
        return result;
    Piece piece = cut.Before;
    if (isSecond)
        piece = cut.After;
    float2 position;
    if (isWithin)
        position = MiddleOf(piece);
    else
    {
        float size = length(cut.Chord);
        float2 beside = size > 0.0 ? cut.Width * float2(-cut.Chord.y, cut.Chord.x) / size : 0.0;
        position = cut.Centre + (isSecond ? -beside : beside);
    }
    result = Follow(CentreOfCell(cell) + position, NO_POINT);
    AddRays(1);
    float3 bends = abs(BendsOf(result, cut.Side));
    result.BendError = min(1.0, BENT_PIECE_ERROR * _WaveNumber * (bends.x + bends.y + bends.z)) * AreaOf(piece, cut.Side);
    return result;
}

[numthreads(GLINT_GROUP, 1, 1)]
void AmplitudeRays(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= BORDER_RAYS * CountOfList(TUBE_BORDERS, _ListCapacity.z))
        return;
    Cell cell = LoadBorder(index / BORDER_RAYS);
    _BorderRays[index] = RayOf(cell, index % BORDER_RAYS);
}

#endif
