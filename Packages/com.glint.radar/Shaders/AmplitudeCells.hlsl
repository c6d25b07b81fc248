#ifndef GLINT_AMPLITUDE_CELLS
#define GLINT_AMPLITUDE_CELLS

#include "AmplitudePath.hlsl"

// Adds the cells whose rays all take the same path, as one tube each; leaves out those that receive nothing; lists the
// others as borders. One thread a cell.

// Cells of which no corner is received, and whose corners have bounced differently often, are divided up to this level:
// what is seen between them may be anything.
static const uint OUTLINE_LEVEL = 1;

// Part by which the landings of the corners may be exceeded between them.
static const float LANDING_MARGIN = 0.25, SAME_LANDING_MARGIN = 0.05;

// A cell of the round, whose pose becomes that of the thread. Signatures are the points of its corners.
Cell LoadCell(uint index)
{
    Cell cell;
    if (_Round == 0)
    {
        cell = LoadBaseCell(index);
        cell.Signatures = uint4(CornerOfBaseCell(index, uint2(0, 0)), CornerOfBaseCell(index, uint2(1, 0)),
            CornerOfBaseCell(index, uint2(1, 1)), CornerOfBaseCell(index, uint2(0, 1)));
    }
    else
        cell = _TubeCells[index];
    EnterPose(cell.Pose, index);
    return cell;
}

// Whether a cell of which no corner is received may hide a part that is. Corners on the same planes tell where the others
// land; those on several planes at least between what they may land.
bool MayReceive(uint4 points, float side, uint level)
{
    uint planes = _Points[points.x * _PointWords + 1];
    bool isSame = true;
    for (uint i = 1; i < 4; i++)
        isSame = isSame && _Points[points[i] * _PointWords + 1] == planes;
    [loop]
    for (uint bounce = 0; bounce < _MaxBounces; bounce++)
    {
        float2 lower = MAX_LANDING, upper = -MAX_LANDING;
        uint count = 0;
        bool isInside = false, isBeside = false;
        for (uint corner = 0; corner < 4; corner++)
        {
            uint word = points[corner] * _PointWords + POINT_LANDINGS + 2 * bounce, packed = _Points[word];
            if (packed == NO_LANDING)
                continue;
            float2 position = float2(f16tof32(packed), f16tof32(packed >> 16));
            float largest = max(abs(position.x), abs(position.y));
            lower = min(lower, position);
            upper = max(upper, position);
            isInside = isInside || largest <= 1.0;
            isBeside = isBeside || largest <= 1.0 + side * asfloat(_Points[word + 1]);
            count++;
        }
        if (count == 0)
            return false;
        float2 margin = (isSame ? SAME_LANDING_MARGIN : LANDING_MARGIN) * (upper - lower);
        bool isBetween = all(lower - margin <= 1.0) && all(upper + margin >= -1.0);
        // A corner inside whose ray meets the same planes as the others is hidden by them.
        if (isSame ? isBetween && !isInside : isBetween || isBeside)
            return true;
        if (count < 4 && level < OUTLINE_LEVEL)
            return true;
    }
    return false;
}

// Whether a neighbour has found something on a side of the cell.
bool IsRevealed(Cell cell)
{
    if (cell.Level >= REVEALED_LEVEL)
        return false;
    uint parts = REVEALED_PARTS >> cell.Level;
    uint2 base = cell.Position >> cell.Level, first = (cell.Position - (base << cell.Level)) * parts;
    uint word = FirstRevealed(base), row = (0xffffffff >> (32 - parts)) << first.x, bits = 0;
    for (uint y = first.y; y < first.y + parts; y++)
        bits |= _Revealed[word + y] & row;
    return bits != 0;
}

// Whether something is received through the new points of a cell that was divided of which no corner is. cell: the first one of
// its parts.
bool IsFoundAmongNothing(Cell cell, uint block)
{
    uint corners = 0, points = 0;
    for (uint corner = 0; corner < BLOCK_CELLS; corner++)
        corners |= SignatureOfCorner(block, corner);
    for (uint i = 0; i < NEW_CORNERS; i++)
        points |= _Points[(FirstNewPoint(cell) + i) * _PointWords];
    return corners == 0 && points != 0;
}

[numthreads(GLINT_GROUP, 1, 1)]
void AmplitudeCells(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= CellCount())
        return;
    Cell cell = LoadCell(index);
    // A ray is a phasor of one.
    cell.Strength = 1.0;
    float side = SideOfCell(cell);
    // What the last level finds in cells of which no corner is received, the next would find again, in parts as large.
    if (_Round > 0 && index % BLOCK_CELLS == 0 && cell.Level == _AmplitudePoses[s_pose].EmptyLevel
        && IsFoundAmongNothing(cell, index / BLOCK_CELLS))
    {
        float error = CRUDE_ERROR * side * side;
        AddUnsigned(SumWord(SUM_ERROR), (uint)(_UnitsPerSquareMetre * error * error));
    }
    uint signature = _Points[cell.Signatures.x * _PointWords];
    bool isSame = true;
    for (uint i = 1; i < 4; i++)
        isSame = isSame && _Points[cell.Signatures[i] * _PointWords] == signature;
    if (isSame && signature == 0)
    {
        if (cell.Level >= _AmplitudePoses[s_pose].EmptyLevel || !MayReceive(cell.Signatures, side, cell.Level) && !IsRevealed(cell))
            return;
        cell.Strength = MISS;
    }
    else if (IsRevealed(cell))
        cell.Strength = MISS;
    else if (isSame)
    {
        Return ray = Follow(CentreOfCell(cell), NO_POINT);
        AddRays(1);
        float3 bends = BendsOf(ray, side);
        float size = _WaveNumber * (abs(bends.x) + abs(bends.y) + abs(bends.z)), error = BentError(size);
        bool isTube = ray.Signature == signature && (error * side * side <= CellError() || cell.Level >= MaxLevel());
        if (isTube)
        {
            Tube tube = TubeOf(ray);
            bool isBent = size < MAX_BENDS;
            // The square is about its centre, the phase of the bends about the corners.
            tube.Phase += (bends.x + bends.y) * (isBent ? 1.0 : 1.0 / 3.0);
            tube.Corners01 = float4(side, isBent ? bends : (float3)0);
            tube.Corners23 = float4(1.0, 0.0, 0.0, 0.0);
            tube.Bent = error;
            AddTube(tube);
            return;
        }
        SetBent(cell, MISS);
    }
    cell.Thinned = cell.Strength;
    ListBorder(cell);
}

#endif
