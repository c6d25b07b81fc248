using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Rays over a sea's field, compared with small steps over the same heights in double precision.</summary>
    public sealed class SeaMarchTests
    {
        const int Side = SeaField.Side;

        static readonly double3 s_radar = math.double3(40, 12, -25);

        // Metres: roundings of float32 5 km away, 5e-4 m, times slopes.
        const double Tolerance = 1e-3;

        // Rays down to the sea, near the crests, upwards, along the axes, straight down, far away, and long ones.
        [Test]
        public void March_OfAnyRay_EndsWhereSmallStepsMeetTheSea([Values(1, 2)] int cascades)
        {
            using (var field = FieldOf(cascades))
            {
                field.Update(5);
                var sea = new Heights(field, cascades, ClutterGeometry.EarthRadius);
                var random = new System.Random(3);
                var rays = Enumerable.Range(0, 256).Select(i => RayOf(random, i)).ToArray();
                var results = March(field, rays, ClutterGeometry.EarthRadius);
                for (int i = 0; i < rays.Length; i++)
                    AssertFirst(sea, rays[i], results[i], $"ray {i}");
                int hits = results.Count(result => result.x != 0);
                Assert.That(hits, Is.InRange(64, 224), "hits and misses");
                TestContext.WriteLine($"{hits} hits, {results.Average(result => result.z):F1} steps a ray, "
                    + $"most {results.Max(result => result.z)}");
            }
        }

        // The cells of a kilometre are 10,000 of the finer tile along each axis.
        [Test]
        public void March_AboveAllCrests_TakesOneStep_AndBetweenThemFarFewerThanCells()
        {
            using (var field = FieldOf(2))
            {
                field.Update(5);
                var points = new SeaPoint[2 * Side * Side];
                field.Points.ReadBack(points, points.Length);
                double highest = points.Take(Side * Side).Max(point => point.Height)
                    + points.Skip(Side * Side).Max(point => point.Height);
                double3 direction = math.normalize(math.double3(1, 0, 0.3));
                Ray above = new Ray(math.double3(3, highest + 0.01, 4), direction, 1000),
                    between = new Ray(math.double3(3, 0.8 * highest, 4), direction, 1000);
                var results = March(field, new[] { above, between }, double.PositiveInfinity);
                Assert.That(results[0], Is.EqualTo(new Vector4(0, 0, 1, 0)));
                Assert.That(results[1].z, Is.InRange(2, 1000));
                TestContext.WriteLine($"{results[1]}");
            }
        }

        // A calm sea: the radar sees the water up to the horizon, sqrt(2 R h) away.
        [Test]
        public void Sight_OfACalmSea_EndsAtTheHorizon()
        {
            var settings = SettingsOf(256, 16);
            (settings.Kind, settings.SignificantWaveHeight) = (SeaSpectrumKind.PiersonMoskowitz, 1e-5);
            using (var field = new SeaField(TestKernels.SeaField, "test", new SeaSurface(settings)))
            {
                field.Update(0);
                const double above = 0.01;
                double radius = ClutterGeometry.EarthRadius,
                    horizon = Math.Sqrt(2 * radius * s_radar.y) + Math.Sqrt(2 * radius * above);
                var directions = Enumerable.Range(0, 8).Select(i => math.double2(Math.Cos(i), Math.Sin(i))).ToArray();
                Assert.That(Sees(field, directions, 0.99 * horizon, above, radius), Is.All.True);
                Assert.That(Sees(field, directions, 1.01 * horizon, above, radius), Is.All.False);
                Assert.That(Sees(field, directions, 1.01 * horizon, above, double.PositiveInfinity), Is.All.True);
            }
        }

        // By small steps over the heights, from the point to the radar.
        [Test]
        public void Sight_OfPointsOfTheSea_IsThatOfSmallSteps()
        {
            const double above = 0.02;
            using (var field = FieldOf(2))
            {
                field.Update(5);
                var sea = new Heights(field, 2, ClutterGeometry.EarthRadius);
                var random = new System.Random(8);
                var points = Enumerable.Range(0, 128).Select(_ =>
                    math.double2(random.NextDouble() - 0.5, random.NextDouble() - 0.5) * 600).ToArray();
                var inputs = points.Select(point => new Vector4((float)point.x, (float)above, (float)point.y, 0));
                var results = Run(field, "Sight", inputs.ToArray(), new Vector4[points.Length],
                    ClutterGeometry.EarthRadius);
                int seen = 0, unclear = 0;
                for (int i = 0; i < points.Length; i++)
                {
                    Assert.That(results[i].y, Is.EqualTo(sea.WavesAt(points[i])).Within(1e-4), "height");
                    double3 from = math.double3(points[i].x, sea.At(points[i]) + above, points[i].y);
                    double lowest = sea.Lowest(new Ray(from, math.normalize(s_radar - from),
                        math.distance(s_radar, from)));
                    if (Math.Abs(lowest) < Tolerance)
                        unclear++;
                    else
                        Assert.That(results[i].x != 0, Is.EqualTo(lowest > 0), $"point {i}, lowest {lowest} m");
                    seen += results[i].x != 0 ? 1 : 0;
                }
                Assert.That(seen, Is.InRange(16, 112), "some are in shadow");
                Assert.That(unclear, Is.LessThan(8));
            }
        }

        [Test]
        public void March_Repeated_GivesTheSameBits()
        {
            using (var field = FieldOf(2))
            {
                field.Update(5);
                var random = new System.Random(4);
                var rays = Enumerable.Range(0, 64).Select(i => RayOf(random, i)).ToArray();
                var first = March(field, rays, ClutterGeometry.EarthRadius);
                field.Update(6);
                field.Update(5);
                Assert.That(March(field, rays, ClutterGeometry.EarthRadius), Is.EqualTo(first));
            }
        }

        static void AssertFirst(Heights sea, in Ray ray, Vector4 result, string name)
        {
            double length = result.x != 0 ? result.y : ray.Length;
            // Small steps may cut off a crest that the ray enters by less than the tolerance.
            Assert.That(sea.Lowest(new Ray(ray.Origin, ray.Direction, length)), Is.GreaterThan(-Tolerance),
                $"{name}: no crossing before {length} m");
            if (result.x != 0)
                Assert.That(sea.Above(ray, length), Is.LessThan(Tolerance), $"{name}: a crossing at {length} m");
        }

        static Ray RayOf(System.Random random, int i)
        {
            double Between(double from, double to) => from + (to - from) * random.NextDouble();
            double3 origin = math.double3(Between(-500, 500), Between(3, 12), Between(-500, 500));
            if (i % 4 == 0)
                origin.y = 4;
            // Where cells have other fractions of float32.
            if (i % 8 == 3)
                origin.x += 5000;
            double turn = i % 8 == 1 ? random.Next(4) * Math.PI / 2 : Between(0, 2 * Math.PI),
                down = i % 8 == 2 ? 1 : Between(-0.005, 0.03);
            if (i % 16 == 10)
                return new Ray(origin, math.double3(0, -1, 0), 300);
            return new Ray(origin, math.normalize(math.double3(Math.Cos(turn), -down, Math.Sin(turn))),
                i % 64 == 5 ? 3000 : 300);
        }

        static Vector4[] March(SeaField field, Ray[] rays, double radius) => Run(field, "March",
            rays.Select(ray => ray.Origin.ToVector((float)ray.Length)).ToArray(),
            rays.Select(ray => ray.Direction.ToVector()).ToArray(), radius);

        static IEnumerable<bool> Sees(SeaField field, double2[] directions, double distance, double above,
            double radius)
        {
            var points = directions.Select(direction => s_radar.xz + distance * direction)
                .Select(point => new Vector4((float)point.x, (float)above, (float)point.y, 0)).ToArray();
            return Run(field, "Sight", points, new Vector4[points.Length], radius).Select(result => result.x != 0);
        }

        static Vector4[] Run(SeaField field, string name, Vector4[] origins, Vector4[] directions, double radius)
        {
            // Whole groups.
            int count = (origins.Length + 63) / 64 * 64;
            Array.Resize(ref origins, count);
            int wanted = directions.Length;
            Array.Resize(ref directions, count);
            var shader = TestKernels.SeaMarch;
            int kernel = shader.FindKernel(name);
            var results = new Vector4[count];
            using (var origin = new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, 16))
            using (var direction = new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, 16))
            using (var output = new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, 16))
            {
                origin.SetData(origins);
                direction.SetData(directions);
                shader.SetBuffer(kernel, "_Origins", origin);
                if (name == "March")
                    shader.SetBuffer(kernel, "_Directions", direction);
                shader.SetBuffer(kernel, "_Results", output);
                field.SetMarch(shader, kernel, s_radar, radius);
                shader.Dispatch(kernel, count / 64, 1, 1);
                output.GetData(results);
            }
            return results.Take(wanted).ToArray();
        }

        static SeaField FieldOf(int cascades)
        {
            var tile = new SeaSurface(SettingsOf(256, Side));
            // Not a power of two smaller: cells of the cascades have no common borders.
            return cascades == 1
                ? new SeaField(TestKernels.SeaField, "test", tile)
                : new SeaField(TestKernels.SeaField, "test", tile, tile.Finer(24));
        }

        static SeaSettings SettingsOf(double tile, int grid)
        {
            var settings = SeaSettings.Default;
            (settings.TileSize, settings.GridSize, settings.WindSpeed) = (tile, grid, 11);
            return settings;
        }

        readonly struct Ray
        {
            public Ray(double3 origin, double3 direction, double length)
            {
                // As the device gets them.
                (Origin, Direction, Length) = ((float3)origin, (float3)direction, (float)length);
            }

            public double3 Origin { get; }
            public double3 Direction { get; }
            public double Length { get; }
        }

        // The device's heights, bilinear in each cell, on a curved earth.
        sealed class Heights
        {
            readonly SeaPoint[] _points;
            readonly double[] _tiles;
            readonly double _curvature;

            public Heights(SeaField field, int cascades, double earthRadius)
            {
                _points = new SeaPoint[field.Points.Capacity];
                field.Points.ReadBack(_points, _points.Length);
                _tiles = new double[] { 256, 24 }.Take(cascades).ToArray();
                _curvature = 1 / (2 * earthRadius);
            }

            public double WavesAt(double2 position)
            {
                double height = 0;
                for (int cascade = 0; cascade < _tiles.Length; cascade++)
                {
                    double2 cells = position * (Side / _tiles[cascade]) + Side / 2, corner = math.floor(cells),
                        within = cells - corner;
                    double Corner(int x, int z) => _points[(cascade * Side + Wrapped(corner.y + z)) * Side
                        + Wrapped(corner.x + x)].Height;
                    height += math.lerp(math.lerp(Corner(0, 0), Corner(1, 0), within.x),
                        math.lerp(Corner(0, 1), Corner(1, 1), within.x), within.y);
                }
                return height;
            }

            public double At(double2 position) =>
                WavesAt(position) - _curvature * math.lengthsq(position - s_radar.xz);

            public double Above(in Ray ray, double distance)
            {
                double3 position = ray.Origin + distance * ray.Direction;
                return position.y - At(position.xz);
            }

            public double Lowest(in Ray ray)
            {
                // A fifth of the finest cell.
                int steps = 1 + (int)(ray.Length / 0.02);
                double lowest = double.MaxValue;
                for (int i = 0; i < steps; i++)
                    lowest = Math.Min(lowest, Above(ray, ray.Length * i / steps));
                return lowest;
            }

            static int Wrapped(double index) => (int)index & (Side - 1);
        }
    }
}
