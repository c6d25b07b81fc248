using System;
using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Host.Tests.TestRunner;

// Logged and expected messages.
internal static partial class Samples<T>
{
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
