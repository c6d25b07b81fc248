#ifndef GLINT_TUBE_CENTRES
#define GLINT_TUBE_CENTRES

#include "Sums.hlsl"
#include "CellCorners.hlsl"
#include "TubeDivisions.hlsl"
#include "RevealedCells.hlsl"

// Sums the cells whose corners see the same, as one tube each bounce, and divides or lists the others as borders. One thread
// a cell, which follows the ray through its centre.

// How much more strongly an edge of slow phase counts than it answers: the errors of the cells along it may have one sign.
static const float EDGE_STRENGTH = 8.0;

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= CountOfList(TUBE_CENTRES, _ListCapacity.w))
        return;
    uint centre = ElementOfList(TUBE_CENTRES, index, 1, _ListCapacity.w);
    Cell cell = LoadCell(_Centres[CENTRE_WORDS * centre]);
    CellCorners corners = LoadCorners(cell);
    float thin = asfloat(_Centres[CENTRE_WORDS * centre + 1]), edge = asfloat(_Centres[CENTRE_WORDS * centre + 2]),
        thinLater = asfloat(_Centres[CENTRE_WORDS * centre + 3]);
    cell.Traits |= (edge > 0.0 ? EDGE_CELL : 0) | _Centres[CENTRE_WORDS * centre + 4] << THIN_PART_SHIFT;
    // What reaches into the cell between its corners may take the place of any bounce of theirs.
    bool isRevealed = IsRevealed(cell);
    uint common = thin > 0.0 || isRevealed ? 0 : thinLater > 0.0 ? min(corners.Common, 1) : corners.Common;
    thin = max(thin, thinLater);
    float3 left = thin;      // as Strength, Thinned and Bent of a cell
    if (common > cell.FirstBounce)
    {
        uint firstBounce = cell.FirstBounce;
        float side = SideOfCell(cell);
        bool canDivide = cell.Level < MaxLevel();
        TubePath tube = BeginTube(CentreOfCell(cell));
        SurfacePoint at;
        [loop]
        while (AdvanceTube(tube, at))
        {
            uint bounce = tube.Path.Bounces - 1, receivers = ReceiversOf(tube, at);
            Sign(tube, receivers);
            float strength = StrengthAt(tube, at, receivers), weight = WeightAt(tube, at, receivers);
            bool goesOn = bounce < common
                && _Corners[corners.Elements.x + min(bounce, common - 1)].Signature == tube.Signature;
            corners.AreSame = corners.AreSame && goesOn;
            if (goesOn && bounce >= firstBounce)
            {
                goesOn = AddSquare(corners.Elements + bounce, CentreOfCell(cell), tube, at, receivers, strength, weight, side,
                    canDivide);
                cell.FirstBounce = goesOn ? bounce + 1 : cell.FirstBounce;
            }
            if (!goesOn)
            {
                left = max(left, strength * weight * float3(1.0, ThinningIn(cell, SteepnessAt(tube, receivers), side),
                    BentPieceError(side * side * BentOf(tube, at, ReceiverFrom(0, tube.Path.Ray.Origin)))));
                break;
            }
            if (!ScatterTube(tube, at))
                break;
        }
        corners.AreSame = corners.AreSame && tube.Path.Bounces >= common;
        AddTo(CountWord(POSE_RAYS), 1);
    }
    if (thin == 0.0 && corners.AreSame && cell.FirstBounce >= common && !isRevealed)
        return;
    CurrentsLeft atCorners = LeftAt(corners, cell);
    cell.Strength = max(left.x, atCorners.Strength);
    cell.Thinned = isRevealed ? MISS : max(EDGE_STRENGTH * edge, max(left.y, atCorners.Thinned));
    bool isKinked = cell.FirstBounce < common && all(cell.Signatures == cell.Signatures.x);
    if (isKinked)
    {
        cell.Traits |= KINKED_CELL;
        cell.Signatures = SignaturesOf(cell);
    }
    SetBent(cell, isRevealed || thin > 0.0 || cell.FirstBounce < common && !isKinked ? MISS : max(left.z, atCorners.Bent));
    AddBorder(cell);
}

#endif
