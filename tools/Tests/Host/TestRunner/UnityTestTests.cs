using System.Linq;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using UnityEngine;

namespace Glint.Host.Tests.TestRunner;

/// <summary>[UnityTest] with the routine that a test returns, in play mode unless the name says otherwise.</summary>
public sealed class UnityTestTests
{
    [SetUp]
    public void Play()
    {
        Samples<int>.Trace.Clear();
        Engine.EnterPlayMode();
    }

    [TearDown]
    public void Stop()
    {
        Time.captureDeltaTime = 0f;
        if (Engine.IsPlaying)
            Engine.ExitPlayMode();
    }

    [Test]
    public void Null_Yielded_StepsOneFrame()
    {
        Passes(FixtureRun.OfOne(typeof(Samples<int>.CountsFrames)));

        var frames = Samples<int>.Trace.Select(int.Parse).ToArray();
        Assert.That(frames, Has.Length.EqualTo(3));
        Assert.That(frames.Select(frame => frame - frames[0]), Is.EqualTo(new[] { 0, 1, 2 }));
    }

    [Test]
    public void Null_YieldedInEditMode_StepsOn()
    {
        Engine.ExitPlayMode();
        Passes(FixtureRun.OfOne(typeof(Samples<int>.CountsFrames)));
        Assert.That(Samples<int>.Trace, Has.Count.EqualTo(3));
    }

    [Test]
    public void Wait_YieldedInEditMode_Fails()
    {
        Engine.ExitPlayMode();
        Fails(FixtureRun.OfOne(typeof(Samples<int>.YieldsAWait)), "can only yield null, not WaitForSeconds");
    }

    [Test]
    public void NestedRoutine_Yielded_RunsToItsEndFirst()
    {
        Passes(FixtureRun.OfOne(typeof(Samples<int>.Nests)));
        Assert.That(Samples<int>.Trace, Is.EqualTo(new[] { "a", "b", "c" }));
    }

    [Test]
    public void WaitForSeconds_Yielded_WaitsInGameTime()
    {
        Time.captureDeltaTime = 0.25f; // two frames make the half second
        Passes(FixtureRun.OfOne(typeof(Samples<int>.HalfASecondLater)));
    }

    [Test]
    public void WaitUntil_Yielded_WaitsForItsCondition() => Passes(FixtureRun.OfOne(typeof(Samples<int>.WaitsForFive)));

    [Test]
    public void Exception_InALaterFrame_Fails()
        => Fails(FixtureRun.OfOne(typeof(Samples<int>.Throws)), "InvalidOperationException : out of rays");

    [Test]
    public void Assertion_InANestedRoutine_FailsAndStops()
    {
        Fails(FixtureRun.OfOne(typeof(Samples<int>.ThrowsInside)), "inner claim");
        Assert.That(Samples<int>.Trace, Is.Empty);
    }

    [Test]
    public void Timeout_OnTheMethod_Fails()
    {
        foreach (var result in FixtureRun.Of(typeof(Samples<int>.NeverEnds)))
            Fails(result, "exceeded Timeout value of 200ms");
    }

    [Test]
    public void Timeout_OnTheFixture_Fails()
        => Fails(FixtureRun.OfOne(typeof(Samples<int>.FixtureNeverEnds)), "exceeded Timeout value of 200ms");

    [Test]
    public void Method_NotReturningARoutine_IsNotRun()
    {
        var result = FixtureRun.OfOne(typeof(Samples<int>.ReturnsNothing));
        Assert.That(result.ResultState, Is.EqualTo(ResultState.NotRunnable));
    }

    [Test]
    public void Name_WithoutParameters_IsTheMethods()
        => Assert.That(FixtureRun.OfOne(typeof(Samples<int>.Throws)).FullName, Does.EndWith("Throws.AfterAFrame"));

    [Test]
    public void Platform_OfAnotherMachine_IsSkipped()
    {
        var results = FixtureRun.Of(typeof(Samples<int>.DependsOnPlatform));
        Assert.That(results.Select(result => result.ResultState.Status),
            Is.EqualTo(new[] { TestStatus.Skipped, TestStatus.Passed }));
    }

    [Test]
    public void Ignore_InALaterFrame_IsIgnored()
        => Assert.That(FixtureRun.OfOne(typeof(Samples<int>.IsIgnored)).ResultState.Status,
            Is.EqualTo(TestStatus.Skipped));

    [Test]
    public void Parameters_ValuesAndValueSource_AreCombined()
    {
        var results = FixtureRun.Of(typeof(Samples<int>.TakesParameters));
        Assert.That(results.Select(result => result.ResultState), Is.All.EqualTo(ResultState.Success));
        Assert.That(Samples<int>.Trace, Is.EquivalentTo(new[] { "x3", "x4", "y3", "y4" }));
    }

    [Test]
    public void Parameters_TestCases_AreRun()
    {
        foreach (var result in FixtureRun.Of(typeof(Samples<int>.TakesCases)))
            Passes(result);
        Assert.That(Samples<int>.Trace, Is.EquivalentTo(new[] { "case 1", "case 2" }));
    }

    static void Passes(ITestResult result) =>
        Assert.That(result.ResultState, Is.EqualTo(ResultState.Success), result.Message);

    static void Fails(ITestResult result, string reason)
    {
        Assert.That(result.ResultState.Status, Is.EqualTo(TestStatus.Failed));
        Assert.That(result.Message, Does.Contain(reason));
    }
}
