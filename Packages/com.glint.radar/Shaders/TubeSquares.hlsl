#ifndef GLINT_TUBE_SQUARES
#define GLINT_TUBE_SQUARES

#include "TubeGrid.hlsl"

// Sums a cell whose rays have met the same at a bounce, as one tube.

// How much phases that are bent at the corners of a square matter, rad (SquareIntegral): where the phase runs along a side,
// x half of it over the side, the integral of a curvature's powers falls faster than the square's own.
float SizeOf(float3 bends, float2 x)
{
    float size = dot(abs(bends.xy), min(1.0, 5.4 / max(abs(x), 1.0))) + abs(bends.z);
    // Compilers may take a comparison with NaN for either.
    return IsNaN(size) ? 1.0e6 : size;
}

// Relative error of a square's integral by a phase whose bend grows from side to side: the gradient between the sides
// differs from that at the centre by this, rad. It is odd about the centre, and adds nothing where no phase runs over the
// square; at a finite range it does, since the currents change along the square as well.
float CubicError(float2 difference, float2 x)
{
    float2 size = min(1.0, 5.4 / max(abs(x), 1.0));
    if (_IsNear == 0)
        size = min(size, 0.9 * abs(x));
    return 0.15 * dot(difference, size);
}

// Mean over a square of a bump that is 1 at the centre and 0 at the sides, (1 - u^2)(1 - v^2), and how wrong that is where the
// phase has kinks instead: at the sides of facets, which are flat.
static const float BUMP_MEAN = 4.0 / 9.0, BUMP_ERROR = 0.3;

// What the rays through the corners of a cell have met at a bounce, if it is the same.
struct Bounce
{
    // Sums over the corners of the differentials of place and length by u and v, times the way to the corner, m.
    float4 AlongU, AlongV;
    // Place and length, m: mean of the corners; halves of their differences along u and v; twist.
    float4 Mean, SlopeU, SlopeV, Twist;
    float4 Strength;       // mean of the corners, halves of the differences along u and v, twist
    float Weight;          // largest of the corners
    bool AreFacetsSame;    // all of them as those of the ray through the centre
};

// A receiver at a finite range, where its direction differs from place to place. Far ones are not asked.
Receiver NearFrom(uint receiver, float4 position)
{
    Receiver near = (Receiver)0;
    if (_IsNear != 0)
        near = ReceiverFrom(receiver, position.xyz);
    return near;
}

// Place and length at which a ray has met something; at a finite range minus the phase towards the receiver there instead.
float4 SeenFrom(Receiver near, float4 position)
{
    return _IsNear != 0 ? float4(0.0, 0.0, 0.0, position.w - near.Phase) : position;
}

// The differential of SeenFrom for that of a position.
float4 StepSeenFrom(Receiver near, float4 step)
{
    return _IsNear != 0 ? float4(0.0, 0.0, 0.0, step.w - dot(near.Direction, step.xyz)) : step;
}

// Adds what the ray through a corner has met. facets: see BounceOf.
void AddCorner(inout Bounce bounce, Corner corner, float2 fromCentre, uint receiver, uint facets)
{
    Receiver near = NearFrom(receiver, corner.Position);
    float4 position = 0.25 * SeenFrom(near, corner.Position);
    float2 sides = fromCentre > 0.0 ? 1.0 : -1.0;
    bounce.AlongU += fromCentre.x * StepSeenFrom(near, corner.AlongU);
    bounce.AlongV += fromCentre.y * StepSeenFrom(near, corner.AlongV);
    bounce.Mean += position;
    bounce.SlopeU += sides.x * position;
    bounce.SlopeV += sides.y * position;
    bounce.Twist += sides.x * sides.y * position;
    bounce.Strength += 0.25 * corner.Strength * float4(1.0, sides, sides.x * sides.y);
    bounce.Weight = max(bounce.Weight, WeightOf(CrossPartOf(corner)));
    bounce.AreFacetsSame = bounce.AreFacetsSame && FacetsOf(corner) == facets;
}

