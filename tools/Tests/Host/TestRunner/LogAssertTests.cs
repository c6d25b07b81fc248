using System.Linq;
using NUnit.Framework;
using NUnit.Framework.Interfaces;

namespace Glint.Host.Tests.TestRunner;

/// <summary>Unexpected errors in the log and missing expected messages fail a test.</summary>
public sealed class LogAssertTests
{
    [SetUp]
    public void Clear() => Samples<int>.Trace.Clear();

    [Test]
    public void Errors_NotExpected_Fail()
    {
        var results = FixtureRun.Of(typeof(Samples<int>.Logs));
        Assert.That(results.Select(result => result.ResultState.Status), Is.EqualTo(new[]
        {
            TestStatus.Failed, TestStatus.Failed, TestStatus.Failed, TestStatus.Passed, TestStatus.Failed,
        }));
        Assert.That(results[0].Message, Does.Contain("[Error] boom"));
        Assert.That(results[1].Message, Does.Contain("[Exception] InvalidOperationException: boom"));
    }

    [Test]
    public void Error_NotExpectedInAFrame_EndsTheTestThere()
    {
        FixtureRun.Of(typeof(Samples<int>.Logs));
        Assert.That(Samples<int>.Trace, Is.Empty);
    }

    [Test]
    public void Messages_Expected_Pass()
    {
        foreach (var result in FixtureRun.Of(typeof(Samples<int>.Expects)))
            Assert.That(result.ResultState, Is.EqualTo(ResultState.Success), result.Name + ": " + result.Message);
    }

    [Test]
    public void Messages_ExpectedInVain_Fail()
    {
        var results = FixtureRun.Of(typeof(Samples<int>.ExpectsInVain));
        Assert.That(results.Select(result => result.ResultState), Is.All.EqualTo(ResultState.Failure));
        Assert.That(results[0].Message, Does.Contain("not logged: [Error] boom"));
        Assert.That(results[4].Message, Does.Contain("[Log] chatter"));
    }

    [Test]
    public void IgnoreFailingMessages_SetByOneTest_EndsWithIt()
    {
        var results = FixtureRun.Of(typeof(Samples<int>.LeavesAnErrorBehind));
        Assert.That(results.Select(result => result.ResultState.Status),
            Is.EqualTo(new[] { TestStatus.Passed, TestStatus.Failed }));
    }
}
