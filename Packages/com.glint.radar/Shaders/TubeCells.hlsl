#ifndef GLINT_TUBE_CELLS
#define GLINT_TUBE_CELLS

#include "TubeGrid.hlsl"
#include "Sums.hlsl"

// Sums the cells whose corners see the same, as one tube each, and lists the others as borders. One thread a cell.

// Strength at the centre of a square below which that of its corners says nothing about its currents, in theirs.
static const float MIN_STRENGTH = 1.0e-3;

// How much phases that are bent at the corners of a square matter, rad (SquareIntegral): where the phase runs along a side,
// x half of it over the side, the integral of a curvature's powers falls faster than the square's own.
float SizeOf(float3 bends, float2 x)
{
    float size = dot(abs(bends.xy), min(1.0, 5.4 / max(abs(x), 1.0))) + abs(bends.z);
    // Compilers may take a comparison with NaN for either.
    return IsNaN(size) ? 1.0e6 : size;
}

// Relative error of a square's integral by a phase whose bend grows from side to side: the gradient between the sides
// differs from that at the centre by this, rad.
float CubicError(float2 difference, float2 x)
{
    return 0.15 * dot(difference, min(1.0, 5.4 / max(abs(x), 1.0)));
}

// What the rays through the corners have met at a bounce.
struct Bounce
{
    uint Signature;
    // Sums over the corners of the differentials of place and length by u and v, times the way to the corner, m.
    float4 AlongU, AlongV;
    // Place and length, m: mean of the corners; halves of their differences along u and v; twist.
    float4 Mean, SlopeU, SlopeV, Twist;
    float4 Strength;       // mean of the corners, halves of the differences along u and v, twist
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

// Whether a corner of a patch is seen in the cell or within half its side: between rays it may reach into it.
bool HasVertex(Cell cell)
{
    if (cell.Level >= _MaxLevel)
        return false;
    float side = SideOfCell(cell);
    float2 centre = CentreOfCell(cell);
    uint2 base = cell.Position >> cell.Level;
    uint link = _Marks[base.x + base.y * _Grid.x];
    bool isNear = false;
    [loop]
    for (uint read = 0; read < MAX_VERTICES && link != 0 && !isNear; read++)
    {
        uint4 vertex = _Links[link - 1];
        isNear = all(abs(asfloat(vertex.xy) - centre) <= side);
        link = vertex.z;
    }
    // A longer list is not read: its corners may be anywhere.
    return isNear || link != 0;
}

// Whether a triangle may be seen in the base cell.
bool IsCovered(uint2 cell)
{
    uint bit = cell.x / COVER_SIDE + cell.y / COVER_SIDE * _Blocks.x;
    return _Marks[_MarkWords - 1] != 0 || (_Marks[FirstCoverWord() + (bit >> 5)] >> (bit & 31) & 1) != 0;
}

// Place and length of a corner; at a finite range, where the receiver's direction differs from corner to corner, minus the
// phase instead.
float4 PlaceOf(TubePath tube)
{
    float3 place = tube.Path.Ray.Origin;
    if (_IsNear != 0)
        return float4(0.0, 0.0, 0.0, tube.Path.RelativeLength - ReceiverFrom(0, place).Phase);
    return float4(place, tube.Path.RelativeLength);
}

// The differential of PlaceOf by u or v.
float4 DifferentialOf(TubePath tube, float3 step)
{
    float3 d = tube.Path.Ray.Direction;
    if (_IsNear != 0)
        return float4(0.0, 0.0, 0.0, dot(d - ReceiverFrom(0, tube.Path.Ray.Origin).Direction, step));
    return float4(step, dot(step, d));
}

// The phase of PlaceOf, or of a difference of such, m.
float PhaseOf(float4 position, Receiver receiver)
{
    return dot(position.xyz, receiver.Direction) - position.w;
}

// Phases of the corners less the linear ones, m: of the curvature by u, by v, and of the twist. The gradients at the
// corners differ by the second derivatives.
float3 BendsOf(Bounce bounce, Receiver receiver)
{
    return float3(0.125 * PhaseOf(bounce.AlongU, receiver), 0.125 * PhaseOf(bounce.AlongV, receiver),
        PhaseOf(bounce.Twist, receiver));
}

// Adds what the ray through a corner has met.
void AddCorner(inout Bounce bounce, TubePath tube, float strength, float2 fromCentre)
{
    float4 position = 0.25 * PlaceOf(tube);
    float2 sides = fromCentre > 0.0 ? 1.0 : -1.0;
    bounce.AlongU += fromCentre.x * DifferentialOf(tube, tube.PlaceU);
    bounce.AlongV += fromCentre.y * DifferentialOf(tube, tube.PlaceV);
    bounce.Mean += position;
    bounce.SlopeU += sides.x * position;
    bounce.SlopeV += sides.y * position;
    bounce.Twist += sides.x * sides.y * position;
    bounce.Strength += 0.25 * strength * float4(1.0, sides, sides.x * sides.y);
}

// Sums a cell at a bounce, from the ray through its centre; false if its phase is bent or its strength changes too much.
bool AddSquare(Bounce bounce, TubePath tube, SurfacePoint at, uint receivers, float strength, float side, bool canDivide)
{
    float mean = bounce.Strength.x, most = max(mean, strength);
    // Between the corners a strength that bends is off by up to this.
    float change = most > 0.0 ? abs(mean - strength) / most : 0.0;
    [loop]
    for (uint step = canDivide ? 0 : 1; step < 2; step++)
        for (uint index = 0; index < _ReceiverCount; index++)
        {
            if ((receivers >> index & 1) == 0)
                continue;
            Receiver receiver = ReceiverFrom(index, tube.Path.Ray.Origin);
            float3 bends = BendsOf(bounce, receiver), slope = receiver.Direction - tube.Path.Ray.Direction;
            float2 halves = float2(PhaseOf(bounce.SlopeU, receiver), PhaseOf(bounce.SlopeV, receiver));
            float2 x = _WaveNumber * halves;
            float2 atCentre = 0.5 * _WaveNumber * side * float2(dot(slope, tube.PlaceU), dot(slope, tube.PlaceV));
            float size = SizeOf(_WaveNumber * bends, x);
            float error = min(1.0, BentError(size) + CubicError(abs(x - atCentre), x) + 0.67 * change);
            float2 falls = 1.0 / max(abs(x), 1.0);
            if (step == 0)
            {
                if (error * falls.x * falls.y * side * side * most > _CellError)
                    return false;
                continue;
            }
            Tube currents = CurrentsAt(tube, at, index, receiver);
            currents.Bent = error;
            // Where the expansion fails, on cells too small to matter, the square is taken as plane.
            if (size < MAX_BENDS)
            {
                currents.Phase = PhaseOf(bounce.Mean, receiver);
                currents.Gradient = halves * (2.0 / side);
                currents.Corners01.yzw = bends;
            }
            currents.Corners01.x = side;
            currents.Corners23 = strength > MIN_STRENGTH * mean ? bounce.Strength / strength : float4(1.0, 0.0, 0.0, 0.0);
            AddTube(currents, at.Part, RateTo(receiver, tube, at));
        }
    return true;
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    Cell cell;
    if (!LoadCell(IndexOf(group, thread), cell) || _Round == 0 && !IsCovered(cell.Position))
        return;
    if (HasVertex(cell))
    {
        cell.Strength = MISS;
        cell.Bent = MISS;
        AddBorder(cell);
        return;
    }
    float side = SideOfCell(cell);
    bool canDivide = cell.Level < _MaxLevel;
    Bounce bounces[MAX_BOUNCES];
    float2 strengths[MAX_BOUNCES];
    for (uint clear = 0; clear < MAX_BOUNCES; clear++)
        strengths[clear] = 0.0;
    uint signatures[4];
    // The same at all corners, and summed.
    uint common = MAX_BOUNCES, done = cell.FirstBounce, rays = 0;
    bool areSame = true;
    [loop]
    for (uint ray = 0; ray < 5; ray++)
    {
        bool isCentre = ray == 4;
        if (isCentre && common <= cell.FirstBounce)
            break;
        float2 fromCentre = isCentre ? 0.0 : side * CornerOf(ray);
        TubePath tube = BeginTube(CentreOfCell(cell) + fromCentre);
        SurfacePoint at;
        rays++;
        bool goesOn = true;
        [loop]
        while (goesOn && AdvanceTube(tube, at))
        {
            uint bounce = tube.Path.Bounces - 1, receivers = ReceiversOf(tube, at);
            Sign(tube, receivers);
            float strength = StrengthAt(tube, at, receivers);
            if (isCentre)
            {
                goesOn = bounce < common && bounces[bounce].Signature == tube.Signature;
                areSame = areSame && goesOn;
                if (goesOn && bounce >= cell.FirstBounce)
                {
                    goesOn = AddSquare(bounces[bounce], tube, at, receivers, strength, side, canDivide);
                    done = goesOn ? bounce + 1 : done;
                }
            }
            strengths[bounce] = max(strengths[bounce],
                strength * float2(1.0, BentErrorAt(tube, at, ReceiverFrom(0, tube.Path.Ray.Origin), side)));
            if (!isCentre && bounce < common)
            {
                Bounce met = (Bounce)0;
                met.Signature = tube.Signature;
                if (ray > 0)
                    met = bounces[bounce];
                if (met.Signature != tube.Signature)
                    common = bounce;
                AddCorner(met, tube, strength, fromCentre);
                bounces[bounce] = met;
            }
            goesOn = goesOn && ScatterTube(tube, at);
        }
        if (isCentre)
        {
            areSame = areSame && tube.Path.Bounces >= common;
            break;
        }
        signatures[ray] = tube.Signature;
        areSame = areSame && signatures[ray] == signatures[0];
        common = min(common, tube.Path.Bounces);
    }
    AddUnsigned(TUBE_RAYS, rays);
    if (areSame && done >= common)
        return;
    cell.Signatures = uint4(signatures[0], signatures[1], signatures[2], signatures[3]);
    float2 most = 0.0;
    for (uint left = done; left < MAX_BOUNCES; left++)
        most = max(most, strengths[left]);
    cell.FirstBounce = done;
    cell.Strength = most.x;
    cell.Bent = done < common ? MISS : most.y;
    AddBorder(cell);
}

#endif