// What the rays through the corners have met at a bounce, if it is the same. corners: their elements at it. At a finite
// range it is that of a receiver. facets: of the ray through the centre.
Bounce BounceOf(uint4 corners, float side, uint receiver, uint facets)
{
    Bounce bounce = (Bounce)0;
    bounce.AreFacetsSame = true;
    [unroll]
    for (uint i = 0; i < 4; i++)
        AddCorner(bounce, _Corners[corners[i]], side * CornerOf(i), receiver, facets);
    return bounce;
}

// The phase of SeenFrom, or of a difference of such, m.
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

static const uint NO_RECEIVER = 0xffffffff;

// Sums a cell at a bounce, from the ray through its centre; false if its phase is bent or its strength changes too much.
// corners: see BounceOf. centre: on the grid. strength, weight: of the ray.
bool AddSquare(uint4 corners, float2 centre, TubePath tube, SurfacePoint at, uint receivers, float strength, float weight,
    float side, bool canDivide)
{
    Incidence incidence = IncidenceAt(tube, at);
    Bounce bounce = (Bounce)0;
    uint seenFrom = NO_RECEIVER;
    // The errors of all receivers, then the sums.
    [loop]
    for (uint turn = canDivide ? 0 : _ReceiverCount; turn < 2 * _ReceiverCount; turn++)
    {
        bool isSum = turn >= _ReceiverCount;
        uint index = isSum ? turn - _ReceiverCount : turn;
        if ((receivers >> index & 1) == 0)
            continue;
        if (seenFrom == NO_RECEIVER || _IsNear != 0 && seenFrom != index)
        {
            bounce = BounceOf(corners, side, index, FacetsOf(tube));
            seenFrom = index;
        }
        Receiver receiver = ReceiverFrom(index, tube.Path.Ray.Origin);
        // Between the corners a strength that bends is off by up to this. On the same facets it is a bump.
        float mean = bounce.Strength.x, most = max(mean, strength);
        float change = most > 0.0 ? abs(mean - strength) / most : 0.0;
        change *= bounce.AreFacetsSame ? BUMP_ERROR : 0.67;
        float3 bends = BendsOf(bounce, receiver);
        float2 halves = float2(PhaseOf(bounce.SlopeU, receiver), PhaseOf(bounce.SlopeV, receiver));
        float2 x = _WaveNumber * halves;
        float2 atCentre = 0.5 * _WaveNumber * side * PhaseSlope(tube, receiver);
        float size = SizeOf(_WaveNumber * bends, x);
        // How far the phase at the centre is from what the corners say, m.
        float bump = receiver.Phase - tube.Path.RelativeLength - PhaseOf(bounce.Mean, receiver) + bends.x + bends.y;
        float error = min(1.0, BentError(size) + CubicError(abs(x - atCentre), x) + change
            + BUMP_ERROR * _WaveNumber * abs(bump));
        float2 falls = 1.0 / max(abs(x), 1.0);
        if (!isSum)
        {
            if (error * falls.x * falls.y * side * side * most * max(weight, bounce.Weight) > CellError())
                return false;
            continue;
        }
        Tube currents = CurrentsAt(incidence, tube, index, receiver);
        currents.Bent = error;
        // Where the expansion fails, on cells too small to matter, the square is taken as plane.
        if (size < MAX_BENDS)
        {
            currents.Phase = PhaseOf(bounce.Mean, receiver) + BUMP_MEAN * bump;
            currents.Gradient = halves * (2.0 / side);
            currents.Corners01.yzw = bends;
        }
        currents.Corners01.x = side;
        currents.Corners23 = float4(1.0, 0.0, 0.0, 0.0);
        if (strength > max(MIN_STRENGTH * mean, MIN_CURRENTS))
        {
            currents.Corners23 = bounce.Strength / strength;
            // From facet to facet VV and HH change by other factors: what the centre meets is right on average. HV and VH
            // grow with the strength towards a silhouette.
            if (bounce.AreFacetsSame)
                currents.Corners23.x += BUMP_MEAN * (1.0 - mean / strength);
            else if (mean > MIN_STRENGTH * strength)
                currents.CoPolar *= strength / mean;
        }
        AddTubeOf(currents, centre, tube, at, receiver, side);
    }
    return true;
}

#endif
