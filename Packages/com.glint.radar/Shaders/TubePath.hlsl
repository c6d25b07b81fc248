#ifndef GLINT_TUBE_PATH
#define GLINT_TUBE_PATH

#include "CurvedFacet.hlsl"
#include "Path.hlsl"
#include "Identity.hlsl"
#include "Trigonometry.hlsl"

// A ray with its differentials by the coordinates u, v of the grid (Igehy 1999), and the field that it carries.

struct TubePath
{
    Path Path;
    float3 PlaceU, PlaceV;          // m a base cell, on the surface of the last hit; after it, in the plane of its facet
    float2 LengthSlope;             // of the path up to it by u, v, m a base cell
    float3 DirectionU, DirectionV;  // a base cell
    float3 V, H;                    // the polarisations sent, mirrored with the ray
    float2 Roll;                    // of V towards H about the direction, beside what the direction's turn makes, rad a base cell
    float4 FieldV, FieldH;          // complex parts along V and H of the field for V sent, for H sent; without spread
    float StartSection;             // where the field would be 1, m2 a base cell
    float2 ExcessSection;           // of rays that leave a facet beside those that leave its surface: m2 a base cell; a metre
    uint Signature;                 // of the patches met, and who sees them
    uint Facets;                    // that of the curved facets met, at whose sides curvatures change
    bool HasMetTarget;              // anything but a sea with a diffuse echo
    float3 Rate;                    // by the motion of what it was reflected by: see RateOf
};

// Of a ray that meets nothing.
static const uint NO_SIGNATURE = 2166136261u;

// What a tube meets.
struct SurfacePoint
{
    float3 Normal;         // smoothed, towards the ray
    float3 NormalU;        // its derivatives
    float3 NormalV;
    float3 FacetNormal;    // towards the ray
    bool IsCurved;         // it is on the curved surface that the facet stands for
    uint NormalField;      // of the facet: row in _NormalFields, or FLAT
    float Lead;            // of a curved surface before the facet, m
    float CurvatureAlong;  // of the surface along the ray, 1/m; above 0: convex
    float Cosine;          // of the incidence angle on the patch; 0 where the patch looks away
    uint Patch;
    uint Surface;
    uint Instance;         // index in the scene
    uint2 Triangle;        // see NumberOf
    uint Part;             // see _TubeParts
    bool IsSea;            // with a diffuse echo
    float3 NextStart;      // of shadow rays
    bool IsLost;           // grazing or spread so much that the tube ends here and radiates nothing
};

// Section of the tube across its direction, m2 a base cell, signed.
float Section(float3 placeU, float3 placeV, float3 direction)
{
    return dot(cross(placeU, placeV), direction);
}

// Minimum cosine of the incidence angle of hits that radiate.
static const float MIN_COSINE = 1.0e-4;

// Maximum section of a tube, in those of its start: its field is then 1/1000.
static const float MAX_SPREAD = 1.0e6;

// Turns V and H of an antenna, to be perpendicular to a direction.
void TurnAcross(float3 direction, inout float3 v, inout float3 h)
{
    v = normalize(v - direction * dot(direction, v));
    h -= direction * dot(direction, h);
    h = normalize(h - v * dot(v, h));
}

TubePath BeginTube(float2 position)
{
    TubePose pose = _Poses[s_pose];
    float2 at = position - pose.Reference;
    float3 whole = pose.Direction.xyz + at.x * pose.DirectionDx.xyz + at.y * pose.DirectionDy.xyz;
    float size = length(whole);
    float3 d = whole / size;
    TubePath tube = (TubePath)0;
    // What the ray is longer up to the grid than the view axis, for each metre of it, without cancellation: the axis is
    // along GridDepth. Parallel rays are as long.
    float longer = 0.0;
    if (_IsNear != 0)
    {
        float3 aside = cross(whole, normalize(pose.GridDepth.xyz));
        longer = dot(aside, aside) / (size + 1.0);
    }
    tube.Path = BeginPath(pose.Origin.xyz + at.x * pose.OriginDx.xyz + at.y * pose.OriginDy.xyz, d,
        pose.OriginDepth * longer);
    tube.PlaceU = pose.OriginDx.xyz;
    tube.PlaceV = pose.OriginDy.xyz;
    tube.LengthSlope = pose.OriginDepth * float2(dot(d, pose.DirectionDx.xyz), dot(d, pose.DirectionDy.xyz));
    tube.DirectionU = (pose.DirectionDx.xyz - d * dot(d, pose.DirectionDx.xyz)) / size;
    tube.DirectionV = (pose.DirectionDy.xyz - d * dot(d, pose.DirectionDy.xyz)) / size;
    tube.V = pose.SentV;
    tube.H = pose.SentH.xyz;
    // V stays in the plane of the antenna's V.
    float3 turnedBy = d * dot(d, tube.V);
    float lift = -dot(d, tube.V) / max(length(tube.V - turnedBy), 1.0e-6);
    TurnAcross(d, tube.V, tube.H);
    tube.Roll = lift * float2(dot(tube.DirectionU, tube.H), dot(tube.DirectionV, tube.H));
    tube.FieldV = float4(1.0, 0.0, 0.0, 0.0);
    tube.FieldH = float4(0.0, 0.0, 1.0, 0.0);
    tube.StartSection = _IsNear != 0
        ? _Range * _Range * Section(tube.DirectionU, tube.DirectionV, d) : Section(tube.PlaceU, tube.PlaceV, d);
    tube.Signature = NO_SIGNATURE;
    return tube;
}

