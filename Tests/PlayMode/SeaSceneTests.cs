using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Tests
{
    /// <summary>The scenes with a stored sea alone, over its ten snapshots.</summary>
    [Category("Slow")]
    public sealed class SeaSceneTests
    {
        [UnityTest]
        [Timeout(600000)]
        public IEnumerator SeaState5_OverItsSnapshots_ReturnsNothing()
        {
            yield return PlayScene.Load("SeaState5", PlayScene.TraceASixteenth);
            Assert.That(Trace().Select(result => result.RaysReceived), Is.All.Zero);
        }

        [UnityTest]
        [Timeout(600000)]
        public IEnumerator SeaState6_OverItsSnapshots_ReturnsInSomeAndNotInAll()
        {
            yield return PlayScene.Load("SeaState6", PlayScene.TraceASixteenth);
            Assert.That(Trace().Count(result => result.RaysReceived > 0), Is.InRange(2, 9));
        }

        // A flat sea of 64 x 128 m covers 0.067 million pixels.
        static List<RadarResult> Trace()
        {
            var radar = Object.FindFirstObjectByType<RadarController>();
            var sea = Object.FindFirstObjectByType<Sea>();
            PlayScene.SkipSamplingError(radar);
            var plan = new SweepPlan(null, Enumerable.Range(1, 10).ToArray());
            var results = new List<RadarResult>();
            using (var run = new SweepRun(new SweepSetup(radar, plan) { Sea = sea }))
                while (!run.IsComplete)
                    results.Add(run.Step().Result);
            foreach (var result in results)
            {
                Assert.That(result.Statistics.Triangles, Is.EqualTo(35344));
                Assert.That(result.RaysHit, Is.InRange(62500, 75000));
            }
            Assert.That(results.Select(result => result.RaysHit).Distinct().Count(), Is.EqualTo(10), "ten moments");
            return results;
        }
    }
}
