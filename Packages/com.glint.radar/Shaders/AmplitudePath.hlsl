#ifndef GLINT_AMPLITUDE_PATH
#define GLINT_AMPLITUDE_PATH

#include "TubeShapes.hlsl"
#include "TubeSlices.hlsl"
#include "AmplitudePose.hlsl"
#include "Mirror.hlsl"
#include "Identity.hlsl"
#include "Sums.hlsl"

// The experiment's rays as the middle of tubes: a ray is reflected by the facets' planes, and is received where it
// crosses the receiver's rectangle before any triangle (ReceiverPlane.hlsl). The length of its path is an exact function
// of its position in the picture as long as it meets the same planes.

// Input.
StructuredBuffer<AmplitudePose> _AmplitudePoses;
uint _PointWords;                          // words of a point of _Points
uint _PointCapacity;

// What is known of the rays through corners of cells, of a point: signature; hash of all planes met; and for each bounce
// where the ray crosses the plane of the receiver, see Landing.
RWStructuredBuffer<uint> _Points;

// Parts of base cells on whose sides a neighbour has found what the ends of the side do not show, REVEALED_PARTS x
// REVEALED_PARTS a cell, a word a row, _RevealedWords a pose: in earlier attempts, and in all with this one.
static const uint REVEALED_LEVEL = 5;
static const uint REVEALED_PARTS = 32;
StructuredBuffer<uint> _Revealed;
RWStructuredBuffer<uint> _RevealedByNow;

static const uint POINT_LANDINGS = 2;      // first word of the landings, two words each
static const uint NO_POINT = 0xffffffff;
static const uint NO_LANDING = 0xffffffff;

// Largest coordinate of a landing: the ray goes elsewhere.
static const float MAX_LANDING = 30000.0;

// Where a ray goes, seen from its last hit: 0 is the receiver's centre, 1 its edge.
struct Landing
{
    float2 Position;
    float Motion;          // of the position by a base cell on the same planes
};

// GLINT_RETURN: what a ray gives (Runtime/Tracing/BorderRay.cs).
struct Return
{
    uint Signature;        // of the planes met; 0: not received
    float Length;          // of the path, less TubePose.OriginDepth and the receiver's depth, m
    float2 Gradient;       // of the length, m a base cell
    float3 Bend;           // its second derivatives: by u, by v, by both
    float BendError;       // of a border cell: area by which the piece may be off, since its phase is bent
};

static uint s_copy = 0;                    // of the counts to which this thread adds

// Makes a pose that of the thread. index: of what the thread does.
void EnterPose(uint pose, uint index)
{
    s_pose = pose;
    s_copy = index % AMPLITUDE_COPIES;
    s_firstInstance = _AmplitudePoses[pose].FirstInstance;
    s_firstRow = _AmplitudePoses[pose].FirstRow;
}

// Word of a sum of this thread's pose.
uint SumWord(uint sum)
{
    return TUBE_SUMS + s_pose * TUBE_SUM_WORDS + sum;
}

// The same of a count of an amplitude.
uint AmplitudeWord(uint count)
{
    return TUBE_SUMS + _PoseCount * TUBE_SUM_WORDS + (s_copy * _PoseCount + s_pose) * AMPLITUDE_WORDS + count;
}

// First word of the parts of a base cell.
uint FirstRevealed(uint2 cell)
{
    return s_pose * _RevealedWords + REVEALED_PARTS * (cell.x + cell.y * _Poses[s_pose].Cells.x);
}

// Stereographic, so that rays that go away from the receiver are far from it.
Landing LandingOf(Path path, float3 stepU, float3 stepV, float pathLength)
{
    float4 axis = _AmplitudePoses[s_pose].ReceiverRight;
    float3 way = _AmplitudePoses[s_pose].ReceiverCentre.xyz - path.Ray.Origin, d = path.Ray.Direction;
    float distance = max(length(way), 1.0e-6);
    way /= distance;
    float3 right = normalize(axis.xyz - way * dot(way, axis.xyz)), up = cross(way, right);
    float2 halfSize = float2(axis.w, _AmplitudePoses[s_pose].ReceiverUp.w) / distance;
    float towards = max(1.0 + dot(d, way), 1.0e-6);
    Landing landing;
    landing.Position = clamp(2.0 * float2(dot(d, right), dot(d, up)) / (towards * halfSize), -MAX_LANDING, MAX_LANDING);
    float2 motion = float2(length(stepU), length(stepV)) * (_AmplitudePoses[s_pose].Aside.w != 0.0 ? 1.0 : pathLength + distance);
    landing.Motion = (motion.x + motion.y) / (distance * min(halfSize.x, halfSize.y));
    return landing;
}

