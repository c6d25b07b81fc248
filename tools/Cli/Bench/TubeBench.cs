using System;
using System.Diagnostics;
using System.Linq;
using Glint.Core;
using Glint.Host;
using Glint.Reference;
using Glint.Vulkan;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Cli;

/// <summary>
/// Measures ray tubes at several tolerances beside uniform rays. Each is compared with the amplitude by clipped tubes
/// in double precision. The device's clock runs all the time, so that wall times and those of the kernels are of the same poses.
/// </summary>
sealed class TubeBench(ComputeShader kernel, ComputeShader tubeKernel, int rounds, GpuClock clock, IProgressSink progress)
{
    /// <summary>Relative errors that the tubes are asked for.</summary>
    public static readonly double[] Tolerances = [0.3, 0.1, 0.03, TubeScene.Goal, 0.003];

    // Undivided cells across the picture: of the converged amplitude, and of another whose difference is its
    // uncertainty.
    const int Cells = 2880, OtherCells = 1920;

    // Between poses that are traced together.
    const double TurnDegrees = 0.01;

    /// <exception cref="GlintException">The device cannot trace.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public TubeResult Run()
    {
        using var uniform = new RayTracer(kernel, "ray tubes");
        using var tubes = new AmplitudeTracer(tubeKernel, "ray tubes");
        var result = new TubeResult
        {
            Device = GraphicsDevice.Current.Info, Rounds = rounds, PosesTogether = tubes.PosesTogether
        };
        var scenes = AccuracyScene.All();
        progress.Start("ray tubes", scenes.Count);
        clock.IsOn = clock.IsSupported;
        try
        {
            foreach (var scene in scenes)
            {
                result.Scenes.Add(Measure(scene, uniform, tubes));
                progress.Advance(result.Scenes.Count, null);
            }
        }
        finally
        {
            clock.IsOn = false;
            progress.Finish();
        }
        return result;
    }

    TubeScene Measure(AccuracyScene scene, RayTracer uniform, AmplitudeTracer tubes)
    {
        var first = PoseOf(scene, RadarSettings.Default);
        var converged = ReferenceAmplitude.Of(first, Cells, new Part(progress, 0, 3), progress.Cancel);
        var other = ReferenceAmplitude.Of(first, OtherCells, new Part(progress, 1, 3), progress.Cancel);
        var measured = new TubeScene(scene, converged, Math.Abs(converged.Magnitude - other.Magnitude));
        RadarPose[] poses =
        [
            .. Tolerances.Select(tolerance => PoseOf(scene, SettingsOf(tolerance))),
            .. AccuracyBench.Across.Select(across => PoseOf(scene, AccuracyBench.SettingsOf(across))),
        ];
        var times = Array.ConvertAll(poses, pose => new Series());
        var kernels = Array.ConvertAll(poses, pose => new Series());
        var results = new RadarResult[poses.Length];
        var sweep = Enumerable.Range(0, tubes.PosesTogether).Select(i =>
            Turned(PoseOf(scene, SettingsOf(TubeScene.Goal)), i * TurnDegrees)).ToArray();
        Series sweepTimes = new(), sweepKernels = new();
        // They take turns, so that a slow phase of the machine affects all. The first round is a warm-up.
        for (int round = 0; round <= rounds; round++)
        {
            for (int i = 0; i < poses.Length; i++)
            {
                Time(() => results[i] = poses[i].Settings.ToleranceDb > 0 ? tubes.Trace(poses[i], null, progress.Cancel)
                    : uniform.Trace(poses[i], RayReadback.None, null, progress.Cancel), 1, round, times[i], kernels[i]);
                new Part(progress, 2, 3).Report((round + (i + 1.0) / poses.Length) / (rounds + 1));
            }
            if (sweep.Length > 1)
                Time(() => tubes.Trace(sweep, null, progress.Cancel), sweep.Length, round, sweepTimes, sweepKernels);
        }
        for (int i = 0; i < poses.Length; i++)
            (poses[i].Settings.ToleranceDb > 0 ? measured.Tubes : measured.Uniform).Add(new TubeRow(
                poses[i].Settings, results[i], times[i], kernels[i], measured.ErrorOf(results[i].NormalisedAmplitude)));
        if (sweep.Length > 1)
            measured.Together = new TubeRow(measured.TubesAtGoal.Settings, measured.TubesAtGoal.Result, sweepTimes, sweepKernels,
                measured.TubesAtGoal.Error);
        return measured;
    }

    // Adds the times of each of some poses, but for the warm-up.
    void Time(Action trace, int count, int round, Series times, Series kernels)
    {
        if (clock.IsOn)
            clock.Reset();
        var watch = Stopwatch.StartNew();
        trace();
        if (round == 0)
            return;
        times.Add(watch.Elapsed.TotalMilliseconds / count);
        if (clock.IsOn)
            kernels.Add(clock.Read() / count);
    }

    // The pose with its scene turned about the vertical through its origin.
    static RadarPose Turned(in RadarPose pose, double degrees)
    {
        double half = math.radians(degrees) / 2;
        var turn = Affine.FromTransform(0, new double4(0, math.sin(half), 0, math.cos(half)), 1);
        var instances = Array.ConvertAll(pose.Scene.Instances, instance =>
        {
            instance.ToWorld = turn * instance.ToWorld;
            return instance;
        });
        return new RadarPose(new RadarScene(instances), pose.Settings, pose.View);
    }

    static RadarPose PoseOf(AccuracyScene scene, in RadarSettings settings) => new(scene.Scene, settings, scene.View);

    static RadarSettings SettingsOf(double tolerance)
    {
        var settings = RadarSettings.Default;
        settings.ToleranceDb = 20 * Math.Log10(1 + tolerance);
        return settings;
    }
}
