using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The diffuse echo that the device sums over facets, against sums and means in double precision.</summary>
    [Category("Slow")]
    public sealed class ClutterTracerTests : ClutterFixture
    {
        const double TenGigahertz = 1e10;

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
            var echo = Tracer.Trace(pose, TenGigahertz).Single();
            var expected = Sum(sea, pose);
            Assert.That(echo.LitFraction, Is.EqualTo(1).Within(1e-6));
            Assert.That(echo.Area, Is.EqualTo(32 * 32).Within(1e-3).Percent);
            Assert.That(echo.SigmaVV, Is.EqualTo(expected.VV).Within(0.02).Percent);
            Assert.That(echo.SigmaHH, Is.EqualTo(expected.HH).Within(0.02).Percent);
            // Nearby the radar's H is not quite horizontal at the facets beside the middle.
            Assert.That(echo.SigmaHV, Is.EqualTo(expected.HV).Within(range > 0 ? 0.5 : 0.02).Percent);
        }

        // Without breaking waves; the mean of two draws of a tile, and of opposite directions.
        [TestCase(5, 0, Category = "Stress")]
        [TestCase(5, 45, Category = "Stress")]
        [TestCase(5, 90, Category = "Stress")]
        [TestCase(18, 0)]
        [TestCase(18, 45, Category = "Stress")]
        [TestCase(18, 90)]
        [Timeout(600000)]
        public void Trace_OfASea_IsTheTwoScaleMean(double wind, double azimuth)
        {
            var seas = new[] { 1, 2 }.Select(seed => new TestSea(wind, 256, 256, 0, 0, seed)).ToArray();
            var clutter = seas[0].Clutter;
            var scattering = new SeaScattering(TenGigahertz, clutter.Water.At(TenGigahertz).permittivity,
                clutter.ShortWaves.Spectrum.Density);
            var (along, across) = clutter.ShortWaves.SlopeVariances(1e-3, scattering.TiltCut);
            foreach (double grazing in new[] { 20, 45, 70.0 })
            {
                var found = ClutterEcho.Sum(seas.SelectMany(sea => new[] { azimuth, azimuth + 180 }
                    .SelectMany(side => Tracer.Trace(sea.Pose(side, grazing), TenGigahertz)))).Sigma0;
                var expected = scattering.TwoScaleMean(RadarAspect.At(azimuth, grazing).ToRadar, clutter.Wind,
                    new double2(along, across));
                AssertNear(found, expected, 0.3, $"azimuth {azimuth}, grazing {grazing}");
            }
        }

        // Far from the radar a facet counts for all of a group, here of 8 x 8 cells: sums stay the same within three
        // standard deviations of 4,096 samples. Those that break, which return HH, are all there.
        [TestCase(20, 0.3)]
        [TestCase(3, 0.5)]
        public void Trace_FarFromTheRadar_TakesFewerFacetsOfTheSameMean(double grazing, double decibels)
        {
            var sea = new TestSea(10, 256, 256, 0, tiles: 4);
            var pose = sea.Pose(180, grazing);
            (pose.Range, pose.PhaseCentre) = (2500, new double3(0, 0, 384));
            using var tracer = Make();
            var all = tracer.Trace(pose, TenGigahertz).Single();
            Assert.That(tracer.Statistics.SeaFacets, Is.EqualTo(4 * sea.Mesh.TriangleCount));
            tracer.MinGroups = 0;
            var some = tracer.Trace(pose, TenGigahertz).Single();
            Assert.That(tracer.Statistics.SeaFacets - 4 * sea.Mesh.TriangleCount,
                Is.EqualTo(4 * (32 * 32 + sea.Clutter.BreakingFacets.Count(breaks => breaks))));
            Assert.That(some.Area, Is.EqualTo(all.Area).Within(1).Percent);
            Assert.That(some.LitFraction, Is.EqualTo(all.LitFraction).Within(0.02));
            AssertNear(some.Sigma0, all.Sigma0, decibels, $"grazing {grazing}");
            Assert.That(Sigma0.Decibels(some.Sigma0.HV / all.Sigma0.HV), Is.EqualTo(0).Within(0.6));
            Assert.That(tracer.Trace(pose, TenGigahertz).Single(), Is.EqualTo(some));
        }

        // The mesh of the same waves in 16 times as many facets, and seas of facets of 0.5 to 4 m.
        [TestCase(64, 64, 64, 256, 0.3)]
        [TestCase(128, 128, 256, 256, 0.5)]
        [TestCase(128, 128, 32, 32, 0.5)]
        public void Trace_InOtherFacets_HasTheSameMean(int grid, int cells, int otherGrid, int otherCells,
            double decibels)
        {
            var sea = new TestSea(10, 128, cells, 20, 0, grid: grid);
            var other = new TestSea(10, 128, otherCells, 20, 0, grid: otherGrid);
            foreach (double grazing in new[] { 25, 50.0 })
                AssertNear(Tracer.Trace(other.Pose(10, grazing), TenGigahertz).Single().Sigma0,
                    Tracer.Trace(sea.Pose(10, grazing), TenGigahertz).Single().Sigma0, decibels,
                    $"grazing {grazing}");
        }

        // Two tiles of 32 bytes a facet are uploaded once; later sums are two dispatches and one round trip.
        [Test]
        public void Trace_OfTheSameSeaAgain_UploadsNoFacetsAndWaitsOnce()
        {
            var sea = new TestSea(10, 32, 32, 0, tiles: 2);
            using var tracer = Make();
            tracer.Trace(sea.Pose(25, 12), TenGigahertz);
            var first = tracer.Statistics;
            long uploaded = first.BytesUploaded, readBack = first.BytesReadBack;
            (int dispatches, int trips) = (first.Dispatches, first.RoundTrips);
            Assert.That(uploaded, Is.GreaterThan(32 * sea.Mesh.TriangleCount));
            tracer.Trace(sea.Pose(40, 5), TenGigahertz);
            Assert.That(tracer.Statistics.Dispatches - dispatches, Is.EqualTo(2));
            Assert.That(tracer.Statistics.RoundTrips - trips, Is.EqualTo(1));
            Assert.That(tracer.Statistics.BytesReadBack, Is.EqualTo(2 * readBack));
            Assert.That(tracer.Statistics.BytesUploaded - uploaded, Is.LessThan(1000));
        }

        // Water near a radar that looks far: the cross section at the range of the phase centre grows with its fourth power,
        // here to 10^8 and 10^14 m2.
        [TestCase(30)]
        [TestCase(1000)]
        public void Trace_OfASeaNearerThanThePhaseCentre_GrowsWithTheFourthPowerOfRange(double times)
        {
            const double range = 200;
            var sea = new TestSea(10, 32, 64, 35);
            ClutterEcho At(double factor)
            {
                var pose = sea.Pose(20, 50);
                (pose.Range, pose.PhaseCentre) = (factor * range, (1 - factor) * range * pose.Radar.ToRadar);
                return Tracer.Trace(pose, TenGigahertz).Single();
            }
            ClutterEcho near = At(1), far = At(times);
            Assert.That(far.SigmaVV / near.SigmaVV, Is.EqualTo(Math.Pow(times, 4)).Within(0.01).Percent);
            Assert.That(far.SigmaHV / near.SigmaHV, Is.EqualTo(Math.Pow(times, 4)).Within(0.01).Percent);
            Assert.That(far.LitFraction, Is.EqualTo(near.LitFraction));
        }

        // Copies of a Sea have one seed. Side by side, at the same distance, they would return twice the field of one.
        [Test]
        public void Trace_TwoSeasOfEqualSettings_HasTheSpeckleOfTwo()
        {
            var sea = new TestSea(10, 32, 32, 0, tiles: 2);
            ClutterEcho Of(int count)
            {
                var pose = sea.Pose(90, 40);
                pose.Scene = new RadarScene(sea.Instances)
                {
                    Seas = Enumerable.Range(0, count).Select(i => new RadarSea(sea.Clutter,
                        new[] { new SeaTileInstance(i, int2.zero) })).ToArray()
                };
                return Tracer.Trace(pose, TenGigahertz).Single();
            }
            ClutterEcho one = Of(1), two = Of(2);
            Assert.That(two.SigmaVV, Is.EqualTo(2 * one.SigmaVV).Within(0.5).Percent);
            Assert.That((two.S.VV - 2 * one.S.VV).Magnitude, Is.GreaterThan(0.3 * one.S.VV.Magnitude));
        }

        [Test]
        public void Trace_TilesInAnotherOrder_ChangeNoBit()
        {
            var sea = new TestSea(10, 32, 32, 0, tiles: 3);
            var expected = Tracer.Trace(sea.Pose(25, 12), TenGigahertz).Single();
            var pose = sea.Pose(25, 12);
            var tiles = pose.Scene.Seas[0].Tiles;
            pose.Scene = new RadarScene(pose.Scene.Instances.Reverse().ToArray())
            {
                Seas = new[] { new RadarSea(sea.Clutter,
                    tiles.Select(tile => new SeaTileInstance(tiles.Count - 1 - tile.Instance, tile.Number)).ToArray()) }
            };
            Assert.That(Tracer.Trace(pose, TenGigahertz).Single(), Is.EqualTo(expected));
        }

        // Float32 about the scene's centre: the field turns, and nothing else changes.
        [Test]
        public void Trace_ElsewhereInTheWorld_TurnsThePhaseOnly()
        {
            var sea = new TestSea(10, 32, 32, 0);
            var expected = Tracer.Trace(sea.Pose(25, 12), TenGigahertz).Single();
            var pose = sea.Pose(25, 12);
            double3 move = new double3(3000.125, 2, -7000.25);
            var instance = pose.Scene.Instances[0];
            instance.ToWorld.Origin += move;
            pose.Scene = new RadarScene(instance) { Seas = pose.Scene.Seas };
            var found = Tracer.Trace(pose, TenGigahertz).Single();
            Assert.That(found.SigmaVV, Is.EqualTo(expected.SigmaVV).Within(1e-3).Percent);
            Assert.That(found.LitArea, Is.EqualTo(expected.LitArea).Within(1e-3).Percent);
            var turn = Complex.FromPolarCoordinates(1,
                4 * Math.PI / Signal.Wavelength(TenGigahertz) * math.dot(pose.Radar.ToRadar, move));
            Assert.That((found.S.VV - turn * expected.S.VV).Magnitude, Is.LessThan(1e-3 * expected.S.VV.Magnitude));
        }

        // A cell's facets add up with random phases: its intensity is exponential about its mean.
        [Test]
        public void Trace_IntensityOfACell_IsExponential()
        {
            var sea = new TestSea(8, 128, 128, 0);
            var grid = new ClutterGrid(new double3(-64, 0, -64), new double3(1, 0, 0), new double3(0, 0, 1), 4,
                new int2(32, 32));
            var cells = Tracer.Trace(sea.Pose(30, 40), TenGigahertz, grid);
            SpeckleTests.AssertExponential(cells.Select(cell => cell.S.VV.Magnitude * cell.S.VV.Magnitude / cell.SigmaVV));
            SpeckleTests.AssertExponential(cells.Select(cell => cell.S.HH.Magnitude * cell.S.HH.Magnitude / cell.SigmaHH));
        }

        // Published lines at 60 deg of grazing; the mesh stands still. The wind blows towards the radar or away from it.
        [TestCase(180, 8.30)]
        [TestCase(0, -8.30)]
        public void Trace_OfAStillMesh_HasTheBraggLineAndTheCoherenceTime(double azimuth, double line)
        {
            var sea = new TestSea(10, 32, 32, 0, 0);
            var grid = new ClutterGrid(new double3(-16, 0, -16), new double3(1, 0, 0), new double3(0, 0, 1), 1,
                new int2(32, 32));
            Complex[] FieldAt(double time) => Tracer.Trace(sea.Pose(azimuth, 60, sea.Clutter.At(time)), TenGigahertz, grid)
                .Select(cell => cell.S.VV / Math.Sqrt(cell.SigmaVV)).ToArray();
            double coherence = sea.Clutter.CoherenceTimeAt(TenGigahertz);
            var first = FieldAt(0);
            double power = first.Sum(field => field.Magnitude * field.Magnitude);
            Complex CorrelationAt(double time) => FieldAt(time).Zip(first, (now, then) => now * Complex.Conjugate(then))
                .Aggregate((a, b) => a + b) / power;
            var correlation = CorrelationAt(coherence / 4);
            Assert.That(correlation.Phase / (2 * Math.PI * coherence / 4), Is.EqualTo(line).Within(0.6));
            Assert.That(correlation.Magnitude, Is.EqualTo(Math.Exp(-1 / 16.0)).Within(0.05));
            Assert.That(CorrelationAt(coherence).Magnitude, Is.EqualTo(Math.Exp(-1)).Within(0.1));
            Assert.That(CorrelationAt(2 * coherence).Magnitude, Is.LessThan(0.1));
        }

        // Nothing is lit outside of the picture.
        [Test]
        public void Trace_OfAFootprint_TakesTheFacetsInThePicture()
        {
            var sea = new TestSea(10, 64, 64, 0);
            var pose = sea.Pose(0, 90);
            var view = new RadarView
            {
                Position = new double3(4, 50, 0), Right = new double3(1, 0, 0), Up = new double3(0, 0, 1),
                Forward = new double3(0, -1, 0), ApertureHeight = 20
            };
            var settings = RadarSettings.Default;
            (settings.RaysAcross, settings.RaysDown) = (400, 200);
            pose.Footprint = new RadarFootprint(view, settings);
            Assert.That(Tracer.Trace(pose, TenGigahertz).Single().Area, Is.EqualTo(40 * 20).Within(2).Percent);
            (view.ApertureHeight, view.VerticalFovDegrees) = (0, 2 * math.degrees(Math.Atan(0.2)));
            pose.Footprint = new RadarFootprint(view, settings);
            Assert.That(Tracer.Trace(pose, TenGigahertz).Single().Area, Is.EqualTo(40 * 20).Within(2).Percent);
        }

        // Figures of another program with other random numbers: sigma0 of HH and VV with shadow and breaking waves and
        // without these, and the shapes in cells of 15 x 30 m, of VV without breaking waves and without gusts. The radar looks against the wind.
        [TestCase(1, 0.163, -37.7, -32.4, -55.5, -33.7, 0.50, 0.64, Category = "Stress")]
        [TestCase(3, 0.423, -36.5, -28.2, -50.0, -28.8, 0.69, 1.93)]
        [TestCase(10, 0.910, -35.0, -23.0, -42.2, -23.2, 0.92, 10.8, Category = "Stress")]
        [TestCase(30, 1.000, -27.7, -17.0, -28.4, -17.1, 7.0, 61.0, Category = "Stress")]
        [Timeout(600000)]
        public void Trace_AtGrazing_RepeatsTheMonteCarloOfFacets(double grazing, double lit, double hh, double vv,
            double unbrokenHH, double unbrokenVV, double shapeHH, double shapeVV)
        {
            var sea = new TestSea(10, 512, 1024, 0, tiles: 2);
            var calm = SeaClutterSettings.On;
            (calm.WhitecapCoefficient, calm.Gustiness) = (0, 0);
            var unbroken = new SeaClutter(sea.Surface, 0, sea.Clutter.Wind, calm);
            var grid = new ClutterGrid(new double3(-256, 0, -256), new double3(1, 0, 0), new double3(0, 0, 1),
                new double2(30, 15), new int2(17, 34));
            var cells = Tracer.Trace(sea.Pose(180, grazing), TenGigahertz, grid);
            var found = ClutterEcho.Sum(cells);
            var unbrokenCells = Tracer.Trace(sea.Pose(180, grazing, unbroken), TenGigahertz, grid);
            AssertNear(ClutterEcho.Sum(unbrokenCells).Sigma0, new Sigma0(Math.Pow(10, unbrokenHH / 10),
                Math.Pow(10, unbrokenVV / 10), 0), 0.7, $"grazing {grazing}, unbroken");
            double ofHH = ClutterStatistics.ShapeOfTexture(cells.Select(cell => cell.SigmaHH).ToArray()),
                ofVV = ClutterStatistics.ShapeOfTexture(unbrokenCells.Select(cell => cell.SigmaVV).ToArray());
            TestContext.WriteLine(FormattableString.Invariant(
                $"| {grazing} | {found.LitFraction:0.000} | {Sigma0.Decibels(found.Sigma0.HH):0.0} | {Sigma0.Decibels(found.Sigma0.VV):0.0} | {ofHH:0.00} | {ofVV:0.00} |"));
            Assert.That(found.LitFraction, Is.EqualTo(lit).Within(0.03));
            Assert.That(Sigma0.Decibels(found.Sigma0.HH), Is.EqualTo(hh).Within(0.7));
            Assert.That(Sigma0.Decibels(found.Sigma0.VV), Is.EqualTo(vv).Within(0.7));
            AssertShape(ofHH, shapeHH);
            AssertShape(ofVV, shapeVV);
        }

        static void AssertShape(double actual, double expected) =>
            Assert.That(actual, Is.EqualTo(expected).Within(expected > 5 ? 50 : 30).Percent);

        static void AssertNear(in Sigma0 actual, in Sigma0 expected, double decibels, string where)
        {
            TestContext.WriteLine(FormattableString.Invariant($"{where}: HH {Sigma0.Decibels(actual.HH / expected.HH):0.00} dB, VV {Sigma0.Decibels(actual.VV / expected.VV):0.00} dB"));
            Assert.That(Sigma0.Decibels(actual.HH / expected.HH), Is.EqualTo(0).Within(decibels), where);
            Assert.That(Sigma0.Decibels(actual.VV / expected.VV), Is.EqualTo(0).Within(decibels), where);
        }

        static Sigma0 Sum(TestSea sea, CrossSectionPose pose)
        {
            var table = sea.Clutter.TableAt(TenGigahertz);
            var scattering = new SeaScattering(TenGigahertz, sea.Clutter.Water.At(TenGigahertz).permittivity,
                sea.Clutter.ShortWaves.Spectrum.Density);
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
                var sigma = table.Read(section / area, toRadar, sea.Clutter.Wind, sea.Clutter.LogWinds[i / 2]);
                double breaking = SeaScattering.Breaking(toRadar.y);
                sum += area * strength * (sea.Clutter.BreakingFacets[i]
                    ? new Sigma0(breaking, breaking, scattering.BreakingCross(toRadar.y)) : sigma);
            }
            return sum;
        }
    }

    /// <summary>
    /// A sea of Elfouhaily's waves with clutter, linear unless it has a choppiness, in tiles along Z. The wind blows along Z, turned towards X.
    /// </summary>
    sealed class TestSea
    {
        public TestSea(double wind, double tileSize, int cells, double windDegrees,
            double whitecaps = WhitecapLaw.DefaultCoefficient, int seed = 1, int tiles = 1, int? grid = null,
            double height = 1, double choppiness = 0)
        {
            var settings = SeaSettings.Default;
            (settings.Kind, settings.WindSpeed, settings.Choppiness) = (SeaSpectrumKind.Elfouhaily, wind, choppiness);
            (settings.TileSize, settings.Cells, settings.GridSize) = (tileSize, cells, grid ?? cells);
            (settings.WindDirectionDegrees, settings.Seed, settings.HeightFactor) = (windDegrees, seed, height);
            Surface = new SeaSurface(settings);
            Mesh = Surface.Mesh(0);
            var clutter = SeaClutterSettings.On;
            clutter.WhitecapCoefficient = whitecaps;
            double angle = math.radians(windDegrees);
            Clutter = new SeaClutter(Surface, 0, new double3(Math.Sin(angle), 0, Math.Cos(angle)), clutter);
            Instances = Enumerable.Range(0, tiles).Select(tile => Instance(new double3(0, 0, tileSize * tile)))
                .ToArray();
        }

        public SeaSurface Surface { get; }

        public TriangleMesh Mesh { get; }

        public SeaClutter Clutter { get; }

        public MeshInstance[] Instances { get; }

        /// <summary>A far radar; null: the sea's own clutter.</summary>
        public CrossSectionPose Pose(double azimuth, double grazing, SeaClutter clutter = null)
        {
            var radar = RadarAspect.At(azimuth, grazing);
            var tiles = Instances.Select((_, i) => new SeaTileInstance(i, new int2(0, i))).ToArray();
            return new CrossSectionPose
            {
                Scene = new RadarScene(Instances) { Seas = new[] { new RadarSea(clutter ?? Clutter, tiles) } },
                Radar = radar, Receivers = new[] { radar }, Frequencies = new[] { 1e10 }
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
