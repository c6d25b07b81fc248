using System;
using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Host.Tests.TestRunner;

/// <summary>Fixtures to be run by tests, as in Unity. They are generic, so that NUnit does not find them: half of them fail, as they should.</summary>
internal static class Samples<T>
{
    internal static readonly List<string> Trace = new();

    static IEnumerator Says(params string[] words)
    {
        foreach (var word in words)
        {
            Trace.Add(word);
            yield return null;
        }
    }

    [UnityTestAction]
    public abstract class Sample
    {
    }

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

    public sealed class Waits : Sample
    {
        [UnityTest]
        public IEnumerator HalfASecond()
        {
            var start = Time.time;
            yield return new WaitForSeconds(0.5f);
            Assert.That(Time.time - start, Is.InRange(0.5f, 0.9f));
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

    public class OrderBase : Sample
    {
        [UnitySetUp]
        public IEnumerator BaseUnitySetUp() => Says("base unity set-up 1", "base unity set-up 2");

        [SetUp]
        public void BaseSetUp() => Trace.Add("base set-up");

        [TearDown]
        public void BaseTearDown() => Trace.Add("base tear-down");

        [UnityTearDown]
        public IEnumerator BaseUnityTearDown() => Says("base unity tear-down");
    }

    public class Order : OrderBase
    {
        [UnitySetUp]
        public IEnumerator UnitySetUp() => Says("unity set-up");

        [SetUp]
        public void SetUp() => Trace.Add("set-up");

        [TearDown]
        public void TearDown() => Trace.Add("tear-down");

        [UnityTearDown]
        public IEnumerator UnityTearDown() => Says("unity tear-down");
    }

    public sealed class PlainOrder : Order
    {
        [Test]
        public void Plain() => Trace.Add("test");
    }

    public sealed class RoutineOrder : Order
    {
        [UnityTest]
        public IEnumerator Routine() => Says("test");
    }

    public sealed class SetUpThrows : OrderBase
    {
        [UnitySetUp]
        public IEnumerator Broken()
        {
            yield return null;
            throw new InvalidOperationException("no set-up");
        }

        [Test]
        public void NotReached() => Trace.Add("test");
    }

    public sealed class TearDownThrows : Sample
    {
        [UnityTearDown]
        public IEnumerator Broken()
        {
            yield return null;
            throw new InvalidOperationException("no tear-down");
        }

        [Test]
        public void Fine()
        {
        }

        [Test]
        public void Wrong() => Assert.Fail("the claim");
    }

    public sealed class Logs : Sample
    {
        [Test]
        public void A_Error() => Debug.LogError("boom");

        [Test]
        public void B_Exception() => Debug.LogException(new InvalidOperationException("boom"));

        [Test]
        public void C_Assertion() => Debug.unityLogger.Log(LogType.Assert, "boom");

        [Test]
        public void D_Warning() => Debug.LogWarning("hm");

        [UnityTest]
        public IEnumerator E_ErrorInAFrame()
        {
            Debug.LogError("boom");
            yield return null;
            Trace.Add("went on");
        }
    }

    public sealed class Expects : Sample
    {
        [Test]
        public void Before()
        {
            LogAssert.Expect(LogType.Error, "boom");
            Debug.LogError("boom");
        }

        [Test]
        public void After()
        {
            Debug.LogError("boom 7");
            LogAssert.Expect(LogType.Error, new Regex("^boom \\d$"));
        }

        [Test]
        public void AnyType()
        {
            LogAssert.Expect("boom");
            Debug.LogError("boom");
        }

        [Test]
        public void Exception()
        {
            LogAssert.Expect(LogType.Exception, "InvalidOperationException: boom");
            Debug.LogException(new InvalidOperationException("boom"));
        }

        [UnityTest]
        public IEnumerator FramesLater()
        {
            LogAssert.Expect(LogType.Error, "boom");
            yield return null;
            yield return null;
            Debug.LogError("boom");
        }

        [Test]
        public void Ignored()
        {
            LogAssert.ignoreFailingMessages = true;
            Debug.LogError("boom");
        }

        [Test]
        public void NothingElse()
        {
            LogAssert.Expect(LogType.Log, "one");
            Debug.Log("one");
            LogAssert.NoUnexpectedReceived();
        }
    }

    public sealed class ExpectsInVain : Sample
    {
        [Test]
        public void A_NotLogged() => LogAssert.Expect(LogType.Error, "boom");

        [Test]
        public void B_OtherType()
        {
            LogAssert.Expect(LogType.Error, "boom");
            Debug.LogWarning("boom");
        }

        [Test]
        public void C_OtherOrder()
        {
            LogAssert.Expect(LogType.Error, "first");
            LogAssert.Expect(LogType.Error, "second");
            Debug.LogError("second");
            Debug.LogError("first");
        }

        [Test]
        public void D_OneOfTwo()
        {
            LogAssert.Expect(LogType.Error, "boom");
            Debug.LogError("boom");
            Debug.LogError("boom");
        }

        [Test]
        public void E_ReceivedMore()
        {
            Debug.Log("chatter");
            LogAssert.NoUnexpectedReceived();
        }
    }

    public sealed class LeavesAnErrorBehind : Sample
    {
        [Test]
        public void A_Ignores() => LogAssert.ignoreFailingMessages = true;

        [Test]
        public void B_Error() => Debug.LogError("boom");
    }
}
