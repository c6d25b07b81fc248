using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>One tile of a sea without end, and factors that bring its mean echo to that of a model.</summary>
    public sealed class EndlessSeaTests : ClutterFixture
    {
        const double TenGigahertz = 1e10;

        // 41 x 41 tiles reach farther than the shadows, which are 10 m / tan(1 deg) = 573 m at most.
        [TestCase(0, 1, 0)]
        [TestCase(180, 3, 0)]
        [TestCase(37, 1, 0)]
        [TestCase(-110, 2, 0)]
        [TestCase(37, 1, 1)]
        [TestCase(80, 90, 1)]
        public void Pose_HasAllTilesThatShade(double azimuth, double grazing, double choppiness)
        {
            var sea = new TestSea(12, 32, 32, 20, choppiness: choppiness);
            var pose = sea.Pose(azimuth, grazing);
            Assert.That(sea.Mesh.Vertices.Max(vertex => vertex.y) - sea.Mesh.Vertices.Min(vertex => vertex.y),
                Is.LessThan(10));
            var tiles = (from x in Enumerable.Range(-20, 41) from z in Enumerable.Range(-20, 41) select new int2(x, z))
                .OrderBy(tile => math.lengthsq((double2)tile)).ToArray();
            var all = new CrossSectionPose
            {
                Scene = new RadarScene(tiles.Select(tile => At(sea, 32 * new double3(tile.x, 0, tile.y))).ToArray())
                {
                    Seas = new[] { new RadarSea(sea.Clutter, new[] { new SeaTileInstance(0, 0) }) }
                },
                Radar = pose.Radar, Receivers = pose.Receivers, Frequencies = pose.Frequencies
            };
            ClutterEcho expected = Tracer.Trace(all, TenGigahertz).Single(), alone = Tracer.Trace(pose, TenGigahertz)
                .Single();
            var endless = new EndlessSea(pose.Scene, pose.Scene.Seas[0]).PoseOf(azimuth, grazing, TenGigahertz);
            Assert.That(endless.Scene.Instances.Length, Is.LessThan(tiles.Length / 10));
            // Shadow rays begin higher in a wider scene: the tiles at the corners make both as wide.
            endless.Scene = new RadarScene(endless.Scene.Instances.Concat(all.Scene.Instances.TakeLast(4)).ToArray())
            {
                Seas = endless.Scene.Seas
            };
            var found = Tracer.Trace(endless, TenGigahertz).Single();
            Assert.That(found.LitArea, Is.EqualTo(expected.LitArea).Within(1e-3));
            Assert.That(found.SigmaVV, Is.EqualTo(expected.SigmaVV).Within(1e-3).Percent);
            if (grazing < 5)
                Assert.That(alone.LitArea, Is.GreaterThan(1.05 * expected.LitArea), "one tile has too little shade");
        }

        // A sea that is turned about Y and stands elsewhere, seen from a direction turned alike.
        [Test]
        public void Pose_OfATurnedSea_IsThatFromTheTurnedDirection()
        {
            var sea = new TestSea(10, 32, 32, 0);
            var turned = sea.Pose(0, 10);
            turned.Scene.Instances[0].ToWorld =
                Affine.FromTransform(new double3(70, 0, 9), new double4(0, 0.5, 0, Math.Sqrt(0.75)), 1);
            var radar = RadarAspect.At(60, 0);
            var clutter = new SeaClutter(sea.Surface, 0, new double3(-radar.ToRadar.x, 0, -radar.ToRadar.z),
                SeaClutterSettings.On);
            var one = new EndlessSea(turned.Scene, new RadarSea(clutter, turned.Scene.Seas[0].Tiles));
            var other = new TestSea(10, 32, 32, 0).Pose(20, 4);
            var expected = Tracer.Trace(new EndlessSea(other.Scene, other.Scene.Seas[0]).PoseOf(20, 4, TenGigahertz),
                TenGigahertz).Single();
            var found = Tracer.Trace(one.PoseOf(80, 4, TenGigahertz), TenGigahertz).Single();
            Assert.That(found.SigmaVV, Is.EqualTo(expected.SigmaVV).Within(1).Percent);
            Assert.That(found.LitArea, Is.EqualTo(expected.LitArea).Within(2));
        }

        // Along the tile's sides whole cells fill it. Turned by 45 degrees the tile is a diamond of 45.25 m to each corner:
        // its four columns, from -29.25 m on, hold 3, 7, 5 and 1 whole cells.
        [TestCase(0, 4 * 8)]
        [TestCase(90, 4 * 8)]
        [TestCase(-45, 16)]
        public void Cells_CoverTheTile_AndAreWholeWithinIt(double azimuth, int whole)
        {
            var sea = new TestSea(10, 64, 64, 0, choppiness: 1);
            var pose = sea.Pose(azimuth, 40);
            var endless = new EndlessSea(pose.Scene, pose.Scene.Seas[0]);
            var (grid, areWhole) = endless.CellsOf(azimuth, new double2(8, 16));
            var cells = Tracer.Trace(endless.PoseOf(azimuth, 40, TenGigahertz), TenGigahertz, grid);
            var all = Tracer.Trace(endless.PoseOf(azimuth, 40, TenGigahertz), TenGigahertz).Single();
            Assert.That(ClutterEcho.Sum(cells).Area, Is.EqualTo(64 * 64).Within(0.01).Percent);
            Assert.That(ClutterEcho.Sum(cells).SigmaHH, Is.EqualTo(all.SigmaHH).Within(0.01).Percent);
            Assert.That(areWhole.Count(it => it), Is.EqualTo(whole));
            // Facets of 1 m whose centres move by the choppiness.
            foreach (var cell in cells.Where((_, i) => areWhole[i]))
                Assert.That(cell.Area, Is.EqualTo(128).Within(20).Percent);
        }

        [Test]
        public void Cells_TooMany_AreRefused()
        {
            var pose = new TestSea(10, 64, 32, 0).Pose(0, 40);
            Assert.That(() => new EndlessSea(pose.Scene, pose.Scene.Seas[0]).CellsOf(0, 0.1),
                Throws.TypeOf<GlintException>().With.Message.EqualTo("sea clutter: a tile of 64 m has 409600 cells of "
                    + "0.1 x 0.1 m, at most 65536 are possible: give larger cells"));
        }

        // Of the angles of the table the mean is the model's; between them it is near it.
        [TestCase("nrl", 3, 0.01)]
        [TestCase("nrl", 45, 0.01)]
        [TestCase("nrl", 4, 0.3)]
        [TestCase("nrl", 47, 0.3)]
        [TestCase("git", 2, 0.01)]
        [TestCase("nathanson", 3, 0.01)]
        public void Level_BringsTheMeanToTheModel(string name, double grazing, double decibels)
        {
            var pose = new TestSea(10, 64, 64, 0).Pose(130, 20);
            var sea = new EndlessSea(pose.Scene, pose.Scene.Seas[0]);
            var model = ClutterModel.All.Single(it => it.Name == name);
            var levels = new ClutterLevels(Tracer, model);
            var table = levels.TableOf(sea, 9.4e9, 130);
            Assert.That(levels.TableOf(sea, 9.4e9, 130), Is.SameAs(table));
            Assert.That(levels.TableOf(sea, 9.4e9, 130 + 1e-5), Is.SameAs(table), "a float32's last digits");
            Assert.That(table.Values.Select(value => value.w), Is.Ordered.Ascending);
            var own = Tracer.Trace(sea.PoseOf(130, grazing, 9.4e9), 9.4e9).Single().Sigma0;
            var factor = table.FactorAt(math.radians(grazing));
            // 10 m/s raise 2.29 m, sea state 4.4; against the wind 130 degrees from azimuth 0 are 50.
            var at = new ClutterConditions(9.4e9, grazing, Math.Pow((Math.Pow(10 / 7.18, 2.5) - 0.04) / 0.1, 1 / 2.1), 50);
            double vv = model.Decibels(Polarisation.VV, at), hh = model.Decibels(Polarisation.HH, at);
            Assert.That(Sigma0.Decibels(factor.VV * own.VV), Is.EqualTo(vv).Within(decibels));
            Assert.That(Sigma0.Decibels(factor.HH * own.HH), Is.EqualTo(hh).Within(decibels));
            Assert.That(factor.HV, Is.EqualTo(Math.Sqrt(factor.VV * factor.HH)).Within(1e-4).Percent);
        }

        [Test]
        public void Level_WhereTheModelDoesNotHold_IsRefused()
        {
            var pose = new TestSea(18, 64, 32, 0).Pose(0, 20);
            var sea = new EndlessSea(pose.Scene, pose.Scene.Seas[0]);
            Assert.That(() => new ClutterLevels(Tracer, ClutterModel.All[0]).TableOf(sea, 9.4e9, 0),
                Throws.TypeOf<GlintException>().With.Message.Matches(@"^clutter model nrl: the sea state 8\.\d+ must be "
                    + "from 0 to 6, where NRL \\(Gregers-Hansen and Mital 2012\\) holds: choose another model, or physics$"));
        }

        static MeshInstance At(TestSea sea, double3 position)
        {
            var toWorld = Affine.Identity;
            toWorld.Origin = position;
            return new MeshInstance { Mesh = sea.Mesh, ToWorld = toWorld };
        }
    }
}
