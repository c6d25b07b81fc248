using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class DispatchPacerTests
    {
        // Seconds of each dispatch of a pose; a tile's cost may depend on its position, 0 to 1.
        static List<double> Pose(DispatchPacer pacer, int tiles, Func<double, double> secondsOfTile,
            double firstExtra = 0, int bounces = 4)
        {
            var dispatches = new List<double>();
            for (int done = 0; done < tiles;)
            {
                int count = pacer.NextTiles(tiles - done, bounces);
                Assert.That(count, Is.InRange(1, tiles - done));
                // Fixed cost of a dispatch.
                double seconds = 2e-4;
                for (int tile = done; tile < done + count; tile++)
                    seconds += secondsOfTile((double)tile / tiles);
                dispatches.Add(seconds);
                pacer.Took(count, seconds + (dispatches.Count == 1 ? firstExtra : 0));
                done += count;
            }
            return dispatches;
        }

        [TestCase(1e-8)]
        [TestCase(1e-6)]
        [TestCase(1e-4)]
        [TestCase(1e-3)]
        [TestCase(0.02)]
        public void NextTiles_TilesOfOneCost_NoDispatchTakesHalfASecondAndFewAreNeeded(double secondsOfTile)
        {
            var pacer = new DispatchPacer();
            const int Tiles = 500_000;
            int tiles = secondsOfTile > 1e-3 ? 2000 : Tiles;
            var first = Pose(pacer, tiles, _ => secondsOfTile, firstExtra: 2);
            // The first dispatch has no history: at this cost of a tile, a single ray would take a millisecond.
            Assert.That(first.Skip(secondsOfTile > 1e-3 ? 1 : 0).Max(), Is.LessThan(secondsOfTile > 1e-4 ? 1.1 : 0.5));
            Assert.That(first.Skip(1).Max(), Is.LessThan(0.5));
            var second = Pose(pacer, tiles, _ => secondsOfTile);
            Assert.That(second.Max(), Is.LessThan(0.5));
            Assert.That(second.Count, Is.LessThanOrEqualTo(Math.Ceiling(tiles * secondsOfTile / 0.2)));
        }

        [Test]
        public void NextTiles_PartOfThePictureFourTimesAsCostly_NoDispatchTakesHalfASecond()
        {
            var pacer = new DispatchPacer();
            double Cost(double position) => position > 0.3 && position < 0.5 ? 2e-4 : 5e-5;
            Pose(pacer, 40_000, Cost, firstExtra: 1);
            for (int pose = 0; pose < 3; pose++)
                Assert.That(Pose(pacer, 40_000, Cost).Max(), Is.LessThan(0.5));
        }

        [Test]
        public void NextTiles_MoreBounces_BeginsSmallAgain()
        {
            var pacer = new DispatchPacer();
            Pose(pacer, 500_000, _ => 1e-6);
            Assert.That(pacer.NextTiles(500_000, 4), Is.GreaterThan(100_000));
            Assert.That(pacer.NextTiles(500_000, 16), Is.LessThan(1000));
        }

        [Test]
        public void NextTiles_OneSlowDispatch_IsForgottenWithTime()
        {
            var pacer = new DispatchPacer();
            Pose(pacer, 20_000, _ => 1e-5);
            Assert.That(Pose(pacer, 20_000, _ => 1e-5), Has.Count.EqualTo(1));
            pacer.Took(20_000, 1);
            for (int pose = 0; pose < 5; pose++)
                Pose(pacer, 20_000, _ => 1e-5);
            Assert.That(Pose(pacer, 20_000, _ => 1e-5), Has.Count.EqualTo(1));
        }
    }
}
