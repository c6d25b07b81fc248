using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine.TestTools;

namespace Glint.Host.Tests.TestRunner;

// Set-ups and tear-downs.
internal static partial class Samples<T>
{
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
}
