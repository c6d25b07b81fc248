#ifndef GLINT_TUBE_CELLS
#define GLINT_TUBE_CELLS

#include "TubeGrid.hlsl"
#include "Sums.hlsl"

// Sums the cells whose corners see the same, as one tube each, and lists the others as borders. One thread a cell.

// Relative error of a tube by a phase that is bent by this much between centre and corners, rad: after the correction
// of its mean, half the variance of what is left, for equal bends along both axes.
static const float BENT_ERROR = 0.022;

// What the rays through the corners have met at a bounce.
struct Bounce
{
    uint Signature;
    float4 Bend;           // sums over the corners of the differential of place and length towards them, m
};

bool LoadCell(uint index, out Cell cell)
{
    cell = (Cell)0;
    if (_Round > 0)
    {
        if (index >= min(_Sums[TUBE_CELLS], _ListCapacity.y))
            return false;
        cell = _TubeCells[index];
        return true;
    }
    uint number = _Grid.y + index;
    cell.Position = uint2(number % _Grid.x, number / _Grid.x);
    return index < _Grid.z;
}

void AddBorder(Cell cell)
{
    uint border;
    InterlockedAdd(_Sums[TUBE_BORDERS], 1, border);
    if (border < _ListCapacity.z)
        _Borders[border] = cell;
}

// Whether a corner of a patch is seen in the cell.
bool IsMarked(Cell cell)
{
    if (cell.Level >= MARK_LEVEL)
        return false;
    uint parts = MARKS >> cell.Level;
    uint2 base = cell.Position >> cell.Level, first = (cell.Position - (base << cell.Level)) * parts;
    uint word = 2 * (base.x + base.y * _Grid.x), row = ((1u << parts) - 1) << first.x, bits = 0;
    for (uint y = first.y; y < first.y + parts; y++)
        bits |= _Marks[word + (y >> 2)] >> 8 * (y & 3) & row;
    return bits != 0;
}

// Phase between the centre and the corners, less the linear one, averaged, m.
float BendTowards(float4 bend, Receiver receiver)
{
    return 0.125 * (dot(bend.xyz, receiver.Direction) - bend.w);
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    Cell cell;
    if (!LoadCell(IndexOf(group, thread), cell))
        return;
    if (IsMarked(cell))
    {
        cell.MustDivide = 1;
        AddBorder(cell);
        return;
    }
    float side = SideOfCell(cell);
    Bounce bounces[MAX_BOUNCES];
    uint signatures[4];
    uint cornerBounces = 0, rays = 0;
    uint firstDifference = MAX_BOUNCES, firstBad = MAX_BOUNCES;
    bool isSame = true;
    [loop]
    for (uint ray = 0; ray < 5 && isSame; ray += 1)
    {
        bool isCentre = ray == 4;
        if (isCentre && (cornerBounces == 0 || firstBad <= cell.FirstBounce))
            break;
        float2 fromCentre = isCentre ? 0.0 : side * CornerOf(ray);
        TubePath tube = BeginTube(CentreOfCell(cell) + fromCentre);
        SurfacePoint at;
        rays++;
        bool goesOn = true;
        [loop]
        while (goesOn && AdvanceTube(tube, at))
        {
            uint bounce = tube.Path.Bounces - 1;
            float3 place = tube.Path.Ray.Origin;
            uint receivers = ReceiversOf(tube, at);
            Sign(tube, receivers);
            if (isCentre)
            {
                if (bounce >= min(cornerBounces, firstBad) || bounces[bounce].Signature != tube.Signature)
                {
                    firstBad = min(firstBad, bounce);
                    goesOn = false;
                }
                else if (bounce >= cell.FirstBounce)
                {
                    [loop]
                    for (uint index = 0; index < _ReceiverCount; index++)
                    {
                        Receiver receiver = ReceiverFrom(index, place);
                        Tube currents = CurrentsAt(tube, at, index, receiver);
                        float bend = BendTowards(bounces[bounce].Bend, receiver), phase = bend * _WaveNumber;
                        currents.Phase += bend / 3.0;
                        currents.Corners01.x = side;
                        currents.Bent = BENT_ERROR * phase * phase;
                        if ((receivers >> index & 1) != 0)
                            AddTube(currents);
                    }
                }
            }
            else
            {
                float3 step = fromCentre.x * tube.PlaceU + fromCentre.y * tube.PlaceV;
                float4 bend = float4(step, dot(step, tube.Path.Ray.Direction));
                if (ray == 0)
                {
                    bounces[bounce].Signature = tube.Signature;
                    bounces[bounce].Bend = bend;
                }
                else if (bounce < cornerBounces && bounces[bounce].Signature == tube.Signature)
                    bounces[bounce].Bend += bend;
                else
                    firstDifference = min(firstDifference, bounce);
            }
            goesOn = goesOn && ScatterTube(tube, at);
        }
        if (isCentre)
        {
            if (tube.Path.Bounces < cornerBounces)
                firstBad = min(firstBad, tube.Path.Bounces);
        }
        else
        {
            signatures[ray] = tube.Signature;
            if (ray == 0)
                cornerBounces = tube.Path.Bounces;
            else if (tube.Path.Bounces < cornerBounces)
                firstDifference = min(firstDifference, tube.Path.Bounces);
        }
        if (ray == 3)
        {
            isSame = firstDifference == MAX_BOUNCES;
            // the first bounce with a phase that is bent too much
            [loop]
            for (uint bounce = 0; bounce < cornerBounces && isSame; bounce++)
                for (uint index = 0; index < _ReceiverCount; index++)
                {
                    float bent = _WaveNumber * BendTowards(bounces[bounce].Bend, ReceiverFrom(index, 0.0));
                    if (bounce < firstBad && abs(bent) > _MaxBentPhase && cell.Level < _MaxLevel)
                        firstBad = bounce;
                }
        }
    }
    AddUnsigned(TUBE_RAYS, rays);
    if (isSame && firstBad == MAX_BOUNCES)
        return;
    cell.Signatures = uint4(signatures[0], signatures[1], signatures[2], signatures[3]);
    cell.FirstDifference = firstDifference;
    cell.MustDivide = isSame ? 1 : 0;
    cell.FirstBounce = isSame ? max(cell.FirstBounce, firstBad) : cell.FirstBounce;
    AddBorder(cell);
}

#endif
