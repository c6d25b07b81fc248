using System;
using System.Collections.Generic;
using System.Linq;
using FsCheck;
using FsCheck.Fluent;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Host.Tests;

/// <summary>
/// Scenes that are hard to trace: slivers, triangles without area, coplanar duplicates, size ratios of one to a
/// million, mirrored and stretched transforms, large offsets.
/// </summary>
static class RandomScenes
{
    // Positions have a limit of 1e7 m.
    const double Farthest = 2e6;

    // -1 to 1 in coarse steps, to make coincidences likely.
    static readonly Gen<double> Coarse = Gen.Choose(-8, 8).Select(number => number / 8.0);

    static readonly Gen<double> Fine = Gen.Choose(-1_000_000, 1_000_000).Select(number => number / 1e6);

    static readonly Gen<double> CoarseOrFine = Gen.OneOf(Coarse, Fine);

    static readonly Gen<double3> Vectors =
        from x in CoarseOrFine
        from y in CoarseOrFine
        from z in CoarseOrFine
        select double3(x, y, z);

    // Including quarter turns.
    static readonly Gen<double4> Rotations = Gen.OneOf(
        Gen.Elements(double4(0, 0, 0, 1), double4(0, 0, 1, 1), double4(1, 0, 0, 1),
            double4(0, 1, 0, 0), double4(1, 1, 1, 1)),
        from v in Vectors
        from w in Fine
        select double4(v, w + 1.5));

    static Gen<double> PowersOfTen(double from, double to) =>
        Gen.Choose(0, 1000).Select(part => Math.Pow(10, from + (to - from) * part / 1000));

    // Any three corners, with sizes from a thousandth to the whole.
    static readonly Gen<float3[]> Clutter = Triangles(
        from centre in Vectors
        from size in PowersOfTen(-3, 0)
        from a in Vectors
        from b in Vectors
        from c in Vectors
        select Corners(centre + size * a, centre + size * b, centre + size * c));

    static readonly Gen<float3[]> Slivers = Triangles(
        from a in Vectors
        from along in Vectors
        from part in Fine
        from across in Vectors
        from width in PowersOfTen(-7, -2)
        select Corners(a, a + along, a + part * along + width * across));

    static readonly Gen<float3[]> WithoutArea = Triangles(
        from a in Vectors
        from b in Vectors
        from part in Coarse
        from kind in Gen.Choose(0, 3)
        select kind switch
        {
            0 => Corners(a, a, b),
            1 => Corners(a, a, a),
            _ => Corners(a, b, a + part * (b - a)),
        });

    // A surface across the rays, which returns them.
    static readonly Gen<float3[]> FacingPlate =
        Vectors.Select(corner => Plate(corner, double3(1, 0, 0), double3(0, 1, 0)));

    static readonly Gen<float3[]> Trihedral = Gen.Constant<float3[]>(
    [
        .. Plate(0, double3(1, 0, 0), double3(0, 1, 0)), .. Plate(0, double3(0, 1, 0), double3(0, 0, 1)),
        .. Plate(0, double3(0, 0, 1), double3(1, 0, 0)),
    ]);

    // A dish of facets that faces the radar.
    static readonly Gen<float3[]> Dish =
        from cells in Gen.Choose(2, 8)
        from depth in PowersOfTen(-4, 0)
        from bumps in Vectors.ArrayOf((cells + 1) * (cells + 1))
        select MakeDish(cells, depth, bumps);

    static readonly Gen<float3[]> Shapes =
        Gen.Frequency((3, Clutter), (2, Slivers), (1, WithoutArea), (3, FacingPlate), (2, Trihedral), (3, Dish));

    // The same triangle again, with the same or the opposite winding.
    static Gen<float3[]> Twice(Gen<float3[]> shapes) =>
        from shape in shapes
        from isTurned in Gen.Elements(false, true)
        select shape.Concat(isTurned ? shape.Reverse() : shape).ToArray();

    static readonly Gen<double> Stretches =
        Gen.Frequency((3, Gen.Constant(1.0)), (2, PowersOfTen(-1, 1)), (1, PowersOfTen(-1, 1).Select(scale => -scale)));

