using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using Glint.Core;
using Glint.Host;
using Glint.Reference;
using UnityEngine;

namespace Glint.Cli;

/// <summary>
/// Measures error against run time. Each scene is built in code, traced with increasing numbers of rays, and compared
/// with the converged result.
/// </summary>
sealed class AccuracyBench(ComputeShader kernel, int rounds, IProgressSink progress)
{
    /// <summary>Rays across the picture; the height follows from 16:9.</summary>
    public static readonly int[] Across = [480, 960, 1920, 3840, 7680];

    // Minimum number of rounds of a slow pose.
    const int MinRounds = 3;
    static readonly TimeSpan s_maxTime = TimeSpan.FromSeconds(3);

    // Receiver size in metres that no ray hits.
    const double NoReceiver = 1e-6;

    readonly AccuracyResult _result = new() { Device = GraphicsDevice.Current.Info, Rounds = rounds };

    /// <exception cref="GlintException">The device cannot trace.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public AccuracyResult Run()
    {
        var scenes = AccuracyScene.All();
        var converged = new Dictionary<AccuracyScene, AccuracyReference>();
        using var tracer = new RayTracer(kernel, "accuracy");
        Steps("converged results", scenes, scene =>
            converged.Add(scene, AccuracyReference.Of(scene, RadarSettings.Default, progress, progress.Cancel)));
        Steps("poses", scenes, scene => MeasureScene(tracer, scene, converged[scene]));
        Steps("same rays by the reference tracer", scenes, scene => _result.Precision.Add(
            AccuracyPrecision.Of(scene, RadarSettings.Default, Row(scene, RadarSettings.Default.RaysAcross).Result,
                progress, progress.Cancel)));
        Steps("costs", [_result.CostScene = scenes.First(scene => scene.HasMuch)],
            scene => MeasureCosts(tracer, scene));
        return _result;
    }

    AccuracyRow Row(AccuracyScene scene, int across) =>
        _result.Rows.Single(row => row.Scene == scene && row.Settings.RaysAcross == across);

    void Steps(string what, IReadOnlyList<AccuracyScene> scenes, Action<AccuracyScene> work)
    {
        progress.Start(what, scenes.Count);
        try
        {
            for (int i = 0; i < scenes.Count; i++)
            {
                work(scenes[i]);
                progress.Advance(i + 1, null);
            }
        }
        finally
        {
            progress.Finish();
        }
    }

    /// <summary>The published radar with other numbers of rays.</summary>
    public static RadarSettings SettingsOf(int across)
    {
        var settings = RadarSettings.Default;
        (settings.RaysAcross, settings.RaysDown) = (across, across * 9 / 16);
        return settings;
    }

    void MeasureScene(RayTracer tracer, AccuracyScene scene, AccuracyReference converged)
    {
        foreach (int across in Across)
        {
            var settings = SettingsOf(across);
            var pose = new RadarPose(scene.Scene, settings, scene.View);
            var times = Time(() => tracer.Trace(pose, RayReadback.None, null, progress.Cancel), out var result);
            _result.Rows.Add(new AccuracyRow(scene, settings, result, times, converged));
        }
    }

    // The first pose is a warm-up.
    Series Time(Func<RadarResult> trace, out RadarResult result)
    {
        var times = new Series();
        var total = Stopwatch.StartNew();
        result = trace();
        while (times.Count < rounds && (times.Count < MinRounds || total.Elapsed < s_maxTime))
        {
            var watch = Stopwatch.StartNew();
            trace();
            times.Add(watch.Elapsed.TotalMilliseconds);
        }
        return times;
    }

    // Time of a pose, in milliseconds.
    double TimeOnce(RayTracer tracer, in RadarPose pose, out RadarResult result)
    {
        var watch = Stopwatch.StartNew();
        result = tracer.Trace(pose, RayReadback.None, null, progress.Cancel);
        return watch.Elapsed.TotalMilliseconds;
    }

    // The variants take turns, so that a slow phase of the machine affects all of them.
    void MeasureCosts(RayTracer tracer, AccuracyScene scene)
    {
        var blind = scene.View;
        blind.ReceiverSize = NoReceiver;
        var each = Enum.GetValues<Culling>().Where(culling => culling is not (Culling.None or Culling.All));
        (string what, Culling culling, RadarView view)[] cases =
        [
            ("a pose as it is", Culling.All, scene.View),
            .. each.Select(culling => (WithoutText(culling), Culling.All & ~culling, scene.View)),
            ("without any culling", Culling.None, scene.View),
            ("nothing received, no refine pass", Culling.All, blind),
        ];
        var results = new RadarResult[cases.Length];
        var times = Array.ConvertAll(cases, index => new Series());
        for (int round = 0; round <= rounds; round++)
        {
            for (int index = 0; index < cases.Length; index++)
            {
                tracer.Culling = cases[index].culling;
                var pose = new RadarPose(scene.Scene, RadarSettings.Default, cases[index].view);
                double time = TimeOnce(tracer, pose, out results[index]);
                if (round > 0)
                    times[index].Add(time);
            }
            progress.Report((round + 1.0) / (rounds + 1));
        }
        tracer.Culling = Culling.All;
        for (int index = 0; index < cases.Length; index++)
            _result.Costs.Add(new AccuracyCost(cases[index].what, times[index], results[index], results[0]));
    }

    static string WithoutText(Culling culling) => culling switch
    {
        Culling.Reach => "traversal past the receiver",
        Culling.LastSegment => "traversal of last segments that miss the receiver",
        Culling.Tiles => "tracing tiles without objects",
        Culling.EntryPoints => "without entry points: from the root of the BVH",
        _ => "without " + culling,
    };
}
