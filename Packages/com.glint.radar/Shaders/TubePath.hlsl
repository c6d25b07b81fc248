#ifndef GLINT_TUBE_PATH
#define GLINT_TUBE_PATH

#include "TubeBindings.hlsl"
#include "Path.hlsl"
#include "Identity.hlsl"

// A ray with its differentials by the coordinates u, v of the grid (Igehy 1999), and the field that it carries.

struct TubePath
{
    Path Path;
    float3 PlaceU, PlaceV;          // m a base cell, in the plane of the facet of the last hit
    float2 LengthSlope;             // of the path up to it by u, v, m a base cell
    float3 DirectionU, DirectionV;  // a base cell
    float3 V, H;                    // the polarisations sent, mirrored with the ray
    float4 FieldV, FieldH;          // complex parts along V and H of the field for V sent, for H sent; without spread
    float StartSection;             // where the field would be 1, m2 a base cell
    uint Signature;                 // of the patches met, and who sees them
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
    // What the ray is longer up to the grid than the view axis, for each metre of it; at a finite range without
    // cancellation: the axis is along GridDepth.
    float longer = size - 1.0;
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
    tube.V = pose.SentV.xyz;
    tube.H = pose.SentH.xyz;
    TurnAcross(d, tube.V, tube.H);
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
    uint mixed = (tube.Signature ^ value) * 16777619u;
    tube.Signature = (mixed ^ (mixed >> 13)) * 2246822519u;
}

// Caustic lines that the tube passes over a distance: roots of its section, a quadratic function of the distance.
uint CausticsWithin(TubePath tube, float distance)
{
    float3 d = tube.Path.Ray.Direction;
    float a = Section(tube.DirectionU, tube.DirectionV, d);
    float b = Section(tube.PlaceU, tube.DirectionV, d) + Section(tube.DirectionU, tube.PlaceV, d);
    float c = Section(tube.PlaceU, tube.PlaceV, d);
    float root = b * b - 4.0 * a * c;
    if (root <= 0.0 || a == 0.0 && b == 0.0)
        return 0;
    float q = -0.5 * (b + (b < 0.0 ? -sqrt(root) : sqrt(root)));
    float first = c / q, second = a == 0.0 ? -1.0 : q / a;
    return (first > 0.0 && first < distance ? 1 : 0) + (second > 0.0 && second < distance ? 1 : 0);
}

// The normal at a hit: that of the facet, or of its patch.
SurfacePoint PointOf(TubePath tube, Hit hit, float3 facetNormal, float3 placeU, float3 placeV)
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
    at.FacetNormal = facetNormal;
    at.Normal = facetNormal;
    at.Cosine = -dot(facetNormal, tube.Path.Ray.Direction);
    at.NextStart = hit.NextStart;
    if (facet.y == FLAT)
        return at;
    float4 x = _NormalFields[facet.y], y = _NormalFields[facet.y + 1], z = _NormalFields[facet.y + 2];
    InstanceRecord record = LoadInstance(hit.Instance);
    Pair pair = LoadPair(record.Page, record.FirstRow + hit.Row);
    float3 middle = (pair.Corner0 + pair.Corner2 + (hit.Second ? pair.Corner3 : pair.Corner1)) / 3.0;
    float3 from = PointToLocal(record, tube.Path.Ray.Origin) - middle;
    float3 mean = NormalFromLocal(record, float3(dot(x.xyz, from) + x.w, dot(y.xyz, from) + y.w,
        dot(z.xyz, from) + z.w));
    // Normals of a sharp ridge may cancel each other.
    float size = max(length(mean), 1.0e-6) * (dot(mean, facetNormal) < 0.0 ? -1.0 : 1.0);
    float3 normal = mean / size, d = tube.Path.Ray.Direction;
    bool looksAway = dot(normal, d) >= 0.0;
    // Derivatives along the facet, on which the hit lies.
    float3 along = d - normal * dot(normal, d);
    float alongSize = length(along);
    float3x3 directions = float3x3(placeU, placeV, alongSize > 1.0e-6 ? along / alongSize : (float3)0);
    float toFacet = min(dot(d, facetNormal), -MIN_COSINE);
    float3 derivatives[3];
    [unroll]
    for (uint i = 0; i < 3; i++)
    {
        float3 step = directions[i] - d * dot(directions[i], facetNormal) / toFacet;
        float3 local = VectorToLocal(record, i < 2 ? step : directions[i]);
        float3 change = NormalFromLocal(record, float3(dot(x.xyz, local), dot(y.xyz, local), dot(z.xyz, local))) / size;
        derivatives[i] = change - normal * dot(normal, change);
    }
    at.Cosine = max(0.0, -dot(normal, d));
    if (!looksAway)
    {
        at.Normal = normal;
        at.NormalU = derivatives[0];
        at.NormalV = derivatives[1];
    }
    at.CurvatureAlong = dot(derivatives[2], directions[2]);
    return at;
}

// Of the incidence angle on the facet itself.
float FacetCosine(SurfacePoint at, float3 direction)
{
    return max(-dot(direction, at.FacetNormal), MIN_COSINE);
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
    MoveTo(tube.Path, hit);
    float3 d = tube.Path.Ray.Direction;
    float3 placeU = tube.PlaceU + hit.Distance * tube.DirectionU, placeV = tube.PlaceV + hit.Distance * tube.DirectionV;
    at = PointOf(tube, hit, hit.Normal, placeU, placeV);
    float cosine = -dot(d, at.Normal);
    float2 way = float2(dot(placeU, at.FacetNormal), dot(placeV, at.FacetNormal)) / FacetCosine(at, d);
    tube.PlaceU = placeU + way.x * d;
    tube.PlaceV = placeV + way.y * d;
    tube.LengthSlope += way;
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

// Reflects a tube; false if it would dive into its facet.
bool ScatterTube(inout TubePath tube, SurfacePoint at)
{
    float3 d = tube.Path.Ray.Direction, n = at.Normal;
    float along = dot(d, n);
    float3 next = Mirrored(d, n);
    float leaving = dot(next, at.FacetNormal);
    if (at.IsLost || leaving <= 0.0)
        return false;
    // The section of the rays jumps, since they are reflected by another normal than that of their facet; the power does not.
    tube.StartSection *= leaving / FacetCosine(at, d);
    float3 s = AcrossIncidence(d, n, tube.V);
    float4 reflection = ReflectionOf(at.Surface, -along);
    float2 components = float2(dot(s, tube.V), dot(s, tube.H));
    tube.FieldV = ReflectField(tube.FieldV, components, reflection);
    tube.FieldH = ReflectField(tube.FieldH, components, reflection);
    tube.V = Mirrored(tube.V, n);
    tube.H = Mirrored(tube.H, n);
    float3 directionU = Mirrored(tube.DirectionU, n)
        - 2.0 * (along * at.NormalU + dot(d, at.NormalU) * n);
    float3 directionV = Mirrored(tube.DirectionV, n)
        - 2.0 * (along * at.NormalV + dot(d, at.NormalV) * n);
    if (_IsMoving != 0)
        tube.Rate += RateOf(at.Instance, tube.Path.Ray.Origin, tube.PlaceU, tube.PlaceV, next - d,
            directionU - tube.DirectionU, directionV - tube.DirectionV);
    tube.DirectionU = directionU;
    tube.DirectionV = directionV;
    Leave(tube.Path, next);
    return true;
}

#endif
