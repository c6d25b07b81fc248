using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>Components that run in edit mode too begin their work when the scene plays, whatever Play reloads.</summary>
public sealed class PlayTests : EngineFixture
{
    [SetUp]
    public void OpenProject() => UseProject();

    [Test]
    public void Radar_InAScene_TracesOnceEachTimeItPlays([Values] bool reloadsScenes)
    {
        Engine.ReloadsScenes = reloadsScenes;
        var radar = new GameObject("Radar", typeof(Camera)).AddComponent<RadarController>();
        radar.Receiver = new GameObject("Receiver").transform;
        Steps(2);
        Assert.That(Traces(), Is.Zero);
        Play();
        Steps(3);
        radar.enabled = false;
        radar.enabled = true;
        Steps(1);
        Assert.That(Traces(), Is.EqualTo(1));
    }

    [Test]
    public void CrossSection_ThatRunsOnStart_RunsOnceEachTimeItPlays([Values] bool reloadsScenes)
    {
        Engine.ReloadsScenes = reloadsScenes;
        var radar = new GameObject("Radar").AddComponent<RadarCrossSection>();
        Steps(2);
        Assert.That(Log, Is.Empty);
        Play();
        Steps(3);
        // There is nothing to trace.
        Assert.That(Errors, Has.Length.EqualTo(1));
        Assert.That(Errors[0], Is.EqualTo(radar.Problem));
    }

    int Traces() => Log.Count(entry => entry.Message.Contains("were received"));
}