// Distance along a ray to the receiver's rectangle, which it crosses against its axis; MISS if it does not.
float ToReceiver(float3 origin, float3 direction)
{
    AmplitudePose pose = _AmplitudePoses[s_pose];
    float3 forward = pose.ReceiverForward.xyz, centre = pose.ReceiverCentre.xyz;
    float distance = ToPlane(origin, direction, centre, forward);
    float3 position = origin + distance * direction - centre;
    bool isWithin = abs(dot(position, pose.ReceiverRight.xyz)) <= pose.ReceiverRight.w
        && abs(dot(position, pose.ReceiverUp.xyz)) <= pose.ReceiverUp.w;
    return dot(direction, forward) < 0.0 && distance > 0.0 && isWithin ? distance : MISS;
}

// Length and derivatives of a received path. Mirrored at the planes the rays are those of one point, or parallel, to a
// plane: the length is h |D| / (D.n), with D linear in the position.
Return ReturnOf(Path path, float3 stepU, float3 stepV, float distance, uint signature)
{
    float4 receiver = _AmplitudePoses[s_pose].ReceiverForward;
    float3 d = path.Ray.Direction, forward = receiver.xyz;
    float c = -dot(d, forward), toPlane = receiver.w + dot(path.Ray.Origin, forward);
    float2 b = -float2(dot(stepU, forward), dot(stepV, forward)) / c;
    Return result;
    result.Signature = signature;
    // The distance less the receiver's depth, without the rounding of large numbers.
    float3 across = d + forward;
    result.Length = path.RelativeLength + (dot(path.Ray.Origin, forward) + toPlane * dot(across, across) / (2.0 * c));
    if (_AmplitudePoses[s_pose].Aside.w != 0.0)
    {
        result.Gradient = -b;
        result.Bend = 0.0;
        return result;
    }
    float whole = _Poses[s_pose].OriginDepth + path.RelativeLength + distance;
    float2 a = float2(dot(stepU, d), dot(stepV, d));
    result.Gradient = whole * (a - b);
    result.Bend = whole * float3(
        dot(stepU, stepU) - a.x * a.x + 2.0 * b.x * (b.x - a.x),
        dot(stepV, stepV) - a.y * a.y + 2.0 * b.y * (b.y - a.y),
        dot(stepU, stepV) - a.x * a.y + 2.0 * b.x * b.y - a.x * b.y - a.y * b.x);
    return result;
}

// Of the rays that this thread has followed.
static uint s_hits = 0, s_bounces = 0, s_received = 0;
static uint2 s_lengths = 0;

void CountRay(Path path, bool isReceived)
{
    if (path.Bounces == 0)
        return;
    uint units = (uint)(AMPLITUDE_LENGTH_UNITS * path.RelativeLength + 0.5);
    s_hits++;
    s_bounces += path.Bounces;
    s_received += isReceived ? 1 : 0;
    s_lengths.x += units;
    s_lengths.y += s_lengths.x < units ? 1 : 0;
}

// Adds the rays that this thread has followed.
void AddRays(uint rays)
{
    AddTo(AmplitudeWord(AMPLITUDE_RAYS), rays);
    if (s_hits == 0)
        return;
    AddTo(AmplitudeWord(AMPLITUDE_HITS), s_hits);
    AddTo(AmplitudeWord(AMPLITUDE_BOUNCES), s_bounces);
    AddWords(AmplitudeWord(AMPLITUDE_LENGTHS), 2, s_lengths.x, s_lengths.y, 0);
    if (s_received > 0)
        AddTo(AmplitudeWord(AMPLITUDE_RECEIVED), s_received);
}