// Product with j.
float2 Quarter(float2 a)
{
    return float2(-a.y, a.x);
}

void Sign(inout TubePath tube, uint value)
{
    tube.Signature = Mixed(tube.Signature, value);
}

// Caustic lines that the tube passes over a distance: roots of its section, a quadratic function of the distance. Both are
// real, as wavefronts have two radii of curvature; rounding can hide that where they are the same, at a focus.
uint CausticsWithin(TubePath tube, float distance)
{
    float3 d = tube.Path.Ray.Direction;
    float a = Section(tube.DirectionU, tube.DirectionV, d);
    float b = Section(tube.PlaceU, tube.DirectionV, d) + Section(tube.DirectionU, tube.PlaceV, d);
    float c = Section(tube.PlaceU, tube.PlaceV, d);
    if (a == 0.0 && b == 0.0)
        return 0;
    float root = sqrt(max(b * b - 4.0 * a * c, 0.0)), q = -0.5 * (b + (b < 0.0 ? -root : root));
    float first = c / q, second = a == 0.0 ? -1.0 : q / a;
    return (first > 0.0 && first < distance ? 1 : 0) + (second > 0.0 && second < distance ? 1 : 0);
}

// What a ray meets: a facet.
SurfacePoint PointOf(TubePath tube, Hit hit)
{
    SurfacePoint at = (SurfacePoint)0;
    Identity identity = Identify(hit);
    uint4 first = _InstanceFacets[identity.Instance];
    uint2 facet = _Facets[first.x + identity.Triangle];
    at.Patch = first.y + facet.x;
    at.Surface = identity.Surface;
    at.Instance = identity.Instance;
    at.Triangle = NumberOf(hit.Instance, hit.Row, hit.Second);
    at.Part = first.z + identity.Triangle;
    at.IsSea = first.w != 0;
    at.FacetNormal = hit.Normal;
    at.Normal = hit.Normal;
    at.Cosine = -dot(hit.Normal, tube.Path.Ray.Direction);
    at.NextStart = hit.NextStart;
    at.NormalField = facet.y;
    at.IsCurved = facet.y != FLAT;
    return at;
}

// Of the incidence angle on a plane.
float CosineOn(float3 normal, float3 direction)
{
    return max(-dot(direction, normal), MIN_COSINE);
}

// Moves the differentials along the tube, to where rays beside it meet a plane through its place.
void SpreadTo(inout TubePath tube, float distance, float3 normal)
{
    float3 d = tube.Path.Ray.Direction;
    float3 placeU = tube.PlaceU + distance * tube.DirectionU, placeV = tube.PlaceV + distance * tube.DirectionV;
    float2 way = float2(dot(placeU, normal), dot(placeV, normal)) / CosineOn(normal, d);
    tube.PlaceU = placeU + way.x * d;
    tube.PlaceV = placeV + way.y * d;
    tube.LengthSlope += way;
}

