using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class TubeJobTests
    {
        // A slice that is traced again does not take what it has revealed itself.
        [Test]
        public void TakesRevealed_IsTrueOnceAnAttempt()
        {
            var job = NewJob();
            for (int attempt = 0; attempt < 2; attempt++)
            {
                job.Begin(0.1, 0.1);
                Assert.That((job.TakesRevealed(), job.TakesRevealed()), Is.EqualTo((true, false)), $"attempt {attempt}");
            }
        }

        // A cell that fills the lists by itself ends a pose; what an earlier attempt found is kept.
        [Test]
        public void GiveUp_AfterAnAttempt_KeepsItsResult()
        {
            var job = NewJob();
            job.Begin(0.1, 0.1);
            Assert.That(job.GiveUp(), Is.False, "nothing is found yet");
            Assert.That(job.IsDone, Is.False);
            var result = job.End();
            job.Begin(0.01, 0.01);
            Assert.That(job.GiveUp());
            Assert.That((job.IsDone, job.Left, job.Result, job.Result.Attempts.Last().CellError), Is.EqualTo((true, 0L, result, 0.1)));
        }

        static TubeJob NewJob()
        {
            var radar = RadarAspect.At(0, 0);
            var pose = new CrossSectionPose
            {
                Scene = new RadarScene(CrossSectionTargets.Plate(0.3, 0.2)), Radar = radar, Receivers = new[] { radar },
                Frequencies = new[] { 10e9 }
            };
            return new TubeJob(pose, new TubeGrid(pose, 0.03, new double3(-0.15, -0.1, 0), new double3(0.15, 0.1, 0)));
        }
    }
}
