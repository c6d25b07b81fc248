#ifndef GLINT_TUBE_FRINGES
#define GLINT_TUBE_FRINGES

#include "PhysicalOptics.hlsl"
#include "Sums.hlsl"
#include "Trigonometry.hlsl"

// Fringe fields of edges: what a wedge radiates beside its physical optics (Ufimtsev; Michaeli 1984). One thread a
// piece of an edge and a receiver.

// GLINT_EDGE_PIECE: a straight piece of an edge (Runtime/CrossSection/EdgePiece.cs).
struct EdgePiece
{
    float3 Centre;         // relative to the scene's centre, m
    float Length;          // m
    float3 Along;          // unit vector of the edge
    float OuterAngle;      // through the air from the first face to the second, rad
    float3 Into;           // unit vector in the first face, across the edge
    uint Part;             // see _TubeParts
    uint Instance;         // that it moves with
    uint Unused[3];
};

StructuredBuffer<EdgePiece> _EdgePieces;
uint2 _EdgeRange;                          // first piece and number of this dispatch
float _EdgeOffset;                         // of the start of a shadow ray from its edge, m

static const float PI = 0.5 * TWO_PI;

// Angle to a face, rad, below which a direction grazes it: the face neither lights the edge nor is lit.
static const float GRAZING_ANGLE = 1.0e-5;

// Minimum square of the sine of the angle between a direction and the edge.
static const float MIN_SQUARE_SINE = 1.0e-9;

// Steps in which the border between the lit and the dark part of a piece is found.
static const uint EDGE_BISECTIONS = 8;

// The angle of a direction around the edge from the first face, 0 to 2 pi.
float AngleAround(EdgePiece piece, float3 direction)
{
    float2 at = float2(dot(direction, piece.Into), dot(direction, cross(piece.Along, piece.Into)));
    // Along the edge there is no angle, and FXC's arc tangent of nothing is no number.
    float angle = any(at != 0.0) ? atan2(at.y, at.x) : 0.0;
    angle = angle < 0.0 ? angle + TWO_PI : angle;
    // A device's own arc tangent may be off by 1e-5.
    float2 wave = PhasorOf(angle);
    return angle + (at.y * wave.x - at.x * wave.y) / max(length(at), 1.0e-20);
}

// The part of a piece that sees the radar or a receiver: its ends from the middle, m; empty: 0, 0. Shadow rays start on
// the side of what they look for, but at least a right angle from both faces, so that none of these is in the way.
float2 LitPart(EdgePiece piece, uint which, inout uint rays)
{
    float angle = AngleAround(piece, ReceiverFrom(which, piece.Centre).Direction);
    if (angle < GRAZING_ANGLE || angle > piece.OuterAngle - GRAZING_ANGLE)
        return 0.0;
    float2 beside = _EdgeOffset * PhasorOf(clamp(angle, 0.5 * PI, piece.OuterAngle - 0.5 * PI));
    float3 start = piece.Centre + beside.x * piece.Into + beside.y * cross(piece.Along, piece.Into);
    // Other bodies may touch the ends.
    float reach = 0.5 * piece.Length - min(_EdgeOffset, 0.25 * piece.Length);
    float2 border = float2(-reach, reach), ends = 0.5 * piece.Length * float2(-1.0, 1.0), part = 0.0;
    bool isFirstLit = false, goesOn = true;
    [loop]
    for (uint step = 0; step < 2 + EDGE_BISECTIONS && goesOn; step++)
    {
        float at = step == 0 ? border.x : step == 1 ? border.y : 0.5 * (border.x + border.y);
        float3 position = start + at * piece.Along;
        bool isLit = IsInSight(position, (uint2)NO_INSTANCE, ReceiverFrom(which, position));
        rays++;
        if (step == 0)
            isFirstLit = isLit;
        else if (step == 1)
        {
            goesOn = isLit != isFirstLit;
            if (!goesOn && isLit)
                part = ends;
        }
        else if (isLit == isFirstLit)
            border.x = at;
        else
            border.y = at;
    }
    float middle = 0.5 * (border.x + border.y);
    if (goesOn)
        part = isFirstLit ? float2(ends.x, middle) : float2(middle, ends.y);
    return part;
}

