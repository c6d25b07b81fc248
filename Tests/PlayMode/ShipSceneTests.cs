using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Tests
{
    /// <summary>The ship alone and on the stored seas, all round by 15 degrees: what the published experiment found of its ship holds for this one.</summary>
    public sealed class ShipSceneTests
    {
        const int BowOn = 0, Broadside = 6, SternOn = 12;

        static readonly double[] s_angles = Enumerable.Range(0, 24).Select(step => 15.0 * step).ToArray();

        // The same for every test, traced once.
        static List<RadarResult> s_freeSpace;

        [UnityTest]
        public IEnumerator FreeSpace_Hits_AreThePublishedShipsWithin15Percent()
        {
            yield return TraceFreeSpace();
            foreach (var (step, published) in new[] { (BowOn, 125508), (Broadside, 331864), (SternOn, 161522) })
                Assert.That(s_freeSpace[step].RaysHit, Is.EqualTo(published).Within(15).Percent, $"{s_angles[step]} deg");
        }

        [UnityTest]
        public IEnumerator FreeSpace_BowAndStern_AreFiveTimesTheMedian()
        {
            yield return TraceFreeSpace();
            double median = s_freeSpace.Select(result => result.Amplitude).OrderBy(amplitude => amplitude).Skip(11).Take(2).Average();
            Assert.That(s_freeSpace[BowOn].Amplitude, Is.GreaterThan(5 * median));
            Assert.That(s_freeSpace[SternOn].Amplitude, Is.GreaterThan(5 * median));
        }

        [UnityTest]
        public IEnumerator SeaState5_Amplitudes_AreMostlyThoseOfFreeSpace()
        {
            yield return TraceFreeSpace();
            yield return PlayScene.Load("ShipSeaState5");
            var onSea = Trace();
            int same = Enumerable.Range(0, onSea.Count).Count(step => Mathf.Abs((float)(onSea[step].Amplitude - s_freeSpace[step].Amplitude)) < 0.1 * s_freeSpace[step].Amplitude + 1);
            Assert.That(same, Is.GreaterThan(onSea.Count / 2));
        }

        [UnityTest]
        public IEnumerator SeaState6_RaysReceived_AreMoreThanInFreeSpaceAtTwoThirdsOfTheAngles()
        {
            yield return TraceFreeSpace();
            yield return PlayScene.Load("ShipSeaState6");
            var onSea = Trace();
            int more = Enumerable.Range(0, onSea.Count).Count(step => onSea[step].RaysReceived > s_freeSpace[step].RaysReceived);
            Assert.That(more, Is.GreaterThanOrEqualTo(2 * onSea.Count / 3));
        }

        static IEnumerator TraceFreeSpace()
        {
            if (s_freeSpace != null)
                yield break;
            yield return PlayScene.Load("ShipFreeSpace");
            s_freeSpace = Trace();
        }

        static List<RadarResult> Trace()
        {
            var radar = Object.FindFirstObjectByType<RadarController>();
            var ship = GameObject.Find("Ship").transform;
            var results = new List<RadarResult>();
            using (var run = new SweepRun(radar, new SweepPlan(s_angles), ship, null, "Scene", null))
                while (!run.IsComplete)
                    results.Add(run.Step().Result);
            return results;
        }
    }
}
