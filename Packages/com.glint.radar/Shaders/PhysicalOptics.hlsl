#ifndef GLINT_PHYSICAL_OPTICS
#define GLINT_PHYSICAL_OPTICS

#include "TubePath.hlsl"
#include "Footprint.hlsl"

// The currents that a tube paints on the surface at each hit, and what they radiate (Documentation~/rcs.md).

// Curvature times wavelength below which shadow edges fade: k R above 50.
static const float MIN_FADED_RADIUS = 50.0;

struct Receiver
{
    float3 Direction;      // unit vector from the hit
    float3 V, H;
    float Distance;        // to the receiver, m; MISS: far
    float Reach;           // in which something may hide it, m: a camera with parallel rays is not far
    float Phase;           // the way from the scene's centre to the receiver less that from the hit, m
    float Strength;        // of what arrives, relative to that from the scene's centre
};

// A receiver of this thread's pose; behind them the radar.
Receiver ReceiverFrom(uint index, float3 position)
{
    Receiver receiver;
    uint row = RECEIVER_ROWS * (s_pose * (_ReceiverCount + 1) + index);
    float4 place = _Receivers[row];
    receiver.Direction = place.xyz;
    receiver.V = _Receivers[row + 1].xyz;
    receiver.H = _Receivers[row + 2].xyz;
    receiver.Distance = MISS;
    receiver.Reach = MISS;
    receiver.Phase = dot(position, receiver.Direction);
    receiver.Strength = 1.0;
    if (_IsNear == 0 && _FootprintPosition.w != 0.0)
        receiver.Reach = max(0.0, dot(_FootprintPosition.xyz - position, receiver.Direction));
    if (_IsNear != 0)
    {
        float3 way = place.xyz - position;
        receiver.Distance = length(way);
        receiver.Reach = receiver.Distance;
        receiver.Direction = way / receiver.Distance;
        // the difference of both distances, without cancellation
        receiver.Phase = dot(position, place.xyz + way) / (receiver.Distance + place.w);
        TurnAcross(receiver.Direction, receiver.V, receiver.H);
        receiver.Strength = _Range / receiver.Distance;
    }
    return receiver;
}

// Cosine of the angle from the mirror direction up to which paths that have met a sea alone radiate: further off, the
// diffuse echo of its facets is what returns, and the edges of its facets are none of the water's.
static const float MIN_SEA_MIRROR = 0.643;

bool IsFacing(SurfacePoint at, Receiver receiver)
{
    return dot(at.FacetNormal, receiver.Direction) > 0.0;
}

// Whether the current at a hit is one of those that are summed for a receiver: of a path that has met a sea with a diffuse echo
// alone only those about the mirror direction.
bool IsSummed(TubePath tube, SurfacePoint at, Receiver receiver)
{
    return !at.IsLost && (tube.HasMetTarget
        || dot(Mirrored(tube.Path.Ray.Direction, at.Normal), receiver.Direction) >= MIN_SEA_MIRROR);
}

// Whether the current at a hit radiates to a receiver that nothing hides: that of the first bounce also makes the shadow
// behind the surface, later ones do not pass through it.
bool RadiatesInSight(TubePath tube, SurfacePoint at, Receiver receiver)
{
    return IsSummed(tube, at, receiver) && (tube.Path.Bounces == 1 || IsFacing(at, receiver));
}

// Whether nothing is between a place and a receiver. excludedTriangle: that of the place; NO_INSTANCE: it is on none.
bool IsInSight(float3 start, uint2 excludedTriangle, Receiver receiver)
{
    Ray ray = (Ray)0;
    ray.Origin = start;
    ray.Start = start;
    ray.Direction = receiver.Direction;
    ray.ExcludedTriangle = excludedTriangle;
    bool isAmbiguous;
    return !AnyHit(ray, receiver.Reach, isAmbiguous);
}

// Whether the current at a hit radiates to a receiver.
bool Radiates(TubePath tube, SurfacePoint at, Receiver receiver)
{
    if (!RadiatesInSight(tube, at, receiver))
        return false;
    if (tube.Path.Bounces == 1 && (_IsMonostatic != 0 || !IsFacing(at, receiver)))
        return true;
    return IsInSight(at.NextStart, at.Triangle, receiver);
}

