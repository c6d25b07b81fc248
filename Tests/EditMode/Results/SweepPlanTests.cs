using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class SweepPlanTests
    {
        [Test]
        public void Plan_OfAnglesAndSnapshots_HasEveryAngleForEachSnapshot()
        {
            var plan = new SweepPlan(new double[] { 0, 22.5 }, new[] { 3, 1 });

            Assert.That(Enumerable.Range(0, plan.Count).Select(i => plan[i].ToString()), Is.EqualTo(
                new[] { "snapshot 3, 0 deg", "snapshot 3, 22.5 deg", "snapshot 1, 0 deg", "snapshot 1, 22.5 deg" }));
        }

        [Test]
        public void Plan_OfEveryAxis_IsTheProductInTheOrderOfTheAxes()
        {
            var plan = new SweepPlan(
                (SweepAxis.Angle, new double[] { 0, 15, 30 }), (SweepAxis.Grazing, new double[] { 1, 2 }),
                (SweepAxis.Range, new double[] { 50, 100 }),
                (SweepAxis.Frequency, new double[] { 9e9, 10e9 }), (SweepAxis.Snapshot, new double[] { 4, 7 }));

            var poses = Enumerable.Range(0, plan.Count).Select(i => plan[i]).ToArray();
            var loops = from snapshot in new double[] { 4, 7 }
                        from frequency in new double[] { 9e9, 10e9 }
                        from range in new double[] { 50, 100 }
                        from grazing in new double[] { 1, 2 }
                        from angle in new double[] { 0, 15, 30 }
                        select (snapshot, frequency, range, grazing, angle);
            Assert.That(poses.Select(pose => ((double)pose.Snapshot, pose[SweepAxis.Frequency].Value,
                    pose[SweepAxis.Range].Value, pose[SweepAxis.Grazing].Value, pose.AngleDegrees.Value)),
                Is.EqualTo(loops));
            Assert.That(poses[47].ToString(),
                Is.EqualTo("snapshot 7, 10000000000 Hz, range 100 m, grazing 2 deg, 30 deg"));
        }

        [Test]
        public void Plan_OfTooManyPoses_IsRefused()
        {
            var thousand = Enumerable.Range(0, 1000).Select(i => (double)i).ToArray();
            Assert.That(new SweepPlan((SweepAxis.Angle, thousand), (SweepAxis.Range, thousand)).Count,
                Is.EqualTo(1000000));
            Assert.That(Assert.Throws<UsageException>(() => new SweepPlan((SweepAxis.Angle, thousand),
                    (SweepAxis.Range, thousand), (SweepAxis.Frequency, thousand))).Message,
                Does.Contain("10,000,000 poses"));
        }

        [Test]
        public void Plan_OfOneAxis_LeavesTheOtherAlone()
        {
            Assert.That(new SweepPlan(new double[] { 5 })[0].Snapshot, Is.Null);
            Assert.That(new SweepPlan(null, new[] { 5 })[0].AngleDegrees, Is.Null);
            Assert.That(SweepPlan.Single.Count, Is.EqualTo(1));
            Assert.That(SweepPlan.Single[0].ToString(), Is.Empty);
        }
    }
}
