using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Cross sections of scenes that have a sea with a diffuse echo.</summary>
    [Category("Slow")]
    public sealed class SeaCrossSectionTests : CrossSectionFixture
    {
        const double TenGigahertz = 1e10;

        // The plate and the water in front of it are a dihedral: sigma = 4 pi (2 a b cos)^2 |R|^2 / lambda^2.
        [TestCase(12)]
        [TestCase(25)]
        public void Trace_PlateOnACalmSea_IsTheDihedralOfBoth(double grazing)
        {
            var pose = CalmSea(grazing, new[] { Plate() });
            var result = Tracer.Trace(pose);
            var sea = result.Sea[0, 0];
            double incidence = Math.Sin(math.radians(grazing)), wavelength = Signal.Wavelength(TenGigahertz);
            var water = pose.Scene.Surfaces[1].Reflection(incidence, TenGigahertz);
            double area = 2 * 0.5 * 0.6 * Math.Cos(math.radians(grazing));
            double Expected(double coefficient) => Math.Sqrt(4 * Math.PI) * area * coefficient / wavelength;
            double DecibelsOf(double found, double coefficient) => 20 * Math.Log10(found / Expected(coefficient));
            Assert.That(result.ShipSea[0].SigmaVV, Is.GreaterThan(0));
            // Without what ripples scatter by way of the plate.
            var signal = result.S[0, 0] + -1 * sea + -1 * result.ShipSea[0].S;
            Assert.That(DecibelsOf(signal.HH.Magnitude, water.S.Magnitude), Is.EqualTo(0).Within(0.3));
            Assert.That(DecibelsOf(signal.VV.Magnitude, water.P.Magnitude), Is.EqualTo(0).Within(0.3));
        }

        // Off the mirror direction nothing but the diffuse echo returns from a sea.
        [Test]
        public void Trace_SeaAlone_IsItsDiffuseEcho()
        {
            var pose = CalmSea(40, Array.Empty<MeshInstance>());
            var result = Tracer.Trace(pose);
            Assert.That(result.Sea[0, 0].VV, Is.EqualTo(result.Clutter[0].S.VV));
            Assert.That(result.S[0, 0].VV, Is.EqualTo(result.Clutter[0].S.VV));
            Assert.That(result.Clutter[0].SigmaVV, Is.GreaterThan(0));
        }

        // The sea fills the echo: nothing is below its clutter, which lies far above the floor that is asked for.
        [Test]
        public void Row_OfASceneWithClutter_HasTheFloorOfItsTrace()
        {
            var pose = CalmSea(40, Array.Empty<MeshInstance>());
            var setup = new CrossSectionSetup(pose.Scene,
                new CrossSectionPlan(new[] { 0.0 }, new[] { 40.0 }, new[] { TenGigahertz }))
            {
                HasEdges = false, GivenFloorDbsm = -100
            };
            var clutter = Tracer.Trace(setup.PoseOf(setup.Plan[0])).Clutter[0];
            using (var run = new CrossSectionRun(setup, TestKernels.Tubes))
            {
                var row = run.Step();
                double level = 10 * Math.Log10(Math.Max(clutter.SigmaVV, clutter.SigmaHH));
                Assert.That(row.FloorDbsm, Is.EqualTo(level).Within(1e-6).And.GreaterThan(-90));
                Assert.That(row.MeetsTolerance);
            }
        }

        // The mean of a published model, in both polarisations; the speckle is the same.
        [TestCase(ClutterLevel.Nrl, Category = "Stress")]
        [TestCase(ClutterLevel.Git)]
        public void Trace_AtAPublishedLevel_HasItsMean(ClutterLevel level)
        {
            var sea = new TestSea(8, 64, 64, 0);
            var pose = sea.Pose(30, 10);
            var plain = Tracer.Trace(pose).Clutter[0];
            var settings = SeaClutterSettings.On;
            settings.Level = level;
            pose = sea.Pose(30, 10, new SeaClutter(sea.Surface, 0, sea.Clutter.Wind, settings));
            var scaled = Tracer.Trace(pose).Clutter[0];
            var conditions = sea.Clutter.ConditionsAt(TenGigahertz, 30, 10);
            var model = ClutterModel.Of(level);
            // The tile alone, whose edge no other tile shades.
            Assert.That(Sigma0.Decibels(scaled.Sigma0.VV),
                Is.EqualTo(model.Decibels(Polarisation.VV, conditions)).Within(0.5));
            Assert.That(Sigma0.Decibels(scaled.Sigma0.HH),
                Is.EqualTo(model.Decibels(Polarisation.HH, conditions)).Within(0.5));
            Assert.That(scaled.S.VV.Phase, Is.EqualTo(plain.S.VV.Phase).Within(1e-3));
        }

        // In double precision: each facet has its power, the speckle of the band's centre at the time, which turns as
        // its Bragg waves do, and moves with the water.
        [Test]
        public void Trace_OfPulses_IsTheSumOverFacetsThatMoveWithTheWater()
        {
            const double start = 50, later = 3e-3;
            var sea = new TestSea(8, 32, 16, 20, 0);
            var clutter = sea.Clutter.At(start);
            var pose = sea.Pose(35, 60, clutter);
            // Of the diffuse echo only: the mirror's need not be known well.
            (pose.Times, pose.ToleranceDb) = (new[] { 0, later }, 10);
            pose.BandCentre = 0.99 * TenGigahertz;
            var echoes = Tracer.Trace(pose).Clutter;
            for (int sample = 0; sample < 2; sample++)
            {
                var expected = FieldOf(sea, clutter, pose, pose.FrequencyOf(sample), pose.TimeOf(sample));
                Assert.That((echoes[sample].S.VV - expected).Magnitude, Is.LessThan(0.01 * expected.Magnitude));
            }
            Assert.That((echoes[1].S.VV - echoes[0].S.VV).Magnitude, Is.GreaterThan(0.2 * echoes[0].S.VV.Magnitude));
        }

        // A day after the start float32 has 8 ms, a turn of Bragg waves 65 ms and the coherence time some: what a pulse
        // adds to the change since the one before is small.
        [Test]
        public void Trace_OfPulsesLateInTheDay_IsSmooth()
        {
            var sea = new TestSea(8, 32, 16, 20, 0);
            var pose = sea.Pose(35, 60, sea.Clutter.At(86400));
            (pose.Times, pose.ToleranceDb) = (new[] { 0, 1e-3, 2e-3, 3e-3, 4e-3 }, 10);
            var field = Tracer.Trace(pose).Clutter.Select(echo => echo.S.VV).ToArray();
            double size = field.Max(value => value.Magnitude);
            for (int i = 2; i < field.Length; i++)
                Assert.That((field[i] - 2 * field[i - 1] + field[i - 2]).Magnitude, Is.LessThan(0.1 * size));
            Assert.That((field[4] - field[0]).Magnitude, Is.GreaterThan(0.1 * size));
        }

        static Complex FieldOf(TestSea sea, SeaClutter clutter, CrossSectionPose pose, double frequency, double time)
        {
            var velocities = clutter.FacetVelocities;
            double3 toRadar = pose.Radar.ToRadar;
            double k = 2 * Math.PI / Signal.Wavelength(frequency), centre = pose.BandCentre.Value,
                now = clutter.Time + time;
            double windCosine = math.dot(math.normalize(new double3(toRadar.x, 0, toRadar.z)), clutter.Wind),
                share = ClutterMotion.ApproachingShare(windCosine, SeaClutter.ApproachingExponent),
                bragg = ClutterMotion.AngularFrequency(4 * Math.PI / Signal.Wavelength(centre)
                    * Math.Sqrt(1 - toRadar.y * toRadar.y));
            var turn = Complex.FromPolarCoordinates(1, bragg * now);
            var sum = Complex.Zero;
            for (int i = 0; i < sea.Mesh.TriangleCount; i++)
            {
                sea.Mesh.GetTriangle(i, out var a, out var b, out var c);
                var section = math.cross((double3)b - a, (double3)c - a) / 2;
                section = section.y < 0 ? -section : section;
                double area = math.length(section),
                    sigma = clutter.TableAt(frequency).Read(section / area, toRadar, clutter.Wind,
                        clutter.LogWinds[i / 2]).VV;
                var speckle = Speckle.Between(new int2(i, 0), clutter.Seed, now / clutter.CoherenceTimeAt(centre));
                var field = Math.Sqrt(share) * speckle.Approaching * turn
                    + Math.Sqrt(1 - share) * speckle.Receding * Complex.Conjugate(turn);
                double3 place = ((double3)a + b + c) / 3 + time * velocities[i];
                sum += Math.Sqrt(area * sigma) * field
                    * Complex.FromPolarCoordinates(1, 2 * k * math.dot(toRadar, place));
            }
            return sum;
        }

        static SeaClutter AtLevel(TestSea sea, ClutterLevel level)
        {
            var settings = SeaClutterSettings.On;
            settings.Level = level;
            return new SeaClutter(sea.Surface, 0, sea.Clutter.Wind, settings);
        }

        // A tile without neighbours, which would shade 5 % of it.
        [Test]
        public void Trace_AtTheLevelOfATable_HasItsMean()
        {
            var sea = new TestSea(8, 64, 64, 0);
            var clutter = AtLevel(sea, ClutterLevel.Nathanson);
            var found = Tracer.Trace(sea.Pose(30, 10, clutter)).Clutter[0].Sigma0;
            var at = clutter.ConditionsAt(10e9, 30, 10);
            var table = ClutterModel.Of(ClutterLevel.Nathanson);
            Assert.That(Sigma0.Decibels(found.VV), Is.EqualTo(table.Decibels(Polarisation.VV, at)).Within(0.5));
            Assert.That(Sigma0.Decibels(found.HH), Is.EqualTo(table.Decibels(Polarisation.HH, at)).Within(0.5));
        }

        // A number that no model has would be the own echo times the factor of the table's end.
        [Test]
        public void Trace_OutsideTheAnglesOfTheLevel_IsRefused()
        {
            var sea = new TestSea(8, 64, 64, 0);
            var clutter = AtLevel(sea, ClutterLevel.Git);
            const string message = "clutter model git: the grazing angle 12 deg must be from 0.1 to 10 deg";
            Assert.That(() => Tracer.Trace(sea.Pose(30, 12, clutter)),
                Throws.TypeOf<GlintException>().With.Message.StartsWith(message));
            var pose = sea.Pose(30, 10, clutter);
            var setup = new CrossSectionSetup(pose.Scene, new CrossSectionPlan(new double[] { 30 }, new double[] { 10, 12 },
                pose.Frequencies));
            Assert.That(() => setup.Validate("sea"), Throws.TypeOf<GlintException>().With.Message.StartsWith(message),
                "before the row of 10 degrees");
            var last = RadarAspect.At(30, 10);
            clutter.RequireLevel(new RadarAspect((float3)last.ToRadar, last.Up, last.Right), 10e9);
        }

        [Test]
        public void Trace_ReceiverElsewhere_IsRefused()
        {
            var pose = CalmSea(40, Array.Empty<MeshInstance>());
            pose.Receivers = new[] { RadarAspect.At(30, 40) };
            Assert.That(() => Tracer.Trace(pose), Throws.TypeOf<GlintException>().With.Message.Contains("receiver"));
        }

        // A camera's picture that holds the target changes nothing; parallel rays on half of a plate leave half of its
        // amplitude.
        [TestCase(double.PositiveInfinity)]
        [TestCase(60)]
        public void Trace_WithAFootprint_IsThatOfThePicture(double range)
        {
            var pose = CalmSea(0, new[] { Plate() });
            pose.Scene = new RadarScene(pose.Scene.Instances[1]);
            pose.PhaseCentre = new double3(0, 0.3, 3);
            (pose.Range, pose.ToleranceDb) = (range, 0.02);
            var whole = Tracer.Trace(pose).S[0, 0].VV;
            pose.Footprint = FootprintOf(pose, 0);
            var seen = Tracer.Trace(pose).S[0, 0].VV;
            Assert.That((seen - whole).Magnitude, Is.LessThan(0.005 * whole.Magnitude));
            if (!pose.IsFar)
                return;
            // The picture begins at the middle of the plate.
            pose.Footprint = FootprintOf(pose, 1);
            var half = Tracer.Trace(pose).S[0, 0].VV;
            Assert.That((half - 0.5 * whole).Magnitude, Is.LessThan(0.02 * whole.Magnitude));
        }

        // Nor do edges that are beside the picture, or behind the camera.
        [TestCase(double.PositiveInfinity, 40, 3)]
        [TestCase(60, 40, 3)]
        [TestCase(60, 0, -80)]
        public void Trace_WithAFootprint_HasNoEdgesOutsideOfIt(double range, double x, double z)
        {
            var pose = CalmSea(0, new[] { Plate() });
            var other = Plate();
            (other.ToWorld.Origin, pose.HasEdges) = (new double3(x, 0, z - 3), true);
            var plate = pose.Scene.Instances[1];
            pose.PhaseCentre = new double3(0, 0.3, 3);
            (pose.Range, pose.ToleranceDb) = (range, 0.1);
            pose.Footprint = FootprintOf(pose, 0);
            // Of the plate from aside, beside its mirror echo.
            plate.ToWorld = Affine.FromTransform(new double3(0.5, 0, 2), new double4(0, 0.2, 0, 1), 1);
            pose.Scene = new RadarScene(plate);
            var alone = Tracer.Trace(pose).S[0, 0].VV;
            pose.Scene = new RadarScene(plate, other);
            Assert.That((Tracer.Trace(pose).S[0, 0].VV - alone).Magnitude, Is.LessThan(0.02 * alone.Magnitude));
        }

        // A wall behind a camera with parallel rays hides nothing from it.
        [Test]
        public void Trace_WithAWallBehindTheCamera_IsThatWithoutIt()
        {
            var pose = CalmSea(25, new[] { Plate() });
            pose.PhaseCentre = new double3(0, 0.3, 3);
            pose.Footprint = FootprintOf(pose, 0);
            var wall = Plate();
            wall.ToWorld = Affine.FromTransform(pose.PhaseCentre + 50 * pose.Radar.ToRadar, new double4(0, 0, 0, 1), 100);
            wall.ToWorld.Origin -= new double3(0, 30, 300);
            // A mirror of water: with clutter the wall would also light it.
            var surfaces = pose.Scene.Surfaces;
            RadarScene With(params MeshInstance[] others) =>
                new RadarScene(pose.Scene.Instances.Take(2).Concat(others).ToArray()) { Surfaces = surfaces };
            pose.Scene = With();
            var alone = Tracer.Trace(pose).S[0, 0].HH;
            Assert.That(alone.Magnitude, Is.GreaterThan(1), "the corner of plate and water");
            pose.Scene = With(wall);
            Assert.That((Tracer.Trace(pose).S[0, 0].HH - alone).Magnitude, Is.LessThan(0.05 * alone.Magnitude));
        }

        // Water all around, and behind the camera, changes neither range nor phase centre of a ship's picture.
        [Test]
        public void Pose_OfAPictureWithWaterAllAround_HasTheRangeOfTheTarget()
        {
            var sea = new TestSea(5, 64, 8, 0, 0, tiles: 9);
            var target = Plate();
            target.ToWorld.Origin = new double3(0, 0, 497);
            var instances = sea.Instances.Select((tile, i) =>
            {
                tile.ToWorld.Origin = new double3(0, 0, 64 * (i - 4));
                return tile;
            }).ToArray();
            CrossSectionPose Of(params MeshInstance[] others) => CrossSectionPose.Of(new RadarPose
            {
                Settings = RadarSettings.Default,
                View = new RadarView
                {
                    Position = new double3(0, 20, 0), Right = new double3(1, 0, 0), Up = new double3(0, 1, 0),
                    Forward = new double3(0, 0, 1), VerticalFovDegrees = 60
                },
                Scene = new RadarScene(instances.Concat(others).ToArray())
                {
                    Seas = new[] { new RadarSea(sea.Clutter, Enumerable.Range(0, 9)
                        .Select(i => new SeaTileInstance(i, new int2(0, i))).ToArray()) }
                }
            });
            Assert.That(Of(target).Range, Is.EqualTo(500).Within(0.5));
            Assert.That(Of().Range, Is.EqualTo(4.5 * 64 / 2).Within(1), "half of the water before it");
        }

        // A picture of 60 degrees from 3 km has 10^9 cells of four wavelengths. Those before a scene of some metres suffice.
        [TestCase(0)]
        [TestCase(4000)]
        public void Grid_OfAPictureOfAFarScene_HasTheCellsBeforeIt(double aperture)
        {
            const double distance = 3000, size = 20;
            var view = new RadarView
            {
                Position = new double3(0, 0, -distance), Right = new double3(1, 0, 0), Up = new double3(0, 1, 0),
                Forward = new double3(0, 0, 1), VerticalFovDegrees = 60, ApertureHeight = aperture
            };
            double3 corner = size / 2;
            var pose = new CrossSectionPose
            {
                Radar = new RadarAspect(-view.Forward, view.Up, view.Right), Frequencies = new[] { TenGigahertz },
                Range = aperture > 0 ? double.PositiveInfinity : distance,
                Footprint = new RadarFootprint(view, RadarSettings.Default)
            };
            double side = TubeGrid.SideFor(pose, -corner, corner);
            var cells = new TubeGrid(pose, side, -corner, corner).Cells;
            // The face of the box that is nearer to the radar looks larger.
            double across = aperture > 0 ? size : size * distance / (distance - size / 2);
            Assert.That(math.cmin(cells), Is.GreaterThanOrEqualTo(across / side));
            Assert.That(math.cmax(cells), Is.LessThanOrEqualTo(across / side + 5));
        }

        // 80 cells high, twice as wide; up: parallel rays begin that much higher, in half pictures.
        static RadarFootprint FootprintOf(CrossSectionPose pose, double up)
        {
            double side = TubeGrid.SideFor(pose, new double3(-0.25, 0, 3), new double3(0.25, 0.6, 3)),
                distance = pose.IsFar ? 30 : pose.Range, height = 80 * side;
            var view = new RadarView
            {
                Position = pose.PhaseCentre + distance * pose.Radar.ToRadar, Right = pose.Radar.Right,
                Up = pose.Radar.Up, Forward = -pose.Radar.ToRadar, ApertureHeight = pose.IsFar ? height : 0,
                VerticalFovDegrees = math.degrees(2 * Math.Atan(height / 2 / distance))
            };
            if (pose.IsFar)
                view.Position += up * height / 2 * view.Up;
            var settings = RadarSettings.Default;
            (settings.RaysAcross, settings.RaysDown) = (1000, 500);
            return new RadarFootprint(view, settings);
        }

        static CrossSectionPose CalmSea(double grazing, MeshInstance[] targets)
        {
            var sea = new TestSea(5, 8, 8, 0, 0, height: 0.001);
            var pose = sea.Pose(0, grazing);
            var water = sea.Instances[0];
            water.Ranges = new[] { new MeshRange(0, 0, 1) };
            pose.Scene = new RadarScene(targets.Prepend(water).ToArray())
            {
                Seas = pose.Scene.Seas, Surfaces = new[] { SurfaceMaterial.PerfectConductor, sea.Clutter.Surface }
            };
            pose.HasEdges = false;
            return pose;
        }

        // 0.5 m wide and 0.6 m high, on the water, towards -Z.
        static MeshInstance Plate() => new MeshInstance
        {
            Mesh = new TriangleMesh(new[]
            {
                new float3(-0.25f, 0, 3), new float3(0.25f, 0, 3), new float3(0.25f, 0.6f, 3),
                new float3(-0.25f, 0.6f, 3)
            }, new[] { 0, 2, 1, 0, 3, 2 }),
            ToWorld = Affine.Identity
        };
    }
}