// Limits a sine away from 0. Only directions that graze a face on both sides of an edge reach the limit.
float AwayFromZero(float sine)
{
    return abs(sine) > GRAZING_ANGLE ? sine : sine < 0.0 ? -GRAZING_ANGLE : GRAZING_ANGLE;
}

// cot(x / 2) / 2
float HalfCotangent(float x)
{
    float2 wave = PhasorOf(0.5 * x);
    return 0.5 * wave.x / AwayFromZero(wave.y);
}

// A wedge's field is a sum of -cot(x / 2n) / 2n for x, the angle from a border of illumination or reflection (Keller).
// Physical optics has -cot(x / 2) / 2 instead for each lit face. Both are -1/x at the border, where their difference is
// small: there it is taken from the series of cot(x / 2) / 2 = 1/x - x/12 - x^3/720 - x^5/30240 - x^7/1209600.
float FringeTerm(float x, float n, bool isLit)
{
    float inverse = 1.0 / n;
    if (!isLit)
        return -inverse * HalfCotangent(x * inverse);
    if (abs(x) >= 1.0)
        return HalfCotangent(x) - inverse * HalfCotangent(x * inverse);
    float s = x * x, q = inverse * inverse;
    return -x * ((1.0 - q) / 12.0 + s * ((1.0 - q * q) / 720.0 + s * ((1.0 - q * q * q) / 30240.0
        + s * (1.0 - q * q * q * q) / 1209600.0)));
}

// Coefficients f - f0 and g - g0 of a wedge, for angles to the radar and to the receiver.
float2 FringeCoefficients(float outerAngle, float toRadar, float toReceiver)
{
    float n = outerAngle / PI, difference = toReceiver - toRadar, sum = toReceiver + toRadar;
    bool isFirstLit = toRadar < PI - GRAZING_ANGLE, isSecondLit = outerAngle - toRadar < PI - GRAZING_ANGLE;
    float incident = FringeTerm(PI - difference, n, isFirstLit) + FringeTerm(PI + difference, n, isSecondLit);
    float reflected = FringeTerm(PI - sum, n, isFirstLit)
        + FringeTerm(PI + sum - 2.0 * outerAngle, n, isSecondLit);
    return float2(incident - reflected, incident + reflected);
}

float SquareSine(float3 direction, float3 along)
{
    float3 across = cross(direction, along);
    return dot(across, across);
}

// A piece as a tube of EDGE_CORNERS, without its length, which takes the place of the side. Phase and coefficients are those
// at a distance along it from its middle, m.
Tube FringeAt(EdgePiece piece, float distance, uint index)
{
    float3 at = piece.Centre + distance * piece.Along, t = piece.Along;
    Receiver radar = ReceiverFrom(_ReceiverCount, at), receiver = ReceiverFrom(index, at);
    float3 v = normalize(radar.V), h = normalize(radar.H - v * dot(v, radar.H));
    float2 coefficients = FringeCoefficients(piece.OuterAngle, AngleAround(piece, radar.Direction),
        AngleAround(piece, receiver.Direction));
    float square = SquareSine(radar.Direction, t);
    float scale = radar.Strength * receiver.Strength / (sqrt(PI) * square);
    float3 acrossSent = cross(radar.Direction, t), acrossReceived = cross(receiver.Direction, t);
    // electric and magnetic field sent along the edge: V, H; the same received
    float2 sent = float2(dot(v, t), dot(h, t)), sentAcross = float2(dot(v, acrossSent), dot(h, acrossSent)),
        received = float2(dot(receiver.V, t), dot(receiver.H, t)),
        receivedAcross = float2(dot(receiver.V, acrossReceived), dot(receiver.H, acrossReceived));
    float2 coPolar = scale * (coefficients.x * sent * received - coefficients.y * sentAcross * receivedAcross);
    float2 crossPolar = scale * (coefficients.x * sent * received.yx - coefficients.y * sentAcross * receivedAcross.yx);
    Tube fringe = (Tube)0;
    fringe.Gradient.x = dot(radar.Direction + receiver.Direction, t);
    fringe.Phase = radar.Phase + receiver.Phase + _Poses[s_pose].RadarPhase;
    fringe.Tag = SlotOfAll(index) | EDGE_CORNERS << 16;
    fringe.CoPolar = float4(coPolar.x, 0.0, coPolar.y, 0.0);
    fringe.CrossPolar = float4(crossPolar.x, 0.0, crossPolar.y, 0.0);
    return fringe;
}

