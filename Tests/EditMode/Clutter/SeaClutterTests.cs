using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The diffuse echo of a sea: its parts against computations of their own, and what it refuses.</summary>
    public sealed class SeaClutterTests
    {
        const double Frequency = 10e9;

        static readonly double3 s_wind = new double3(0, 0, 1);

        [Test]
        public void Clutter_OfADefaultSea_HasTheFiguresOfItsWind()
        {
            var clutter = Of(SeaSettings.Default);
            Assert.That(clutter.ShortWaves.Wind, Is.EqualTo(7));
            Assert.That(clutter.BreakingFraction, Is.EqualTo(0.00292).Within(0.6).Percent);
            Assert.That(clutter.Seed, Is.EqualTo(1));
            // Facets of 1 m, coherence times published for 5 and 10 m/s: 57 ms.
            Assert.That(clutter.CoherenceTimeAt(Frequency), Is.EqualTo(0.057).Within(0.001));
            var water = clutter.Water.At(Frequency).permittivity;
            Assert.That(water.Real, Is.EqualTo(55.061).Within(0.001));
            Assert.That(water.Imaginary, Is.EqualTo(-37.513).Within(0.001));
        }

        // Of the waves that the mesh leaves out at 10 m/s: 15.6 mm for facets of 1 m, from a wave number of pi.
        [Test]
        public void Surface_IsSeaWaterWithTheRoughnessOfTheShortWaves()
        {
            var settings = Waves(10, 64, 64);
            settings.GridSize = 128;
            var surface = Of(settings).Surface;
            Assert.That(surface.Name, Is.EqualTo("sea water"));
            Assert.That(surface.Roughness, Is.EqualTo(0.0156).Within(0.00005));
            Assert.That(surface.HalfSpace, Is.Not.Null);
        }

        // The second difference of the heights, of waves so long that its own error is below 1 %.
        [Test]
        public void Accelerations_AreThoseOfTheHeights()
        {
            var settings = Waves(10, 64, 64);
            (settings.ShortestWave, settings.Choppiness, settings.WindDirectionDegrees) = (16, 0, 33);
            var surface = new SeaSurface(settings);
            const double step = 0.15, time = 3;
            double[] Heights(double at) => surface.Mesh(at).Vertices.Select(vertex => (double)vertex.y).ToArray();
            double[] before = Heights(time - step), now = Heights(time), after = Heights(time + step),
                found = surface.Accelerations(time);
            Assert.That(found.Length, Is.EqualTo(now.Length));
            double largest = found.Max(Math.Abs);
            Assert.That(largest, Is.GreaterThan(0.5));
            for (int i = 0; i < found.Length; i++)
                Assert.That(found[i], Is.EqualTo((before[i] - 2 * now[i] + after[i]) / (step * step))
                    .Within(0.01 * largest));
        }

        // With a choppiness of 1 the vertices are displaced as the water of linear waves is.
        [Test]
        public void Velocities_AreThoseOfTheMesh()
        {
            var settings = Waves(10, 64, 64);
            (settings.ShortestWave, settings.Choppiness, settings.WindDirectionDegrees) = (16, 1, 33);
            var surface = new SeaSurface(settings);
            const double step = 0.05, time = 3;
            var (before, after) = (surface.Mesh(time - step).Vertices, surface.Mesh(time + step).Vertices);
            var found = surface.Velocities(time);
            double largest = found.Max(velocity => math.length(velocity));
            Assert.That(largest, Is.GreaterThan(0.5));
            for (int i = 0; i < found.Length; i++)
                Assert.That(math.distance(found[i], ((double3)after[i] - before[i]) / (2 * step)),
                    Is.LessThan(0.005 * largest));
        }

        // Mean squares over the facets of a mesh that is fine against its waves.
        [TestCase(0)]
        [TestCase(40)]
        public void SlopeVariances_AreThoseOfAFineMesh(double direction)
        {
            var settings = Waves(10, 64, 256);
            (settings.GridSize, settings.Choppiness, settings.WindDirectionDegrees) = (16, 0, direction);
            var surface = new SeaSurface(settings);
            double2 mean = MeanSquareSlopes(surface.Mesh(5), direction), found = surface.SlopeVariances(1e3);
            Assert.That(found.x, Is.EqualTo(mean.x).Within(0.5).Percent);
            Assert.That(found.y, Is.EqualTo(mean.y).Within(0.5).Percent);
            Assert.That(found.x, Is.GreaterThan(1.2 * found.y));
            Assert.That(surface.SlopeVariances(0.5).x, Is.LessThan(0.9 * found.x));
        }

        // The facets of a mesh as coarse as its waves, whose slopes are those of chords.
        [TestCase(0)]
        [TestCase(40)]
        [TestCase(130)]
        public void FacetSlopeVariances_AreThoseOfTheMesh(double direction)
        {
            var settings = Waves(10, 64, 16);
            (settings.Choppiness, settings.WindDirectionDegrees) = (0, direction);
            var surface = new SeaSurface(settings);
            double2 found = surface.FacetSlopeVariances().Variances, mean = MeanSquareSlopes(surface.Mesh(5), direction);
            Assert.That(found.x, Is.EqualTo(mean.x).Within(0.1).Percent);
            Assert.That(found.y, Is.EqualTo(mean.y).Within(0.1).Percent);
            Assert.That(surface.SlopeVariances(1e3).x, Is.GreaterThan(1.1 * found.x));
        }

        // Breaking facets fall fastest, at the windward corners of their cells, and are the crests. The wind blows along Z.
        [Test]
        public void BreakingFacets_AreTheFractionThatFallsFastest()
        {
            var settings = Waves(12, 128, 64);
            var clutter = new SeaClutter(new SeaSurface(settings), 7, s_wind, SeaClutterSettings.On);
            var mesh = clutter.LongWaves.Mesh(7);
            double[] accelerations = clutter.LongWaves.Accelerations(7),
                falls = Enumerable.Range(0, mesh.TriangleCount).Select(t => t / 2 / 64 * 65 + t / 2 % 64)
                    .Select(corner => Math.Min(accelerations[corner], accelerations[corner + 1])).ToArray(),
                heights = Enumerable.Range(0, mesh.TriangleCount).Select(t => Enumerable.Range(3 * t, 3)
                    .Average(i => (double)mesh.Vertices[mesh.Indices[i]].y)).ToArray();
            var breaking = Enumerable.Range(0, mesh.TriangleCount).Where(t => clutter.BreakingFacets[t]).ToArray();
            Assert.That(clutter.BreakingFacets.Count, Is.EqualTo(mesh.TriangleCount));
            // 3.84e-6 x 12^3.41 = 1.84 % of 8,192.
            Assert.That(breaking.Length, Is.EqualTo(Math.Round(3.84e-6 * Math.Pow(12, 3.41) * 8192)));
            double limit = breaking.Max(t => falls[t]);
            Assert.That(falls.Count(fall => fall < limit), Is.LessThan(breaking.Length));
            Assert.That(limit, Is.LessThan(-1));
            double deviation = clutter.LongWaves.MeasuredWaveHeight(7) / 4;
            Assert.That(breaking.Average(t => heights[t]), Is.GreaterThan(deviation / 2));
        }

        // The water falls along the wind there, whatever the direction of the wind in the tile.
        [TestCase(0)]
        [TestCase(70)]
        [TestCase(180)]
        [TestCase(-90)]
        public void BreakingFacets_AreForwardFaces(double direction)
        {
            var settings = Waves(12, 128, 128);
            settings.WindDirectionDegrees = direction;
            var clutter = new SeaClutter(new SeaSurface(settings), 7, s_wind, SeaClutterSettings.On);
            var mesh = clutter.LongWaves.Mesh(7);
            double angle = math.radians(direction);
            var slopes = Enumerable.Range(0, mesh.TriangleCount).Where(t => clutter.BreakingFacets[t])
                .Select(t => Normal(mesh, t))
                .Select(normal => -(normal.x * Math.Sin(angle) + normal.z * Math.Cos(angle)) / normal.y).ToArray();
            // Some 600 facets with slopes of 0.2: their mean is known to 0.01.
            Assert.That(slopes.Average(), Is.LessThan(-0.04));
        }

        [Test]
        public void BreakingFacets_WithoutWhitecaps_AreNone()
        {
            var settings = SeaClutterSettings.On;
            settings.WhitecapCoefficient = 0;
            var clutter = new SeaClutter(new SeaSurface(SeaSettings.Default), 0, s_wind, settings);
            Assert.That(clutter.BreakingFraction, Is.Zero);
            Assert.That(clutter.BreakingFacets, Has.None.True);
        }

        [Test]
        public void At_AnotherTime_HasTheSameTablesAndOtherBreakers()
        {
            var clutter = Of(Waves(15, 64, 32));
            var later = clutter.At(20);
            Assert.That(later.Time, Is.EqualTo(20));
            Assert.That(later.TableAt(Frequency), Is.SameAs(clutter.TableAt(Frequency)));
            Assert.That(later.TableAt(9e9), Is.Not.SameAs(clutter.TableAt(Frequency)));
            Assert.That(later.BreakingFacets, Is.Not.EqualTo(clutter.BreakingFacets));
            Assert.That(later.BreakingFacets.Count(it => it), Is.EqualTo(clutter.BreakingFacets.Count(it => it)));
        }

        // Azimuth 0 is south of the sea. The tile's wind, to 30 degrees, blows along Z of the world: its frame is turned.
        [TestCase(30, 0, 180)]
        [TestCase(30, 180, 0)]
        [TestCase(75, 180, 45)]
        [TestCase(75, 0, 135)]
        [TestCase(120, -90, 0)]
        public void SwellAngle_IsBetweenSwellAndRadar(double swell, double azimuth, double expected)
        {
            var settings = Waves(7, 128, 64);
            (settings.WindDirectionDegrees, settings.SwellHeight, settings.SwellPeriod, settings.SwellDirectionDegrees) =
                (30, 1, 7, swell);
            Assert.That(Of(settings).SwellAngleAt(azimuth), Is.EqualTo(expected).Within(1e-6));
            settings.SwellHeight = 0;
            Assert.That(Of(settings).SwellAngleAt(azimuth), Is.Null);
        }

        [TestCase(0)]
        [TestCase(-1)]
        [TestCase(1e8)]
        [TestCase(9.4e10)]
        [TestCase(double.NaN)]
        public void Table_OfAFrequencyOutsideTheModels_IsRefused(double frequency) =>
            Assert.That(() => Of(SeaSettings.Default).TableAt(frequency), Throws.TypeOf<GlintException>().With.Message
                .StartsWith("sea clutter: the frequency ").And.Message.Contains("must be from 1e9 to 4.7e10 Hz"));

        // At 1 GHz waves above 7 rad/m scatter; facets of 0.25 m hold waves up to 12.6.
        [Test]
        public void Table_OfAMeshWithBraggWaves_IsRefused()
        {
            var settings = Waves(7, 64, 256);
            settings.GridSize = 512;
            Assert.That(() => Of(settings).TableAt(1e9), Throws.TypeOf<GlintException>().With.Message
                .Contains("at 1000000000 Hz the mesh holds waves up to 12.5").And.Message.Contains("fewer cells"));
        }

        [TestCase(nameof(SeaClutterSettings.Wind), 21, "clutter wind 21 m/s must be from 0 to 20")]
        [TestCase(nameof(SeaClutterSettings.Wind), -1, "clutter wind -1 m/s")]
        [TestCase(nameof(SeaClutterSettings.Wind), 1, "clutter wind 1 m/s must be from 3 to 20")]
        [TestCase(nameof(SeaClutterSettings.WaterTemperature), 35, "water temperature 35 C must be from -2 to 29")]
        [TestCase(nameof(SeaClutterSettings.Salinity), -1, "salinity -1 psu must be from 0 to 40")]
        [TestCase(nameof(SeaClutterSettings.WhitecapCoefficient), 1, "whitecap coefficient 1 must be from 0 to 0.001")]
        [TestCase(nameof(SeaClutterSettings.Gustiness), 5, "gustiness 5 must be from 0 to 4")]
        [TestCase(nameof(SeaClutterSettings.Seed), -1, "seed -1 must be from 0")]
        public void Setting_OutOfRange_IsRefused(string field, double value, string part)
        {
            object settings = SeaClutterSettings.On;
            var info = typeof(SeaClutterSettings).GetField(field);
            info.SetValue(settings, Convert.ChangeType(value, info.FieldType));
            var surface = new SeaSurface(SeaSettings.Default);
            Assert.That(() => new SeaClutter(surface, 0, s_wind, (SeaClutterSettings)settings),
                Throws.TypeOf<GlintException>().With.Message.StartsWith("sea: ").And.Message.Contains(part));
        }

        // A flat sea has no wind of its own.
        [Test]
        public void Wind_OfALowSea_IsRefused()
        {
            var settings = SeaFields.Settings();
            settings.SignificantWaveHeight = 0.05;
            Assert.That(() => Of(settings), Throws.TypeOf<GlintException>().With.Message.Contains("clutter wind 2.1"));
        }

        [Test]
        public void Wind_ThatIsNoHorizontalUnitVector_IsRefused()
        {
            var surface = new SeaSurface(SeaSettings.Default);
            foreach (var wind in new[] { new double3(0, 0, 2), new double3(0, 1, 0), new double3(double.NaN, 0, 0) })
                Assert.Throws<ArgumentOutOfRangeException>(
                    () => new SeaClutter(surface, 0, wind, SeaClutterSettings.On));
        }

        /// <summary>A square sea of Elfouhaily's spectrum whose facets hold all waves of its grid.</summary>
        internal static SeaSettings Waves(double wind, double tile, int cells)
        {
            var settings = SeaSettings.Default;
            (settings.WindSpeed, settings.TileSize, settings.Cells, settings.GridSize) = (wind, tile, cells, cells);
            return settings;
        }

        internal static double3 Normal(TriangleMesh mesh, int triangle)
        {
            mesh.GetTriangle(triangle, out var a, out var b, out var c);
            return math.normalize(math.cross((double3)b - a, (double3)c - a));
        }

        // Along and across the wind.
        static double2 MeanSquareSlopes(TriangleMesh mesh, double direction)
        {
            double2 wind = new double2(Math.Sin(math.radians(direction)), Math.Cos(math.radians(direction))), sum = 0;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                double3 normal = Normal(mesh, t);
                double2 slope = -normal.xz / normal.y;
                double along = math.dot(slope, wind), across = slope.x * wind.y - slope.y * wind.x;
                sum += new double2(along * along, across * across);
            }
            return sum / mesh.TriangleCount;
        }

        static SeaClutter Of(SeaSettings settings) =>
            new SeaClutter(new SeaSurface(settings), 0, s_wind, SeaClutterSettings.On);
    }
}
