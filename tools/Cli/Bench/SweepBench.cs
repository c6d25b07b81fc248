using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Glint.Core;
using Glint.Editor;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>
/// Times sweeps that turn the target by a step a pose, with poses in flight and rows in a temporary results folder.
/// </summary>
sealed class SweepBench(LoadedScene loaded, int poses, GpuClock clock)
{
    readonly SweepSetup _setup = loaded.Sweep(
        new SweepPlan([.. Enumerable.Range(0, poses).Select(i => i * PoseBench.StepDegrees)]));

    TraceStatistics[] _last = [];

    /// <summary>Poses of a sweep.</summary>
    public int Poses => poses;

    /// <summary>
    /// Milliseconds a pose, one figure each round: from the first row to the last, divided by the poses between.
    /// </summary>
    public Series Wall { get; } = new();

    /// <summary>Device time of a pose's kernels in milliseconds, in a sweep of its own each round.</summary>
    public Series Kernels { get; } = new();

    /// <summary>The parts of <see cref="Wall"/>, times of the main thread.</summary>
    public IReadOnlyList<(string Name, string Title, Series Time)> Parts { get; } =
    [
        ("gather", "gather", new()), ("build_and_upload", "build and upload", new()),
        ("dispatch", "list tiles, dispatch", new()), ("wait", "wait for the device", new()),
        ("finish", "sums and sampling error", new()), ("write", "write the row", new()), ("other", "other", new()),
    ];

    /// <summary>Rows that the last sweep wrote.</summary>
    public int Rows { get; private set; }

    /// <summary>The mean of a count over the poses of the last sweep.</summary>
    public double Mean(Func<TraceStatistics, double> count) => _last.Average(count);

    /// <summary>
    /// Runs a sweep by the wall clock, and another by the device's clock, which adds to the wall time.
    /// </summary>
    /// <param name="counts">False for a warm-up.</param>
    public void RunRound(bool counts, IProgress<double> progress, CancellationToken cancel)
    {
        loaded.Radar.ExpectMotion(loaded.Target); // so that no sweep builds BVHs again
        Sweep(new Part(progress, 0, 2), cancel, out double wall, out var parts);
        double kernels = clock.IsSupported ? TimeOnDevice(new Part(progress, 1, 2), cancel) : double.NaN;
        if (!counts)
            return;
        Wall.Add(wall);
        foreach (var (part, time) in Parts.Zip(parts))
            part.Time.Add(time);
        if (clock.IsSupported)
            Kernels.Add(kernels);
    }

    double TimeOnDevice(IProgress<double> progress, CancellationToken cancel)
    {
        clock.IsOn = true;
        try
        {
            clock.Reset();
            Sweep(progress, cancel, out _, out _);
            return clock.Read() / poses;
        }
        finally
        {
            clock.IsOn = false;
        }
    }

    void Sweep(IProgress<double> progress, CancellationToken cancel, out double wall, out double[] parts)
    {
        string path = Directory.CreateTempSubdirectory("glint-bench-").FullName;
        try
        {
            using var folder = ResultsFolder.Open(path);
            using var run = new SweepRun(_setup, folder) { PosesAhead = int.MaxValue };
            var rows = new List<TraceStatistics>();
            TimeSpan firstRow = default, firstWriting = default;
            while (!run.IsComplete)
            {
                rows.Add(run.Step(new Part(progress, run.Done, poses), cancel).Result.Statistics);
                if (run.Done == 1)
                    (firstRow, firstWriting) = (run.RowWritten, run.Writing);
            }
            _last = [.. rows];
            Rows = folder.Rows.Count;
            wall = (run.RowWritten - firstRow).TotalMilliseconds / (poses - 1);
            parts = PartsOf([.. rows.Select(row => row.Timings)], run.Writing - firstWriting, wall);
        }
        finally
        {
            Directory.Delete(path, true);
        }
    }

    // All poses but the first are finished between the first row and the last. Only those after the second are surely
    // started there: the second one starts before the first row if poses overlap.
    static double[] PartsOf(Timings[] rows, TimeSpan writing, double wall)
    {
        var (finished, started) = (rows[1..], rows[2..]);
        double[] starting =
        [
            started.Average(pose => pose.GatherMs), started.Average(pose => pose.BuildMs + pose.UploadMs),
            started.Average(pose => pose.DispatchMs)
        ];
        double[] finishing =
        [
            finished.Average(pose => pose.WaitMs), finished.Average(pose => pose.FinishMs),
            writing.TotalMilliseconds / finished.Length
        ];
        return [.. starting, .. finishing, wall - starting.Sum() * started.Length / finished.Length - finishing.Sum()];
    }
}
