using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Which facets of a sea stand for others, far from the radar.</summary>
    public sealed class SeaGroupsTests
    {
        // 32 x 32 tiles of 64 m in facets of 0.5 m, as the stored large sea; the radar 50 m from the middle.
        [Test]
        public void SidesOf_ALargeSea_AreAtMostFiveMilliradians()
        {
            var (pose, sea) = LargeSea(new double3(0, 8.7, -49.2));
            int[] sides = SeaGroups.SidesOf(pose, sea, ClutterGrid.Whole);
            for (int i = 0; i < sides.Length; i++)
            {
                double distance = DistanceOf(pose, sea, i);
                Assert.That(sides[i] == 1 || 0.5 * sides[i] <= distance / 200);
                Assert.That(sides[i], Is.LessThanOrEqualTo(1).Or.GreaterThan(distance / 200 / 0.5 / 4 - 1));
            }
            long facets = sides.Length * SeaGroups.CountOf(128, 1), items = sides.Sum(side => SeaGroups.CountOf(128, side));
            var tiles = sides.GroupBy(side => side).OrderBy(it => it.Key).Select(it => $"{it.Key}: {it.Count()}");
            TestContext.WriteLine($"{facets} facets, {items} groups, tiles by side {string.Join(", ", tiles)}");
            Assert.That(items, Is.InRange(SeaGroups.MinGroups, facets / 8));
        }

        [Test]
        public void SidesOf_ASmallSeaOrAFarRadar_AreCells()
        {
            var (pose, sea) = LargeSea(new double3(0, 8.7, -49.2));
            var few = new RadarSea(sea.Clutter, sea.Tiles.Take(4).ToArray());
            Assert.That(SeaGroups.SidesOf(pose, few, ClutterGrid.Whole), Has.All.EqualTo(1));
            pose.Range = double.PositiveInfinity;
            Assert.That(SeaGroups.SidesOf(pose, sea, ClutterGrid.Whole), Has.All.EqualTo(1));
        }

        // At least two groups a range cell, and four a cell of the ground.
        [Test]
        public void SidesOf_RangeCellsOrCells_AreFiner()
        {
            var (pose, sea) = LargeSea(new double3(0, 8.7, -49.2));
            Assert.That(SeaGroups.SidesOf(pose, sea, ClutterGrid.Whole).Max(), Is.EqualTo(8));
            pose.RangeCell = 4;
            Assert.That(SeaGroups.SidesOf(pose, sea, ClutterGrid.Whole).Max(), Is.EqualTo(4));
            var cells = new ClutterGrid(0, new double3(1, 0, 0), new double3(0, 0, 1), new double2(4, 8), new int2(2, 2));
            Assert.That(SeaGroups.SidesOf(pose, sea, cells).Max(), Is.EqualTo(2));
        }

        static double DistanceOf(CrossSectionPose pose, RadarSea sea, int tile) => math.distance(
            pose.Scene.Instances[sea.Tiles[tile].Instance].ToWorld.Origin, pose.Range * pose.Radar.ToRadar);

        static (CrossSectionPose, RadarSea) LargeSea(double3 radar)
        {
            var one = new TestSea(10, 64, 128, 0);
            var instances = Enumerable.Range(0, 32 * 32).Select(i =>
            {
                var instance = one.Instances[0];
                instance.ToWorld.Origin = 64 * new double3(i % 32 - 15.5, 0, i / 32 - 15.5);
                return instance;
            }).ToArray();
            var sea = new RadarSea(one.Clutter,
                instances.Select((_, i) => new SeaTileInstance(i, new int2(i % 32, i / 32))).ToArray());
            return (new CrossSectionPose
            {
                Scene = new RadarScene(instances) { Seas = new[] { sea } }, Range = math.length(radar),
                Radar = new RadarAspect(math.normalize(radar), new double3(0, 1, 0), new double3(1, 0, 0))
            }, sea);
        }
    }
}
