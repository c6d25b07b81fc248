using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    public sealed class PictureTilesTests
    {
        static readonly RadarSettings s_settings = TestRadar.Settings(213, 131);

        static readonly RadarView s_view = TestRadar.LookAt(double3(1, 6, -9), double3(0, 1, 2));

        static HashSet<uint> Tiles(PictureTiles picture)
        {
            var cells = picture.ToCells(spread: false);
            var tiles = new HashSet<uint>(TilesOf(cells));
            Assert.That(tiles.Count, Is.EqualTo(cells.TileCount), "no tile twice");
            return tiles;
        }

        static IEnumerable<uint> TilesOf(TileCells cells) =>
            from corner in cells.Corners
            from y in Enumerable.Range(0, cells.Size.y)
            from x in Enumerable.Range(0, cells.Size.x)
            select corner + (uint)x + ((uint)y << 16);

        static uint TileOf(int pixel) =>
            (uint)(pixel % s_settings.RaysAcross / 8) | (uint)(pixel / s_settings.RaysAcross / 8) << 16;

        // Slab test in the box's own axes.
        static bool Meets(double3 origin, double3 direction, float3 boxMin, float3 boxMax)
        {
            double3 a = (boxMin - origin) / direction, b = (boxMax - origin) / direction;
            return max(cmax(min(a, b)), 0) <= cmin(max(a, b));
        }

        [Test]
        public void Add_BoxesNearFarAroundAndBehindTheCamera_TakesTheTileOfEveryRayThatMeetsThem()
        {
            var random = new System.Random(4);
            double Next() => 2 * random.NextDouble() - 1;
            int met = 0, tight = 0;
            for (int i = 0; i < 300; i++)
            {
                float3 boxMin = (float3)(10 * double3(Next(), Next(), Next())),
                    boxMax = boxMin + (float3)(pow(10, 1.5 * Next()) * double3(1 + Next(), 1 + Next(), 1 + Next()));
                var transform = Affine.FromTransform(10 * double3(Next(), Next(), Next()),
                    double4(Next(), Next(), Next(), Next()), double3(1, Next() > 0 ? 1 : -1, 1.5 + Next()));
                var picture = new PictureTiles(s_settings, s_view);
                picture.Add(boxMin, boxMax, transform);
                var tiles = Tiles(picture);
                var back = transform.Inverse();
                double3 origin = back.Point(s_view.Position);
                var seen = new HashSet<uint>(Enumerable.Range(0, (int)s_settings.RayCount)
                    .Where(pixel => Meets(origin, back.Vector(TestRadar.Direction(s_settings, s_view, pixel)),
                        boxMin, boxMax)).Select(TileOf));
                met += seen.Count > 0 ? 1 : 0;
                tight += tiles.Count < picture.Count ? 1 : 0;
                Assert.That(seen.Except(tiles), Is.Empty, $"box {i}");
            }
            Assert.That(met, Is.GreaterThan(100));
            Assert.That(tight, Is.GreaterThan(100));
        }

        [Test]
        public void Add_BoxOfOnePixelFarAway_TakesAFewTiles()
        {
            var picture = new PictureTiles(s_settings, s_view);
            double3 far = s_view.Position + 1000 * s_view.Forward;
            picture.Add((float3)far - 0.1f, (float3)far + 0.1f, Affine.Identity);
            Assert.That(Tiles(picture).Count, Is.InRange(1, 4));
        }

        [Test]
        public void Add_FloorUnderTheCamera_LeavesTheSky()
        {
            // The floor extends behind the camera; its horizon is its far edge.
            var picture = new PictureTiles(s_settings, TestRadar.LookAt(double3(0, 5, 0), double3(0, 5, 10)));
            picture.Add(float3(-1000, -1, -1000), float3(1000, 0, 1000), Affine.Identity);
            int rows = (131 + 7) / 8;
            Assert.That(Tiles(picture).Max(tile => tile >> 16), Is.InRange(rows / 2 - 1, rows / 2 + 1));
        }

        [Test]
        public void Add_BoxBehindTheCamera_TakesNothing()
        {
            var picture = new PictureTiles(s_settings, TestRadar.LookAt(0, double3(0, 0, 1)));
            picture.Add(float3(-1, -1, -5), float3(1, 1, -4), Affine.Identity);
            Assert.That(Tiles(picture), Is.Empty);
        }

        [Test]
        public void Add_CameraInTheBox_TakesEverything()
        {
            var picture = new PictureTiles(s_settings, TestRadar.LookAt(0, double3(0, 0, 1)));
            picture.Add(-5, 5, Affine.Identity);
            Assert.That(Tiles(picture).Count, Is.EqualTo(picture.Count));
        }

        [Test]
        public void AddAll_OfARegion_TakesItsTilesOnly()
        {
            var settings = s_settings;
            settings.Region = new RayRegion { Left = 17, Bottom = 40, Width = 30, Height = 1 };
            var picture = new PictureTiles(settings, s_view);
            picture.AddAll();
            Assert.That(Tiles(picture),
                Is.EquivalentTo(Enumerable.Range(2, 4).Select(column => (uint)column | 5u << 16)));
        }

        [Test]
        public void ToCells_Spread_HasEveryCellOnceAndBothHalvesSeeTheWholePicture()
        {
            var picture = new PictureTiles(TestRadar.Settings(1920, 1080), s_view);
            picture.AddAll();
            var inOrder = picture.ToCells(spread: false).Corners;
            var spread = picture.ToCells(spread: true).Corners;
            Assert.That(inOrder, Is.Ordered.Descending, "from the top down");
            Assert.That(spread.OrderByDescending(cell => cell), Is.EqualTo(inOrder));
            int upper = spread.Take(spread.Length / 2).Count(cell => cell >> 16 >= 135 / 2);
            Assert.That(upper, Is.EqualTo(spread.Length / 4).Within(spread.Length / 40));
        }

        [TestCase(1024, 1024, 1)]
        [TestCase(1920, 1080, 2)]
        [TestCase(7680, 4320, 8)]
        [TestCase(100000, 8, 98)]
        public void ToCells_AnyPicture_ListIsBoundedAndHoldsEveryTileOnce(int across, int down, int sizeAcross)
        {
            var settings = TestRadar.Settings(across, down);
            var picture = new PictureTiles(settings, s_view);
            picture.AddAll();
            var cells = picture.ToCells(spread: true);
            // The smallest cells of which 128 reach from side to side.
            Assert.That(cells.Size, Is.EqualTo(int2(sizeAcross, max(1, (down / 8 + 127) / 128))));
            Assert.That(cells.Corners.Length * sizeof(uint), Is.LessThanOrEqualTo(128 * 128 * 4));
            Assert.That(cells.TilesInRegion, Is.EqualTo(picture.Count));
            var inPicture = TilesOf(cells).Where(tile => (tile & 0xffff) < across / 8 && tile >> 16 < down / 8);
            Assert.That(inPicture.Distinct().Count(), Is.EqualTo(across / 8 * (down / 8)));
            Assert.That(inPicture.Count(), Is.EqualTo(across / 8 * (down / 8)));
        }

        [Test]
        public void ToCells_SmallBoxesFarApart_TakesLessThanACellMoreAroundEach()
        {
            // At 7680 x 4320 a single small box has cells of one tile: its exact cover.
            var settings = TestRadar.Settings(7680, 4320);
            var random = new System.Random(7);
            for (int trial = 0; trial < 20; trial++)
            {
                var all = new PictureTiles(settings, s_view);
                var exact = new HashSet<uint>();
                var boxes = new List<int2>();
                for (int i = 0; i < 5; i++)
                {
                    double3 centre = s_view.Position + 100 * s_view.Forward
                        + 90 * (2 * random.NextDouble() - 1) * s_view.Right
                        + 50 * (2 * random.NextDouble() - 1) * s_view.Up;
                    float half = (float)(2 * random.NextDouble());
                    var one = new PictureTiles(settings, s_view);
                    one.Add((float3)centre - half, (float3)centre + half, Affine.Identity);
                    all.Add((float3)centre - half, (float3)centre + half, Affine.Identity);
                    Assert.That(one.ToCells(spread: false).Size, Is.EqualTo(int2(1, 1)));
                    var own = Tiles(one);
                    exact.UnionWith(own);
                    boxes.Add(int2((int)(own.Max(tile => tile & 0xffff) - own.Min(tile => tile & 0xffff)),
                        (int)(own.Max(tile => tile >> 16) - own.Min(tile => tile >> 16))) + 1);
                }
                var cells = all.ToCells(spread: false);
                Assert.That(cmax(cells.Size), Is.InRange(2, 8));
                var tiles = Tiles(all);
                Assert.That(exact.Except(tiles), Is.Empty);
                // n tiles in a row touch cells of at most n + 2 (c - 1) tiles, c tiles each.
                int most = boxes.Sum(box => (box.x + 2 * (cells.Size.x - 1)) * (box.y + 2 * (cells.Size.y - 1)));
                Assert.That(tiles.Count, Is.InRange(exact.Count, most));
            }
        }
    }
}