// Moves a tube from the last hit to this one, on the surface that the facet stands for.
void MoveToSurface(inout TubePath tube, inout SurfacePoint at, Hit hit)
{
    MoveTo(tube.Path, hit);
    if (!at.IsCurved)
    {
        SpreadTo(tube, hit.Distance, at.FacetNormal);
        return;
    }
    float3 d = tube.Path.Ray.Direction;
    InstanceRecord record = LoadInstance(hit.Instance);
    CurvedFacet facet = LoadCurvedFacet(record, hit, at.NormalField);
    CurvedHit curved = MeetCurved(facet, record, tube.Path.Ray.Origin, d, at.FacetNormal);
    at.Cosine = max(0.0, -dot(curved.Normal, d));
    float3 along = d - curved.Normal * dot(curved.Normal, d);
    along /= max(length(along), 1.0e-6);
    at.CurvatureAlong = dot(ChangeAlong(facet, record, curved, along, at.FacetNormal), along);
    // A mean normal that looks away from the ray is of no use.
    at.IsCurved = at.Cosine > 0.0;
    if (!at.IsCurved)
    {
        SpreadTo(tube, hit.Distance, at.FacetNormal);
        return;
    }
    at.Lead = curved.Lead;
    at.Normal = curved.Normal;
    tube.Path.Ray.Origin -= at.Lead * d;
    tube.Path.RelativeLength -= at.Lead;
    SpreadTo(tube, hit.Distance - at.Lead, curved.Tangent);
    at.NormalU = ChangeAlong(facet, record, curved, tube.PlaceU, at.FacetNormal);
    at.NormalV = ChangeAlong(facet, record, curved, tube.PlaceV, at.FacetNormal);
}

// Most that facets change the section of a tube beside that from their surface: near a caustic line either may be 0.
static const float MAX_EXCESS = 8.0;

// Gives the field of a tube that has left a curved surface the spread of the rays from there; its section is that of the rays
// from the facet, which neighbours share. distance: since then.
void SpreadFromSurface(inout TubePath tube, float distance)
{
    float excess = tube.ExcessSection.x + distance * tube.ExcessSection.y;
    if (excess == 0.0)
        return;
    float section = Section(tube.PlaceU, tube.PlaceV, tube.Path.Ray.Direction);
    tube.StartSection *= clamp(abs(section) / max(abs(section - excess), 1.0e-30), 1.0 / MAX_EXCESS, MAX_EXCESS);
    tube.ExcessSection = 0.0;
}

// Traces a tube to its next hit; false if there is none.
bool AdvanceTube(inout TubePath tube, out SurfacePoint at)
{
    at = (SurfacePoint)0;
    if (IsLast(tube.Path))
        return false;
    Hit hit = ClosestHit(tube.Path.Ray, MISS, NO_ENTRY_POINTS, NOT_MET);
    if (IsMiss(hit))
        return false;
    uint caustics = CausticsWithin(tube, hit.Distance);
    if ((caustics & 1) != 0)
    {
        tube.FieldV = float4(Quarter(tube.FieldV.xy), Quarter(tube.FieldV.zw));
        tube.FieldH = float4(Quarter(tube.FieldH.xy), Quarter(tube.FieldH.zw));
    }
    if ((caustics & 2) != 0)
    {
        tube.FieldV = -tube.FieldV;
        tube.FieldH = -tube.FieldH;
    }
    at = PointOf(tube, hit);
    MoveToSurface(tube, at, hit);
    float3 d = tube.Path.Ray.Direction;
    SpreadFromSurface(tube, hit.Distance - at.Lead);
    float cosine = -dot(d, at.Normal);
    float section = abs(Section(tube.PlaceU, tube.PlaceV, d));
    float squareU = dot(tube.PlaceU, tube.PlaceU), squareV = dot(tube.PlaceV, tube.PlaceV);
    float maxSection = MAX_SPREAD * abs(tube.StartSection);
    // Compilers may take a comparison with NaN for either.
    at.IsLost = IsNaN(cosine) || IsNaN(section) || IsNaN(squareU) || IsNaN(squareV) || cosine < MIN_COSINE
        || section > maxSection || max(squareU, squareV) > MAX_SPREAD * maxSection;
    if (at.IsLost)
    {
        tube.PlaceU = 0.0;
        tube.PlaceV = 0.0;
    }
    tube.HasMetTarget = tube.HasMetTarget || !at.IsSea;
    Sign(tube, at.Patch);
    tube.Facets = Mixed(tube.Facets, at.NormalField);
    return true;
}

// Reflection coefficients R_s, R_p of a surface.
float4 ReflectionOf(uint surface, float cosine)
{
    float place = saturate(cosine) * REFLECTION_STEPS;
    uint step = min((uint)place, REFLECTION_STEPS - 1), first = surface * (REFLECTION_STEPS + 1) + step;
    return lerp(_Reflections[first], _Reflections[first + 1], place - step);
}

// Unit vector across direction and normal: along the s polarisation.
float3 AcrossIncidence(float3 direction, float3 normal, float3 fallback)
{
    float3 across = cross(direction, normal);
    float size = length(across);
    return size > 1.0e-4 ? across / size : fallback;
}

