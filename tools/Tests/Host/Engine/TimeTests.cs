using System.Threading;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public sealed class TimeTests : EngineFixture
{
    [Test]
    public void Frames_OfGivenLength_AddUp()
    {
        Play(0.25f);
        Steps(4);
        Assert.That(Time.frameCount, Is.EqualTo(4));
        Assert.That(Time.timeAsDouble, Is.EqualTo(1.0).Within(1e-12));
        Assert.That(Time.deltaTime, Is.EqualTo(0.25f));
    }

    [Test]
    public void TimeScale_SlowsGameTimeOnly()
    {
        Play(0.25f);
        Time.timeScale = 0.5f;
        Steps(4);
        Assert.That(Time.time, Is.EqualTo(0.5f).Within(1e-6f));
        Assert.That(Time.unscaledTime, Is.EqualTo(1f).Within(1e-6f));
        Assert.That(Time.unscaledDeltaTime, Is.EqualTo(0.25f));
    }

    [Test]
    public void RealFrames_MeasureTheClockAndAreCapped()
    {
        Play(0f);
        Steps(1);
        Thread.Sleep(30);
        Steps(1);
        Assert.That(Time.deltaTime, Is.InRange(0.03f, Time.maximumDeltaTime));
    }

    [Test]
    public void TimeScale_Negative_IsRefused()
    {
        Time.timeScale = -1f;
        Assert.That(Time.timeScale, Is.EqualTo(1f));
        Assert.That(Errors.Length, Is.EqualTo(1));
    }
}
