using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The diffuse echo that the device sums over facets, against sums and means in double precision.</summary>
    public sealed class ClutterTracerTests
    {
        const double TenGigahertz = 1e10;

        ClutterTracer _tracer;

        [OneTimeSetUp]
        public void MakeTracer() => _tracer = new ClutterTracer(TestKernels.Tubes);

        [OneTimeTearDown]
        public void DisposeTracer() => _tracer.Dispose();

        // From above nothing is in the shade.
        [TestCase(50, 20, 0)]
        [TestCase(75, -110, 0)]
        [TestCase(88, 60, 0)]
        [TestCase(50, 20, 3000)]
        public void Trace_OfLitFacets_IsTheSumOfTheTable(double grazing, double azimuth, double range)
        {
            var sea = new TestSea(10, 32, 64, 35);
            var pose = sea.Pose(azimuth, grazing);
            if (range > 0)
                pose.Range = range;
            var echo = _tracer.Trace(pose, TenGigahertz).Single();
            var expected = Sum(sea, pose);
            Assert.That(echo.LitFraction, Is.EqualTo(1).Within(1e-6));
            Assert.That(echo.Area, Is.EqualTo(32 * 32).Within(1e-3).Percent);
            Assert.That(echo.SigmaVV, Is.EqualTo(expected.VV).Within(0.02).Percent);
            Assert.That(echo.SigmaHH, Is.EqualTo(expected.HH).Within(0.02).Percent);
            // Nearby the radar's H is not quite horizontal at the facets beside the middle.
            Assert.That(echo.SigmaHV, Is.EqualTo(expected.HV).Within(range > 0 ? 0.5 : 0.02).Percent);
        }

        // Without breaking waves; the mean of some draws of a tile, and of opposite directions.
        [Test]
        public void Trace_OfASea_IsTheTwoScaleMean([Values(5, 7, 10, 14, 18)] double wind)
        {
            var seas = Enumerable.Range(1, 4).Select(seed => new TestSea(wind, 128, 128, 0, 0, 1, seed)).ToArray();
            var clutter = seas[0].Clutter;
            var scattering = new SeaScattering(TenGigahertz, clutter.Water.At(TenGigahertz).permittivity,
                clutter.ShortWaves.Spectrum.Density);
            var (along, across) = clutter.ShortWaves.SlopeVariances(1e-3, scattering.TiltCut);
            foreach (double azimuth in new[] { 0, 90, 45.0 })
                foreach (double grazing in new[] { 20, 30, 45, 60, 70.0 })
                {
                    var found = ClutterEcho.Sum(seas.SelectMany(sea => new[] { azimuth, azimuth + 180 }
                        .SelectMany(side => _tracer.Trace(sea.Pose(side, grazing), TenGigahertz)))).Sigma0;
                    var expected = scattering.TwoScaleMean(RadarAspect.At(azimuth, grazing).ToRadar, clutter.Wind,
                        new double2(along, across));
                    string where = FormattableString.Invariant($"{wind} m/s, azimuth {azimuth}, grazing {grazing}");
                    TestContext.WriteLine(where + FormattableString.Invariant($"HH {Sigma0.Decibels(expected.HH):0.00} {Sigma0.Decibels(found.HH / expected.HH):+0.00;-0.00} ")
                        + FormattableString.Invariant($"VV {Sigma0.Decibels(expected.VV):0.00} {Sigma0.Decibels(found.VV / expected.VV):+0.00;-0.00}"));
                }
        }

        [Test]
        public void Dev_MonteCarlo()
        {
            foreach (int seed in new[] { 1, 2 })
            {
            var sea = new TestSea(10, 512, 1024, 0, WhitecapLaw.DefaultCoefficient, 2, seed);
            foreach (double grazing in new[] { 1, 3, 10, 30.0 })
            {
                // Against the wind, from +Z.
                var watch = System.Diagnostics.Stopwatch.StartNew();
                var pose = sea.Pose(180, grazing);
                var grid = new ClutterGrid(new double3(-256, 0, -256), new double3(1, 0, 0), new double3(0, 0, 1), new double2(30, 15), new int2(17, 34));
                var cells = _tracer.Trace(pose, TenGigahertz, grid);
                var found = ClutterEcho.Sum(cells);
                TestContext.WriteLine(FormattableString.Invariant($"{grazing}: lit {found.LitFraction:0.000} HH {Sigma0.Decibels(found.Sigma0.HH):0.00} VV {Sigma0.Decibels(found.Sigma0.VV):0.00} HV {Sigma0.Decibels(found.Sigma0.HV):0.00} shape {ClutterStatistics.ShapeOfTexture(cells.Select(c => c.SigmaHH).ToArray()):0.00} {ClutterStatistics.ShapeOfTexture(cells.Select(c => c.SigmaVV).ToArray()):0.00} {watch.ElapsedMilliseconds} ms"));
            }
            }
        }

        static Sigma0 Sum(TestSea sea, CrossSectionPose pose)
        {
            var table = sea.Clutter.TableAt(TenGigahertz);
            var sum = default(Sigma0);
            for (int i = 0; i < sea.Mesh.TriangleCount; i++)
            {
                sea.Mesh.GetTriangle(i, out var a, out var b, out var c);
                var section = math.cross((double3)b - a, (double3)c - a) / 2;
                section = section.y < 0 ? -section : section;
                double area = math.length(section), strength = 1;
                var toRadar = pose.Radar.ToRadar;
                if (!pose.IsFar)
                {
                    var way = pose.PhaseCentre + pose.Range * pose.Radar.ToRadar - ((double3)a + b + c) / 3;
                    toRadar = math.normalize(way);
                    strength = Math.Pow(pose.Range / math.length(way), 4);
                }
                var sigma = table.Read(section / area, toRadar, sea.Clutter.Wind);
                double breaking = SeaScattering.Breaking(toRadar.y);
                sum += area * strength * (sea.Clutter.BreakingFacets[i] ? new Sigma0(breaking, breaking, sigma.HV) : sigma);
            }
            return sum;
        }
    }

    /// <summary>A sea of Elfouhaily's waves with clutter, whose tile is repeated.</summary>
    sealed class TestSea
    {
        public TestSea(double wind, double tileSize, int cells, double windDegrees, double whitecaps = WhitecapLaw.DefaultCoefficient,
            int tilesAlong = 1, int seed = 1)
        {
            var settings = SeaSettings.Default;
            settings.Kind = SeaSpectrumKind.Elfouhaily;
            (settings.WindSpeed, settings.SignificantWaveHeight) = (wind, 0);
            (settings.TileSize, settings.Cells, settings.GridSize) = (tileSize, cells, cells);
            (settings.WindDirectionDegrees, settings.Seed, settings.Choppiness) = (windDegrees, seed, 0);
            Surface = new SeaSurface(settings);
            Mesh = Surface.Mesh(0);
            var clutter = SeaClutterSettings.On;
            clutter.WhitecapCoefficient = whitecaps;
            double angle = math.radians(windDegrees);
            Clutter = new SeaClutter(Surface, 0, new double3(Math.Sin(angle), 0, Math.Cos(angle)), clutter);
            var tiles = Enumerable.Range(0, tilesAlong).Select(i => new int2(0, i)).ToArray();
            Scene = new RadarScene(tiles.Select(tile => Instance(new double3(0, 0, tileSize * tile.y))).ToArray())
            {
                Seas = new[] { new SceneSea(Clutter, Enumerable.Range(0, tilesAlong).ToArray(), tiles) }
            };
        }

        public SeaSurface Surface { get; }

        public TriangleMesh Mesh { get; }

        public SeaClutter Clutter { get; }

        public RadarScene Scene { get; }

        public CrossSectionPose Pose(double azimuth, double grazing)
        {
            var radar = RadarAspect.At(azimuth, grazing);
            return new CrossSectionPose
            {
                Scene = Scene, Radar = radar, Receivers = new[] { radar }, Frequencies = new[] { 1e10 }
            };
        }

        MeshInstance Instance(double3 at)
        {
            var toWorld = Affine.Identity;
            toWorld.Origin = at;
            return new MeshInstance { Mesh = Mesh, ToWorld = toWorld };
        }
    }
}