// The field after a reflection, in the mirrored polarisations: R_s along s, -R_p along the mirrored p.
float4 ReflectField(float4 field, float2 along, float4 reflection)
{
    // along: components of s in V and H
    float2 s = field.xy * along.x + field.zw * along.y, p = field.xy * -along.y + field.zw * along.x;
    s = ComplexMul(s, reflection.xy);
    p = -ComplexMul(p, reflection.zw);
    return float4(s * along.x - p * along.y, s * along.y + p * along.x);
}

float3 Mirrored(float3 v, float3 normal)
{
    return v - 2.0 * dot(v, normal) * normal;
}

// What a moving instance adds to the rate of a path at a place: by u and v, m/s a base cell, and itself, m/s. The rate
// is that at which the path shortens: positive for what approaches. The velocity is that of the material at the place:
// along a mirror a path is stationary, so that its shift over the surface does not count (Fermat).
float3 RateOf(uint instance, float3 position, float3 placeU, float3 placeV, float3 turn, float3 turnU, float3 turnV)
{
    float3 turning = _Motions[2 * instance + 1].xyz, velocity = _Motions[2 * instance].xyz + cross(turning, position);
    return float3(dot(cross(turning, placeU), turn) + dot(velocity, turnU),
        dot(cross(turning, placeV), turn) + dot(velocity, turnV), dot(velocity, turn));
}

// Continues a tube, reflected by a curved surface, from its facet: with phase and spread of the rays that leave the surface.
void LeaveFacet(inout TubePath tube, SurfacePoint at, float3 next, float3 directionU, float3 directionV)
{
    float3 d = tube.Path.Ray.Direction;
    float2 turn = float2(dot(tube.DirectionU, next) + dot(d, directionU), dot(tube.DirectionV, next) + dot(d, directionV)),
        before = tube.LengthSlope;
    float3 placeU = tube.PlaceU, placeV = tube.PlaceV;
    SpreadTo(tube, at.Lead, at.FacetNormal);
    tube.ExcessSection = float2(Section(tube.PlaceU, tube.PlaceV, next) - Section(placeU, placeV, next),
        Section(tube.PlaceU - placeU, directionV, next) + Section(directionU, tube.PlaceV - placeV, next));
    tube.LengthSlope = before + (tube.LengthSlope - before) * dot(d, next) + at.Lead * turn;
    tube.Path.Ray.Origin += at.Lead * d;
    tube.Path.RelativeLength += at.Lead * dot(d, next);
}

// Reflects a tube; false if it would dive into its facet.
bool ScatterTube(inout TubePath tube, SurfacePoint at)
{
    float3 d = tube.Path.Ray.Direction, n = at.Normal;
    float along = dot(d, n);
    float3 next = Mirrored(d, n);
    if (at.IsLost || dot(next, at.FacetNormal) <= 0.0)
        return false;
    float3 s = AcrossIncidence(d, n, tube.V);
    float4 reflection = ReflectionOf(at.Surface, -along);
    float2 components = float2(dot(s, tube.V), dot(s, tube.H));
    tube.FieldV = ReflectField(tube.FieldV, components, reflection);
    tube.FieldH = ReflectField(tube.FieldH, components, reflection);
    float alongV = dot(tube.V, n), alongH = dot(tube.H, n);
    tube.Roll += 2.0 * (alongH * float2(dot(tube.V, at.NormalU), dot(tube.V, at.NormalV))
        - alongV * float2(dot(tube.H, at.NormalU), dot(tube.H, at.NormalV)));
    tube.V = Mirrored(tube.V, n);
    tube.H = Mirrored(tube.H, n);
    float3 directionU = Mirrored(tube.DirectionU, n)
        - 2.0 * (along * at.NormalU + dot(d, at.NormalU) * n);
    float3 directionV = Mirrored(tube.DirectionV, n)
        - 2.0 * (along * at.NormalV + dot(d, at.NormalV) * n);
    if (_IsMoving != 0)
        tube.Rate += RateOf(at.Instance, tube.Path.Ray.Origin, tube.PlaceU, tube.PlaceV, next - d,
            directionU - tube.DirectionU, directionV - tube.DirectionV);
    if (at.IsCurved)
        LeaveFacet(tube, at, next, directionU, directionV);
    tube.DirectionU = directionU;
    tube.DirectionV = directionV;
    Leave(tube.Path, next);
    return true;
}

#endif
