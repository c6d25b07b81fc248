#ifndef GLINT_TUBE_BISECT
#define GLINT_TUBE_BISECT

#include "Sums.hlsl"
#ifdef GLINT_AMPLITUDE
#include "AmplitudePath.hlsl"
#else
#include "TubeGrid.hlsl"
#endif

// Finds where borders cross the sides of their cells. One thread a side.

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread), which = index & 1;
    if (index >= 2 * CountOfList(TUBE_BORDERS, _ListCapacity.z))
        return;
    uint listed = ElementOfList(TUBE_BORDERS, index / 2, 1, _ListCapacity.z);
    Cell cell = LoadBorder(listed);
    Border border = BorderOf(cell);
    uint crossing = which == 0 ? cell.Crossings.x : cell.Crossings.y, end = BisectionsOf(cell), rays = 0;
    float side = SideOfCell(cell);
    [loop]
    for (uint step = _BisectSteps.x; step < min(end, _BisectSteps.y); step++)
    {
        if (!border.IsCut || (crossing & NO_CROSSING) != 0)
            break;
        float fraction = (crossing + 0.5) * asfloat((127 - step) << 23);
        uint signature = SignatureAt(CentreOfCell(cell) + PlaceOnSide(border, which, fraction, side), cell);
        rays++;
        if (signature == border.SignatureBefore)
            crossing = 2 * crossing + 1;
        else if (signature == border.SignatureAfter)
            crossing = 2 * crossing;
        else
            crossing |= NO_CROSSING;
    }
    if (which == 0)
        _Borders[listed].Crossings.x = crossing;
    else
        _Borders[listed].Crossings.y = crossing;
    if (rays > 0)
        AddTo(CountWord(POSE_BORDER_RAYS), rays);
}

#endif
