#ifndef GLINT_TUBE_WHOLES
#define GLINT_TUBE_WHOLES

#include "TubeSquares.hlsl"
#include "CellCorners.hlsl"
#include "TubeDivisions.hlsl"
#include "Sums.hlsl"

// Sums border cells that are not cut in two as a whole: those that are small, and those that cannot be divided. One thread a
// cell.

// The error of a cell that is summed as a whole is that of its corners. If the ray through its middle meets currents
// whose error is above this many times the error that a cell may have, it is divided after all: its error would be the
// same in each attempt.
static const float MAX_HIDDEN_ERROR = 8.0;

// Cells along an edge of slow phase answer together: a square of steep phase cancels itself, and the part of the strip between
// its edges that the square stands for does not. They are taken as points of their size, whose sum is that of the strip on
// average, and whose errors may have one sign: this part of each. Where the phase runs too fast for that, the square stays, and
// the edges of the strip are its error.
static const float ONE_SIDED = 0.25;

void SumAlongEdge(inout Tube currents, float side)
{
    float thinning = ThinningAlongEdge(length(currents.Gradient), side);
    if (thinning < 1.0)
    {
        currents.Error = side * side * thinning;
        currents.Bent = 1.0;
        return;
    }
    currents.Gradient = 0.0;
    currents.Bent = max(currents.Bent, ONE_SIDED);
}

// Whether the middle of a cell that is summed as a whole answers far more strongly than its corners. strength: of its ray.
bool HidesCurrents(Cell cell, TubePath tube, SurfacePoint at, uint receivers, float strength, float side)
{
    float thinned = ThinningIn(cell, SteepnessAt(tube, receivers), side) * strength;
    return CRUDE_ERROR * side * side * thinned * WeightAt(tube, at, receivers) > MAX_HIDDEN_ERROR * CellError();
}

// Adds the error of a cell whose corners see something, and its centre nothing: what is left out of the sum. A square
// without strength radiates nothing.
void AddMissed(Cell cell)
{
    float side = SideOfCell(cell);
    Tube missed = (Tube)0;
    Cell known = cell;
    float2 strengths = LeftAt(LoadCorners(known), cell).Missed;
    // A thin part between corners that see nothing.
    if (strengths.x == 0.0)
    {
        float crossPart = ThinPartOf(cell);
        strengths = cell.Thinned / WeightOf(crossPart) * float2(1.0, crossPart);
    }
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

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint index = IndexOf(group, thread);
    if (index >= CountOfList(TUBE_WHOLES, _ListCapacity.z))
        return;
    Cell cell = LoadBorder(_ListCapacity.z + ElementOfList(TUBE_WHOLES, index, 1, _ListCapacity.z));
    float side = SideOfCell(cell);
    bool isSummed = false, isHidden = false;
    TubePath tube = BeginTube(CentreOfCell(cell));
    SurfacePoint at;
    [loop]
    while (AdvanceTube(tube, at))
    {
        uint receivers = ReceiversOf(tube, at), bounce = tube.Path.Bounces - 1;
        bool isLeft = bounce >= cell.FirstBounce;
        float strength = StrengthAt(tube, at, receivers);
        if (isLeft && cell.Level < MaxLevel() && HidesCurrents(cell, tube, at, receivers, strength, side))
        {
            // What it has met before is summed for the whole cell.
            cell.FirstBounce = bounce;
            isHidden = true;
            break;
        }
        Incidence incidence = IncidenceAt(tube, at);
        [loop]
        for (uint number = 0; number < _ReceiverCount && isLeft; number++)
            if ((receivers >> number & 1) != 0)
            {
                Receiver receiver = ReceiverFrom(number, tube.Path.Ray.Origin);
                Tube currents = CurrentsAt(incidence, tube, number, receiver);
                currents.Corners01.x = side;
                currents.Corners23.x = 1.0;
                currents.Bent = BentErrorAt(tube, at, receiver, side);
                currents.Error = CRUDE_ERROR * side * side * ThinningIn(cell, length(currents.Gradient), side);
                if (IsAlongEdge(cell))
                    SumAlongEdge(currents, side);
                AddTubeOf(currents, CentreOfCell(cell), tube, at, receiver, side);
                isSummed = true;
            }
        if (!ScatterTube(tube, at))
            break;
    }
    if (isHidden)
        Divide(cell);
    else if (!isSummed)
        AddMissed(cell);
    AddTo(CountWord(POSE_BORDER_RAYS), 1);
}

#endif
