using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>The spokes of frames.</summary>
    public sealed class ScreenSweepTests
    {
        static readonly ScreenGeometry s_geometry = new ScreenGeometry(ScreenRadar.Default, "test");

        [Test]
        public void Frames_TraceAndFinishEachSpokeOnce_AndTraceBeforeTheyFinish()
        {
            var sweep = new ScreenSweep(s_geometry);
            var random = new System.Random(1);
            List<long> traced = new List<long>(), finished = new List<long>();
            double turns = 7.3;
            for (int frame = 0; frame < 200; frame++, turns += 0.05 * random.NextDouble())
            {
                var slice = sweep.Advance(turns);
                traced.AddRange(Enumerable.Range(0, slice.Traced).Select(i => slice.FirstTraced + i));
                finished.AddRange(Enumerable.Range(0, slice.Finished).Select(i => slice.FirstFinished + i));
                if (finished.Count > 0)
                    Assert.That(traced[traced.Count - 1] - finished[finished.Count - 1],
                        Is.EqualTo(s_geometry.HalfBeam), "the leading edge");
            }
            Assert.That(traced, Is.EqualTo(Enumerable.Range(0, traced.Count).Select(i => traced[0] + i)));
            Assert.That(finished, Is.EqualTo(Enumerable.Range(0, finished.Count).Select(i => finished[0] + i)));
            Assert.That(finished[0], Is.EqualTo((long)(7.3 * 4096)));
            Assert.That(finished[0] - traced[0], Is.EqualTo(s_geometry.HalfBeam), "the trailing edge");
        }

        [Test]
        public void LongFrame_FinishesHalfATurn_AndTheNextOneGoesOn()
        {
            var sweep = new ScreenSweep(s_geometry);
            sweep.Advance(0);
            Assert.That(sweep.Advance(0.9).Finished, Is.EqualTo(2048));
            var next = sweep.Advance(0.9);
            Assert.That((next.FirstFinished, next.Finished), Is.EqualTo((2048L, (int)(0.9 * 4096) - 2048)));
        }

        // An antenna that is turned back, with the ship, waits.
        [Test]
        public void AntennaThatTurnsBack_FinishesNothing()
        {
            var sweep = new ScreenSweep(s_geometry);
            sweep.Advance(0.5);
            Assert.That(sweep.Advance(0.4).Finished, Is.Zero);
            Assert.That(sweep.Advance(0.5).Finished, Is.Zero);
            Assert.That(sweep.Advance(0.5 + 3 / 4096.0).Finished, Is.EqualTo(3));
        }
    }
}
