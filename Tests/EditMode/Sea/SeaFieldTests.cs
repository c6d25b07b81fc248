using System;
using System.Linq;
using Number = System.Numerics.Complex;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The device's sea is that of <see cref="SeaSurface"/>.</summary>
    public sealed class SeaFieldTests
    {
        const int Side = SeaField.Side, Points = Side * Side;

        static readonly SeaSurface s_tile = new SeaSurface(SettingsOf(256)), s_finer = s_tile.Finer(24);

        // The last time is 18 days after the start of the waves: the device's clock has started anew, and float32 has
        // steps of 0.125 s there.
        [Test]
        public void Points_AtAnyTime_AreThoseOfTheProcessor([Values(0, 12.34, -3.7, 1555200.3)] double time)
        {
            using (var field = new SeaField(TestKernels.SeaField, "test", s_tile, s_finer))
            {
                field.Update(time);
                var points = Read(field);
                AssertPoints(points.Take(Points).ToArray(), s_tile, time);
                AssertPoints(points.Skip(Points).ToArray(), s_finer, time);
            }
        }

        // The mesh is another way to the heights, rounded to 2^-16 m.
        [Test]
        public void Heights_AreThoseOfTheMesh()
        {
            using (var field = new SeaField(TestKernels.SeaField, "test", s_tile))
            {
                field.Update(7.5);
                double[] heights = SeaFields.Heights(s_tile.Mesh(7.5), Side);
                AssertNear(Read(field), point => point.Height, heights, 1e-4, "height");
                Assert.That(heights.Max(), Is.GreaterThan(1), "metres: there are waves");
            }
        }

        [Test]
        public void Acceleration_IsTheSecondDifferenceOfHeights()
        {
            const double step = 1.0 / 32;
            using (var field = new SeaField(TestKernels.SeaField, "test", s_tile))
            {
                SeaPoint[] At(double time)
                {
                    field.Update(time);
                    return Read(field);
                }
                SeaPoint[] before = At(20 - step), now = At(20), after = At(20 + step);
                double[] acceleration = Enumerable.Range(0, Points)
                    .Select(i => (after[i].Height - 2.0 * now[i].Height + before[i].Height) / (step * step)).ToArray();
                // The fourth derivative of the shortest waves, w = 5.5 rad/s, limits the difference quotient.
                AssertNear(now, point => point.Acceleration, acceleration, 0.02, "acceleration");
                Assert.That(acceleration.Max(), Is.GreaterThan(1), "m/s2");
            }
        }

        [Test]
        public void Bounds_OfAllLevels_AreTheExtremesOfTheHeights()
        {
            using (var field = new SeaField(TestKernels.SeaField, "test", s_tile, s_finer))
            {
                field.Update(3);
                var points = Read(field);
                var bounds = new float2[2 * SeaField.BoundsOfATile];
                field.Bounds.ReadBack(bounds, bounds.Length);
                for (int cascade = 0; cascade < 2; cascade++)
                {
                    int first = cascade * SeaField.BoundsOfATile;
                    for (int cells = Side; cells >= 1; first += cells * cells, cells /= 2)
                        Assert.That(bounds.Skip(first).Take(cells * cells),
                            Is.EqualTo(BoundsOf(points, cascade * Points, cells)), $"{cells} cells");
                }
            }
        }

        [Test]
        public void Update_AtTheSameTime_GivesTheSameBits_InFourDispatches()
        {
            using (var field = new SeaField(TestKernels.SeaField, "test", s_tile, s_finer))
            {
                field.Update(100);
                var first = Read(field);
                field.Update(101);
                Assert.That(Read(field), Is.Not.EqualTo(first));
                field.Update(100);
                Assert.That(Read(field), Is.EqualTo(first));
                Assert.That(field.Dispatches, Is.EqualTo(3 * SeaField.DispatchesOfAnUpdate));
                Assert.That(field.Uploads, Is.EqualTo(1));
                field.Update(SeaField.ClockSeconds);
                Assert.That(field.Uploads, Is.EqualTo(2));
            }
        }

        [Test]
        public void Field_OfWhatItCannotHold_IsRefused()
        {
            var shader = TestKernels.SeaField;
            var settings = SettingsOf(256);
            settings.GridSize = 512;
            Assert.That(() => new SeaField(shader, "screen", new SeaSurface(settings)),
                Throws.InstanceOf<GlintException>().With.Message.StartsWith("screen: grid size 512"));
            Assert.That(() => new SeaField(shader, "screen"),
                Throws.InstanceOf<GlintException>().With.Message.Contains("has 0 cascades"));
            Assert.That(() => new SeaField(TestKernels.Trace, "screen", s_tile),
                Throws.InstanceOf<GlintException>().With.Message.Contains("Shaders/SeaField.compute"));
            using (var field = new SeaField(shader, "screen", s_tile))
                Assert.That(() => field.Update(double.NaN),
                    Throws.InstanceOf<GlintException>().With.Message.Contains("time NaN s"));
        }

        static SeaPoint[] Read(SeaField field)
        {
            var points = new SeaPoint[field.Points.Capacity];
            field.Points.ReadBack(points, points.Length);
            return points;
        }

        // Coefficients of the fields by the theory of deep-water waves: h has the factor e^(i (k x - w t)).
        static void AssertPoints(SeaPoint[] points, SeaSurface surface, double time)
        {
            AssertField(points, point => point.Height, surface, time, 1e-3, "height", (mode, w) => 1);
            AssertField(points, point => point.Acceleration, surface, time, 1e-4, "acceleration",
                (mode, w) => -w * w);
        }

        static void AssertField(SeaPoint[] points, Func<SeaPoint, float> field, SeaSurface surface, double time,
            double tolerance, string name, Func<SeaMode, double, Number> factor)
        {
            var waves = new WaveCoefficients(surface.Settings.GridSize / 2 - 1);
            foreach (var mode in surface.Modes)
            {
                double w = 2 * Math.PI * mode.Frequency;
                var value = new Number(mode.Real, mode.Imaginary)
                    * Number.FromPolarCoordinates(1, -Math.IEEERemainder(w * time, 2 * Math.PI)) * factor(mode, w);
                int at = waves.IndexOf(mode.Column, mode.Row);
                (waves.Real[at], waves.Imaginary[at]) = (value.Real, value.Imaginary);
            }
            AssertNear(points, field, new FourierSum(Side).Sum(waves), tolerance, name);
        }

        static void AssertNear(SeaPoint[] points, Func<SeaPoint, float> field, double[] expected, double tolerance,
            string name)
        {
            double worst = points.Select((point, i) => Math.Abs(field(point) - expected[i])).Max();
            TestContext.WriteLine($"{name}: {worst:G3} of {expected.Max(Math.Abs):G3}");
            Assert.That(worst, Is.LessThan(tolerance), name);
        }

        static float2[] BoundsOf(SeaPoint[] points, int first, int cells)
        {
            var bounds = new float2[cells * cells];
            int block = Side / cells;
            for (int i = 0; i < bounds.Length; i++)
            {
                bounds[i] = math.float2(float.MaxValue, float.MinValue);
                for (int z = 0; z <= block; z++)
                    for (int x = 0; x <= block; x++)
                    {
                        int row = (i / cells * block + z) % Side, column = (i % cells * block + x) % Side;
                        float height = points[first + row * Side + column].Height;
                        bounds[i] = math.float2(math.min(bounds[i].x, height), math.max(bounds[i].y, height));
                    }
            }
            return bounds;
        }

        static SeaSettings SettingsOf(double tile)
        {
            var settings = SeaSettings.Default;
            (settings.TileSize, settings.GridSize, settings.Cells) = (tile, Side, Side);
            (settings.WindSpeed, settings.WindDirectionDegrees, settings.Choppiness) = (11, 40, 0);
            return settings;
        }
    }
}
