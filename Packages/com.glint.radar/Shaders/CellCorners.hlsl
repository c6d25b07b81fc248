#ifndef GLINT_CELL_CORNERS
#define GLINT_CELL_CORNERS

#include "TubeBlocks.hlsl"

// What the rays through the corners of a cell have met.
struct CellCorners
{
    uint4 Elements;        // in _Corners
    uint4 Bounces;
    bool AreSame;          // all that they have met
    uint Common;           // bounces at which they have met the same
};

// Bounces at which the rays have met the same.
uint CommonBounces(CellCorners corners)
{
    uint4 bounces = corners.Bounces;
    uint common = 0, end = min(min(bounces.x, bounces.y), min(bounces.z, bounces.w));
    [loop]
    for (uint bounce = 0; bounce < end && common == bounce; bounce++)
    {
        uint signature = _Corners[corners.Elements.x + bounce].Signature;
        bool isSame = true;
        for (uint i = 1; i < 4; i++)
            isSame = isSame && _Corners[corners.Elements[i] + bounce].Signature == signature;
        common += isSame ? 1 : 0;
    }
    return common;
}

// First element of a corner of a cell of this round.
uint ElementOf(Cell cell, uint corner)
{
    return CornerOfCell(cell.Number, uint2(CornerOf(corner) > 0.0), _Round) * _MaxBounces;
}

// Signature of the path through a corner up to one of its bounces. element: its first.
uint SignatureOf(uint element, uint bounces)
{
    uint signature = NO_SIGNATURE;
    if (bounces > 0)
        signature = _Corners[element + bounces - 1].Signature;
    return signature;
}

// Of a cell of this round, which takes the signatures of their paths and their depth.
CellCorners LoadCorners(inout Cell cell)
{
    CellCorners corners = (CellCorners)0;
    corners.AreSame = true;
    [unroll]
    for (uint i = 0; i < 4; i++)
    {
        uint element = ElementOf(cell, i);
        uint bounces = BouncesOf(_Corners[element]);
        corners.Elements[i] = element;
        corners.Bounces[i] = bounces;
        cell.Signatures[i] = SignatureOf(element, bounces);
        corners.AreSame = corners.AreSame && cell.Signatures[i] == cell.Signatures[0];
    }
    corners.Common = CommonBounces(corners);
    cell.Traits = (cell.Traits & EDGE_CELL) | (any(corners.Bounces > 1) ? DEEP_CELL : 0);
    return corners;
}

// Signature of the path through a corner up to a bounce, beside those of its cell.
uint SignatureUpTo(Cell cell, uint corner, uint bounces)
{
    uint element = ElementOf(cell, corner);
    bounces = min(bounces, BouncesOf(_Corners[element]));
    if (bounces == 0)
        return NO_SIGNATURE;
    Corner hit = _Corners[element + bounces - 1];
    return IsKinked(cell) ? FineSignature(hit.Signature, FacetsOf(hit)) : hit.Signature;
}

// Signatures of the paths of the corners.
uint4 SignaturesOf(Cell cell)
{
    uint4 signatures;
    [unroll]
    for (uint i = 0; i < 4; i++)
        signatures[i] = SignatureUpTo(cell, i, _MaxBounces);
    return signatures;
}

// What the corners have met at bounces that are not summed yet: the largest of each.
struct CurrentsLeft
{
    float Strength;        // weighted
    float Thinned;         // the same times ThinningIn
    float Bent;            // Strength times the error by bent phases
    float Unweighted;      // strength alone
    float2 Missed;         // thinned, not weighted: of all currents, of the cross-polarised ones
};

CurrentsLeft LeftAt(CellCorners corners, Cell cell)
{
    float side = SideOfCell(cell);
    CurrentsLeft most = (CurrentsLeft)0;
    for (uint i = 0; i < 4; i++)
        for (uint bounce = cell.FirstBounce; bounce < corners.Bounces[i]; bounce++)
        {
            Corner corner = _Corners[corners.Elements[i] + bounce];
            float crossPart = CrossPartOf(corner), thinning = ThinningIn(cell, f16tof32(corner.Changes), side),
                bent = BentPieceError(side * side * f16tof32(corner.Changes >> 16)),
                strength = corner.Strength * WeightOf(crossPart);
            most.Strength = max(most.Strength, strength);
            most.Unweighted = max(most.Unweighted, corner.Strength);
            most.Thinned = max(most.Thinned, strength * thinning);
            most.Bent = max(most.Bent, strength * bent);
            most.Missed = max(most.Missed, corner.Strength * thinning * float2(1.0, crossPart));
        }
    return most;
}

#endif