// The rate of the path by an edge (see RateOf), the first by metres along it; 0 if nothing moves.
float3 RateAt(EdgePiece piece, float2 part, uint index)
{
    if (_IsMoving == 0)
        return 0.0;
    float3 middle = piece.Centre + 0.5 * (part.x + part.y) * piece.Along;
    float3 turn = ReceiverFrom(_ReceiverCount, middle).Direction + ReceiverFrom(index, middle).Direction;
    return RateOf(piece.Instance, middle, piece.Along, 0.0, turn, 0.0, 0.0);
}

// Adds the lit part of a piece. At a finite range its phase is exact at its ends, where the next piece begins, and bent
// between them, and its coefficients change along it.
void AddFringe(Tube fringe, EdgePiece piece, float2 part, uint index)
{
    float3 rate = RateAt(piece, part, index);
    if (_IsNear == 0)
    {
        AddTube(fringe, piece.Part, rate);
        return;
    }
    Tube first = FringeAt(piece, part.x, index), last = FringeAt(piece, part.y, index);
    float phase = 0.5 * (first.Phase + last.Phase);
    fringe.Corners01.y = phase - fringe.Phase;
    fringe.Phase = phase;
    fringe.Gradient.x = (last.Phase - first.Phase) / (part.y - part.x);
    Changes changes = (Changes)0;
    changes.CoPolarU = 0.5 * (last.CoPolar - first.CoPolar);
    changes.CrossPolarU = 0.5 * (last.CrossPolar - first.CrossPolar);
    fringe.Tag |= CHANGES;
    AddTube(fringe, changes, piece.Part, rate);
}

[numthreads(GLINT_GROUP, 1, 1)]
void GLINT_KERNEL(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint number = IndexOf(group, thread), index = number % _ReceiverCount;
    if (!TakeOfPose(number, _EdgeRange.y * _ReceiverCount))
        return;
    EdgePiece piece = _EdgePieces[_EdgeRange.x + number / _ReceiverCount];
    if (!IsInFootprint(piece.Centre)
        || SquareSine(ReceiverFrom(_ReceiverCount, piece.Centre).Direction, piece.Along) < MIN_SQUARE_SINE)
        return;
    float2 part = 0.5 * piece.Length * float2(-1.0, 1.0);
    uint rays = 0, queries = _IsMonostatic != 0 ? 1 : 2;
    // The radar, then the receiver.
    [loop]
    for (uint query = 0; query < queries && part.x < part.y; query++)
    {
        float2 seen = LitPart(piece, query == 0 ? _ReceiverCount : index, rays);
        part = float2(max(part.x, seen.x), min(part.y, seen.y));
    }
    // Additions to one word wait for each other.
    s_part = group.x % POSE_PARTS;
    AddTo(CountWord(POSE_RAYS), rays);
    if (part.x >= part.y)
        return;
    Tube fringe = FringeAt(piece, 0.5 * (part.x + part.y), index);
    fringe.Corners01.x = part.y - part.x;
    // Standard deviation of a border that is anywhere within its interval.
    bool isWhole = part.y - part.x == piece.Length;
    fringe.Error = isWhole ? 0.0 : 0.289 * piece.Length / (1u << EDGE_BISECTIONS);
    AddFringe(fringe, piece, part, index);
}

#endif