// Factor of the current towards a curved surface's shadow: over the width in which nature fades it.
float FadeOf(SurfacePoint at)
{
    float radius = _WaveNumber / max(at.CurvatureAlong, 1.0e-20);
    if (_FadesShadows == 0 || at.CurvatureAlong <= 0.0 || radius < MIN_FADED_RADIUS)
        return 1.0;
    float x = min(1.0, at.Cosine * pow(0.5 * radius, 1.0 / 3.0));
    return x * x * (3.0 - 2.0 * x);
}

// What the currents at a hit have in common for all receivers. It is found before loops over receivers, not in them: FXC goes
// through the whole kernel again for each instruction that it moves out of a loop.
struct Incidence
{
    float4 AlongV, AlongH;                          // complex parts along s and p of the field for V sent, for H sent
    float3 ElectricS, ElectricP;                    // currents of a field of 1 along s, along p,
    float3 ReflectedElectricS, ReflectedElectricP;  // and of what is reflected by a mirror
    float3 MagneticS, MagneticP, ReflectedMagneticP;
    float4 Reflection;                              // R_s, R_p
    float Fade;                                     // see FadeOf
    float Spread;                                   // what the field loses by it, times the section of the tube, m2 a base cell
    float Cosine;                                   // of the incidence angle
};

// Parts along s and p of a field (see ReflectField).
float4 PartsOf(float4 field, float3 s, float3 p, float3 v, float3 h)
{
    return float4(field.xy * dot(s, v) + field.zw * dot(s, h), field.xy * dot(p, v) + field.zw * dot(p, h));
}

Incidence IncidenceAt(TubePath tube, SurfacePoint at)
{
    float3 d = tube.Path.Ray.Direction, n = at.Normal;
    float3 s = AcrossIncidence(d, n, tube.V), p = cross(s, d), next = Mirrored(d, n), reflectedP = cross(s, next);
    Incidence incidence;
    incidence.AlongV = PartsOf(tube.FieldV, s, p, tube.V, tube.H);
    incidence.AlongH = PartsOf(tube.FieldH, s, p, tube.V, tube.H);
    incidence.ElectricS = cross(n, cross(d, s));
    incidence.ElectricP = cross(n, cross(d, p));
    incidence.ReflectedElectricS = cross(n, cross(next, s));
    incidence.ReflectedElectricP = cross(n, cross(next, reflectedP));
    incidence.MagneticS = cross(s, n);
    incidence.MagneticP = cross(p, n);
    incidence.ReflectedMagneticP = cross(reflectedP, n);
    incidence.Cosine = -dot(d, n);
    incidence.Reflection = ReflectionOf(at.Surface, incidence.Cosine);
    incidence.Fade = FadeOf(at);
    incidence.Spread = sqrt(abs(tube.StartSection) * abs(Section(tube.PlaceU, tube.PlaceV, d)));
    return incidence;
}

// p.C of one sent polarisation for a received one. along: parts of its field.
float2 Radiated(float3 received, float4 along, float3 toReceiver, Incidence incidence)
{
    float3 magnetic = cross(toReceiver, incidence.MagneticS);
    float incidentS = dot(received, incidence.ElectricS - magnetic),
        reflectedS = dot(received, incidence.ReflectedElectricS - magnetic),
        incidentP = dot(received, incidence.ElectricP - cross(toReceiver, incidence.MagneticP)),
        reflectedP = dot(received, incidence.ReflectedElectricP - cross(toReceiver, incidence.ReflectedMagneticP));
    return ComplexMul(along.xy, float2(incidentS, 0.0) + reflectedS * incidence.Reflection.xy)
        + ComplexMul(along.zw, float2(incidentP, 0.0) + reflectedP * incidence.Reflection.zw);
}

// Of the sums of a receiver: paths that have met a sea alone are summed apart, behind all receivers.
uint SlotOf(TubePath tube, uint receiver)
{
    return SlotOfAll(tube.HasMetTarget ? receiver : _ReceiverCount + receiver);
}