// Follows the ray through a position of the grid, and keeps what a point says of it, if there is one.
Return Follow(float2 position, uint recorded, bool isCounted)
{
    TubePose rays = _Poses[s_pose];
    float4 start = _AmplitudePoses[s_pose].Aside;
    float2 step = _AmplitudePoses[s_pose].PictureStep, pixel = _AmplitudePoses[s_pose].PictureStart + position * step;
    float3 origin = rays.Origin.xyz + (pixel.x * rays.OriginDx.xyz + pixel.y * rays.OriginDy.xyz),
        direction = rays.Direction.xyz + (pixel.x * rays.DirectionDx.xyz + pixel.y * rays.DirectionDy.xyz),
        aside = start.xyz + pixel.x * rays.DirectionDx.xyz + pixel.y * rays.DirectionDy.xyz;
    float square = dot(aside, aside), size = sqrt(1.0 + square);
    // Without the difference of two numbers near each other, which leaves float32 few digits far away.
    Path path = BeginPath(origin, direction * (1.0 / sqrt(dot(direction, direction))), rays.OriginDepth * square / (1.0 + size));
    bool isParallel = start.w != 0.0;
    float3 stepU = step.x * (isParallel ? rays.OriginDx.xyz : rays.DirectionDx.xyz / size);
    float3 stepV = step.y * (isParallel ? rays.OriginDy.xyz : rays.DirectionDy.xyz / size);
    Return result = (Return)0;
    uint planes = 2166136261u, word = recorded * _PointWords + POINT_LANDINGS;
    bool goesOn = true;
    [loop]
    while (goesOn)
    {
        float toReceiver = MISS;
        if (path.Bounces > 0)
        {
            toReceiver = ToReceiver(path.Ray.Origin, path.Ray.Direction);
            if (recorded != NO_POINT)
            {
                Landing landing = LandingOf(path, stepU, stepV, rays.OriginDepth + path.RelativeLength);
                _Points[word] = f32tof16(landing.Position.x) | f32tof16(landing.Position.y) << 16;
                _Points[word + 1] = asuint(landing.Motion);
                word += 2;
            }
        }
        Hit hit = NoHit();
        if (toReceiver < MISS || !IsLast(path))
            hit = ClosestHit(path.Ray, MISS, NO_ENTRY_POINTS, NOT_MET);
        bool isReceived = toReceiver < MISS && (IsMiss(hit) || toReceiver <= hit.Distance);
        if (isReceived)
            result = ReturnOf(path, stepU, stepV, toReceiver, planes | 1);
        goesOn = !isReceived && !IsMiss(hit) && !IsLast(path);
        if (!IsMiss(hit) && !isReceived)
        {
            Identity identity = Identify(hit);
            uint2 first = _InstanceFacets[identity.Instance].xy;
            planes = Mixed(planes, first.y + _Facets[first.x + identity.Triangle].x);
        }
        if (goesOn)
        {
            MoveTo(path, hit);
            stepU -= 2.0 * dot(stepU, hit.Normal) * hit.Normal;
            stepV -= 2.0 * dot(stepV, hit.Normal) * hit.Normal;
            Scatter(path, hit);
        }
    }
    if (isCounted)
        CountRay(path, result.Signature != 0);
    if (recorded != NO_POINT)
    {
        _Points[recorded * _PointWords] = result.Signature;
        _Points[recorded * _PointWords + 1] = Mixed(planes, path.Bounces);
        for (uint bounce = path.Bounces; bounce < _MaxBounces; bounce++)
        {
            _Points[word] = NO_LANDING;
            word += 2;
        }
    }
    return result;
}

Return Follow(float2 position, uint recorded)
{
    return Follow(position, recorded, true);
}

// The amplitude needs all bounces.
uint SignatureAt(float2 position, Cell cell, uint bounces)
{
    return Follow(position, NO_POINT).Signature;
}

// The first new point of a cell that was divided. cell: the first one of its parts.
uint FirstNewPoint(Cell cell)
{
    return cell.Signatures.y;
}

// Signature of a corner of a cell that was divided.
uint SignatureOfCorner(uint block, uint corner)
{
    return _Points[_TubeCells[BLOCK_CELLS * block + corner].Signatures[corner] * _PointWords];
}

// A border cell, whose pose becomes that of the thread. In the list Signatures are the points of its corners.
Cell LoadBorder(uint index)
{
    Cell cell = _Borders[index];
    EnterPose(cell.Pose, index);
    uint4 words = cell.Signatures * _PointWords;
    cell.Signatures = uint4(_Points[words.x], _Points[words.y], _Points[words.z], _Points[words.w]);
    return cell;
}

// Phases at the corners of a cell less the linear ones, m: as BendsOf in TubeCells.hlsl.
float3 BendsOf(Return ray, float side)
{
    return side * side * ray.Bend * float3(0.125, 0.125, 0.25);
}

// A piece of a tube: without corners, a square.
Tube TubeOf(Return ray)
{
    Tube tube = (Tube)0;
    tube.Tag = s_pose;
    tube.Phase = ray.Length;
    tube.Gradient = ray.Gradient;
    tube.CoPolar = float4(1.0, 0.0, 0.0, 0.0);
    return tube;
}

void AddTube(Tube tube)
{
    uint at;
    InterlockedAdd(_Sums[TUBE_COUNT], 1, at);
    if (at < _ListCapacity.x)
        _Tubes[at] = tube;
}

#endif