    // Modelled in other units, and partly far from its own origin.
    static Gen<RandomBody> Bodies(Gen<float3[]> shapes, double size, double3 aside) =>
        from shape in shapes
        from unit in Gen.Frequency((2, Gen.Constant(1.0)), (1, PowersOfTen(-3, 3)))
        from far in Gen.Frequency((5, Gen.Constant(0.0)), (1, PowersOfTen(0, 2)))
        from position in Vectors
        from rotation in Gen.Frequency((2, Gen.Constant(double4(0, 0, 0, 1))), (3, Rotations))
        from share in Gen.Frequency((3, Gen.Constant(1.0)), (1, PowersOfTen(-3, 0)))
        from x in Stretches
        from y in Stretches
        from z in Stretches
        select new RandomBody(
            Array.ConvertAll(shape, corner => (float3)(unit * ((double3)corner + far))),
            size * (0.7 * position + aside), rotation, size * share / unit * double3(x, y, z));

    static Gen<RandomScene> Scenes(Gen<float3[]> shapes, double3 aside) =>
        from size in Gen.Frequency((1, Gen.Constant(1.0)), (2, PowersOfTen(-3, 5)))
        from bodies in Gen.Choose(1, 7).SelectMany(count => Bodies(shapes, size, aside).ArrayOf(count))
        from range in Gen.Frequency((3, Gen.Elements(1.0, 5.0, 30.0)), (1, PowersOfTen(-1, 4)))
            .Select(range => Math.Min(range, Farthest / size))
        from isParallel in Gen.Elements(false, false, true)
        from at in Gen.Frequency((1, Gen.Constant(double3(0))), (1, Vectors.Select(v => 1e6 * v)))
        from turn in Gen.Frequency((1, Gen.Constant(double4(0, 0, 0, 1))), (2, Rotations))
        from receiver in PowersOfTen(-1, 1)
        from bounces in Gen.Elements(1, 2, 3, 4, 4, 7)
        select new RandomScene(bodies, size, size * range, isParallel, at, turn, size * receiver, bounces);

    /// <summary>
    /// Scenes in which every ray's path is certain, except for rays that pass an edge within rounding.
    /// </summary>
    public static readonly Arbitrary<RandomScene> Certain = Arb.From(
        Scenes(Gen.Frequency((5, Shapes), (1, Twice(Gen.OneOf(FacingPlate, Trihedral, Dish)))),
            double3(0.0123, 0.0071, 0.0039)), scene => scene.Simpler());

    /// <summary>
    /// Includes scenes with rays along edges and in planes, duplicate slivers, and rays that start on a surface.
    /// </summary>
    public static readonly Arbitrary<RandomScene> Any =
        Arb.From(Scenes(Gen.Frequency((3, Shapes), (1, Twice(Shapes))), 0), scene => scene.Simpler());

    static Gen<float3[]> Triangles(Gen<float3[]> triangle) => Gen.Choose(1, 12)
        .SelectMany(count => triangle.ArrayOf(count)).Select(all => all.SelectMany(corners => corners).ToArray());

    static float3[] Corners(double3 a, double3 b, double3 c) => [(float3)a, (float3)b, (float3)c];

    static float3[] Plate(double3 corner, double3 along, double3 across) =>
        [.. Corners(corner, corner + along, corner + along + across),
            .. Corners(corner, corner + along + across, corner + across)];

    static float3[] MakeDish(int cells, double depth, double3[] bumps)
    {
        float3 Point(int x, int y)
        {
            double2 position = 2.0 * double2(x, y) / cells - 1;
            return (float3)double3(position,
                depth * (0.3 * bumps[y * (cells + 1) + x].z / cells - dot(position, position)));
        }
        var corners = new List<float3>();
        for (int y = 0; y < cells; y++)
            for (int x = 0; x < cells; x++)
            {
                corners.AddRange([Point(x, y), Point(x + 1, y), Point(x, y + 1)]);
                corners.AddRange([Point(x + 1, y), Point(x + 1, y + 1), Point(x, y + 1)]);
            }
        return [.. corners];
    }
}
