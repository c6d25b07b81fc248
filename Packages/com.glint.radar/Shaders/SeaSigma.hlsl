#ifndef GLINT_SEA_SIGMA
#define GLINT_SEA_SIGMA

// What a facet of a sea scatters back, per its true area (Documentation~/clutter.md).

StructuredBuffer<float4> _FacetTable;      // FacetTable.Values: two elements a value
float4 _SeaWind;                           // horizontal unit vector along the wind; w: offset of a shadow ray's start, m
float4 _SeaMirror;                         // of mirror points: halves of the inverse covariances of the unresolved slopes,
                                           // along and across the wind and mixed; factor

// Natural logarithms of factors of the power of VV, HV and HH, and of the sine of the grazing angle at which they hold, in
// ascending order: one table, or one for each of some directions.
StructuredBuffer<float4> _SeaLevels;
uint _SeaLevelCount;                       // of a table

// Of Core/Clutter/FacetTable.cs.
static const uint FACET_ROWS = 257;
static const uint FACET_COLUMNS = 9;

// Products of the elements of a facet's scattering matrix: Core/Clutter/FacetPower.cs. Its s is along normal x direction
// to the radar.
struct FacetPower
{
    float SS, PP, SP, SSPP, SSSP, PPSP;
};

// Two elements of the table, interpolated.
void ReadTable(float cosine, float squaredWindSine, out float4 first, out float4 second)
{
    float row = (FACET_ROWS - 1) * sqrt(saturate(1.0 - cosine)), column = (FACET_COLUMNS - 1) * saturate(squaredWindSine);
    uint top = min((uint)row, FACET_ROWS - 2), left = min((uint)column, FACET_COLUMNS - 2);
    uint element = 2 * (top * FACET_COLUMNS + left), below = element + 2 * FACET_COLUMNS;
    float down = row - top, right = column - left;
    first = lerp(lerp(_FacetTable[element], _FacetTable[element + 2], right),
        lerp(_FacetTable[below], _FacetTable[below + 2], right), down);
    second = lerp(lerp(_FacetTable[element + 1], _FacetTable[element + 3], right),
        lerp(_FacetTable[below + 1], _FacetTable[below + 3], right), down);
}

// Cosine and sine of the angle from a direction to the wind, seen from above.
float2 ToWind(float3 direction)
{
    float size = length(direction.xz);
    return size > 0.0 ? float2(dot(_SeaWind.xz, direction.xz), _SeaWind.x * direction.z - _SeaWind.z * direction.x) / size
        : float2(1.0, 0.0);
}

// Bragg scattering of a facet: sigma0 of VV, HV and HH. V is the vertical polarisation's unit vector. The last input is
// the logarithm of the wind in the facet's gust over the mean wind.
float3 BraggSigma(float3 normal, float3 toRadar, float3 v, float logWind)
{
    float3 across = cross(normal, toRadar);
    float cosine = dot(normal, toRadar), sine = length(across);
    float2 wind = float2(1.0, 0.0), turn = float2(1.0, 0.0);
    if (sine > 0.0)
    {
        float3 s = across / sine, h = cross(v, toRadar);
        turn = float2(dot(s, h), dot(s, v));
        turn /= max(length(turn), 1.0e-20);
        wind = ToWind((toRadar - cosine * normal) / sine);
    }
    float4 first, second;
    ReadTable(cosine, wind.y * wind.y, first, second);
    float twice = 2.0 * wind.x * wind.y;
    FacetPower power;
    power.SS = first.x;
    power.PP = first.y;
    power.SP = first.z;
    power.SSPP = first.w;
    power.SSSP = twice * second.x;
    power.PPSP = twice * second.y;
    float a = turn.x * turn.x, b = turn.y * turn.y, product = turn.x * turn.y;
    float both = 4.0 * a * b * power.SP + 2.0 * a * b * power.SSPP;
    return exp(second.w * logWind) * max(0.0, float3(
        b * b * power.SS + a * a * power.PP + both + 4.0 * product * (b * power.SSSP + a * power.PPSP),
        a * b * (power.SS + power.PP - 2.0 * power.SSPP) + (a - b) * (a - b) * power.SP
            + 2.0 * product * (a - b) * (power.SSSP - power.PPSP),
        a * a * power.SS + b * b * power.PP + both - 4.0 * product * (a * power.SSSP + b * power.PPSP)));
}

// Mirror points of a facet, in VV and HH: SeaScattering.Specular.
float SpecularSigma(float3 normal, float3 toRadar)
{
    float2 slope = normal.xz / max(normal.y, 1.0e-6) - toRadar.xz / max(toRadar.y, 1.0e-6);
    float along = dot(slope, _SeaWind.xz), across = slope.x * _SeaWind.z - slope.y * _SeaWind.x;
    float exponent = along * along * _SeaMirror.x + across * across * _SeaMirror.y + 2.0 * along * across * _SeaMirror.z;
    float squared = max(toRadar.y * toRadar.y, 1.0e-12);
    return max(0.0, normal.y) * _SeaMirror.w * exp(-min(exponent, 80.0)) / (squared * squared);
}

// Sigma0 of a breaking facet in VV, HV and HH; its incidence is that on the mean sea.
float3 BreakingSigma(float cosine)
{
    float4 first, coPolar, crossPolar;
    ReadTable(cosine, 0.0, first, coPolar);
    ReadTable(cosine, 1.0, first, crossPolar);
    return float3(coPolar.z, crossPolar.z, coPolar.z);
}

// Factors that bring the power of VV, HV and HH to a published level: ClutterLevelTable.FactorAt. first: element of the
// table.
float3 LevelAt(float sine, uint first)
{
    float place = log(max(sine, 1.0e-6));
    uint next = 0;
    [loop]
    while (next < _SeaLevelCount && _SeaLevels[first + next].w <= place)
        next++;
    float4 above = _SeaLevels[first + min(next, _SeaLevelCount - 1)], below = _SeaLevels[first + max(next, 1) - 1];
    float share = above.w > below.w ? (place - below.w) / (above.w - below.w) : 0.0;
    return exp(lerp(below.xyz, above.xyz, saturate(share)));
}

#endif
