using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The echo of a sea on the radar screen, and points that its waves hide.</summary>
    [Category("Slow")]
    public sealed class ScreenSeaTests
    {
        const double Wind = 10, Range = 1000;

        // 10 degrees of grazing, where most of the surface is lit, against the wind: the sea lies to the south, and the
        // wind blows to the north. Averages over 40 degrees, 200 m and two moments.
        [TestCase(ScreenPolarisation.Vertical)]
        [TestCase(ScreenPolarisation.Horizontal)]
        public void Clutter_HasTheMeanOfTheTwoScaleSea(ScreenPolarisation polarisation)
        {
            var expected = new AnalyticSea(Wind, ScreenRadar.Default.Frequency).WithShadow(80, 0);
            double decibels = MeanDecibels(RadarOf(polarisation), SeaClutterSettings.On, 10)
                - 10 * Math.Log10(polarisation == ScreenPolarisation.Vertical ? expected.VV : expected.HH);
            Assert.That(decibels, Is.EqualTo(0).Within(1));
        }

        // The mean is that of the model, in the sea's state of the wind, against the wind; texture and shadows stay.
        [TestCase(ClutterLevel.Nrl, 2, ScreenPolarisation.Vertical, Category = "Stress")]
        [TestCase(ClutterLevel.Git, 5, ScreenPolarisation.Horizontal)]
        [Timeout(600000)]
        public void Clutter_OfAPublishedLevel_HasItsMean(ClutterLevel level, double grazing, ScreenPolarisation polarisation)
        {
            var clutter = SeaClutterSettings.On;
            clutter.Level = level;
            var model = ClutterModel.Of(level);
            var sea = new SeaClutter(new SeaSurface(Waves()), 0, new double3(0, 0, 1), clutter);
            // The radar is north of the sea that it sees, which the wind leaves to the north.
            double expected = model.Decibels(
                polarisation == ScreenPolarisation.Vertical ? Polarisation.VV : Polarisation.HH,
                sea.ConditionsAt(ScreenRadar.Default.Frequency, 180, grazing));
            Assert.That(MeanDecibels(RadarOf(polarisation), clutter, grazing), Is.EqualTo(expected).Within(1));
        }

        // Sigma0 of the sea to the south.
        static double MeanDecibels(in ScreenRadar radar, in SeaClutterSettings clutter, double grazing)
        {
            double height = Range * Math.Sin(math.radians(grazing));
            using (var bench = new ScreenBench(radar))
            using (var sea = new ScreenSea(TestKernels.SeaField, "test", bench.Geometry, Waves(), clutter))
            {
                double sum = 0, count = 0;
                for (int moment = 0; moment < 2; moment++)
                {
                    sea.Update(10 * moment);
                    foreach (double turns in new[] { (160 + 360.0 * moment) / 360, (200 + 360.0 * moment) / 360 })
                    {
                        bench.Tracer.Begin(turns);
                        bench.Tracer.AddSea(sea, new double3(37, height, 51), 0);
                        bench.Tracer.Finish(bench.Receiver);
                    }
                    var levels = bench.Levels();
                    for (int spoke = 4096 * 16 / 36; spoke < 4096 * 20 / 36; spoke++)
                        for (int cell = 115; cell < 141; cell++, count++)
                            sum += Math.Pow(10, levels[bench.Element(spoke, cell)] / 10);
                }
                // Two-way beam and matched pulse; the cells are at 900 to 1,100 m, where R^-3 averages to its middle.
                double gain = 26000 / (1.2 * 179), wave = 299792458 / 9.41e9,
                    area = Range * 1.0645 / Math.Sqrt(2) * math.radians(1.2) * 2 / 3 * 299792458 / 2 * 80e-9
                        / Math.Cos(math.radians(grazing)),
                    noise = 1.380649e-23 * 290 / 80e-9 * Math.Pow(10, 0.5),
                    factor = 25000 * gain * gain * wave * wave * area / (Math.Pow(4 * Math.PI, 3) * Math.Pow(Range, 4));
                double decibels = 10 * Math.Log10((sum / count - 1) * noise / factor);
                TestContext.WriteLine($"{decibels:F2} dB");
                return decibels;
            }
        }

        // A cosecant from 2 degrees below the middle of a beam of 4, where half of the power is: below it the power one way
        // is sin^2(2 deg) / (2 sin^2(depression)). The same waves and speckle in a beam without effect have the sea's own
        // level. 174 m of height: depressions of 20 to 9 degrees.
        [Test]
        public void Clutter_HasThePatternBelowTheAntenna()
        {
            const double height = 174;
            double[] Powers(in ScreenRadar radar)
            {
                using (var bench = new ScreenBench(radar))
                using (var sea = new ScreenSea(TestKernels.SeaField, "test", bench.Geometry, Waves(),
                    SeaClutterSettings.On))
                {
                    sea.Update(0);
                    foreach (double turns in new[] { 0.25, 0.3 })
                    {
                        bench.Tracer.Begin(turns);
                        bench.Tracer.AddSea(sea, new double3(0, height, 0), 0);
                        bench.Tracer.Finish(bench.Receiver);
                    }
                    var levels = bench.Levels();
                    return Enumerable.Range(0, 154).Select(cell => Enumerable.Range(1030, 180)
                        .Average(spoke => Math.Pow(10, levels[bench.Element(spoke, cell)] / 10)) - 1).ToArray();
                }
            }
            var wide = RadarOf(ScreenPolarisation.Vertical);
            var cosecant = wide;
            (cosecant.Pattern, cosecant.VerticalBeamWidth, cosecant.CosecantFrom, cosecant.CosecantTo) =
                (ScreenPattern.Cosecant, 4, -2, -40);
            double[] expected = Powers(wide), actual = Powers(cosecant);
            foreach (int first in new[] { 65, 85, 110, 140 })
            {
                double Ratio(int cell)
                {
                    double sine = height / ((cell + 0.5) * 1200 / 154), angle = Math.Asin(sine) / math.radians(179),
                        power = Math.Pow(Math.Sin(math.radians(2)) / sine, 2) / 2 / Math.Pow(2, -4 * angle * angle);
                    // The gain is 26,000 over the product of the widths.
                    return Math.Pow(179 / 4.0 * power, 2);
                }
                double decibels = 10 * Math.Log10(actual.Skip(first).Take(13).Sum()
                    / Enumerable.Range(first, 13).Sum(cell => expected[cell] * Ratio(cell)));
                // Crests 2 m above the mean level are 0.1 dB stronger or weaker.
                Assert.That(decibels, Is.EqualTo(0).Within(0.2), $"cells from {first}");
            }
        }

        // Against and with the wind a sea without shadow is the same, across it is lower: the spectrum has cos 2 phi.
        [Test]
        public void Clutter_AcrossTheWind_IsWeaker()
        {
            double Mean(double north)
            {
                using (var bench = new ScreenBench(RadarOf(ScreenPolarisation.Vertical)))
                using (var sea = new ScreenSea(TestKernels.SeaField, "test", bench.Geometry, Waves(),
                    SeaClutterSettings.On))
                {
                    sea.Update(0);
                    foreach (double turns in new[] { 0, 30 / 360.0 })
                    {
                        bench.Tracer.Begin(turns);
                        bench.Tracer.AddSea(sea, new double3(0, 500, 0), north);
                        bench.Tracer.Finish(bench.Receiver);
                    }
                    var levels = bench.Levels();
                    return 10 * Math.Log10(Enumerable.Range(0, 300).Average(spoke => Enumerable.Range(115, 26)
                        .Average(cell => Math.Pow(10, levels[bench.Element(spoke, cell)] / 10))));
                }
            }
            double along = Mean(0), across = Mean(0.25);
            // 30 degrees of grazing: 3.4 to 3.7 dB in X band.
            Assert.That(along - across, Is.InRange(2.5, 4.5));
        }

        [Test]
        public void Points_BelowTheWaves_AreHidden_AndThoseAboveAreNot()
        {
            using (var bench = new ScreenBench(RadarOf(ScreenPolarisation.Vertical)))
            using (var sea = new ScreenSea(TestKernels.SeaField, "test", bench.Geometry, Waves(), SeaClutterSettings.On))
            {
                sea.Update(0);
                // 20 m of antenna: the ray to 10 m passes over all crests, that to -3 m does not.
                ScreenPoint At(double bearing, double height) => bench.Geometry.PointOf(new double3(
                    Range * Math.Sin(math.radians(bearing)), height, Range * Math.Cos(math.radians(bearing))),
                    new double3(0, 20, 0), 1e5);
                var points = new[] { At(90, 10), At(100, 10) };
                points[1].Position.y = -23;
                foreach (double turns in new[] { 85 / 360.0, 105 / 360.0 })
                {
                    bench.Tracer.Begin(turns);
                    bench.Tracer.AddSea(sea, new double3(5, 20, 6), 0);
                    bench.Tracer.AddPoints(points, 2, isOverSea: true);
                    bench.Tracer.Finish(bench.Receiver);
                }
                var levels = bench.Levels();
                double Level(ScreenPoint point) => levels[bench.Element(point.Spoke, point.Cell)];
                Assert.That(Level(points[0]), Is.GreaterThan(80));
                Assert.That(Level(points[1]), Is.LessThan(Level(points[0]) - 20));
            }
        }

        // The same with walls: one 10 m above the sea, one 3 m below it.
        [Test]
        public void Meshes_BelowTheWaves_AreHidden_AndThoseAboveAreNot()
        {
            double3 antenna = new double3(5, 20, 6);
            TriangleMesh Wall(double bearing, double height)
            {
                double angle = math.radians(bearing);
                double3 forward = new double3(Math.Sin(angle), 0, Math.Cos(angle)), across = new double3(forward.z, 0, -forward.x),
                    middle = antenna * new double3(1, 0, 1) + Range * forward + new double3(0, height, 0);
                float3 At(double x, double y) => (float3)(middle + x * across + new double3(0, y, 0));
                return new TriangleMesh(new[] { At(-5, -1), At(5, -1), At(5, 1), At(-5, 1) }, new[] { 0, 1, 2, 0, 2, 3 });
            }
            var scene = new RadarScene(new MeshInstance { Mesh = Wall(90, 10), ToWorld = Affine.Identity },
                new MeshInstance { Mesh = Wall(100, -3), ToWorld = Affine.Identity });
            using (var bench = new ScreenBench(RadarOf(ScreenPolarisation.Vertical)))
            using (var sea = new ScreenSea(TestKernels.SeaField, "test", bench.Geometry, Waves(), SeaClutterSettings.On))
            using (var targets = new ScreenTargets("test", bench.Geometry))
            {
                sea.Update(0);
                targets.SetScene(scene, new bool[2]);
                foreach (double turns in new[] { 85 / 360.0, 105 / 360.0 })
                {
                    bench.Tracer.Begin(turns);
                    bench.Tracer.AddSea(sea, antenna, 0);
                    bench.Tracer.AddTargets(targets, antenna, 0, 0, isOverSea: true);
                    bench.Tracer.Finish(bench.Receiver);
                }
                var levels = bench.Levels();
                double Level(double bearing) => levels[bench.Element((int)Math.Round(bearing / 360 * bench.Geometry.Radar.Spokes),
                    (int)(Range / bench.Geometry.CellSize))];
                Assert.That(Level(90), Is.GreaterThan(Level(100) + 20));
            }
        }

        [Test]
        public void Constants_AreThoseOfCSharp()
        {
            Assert.That(ShaderConstants.Of("Screen.hlsl"), Is.EquivalentTo(
                new Dictionary<string, double> { ["ECHO_UNITS"] = ScreenGeometry.UnitsOfNoise }));
            Assert.That(ShaderConstants.Of("ScreenPattern.hlsl"), Is.EquivalentTo(
                new Dictionary<string, double> { ["ELEVATION_STEPS"] = ScreenGeometry.ElevationSteps }));
            Assert.That(ShaderConstants.Of("ScreenSeaLevels.hlsl"), Is.EquivalentTo(new Dictionary<string, double>
            {
                ["SEA_DIRECTIONS"] = ScreenSeaLevels.Directions, ["SEA_MEAN_FACETS"] = ScreenSeaLevels.Facets
            }));
            Assert.That(ShaderConstants.Of("ScreenPixel.hlsl"), Is.EquivalentTo(new Dictionary<string, double>
            {
                ["SCREEN_PIXEL_SPOKES"] = ScreenPicture.MaxSpokes, ["TRAIL_SIDE"] = TrailMap.Side,
                ["TRAIL_RADIUS"] = TrailMap.Radius
            }));
            Assert.That(ShaderConstants.Of("ScreenPicture.hlsl")["TRAIL_REACH"], Is.EqualTo(ScreenPicture.TrailReach));
        }

        // Narrow cells around 1,000 m, and a beam without effect in elevation.
        static ScreenRadar RadarOf(ScreenPolarisation polarisation)
        {
            var radar = ScreenRadar.Default;
            (radar.Polarisation, radar.RangeScale, radar.Cells, radar.VerticalBeamWidth) =
                (polarisation, 1200, 154, 179);
            return radar;
        }

        static SeaSettings Waves()
        {
            var waves = SeaSettings.Default;
            (waves.WindSpeed, waves.TileSize, waves.GridSize, waves.Choppiness) = (Wind, 256, 256, 0);
            return waves;
        }
    }
}
