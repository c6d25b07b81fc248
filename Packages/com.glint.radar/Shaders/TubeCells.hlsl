#ifndef GLINT_TUBE_CELLS
#define GLINT_TUBE_CELLS

#include "TubeGrid.hlsl"
#include "Sums.hlsl"

// Sums the cells whose corners see the same, as one tube each, and lists the others as borders. One thread a cell.

// What the rays through the corners have met at a bounce.
struct Bounce
{
    uint Signature;
    // Sums over the corners of the differentials of place and length by u and v, times the way to the corner, m.
    float4 AlongU, AlongV, Twist;
    float Fade;            // largest of the corners
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

// Phases of the corners less the linear ones, m: of the curvature by u, by v, and of the twist. A corner's
// gradient differs from that at the centre by the second derivatives.
float3 BendsOf(Bounce bounce, Receiver receiver)
{
    float3 direction = receiver.Direction;
    return float3(0.125 * (dot(bounce.AlongU.xyz, direction) - bounce.AlongU.w),
        0.125 * (dot(bounce.AlongV.xyz, direction) - bounce.AlongV.w),
        0.25 * (dot(bounce.Twist.xyz, direction) - bounce.Twist.w));
}

// The differential of place and length of a corner by u or v; at a finite range, where the receiver's direction differs
// from corner to corner, the gradient of the phase instead.
float4 DifferentialOf(TubePath tube, float3 step)
{
    float3 d = tube.Path.Ray.Direction;
    if (_IsNear != 0)
        return float4(0.0, 0.0, 0.0, dot(d - ReceiverFrom(0, tube.Path.Ray.Origin).Direction, step));
    return float4(step, dot(step, d));
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
                        if ((receivers >> index & 1) == 0)
                            continue;
                        Receiver receiver = ReceiverFrom(index, place);
                        Tube currents = CurrentsAt(tube, at, index, receiver);
                        float3 bends = BendsOf(bounces[bounce], receiver);
                        currents.Bent = BentError(_WaveNumber * bends);
                        // Where the expansion fails, on cells too small to matter, the mean phase remains.
                        bool isBent = currents.Bent < MAX_BENT_ERROR;
                        float mean = (bends.x + bends.y) * (isBent ? 1.0 : 1.0 / 3.0);
                        currents.Phase += IsNaN(mean) ? 0.0 : mean;
                        currents.Corners01 = float4(side, isBent ? bends : (float3)0);
                        AddTube(currents);
                    }
                }
            }
            else
            {
                float4 byU = DifferentialOf(tube, tube.PlaceU), byV = DifferentialOf(tube, tube.PlaceV);
                float fade = FadeOf(at);
                if (ray == 0)
                {
                    bounces[bounce].Fade = fade;
                    bounces[bounce].Signature = tube.Signature;
                    bounces[bounce].AlongU = fromCentre.x * byU;
                    bounces[bounce].AlongV = fromCentre.y * byV;
                    bounces[bounce].Twist = fromCentre.y * byU;
                }
                else if (bounce < cornerBounces && bounces[bounce].Signature == tube.Signature)
                {
                    bounces[bounce].AlongU += fromCentre.x * byU;
                    bounces[bounce].AlongV += fromCentre.y * byV;
                    bounces[bounce].Twist += fromCentre.y * byU;
                    bounces[bounce].Fade = max(bounces[bounce].Fade, fade);
                }
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
                    float3 bends = _WaveNumber * BendsOf(bounces[bounce], ReceiverFrom(index, 0.0));
                    if (bounce < firstBad && bounces[bounce].Fade * BentError(bends) * side * side > _CellError && cell.Level < _MaxLevel)
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