// Derivatives of the phase by u and v, m a base cell.
float2 PhaseSlope(TubePath tube, Receiver receiver)
{
    return float2(dot(receiver.Direction, tube.PlaceU), dot(receiver.Direction, tube.PlaceV)) - tube.LengthSlope;
}

// The currents at a hit, towards a receiver: a tube without its polygon.
Tube CurrentsAt(Incidence incidence, TubePath tube, uint index, Receiver receiver)
{
    float scale = receiver.Strength * incidence.Fade * incidence.Spread / incidence.Cosine;
    Tube currents = (Tube)0;
    currents.Phase = receiver.Phase - tube.Path.RelativeLength;
    currents.Gradient = PhaseSlope(tube, receiver);
    currents.Tag = SlotOf(tube, index) | tube.Path.Bounces << 8;
    currents.CoPolar = scale * float4(Radiated(receiver.V, incidence.AlongV, receiver.Direction, incidence),
        Radiated(receiver.H, incidence.AlongH, receiver.Direction, incidence));
    currents.CrossPolar = scale * float4(Radiated(receiver.H, incidence.AlongV, receiver.Direction, incidence),
        Radiated(receiver.V, incidence.AlongH, receiver.Direction, incidence));
    return currents;
}

// The rate of a path that ends at a receiver (see RateOf); 0 if nothing moves.
float3 RateTo(Receiver receiver, TubePath tube, SurfacePoint at)
{
    if (_IsMoving == 0)
        return 0.0;
    float3 e = receiver.Direction;
    float nearness = _IsNear != 0 ? 1.0 / receiver.Distance : 0.0;
    float3 turnU = nearness * (e * dot(e, tube.PlaceU) - tube.PlaceU) - tube.DirectionU;
    float3 turnV = nearness * (e * dot(e, tube.PlaceV) - tube.PlaceV) - tube.DirectionV;
    return tube.Rate + RateOf(at.Instance, tube.Path.Ray.Origin, tube.PlaceU, tube.PlaceV,
        e - tube.Path.Ray.Direction, turnU, turnV);
}

// In m2 a base cell: smaller currents may be rounded to 0.
static const float MIN_CURRENTS = 1.0e-30;

// Strength of a ray below which those beside it say nothing about its currents: in theirs.
static const float MIN_STRENGTH = 1.0e-3;

// About the largest p.C of a hit, m2 a base cell: that of a conductor. Its currents along the plane of incidence are those
// that do not fall with the cosine of the incidence angle; towards a receiver along them they radiate nothing.
float StrengthAt(TubePath tube, SurfacePoint at, uint receivers)
{
    if (at.IsLost)
        return 0.0;
    float3 d = tube.Path.Ray.Direction;
    float cosine = -dot(d, at.Normal), section = abs(Section(tube.PlaceU, tube.PlaceV, d));
    float scale = FadeOf(at) * sqrt(abs(tube.StartSection) * section) / cosine;
    float3 across = AcrossIncidence(d, at.Normal, tube.V);
    float strength = 0.0;
    [loop]
    for (uint index = 0; index < _ReceiverCount; index++)
    {
        if ((receivers >> index & 1) == 0)
            continue;
        Receiver receiver = ReceiverFrom(index, tube.Path.Ray.Origin);
        float2 aside = float2(dot(receiver.Direction, at.Normal), dot(receiver.Direction, across));
        strength = max(strength, receiver.Strength * (cosine + length(aside)));
    }
    return scale * strength;
}

// A smaller cross-polarised part is what rounding leaves of one that vanishes, as that of metal which a radar illuminates and
// sees itself.
static const float MIN_CROSS_PART = 5.0e-6;

// The cross-polarised part of p.C, 0 to 1: the largest of the receivers.
float CrossPartAt(TubePath tube, SurfacePoint at, uint receivers)
{
    float part = 0.0;
    Incidence incidence = IncidenceAt(tube, at);
    [loop]
    for (uint index = 0; index < _ReceiverCount && !at.IsLost; index++)
        if ((receivers >> index & 1) != 0)
        {
            float2 magnitudes = MagnitudesOf(CurrentsAt(incidence, tube, index, ReceiverFrom(index, tube.Path.Ray.Origin)));
            part = max(part, magnitudes.y / max(max(magnitudes.x, magnitudes.y), MIN_CURRENTS));
        }
    return part < MIN_CROSS_PART ? 0.0 : min(part, 1.0);
}

