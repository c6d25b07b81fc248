using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Host.Tests;

/// <summary>A mesh with a transform, small enough to print in a message.</summary>
/// <param name="Corners">Corners, three for each triangle.</param>
sealed record RandomBody(float3[] Corners, double3 Position, double4 Rotation, double3 Scale)
{
    static readonly double4 NoRotation = double4(0, 0, 0, 1);

    public MeshInstance Placed(Affine scene) => new()
    {
        Mesh = new TriangleMesh(Corners, [.. Enumerable.Range(0, Corners.Length)]),
        ToWorld = scene * Affine.FromTransform(Position, Rotation, Scale),
    };

    /// <summary>Simpler bodies: fewer triangles first, then a simpler transform, then shorter numbers.</summary>
    public IEnumerable<RandomBody> Simpler()
    {
        int triangles = Corners.Length / 3;
        for (int part = triangles / 2; part > 0; part /= 2)
            for (int first = 0; first < triangles && part < triangles; first += part)
                yield return this with
                {
                    Corners = [.. Corners[..(3 * first)], .. Corners[(3 * Math.Min(triangles, first + part))..]]
                };
        if (any(Rotation != NoRotation))
            yield return this with { Rotation = NoRotation };
        // No body may recur, or shrinking would not terminate.
        foreach (double3 scale in new[] { 1, Scale.x, abs(Scale) })
            if (any(Scale != scale) && any(Scale != 1))
                yield return this with { Scale = scale };
        if (any(Position != 0))
            yield return this with { Position = 0 };
        foreach (int digits in new[] { 1, 2, 4 })
        {
            var corners = Array.ConvertAll(Corners,
                corner => float3(Short(corner.x, digits), Short(corner.y, digits), Short(corner.z, digits)));
            if (!corners.SequenceEqual(Corners))
                yield return this with { Corners = corners };
        }
    }

    public override string ToString() => string.Create(CultureInfo.InvariantCulture,
        $"{string.Join(", ", Corners.Chunk(3).Select(triangle => string.Join(" ", triangle.Select(Text))))}\n    at {Text(Position)}, rotation ({Rotation.x:R} {Rotation.y:R} {Rotation.z:R} {Rotation.w:R}), scale {Text(Scale)}");

    public static string Text(double3 v) => string.Create(CultureInfo.InvariantCulture, $"({v.x:R} {v.y:R} {v.z:R})");

    static string Text(float3 v) => string.Create(CultureInfo.InvariantCulture, $"({v.x:R} {v.y:R} {v.z:R})");

    static float Short(float value, int digits) =>
        float.Parse(value.ToString("E" + digits, CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
}
