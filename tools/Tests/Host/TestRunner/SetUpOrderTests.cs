using NUnit.Framework;
using NUnit.Framework.Interfaces;

namespace Glint.Host.Tests.TestRunner;

/// <summary>[UnitySetUp] and [UnityTearDown] around every kind of test.</summary>
public sealed class SetUpOrderTests
{
    static readonly string[] _order =
    {
        "base unity set-up 1", "base unity set-up 2", "unity set-up", "base set-up", "set-up",
        "test",
        "tear-down", "base tear-down", "unity tear-down", "base unity tear-down",
    };

    [SetUp]
    public void Clear() => Samples<int>.Trace.Clear();

    [Test]
    public void Test_WithAllSetUps_RunsThemInUnitysOrder()
    {
        Assert.That(FixtureRun.OfOne(typeof(Samples<int>.PlainOrder)).ResultState, Is.EqualTo(ResultState.Success));
        Assert.That(Samples<int>.Trace, Is.EqualTo(_order));
    }

    [Test]
    public void UnityTest_WithAllSetUps_RunsThemInUnitysOrder()
    {
        Assert.That(FixtureRun.OfOne(typeof(Samples<int>.RoutineOrder)).ResultState, Is.EqualTo(ResultState.Success));
        Assert.That(Samples<int>.Trace, Is.EqualTo(_order));
    }

    [Test]
    public void UnitySetUp_Throws_TestIsNotRunButTornDown()
    {
        var result = FixtureRun.OfOne(typeof(Samples<int>.SetUpThrows));
        Assert.That(result.ResultState.Status, Is.EqualTo(TestStatus.Failed));
        Assert.That(result.Message, Does.Contain("no set-up"));
        Assert.That(Samples<int>.Trace,
            Is.EqualTo(new[] { "base unity set-up 1", "base unity set-up 2", "base unity tear-down" }));
    }

    [Test]
    public void UnityTearDown_Throws_FailsWithoutHidingTheTestsOwnFailure()
    {
        var results = FixtureRun.Of(typeof(Samples<int>.TearDownThrows));
        Assert.That(results[0].ResultState.Status, Is.EqualTo(TestStatus.Failed));
        Assert.That(results[0].Message, Does.Contain("no tear-down"));
        Assert.That(results[1].Message, Does.Contain("the claim").And.Contain("no tear-down"));
    }
}
