using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Host.Tests.TestRunner;

// Values that routines yield, exceptions and durations.
internal static partial class Samples<T>
{
    public sealed class CountsFrames : Sample
    {
        [UnityTest]
        public IEnumerator EachNull()
        {
            for (var frame = 0; frame < 3; frame++)
            {
                Trace.Add(Time.frameCount.ToString());
                yield return null;
            }
        }
    }

    public sealed class Nests : Sample
    {
        [UnityTest]
        public IEnumerator Routines()
        {
            yield return Says("a", "b");
            Trace.Add("c");
        }
    }

    public sealed class HalfASecondLater : Sample
    {
        [UnityTest]
        public IEnumerator HalfASecond()
        {
            var start = Time.frameCount;
            yield return new WaitForSeconds(0.5f);
            Assert.That(Time.frameCount - start, Is.EqualTo(2));
        }
    }

    public sealed class WaitsForFive : Sample
    {
        [UnityTest]
        public IEnumerator Calls()
        {
            var calls = 0;
            yield return new WaitUntil(() => ++calls == 5);
            Assert.That(calls, Is.EqualTo(5));
        }
    }

    public sealed class Throws : Sample
    {
        [UnityTest]
        public IEnumerator AfterAFrame()
        {
            yield return null;
            throw new InvalidOperationException("out of rays");
        }
    }

    public sealed class ThrowsInside : Sample
    {
        [UnityTest]
        public IEnumerator Nested()
        {
            yield return Inner();
            Trace.Add("went on");
        }

        static IEnumerator Inner()
        {
            yield return null;
            Assert.Fail("inner claim");
        }
    }

    public sealed class NeverEnds : Sample
    {
        [UnityTest, Timeout(200)]
        public IEnumerator Alone()
        {
            while (true)
                yield return null;
        }

        [UnityTest, Timeout(200)]
        public IEnumerator WithParameter([Values(1)] int _)
        {
            while (true)
                yield return null;
        }
    }

    [Timeout(200)]
    public sealed class FixtureNeverEnds : Sample
    {
        [UnityTest]
        public IEnumerator Inherited()
        {
            while (true)
                yield return null;
        }
    }

    public sealed class ReturnsNothing : Sample
    {
        [UnityTest]
        public void NoRoutine()
        {
        }
    }

    public sealed class TakesParameters : Sample
    {
        static readonly int[] _numbers = { 3, 4 };

        [UnityTest]
        public IEnumerator Combined([Values("x", "y")] string letter, [ValueSource(nameof(_numbers))] int number)
        {
            yield return null;
            Trace.Add(letter + number);
        }
    }

    public sealed class TakesCases : Sample
    {
        [UnityTest]
        [TestCase(1, ExpectedResult = null)]
        [TestCase(2, ExpectedResult = null)]
        public IEnumerator Case(int number)
        {
            yield return null;
            Trace.Add("case " + number);
        }
    }

    public sealed class DependsOnPlatform : Sample
    {
        [Test, UnityPlatform(RuntimePlatform.OSXPlayer, RuntimePlatform.WindowsPlayer)]
        public void A_OnlyElsewhere()
        {
        }

        [Test, UnityPlatform(exclude = new[] { RuntimePlatform.OSXPlayer })]
        public void B_NotElsewhere()
        {
        }
    }

    public sealed class IsIgnored : Sample
    {
        [UnityTest]
        public IEnumerator Later()
        {
            yield return null;
            Assert.Ignore("not today");
        }
    }

    public sealed class YieldsAWait : Sample
    {
        [UnityTest]
        public IEnumerator InEditMode()
        {
            yield return new WaitForSeconds(0.1f);
        }
    }
}