// Factor of a strength beside CellError: more than 1 where a part of the currents is cross-polarised, whose error is to be
// smaller.
float WeightOf(float crossPart)
{
    return max(1.0, _Poses[s_pose].CrossWeight * crossPart);
}

// CrossPartAt where it has a weight. First attempts take all currents as cross-polarised, which then weighs nothing.
float WeighedPartAt(TubePath tube, SurfacePoint at, uint receivers)
{
    return _Poses[s_pose].CrossWeight > 1.0 ? CrossPartAt(tube, at, receivers) : 1.0;
}

// WeightOf at a hit.
float WeightAt(TubePath tube, SurfacePoint at, uint receivers)
{
    return WeightOf(WeighedPartAt(tube, at, receivers));
}

// The smallest phase gradient towards the receivers, m a base cell.
float SteepnessAt(TubePath tube, uint receivers)
{
    float least = MISS;
    [loop]
    for (uint index = 0; index < _ReceiverCount; index++)
        if ((receivers >> index & 1) != 0)
            least = min(least, length(PhaseSlope(tube, ReceiverFrom(index, tube.Path.Ray.Origin))));
    return least;
}

// The same along a direction of the grid.
float SlopeAlong(TubePath tube, uint receivers, float2 along)
{
    float least = MISS;
    [loop]
    for (uint index = 0; index < _ReceiverCount; index++)
        if ((receivers >> index & 1) != 0)
            least = min(least, abs(dot(along, PhaseSlope(tube, ReceiverFrom(index, tube.Path.Ray.Origin)))));
    return least;
}

// What the currents of a tube change along u and v: see _TubeExtras.
struct Changes
{
    float4 CoPolarU, CoPolarV, CrossPolarU, CrossPolarV;
};

// The changes of a tube, by its number.
void SetChanges(uint tube, Changes changes)
{
    uint row = _ExtraRows * tube;
    _TubeExtras[row + 1] = changes.CoPolarU;
    _TubeExtras[row + 2] = changes.CoPolarV;
    _TubeExtras[row + 3] = changes.CrossPolarU;
    _TubeExtras[row + 4] = changes.CrossPolarV;
}

// Changes: of a tube that has them. Part: see _TubeParts. Rate: see RateOf.
void AddTube(Tube tube, Changes changes, uint part, float3 rate)
{
    uint bounces = BounceOf(tube);
    if (bounces != _OnlyBounce && _OnlyBounce != 0)
        return;
    uint at;
    InterlockedAdd(_Sums[TUBE_COUNT], 1, at);
    InterlockedAdd(_Sums[CountWord(POSE_TUBES)], 1);
    // Most tubes need no exchange.
    uint mostBounces = CountWord(POSE_BOUNCES);
    if (_Sums[mostBounces] < bounces)
        InterlockedMax(_Sums[mostBounces], bounces);
    if (at >= _ListCapacity.x)
        return;
    _Tubes[at] = tube;
    if (_HasParts != 0)
        _TubeParts[at] = part;
    if (_IsMoving != 0)
        _TubeExtras[_ExtraRows * at] = float4(rate, 0.0);
    if (HasChanges(tube))
        SetChanges(at, changes);
}

void AddTube(Tube tube, uint part, float3 rate)
{
    AddTube(tube, (Changes)0, part, rate);
}

// Adds a tube of a ray through a position of the grid, towards a receiver. At a finite range TubeChanges finds how its currents
// change, for which the position and the side of the cell are left in the first row of the changes.
void AddTubeOf(Tube currents, float2 position, TubePath tube, SurfacePoint at, Receiver receiver, float side)
{
    Changes changes = (Changes)0;
    changes.CoPolarU = float4(position, side, 0.0);
    currents.Tag |= _IsNear != 0 ? CHANGES : 0;
    AddTube(currents, changes, at.Part, RateTo(receiver, tube, at));
}

#endif
