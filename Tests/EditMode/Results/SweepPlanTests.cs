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

            Assert.That(Enumerable.Range(0, plan.Count).Select(i => plan[i].ToString()), Is.EqualTo(new[] { "snapshot 3, 0 deg", "snapshot 3, 22.5 deg", "snapshot 1, 0 deg", "snapshot 1, 22.5 deg" }));
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
