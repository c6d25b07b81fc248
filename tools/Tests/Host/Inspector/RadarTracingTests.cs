using System.Collections.Generic;
using System.Linq;
using Glint.Editor;
using Glint.Tests;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>
/// The inspector's button: a pose with a progress bar, problems as text, and the release of the buffers.
/// </summary>
public sealed class RadarTracingTests
{
    readonly List<float?> _bar = new();
    RadarController _radar;
    GameObject _plate;
    RadarTracing _tracing;

    [SetUp]
    public void MakeScene()
    {
        _plate = GameObject.CreatePrimitive(PrimitiveType.Quad);
        (_plate.transform.position, _plate.transform.localScale) = (new Vector3(0, 0, 20), new Vector3(4, 4, 1));
        _radar = new GameObject("Radar", typeof(Camera)).AddComponent<RadarController>();
        _radar.Settings = TestRadar.Settings();
        _radar.Receiver = MeshFileScene.MakeReceiver(_radar.transform, false);
        _radar.Kernel = TestKernels.Trace;
        _radar.Roots.Add(_plate.transform);
        _tracing = new RadarTracing(_radar, 0);
        _bar.Clear();
        EditorHooks.ProgressBar = value => { _bar.Add(value); return false; };
    }

    [TearDown]
    public void RemoveScene()
    {
        EditorHooks.ProgressBar = _ => false;
        _tracing.Dispose();
        Object.DestroyImmediate(_radar.gameObject);
        Object.DestroyImmediate(_plate);
    }

    [Test]
    public void Trace_KeepsTheResultAndClearsTheBar()
    {
        _tracing.Trace();
        Assert.That(_tracing.Problem, Is.Null);
        Assert.That(_radar.Result.RaysReceived, Is.GreaterThan(0));
        Assert.That(_bar.First(), Is.EqualTo(0f));
        Assert.That(_bar[^2], Is.EqualTo(1f));
        Assert.That(_bar.Last(), Is.Null);
        var rows = RadarTracing.Rows(_radar.Result).ToDictionary(row => row.label, row => row.value);
        Assert.That(rows["Undersampled"], Is.EqualTo("no"));
        Assert.That(rows["Rays hit"], Is.EqualTo($"{_radar.Result.RaysHit} of 14,400"));
    }

    [Test]
    public void Trace_ShorterThanAUserNotices_ShowsNoBar()
    {
        using var tracing = new RadarTracing(_radar, 3600);
        tracing.Trace();
        Assert.That(_radar.Result.RaysReceived, Is.GreaterThan(0));
        Assert.That(_bar, Is.Empty);
    }

    [Test]
    public void Trace_Cancelled_LeavesTheResultBefore()
    {
        _tracing.Trace();
        var before = _radar.Result;
        EditorHooks.ProgressBar = value => { _bar.Add(value); return true; };
        _tracing.Trace();
        Assert.That(_tracing.Problem, Is.EqualTo("The pose was cancelled."));
        Assert.That(_radar.Result, Is.SameAs(before));
        Assert.That(_bar.Last(), Is.Null);
    }

    [Test]
    public void Trace_Refused_SaysWhy()
    {
        _radar.Receiver = null;
        _tracing.Trace();
        Assert.That(_tracing.Problem, Is.EqualTo(_radar.HasNoReceiver));
        Assert.That(_bar.Last(), Is.Null);
    }

    [Test]
    public void Dispose_AfterATrace_GivesTheBuffersBack()
    {
        _tracing.Trace();
        Assert.That(_radar.Result.Statistics.BvhsBuilt, Is.EqualTo(1));
        _tracing.Trace();
        Assert.That(_radar.Result.Statistics.BvhsBuilt, Is.EqualTo(0), "they stayed for the next pose");
        _tracing.Dispose();
        _tracing.Trace();
        Assert.That(_radar.Result.Statistics.BvhsBuilt, Is.EqualTo(1));
    }
}
