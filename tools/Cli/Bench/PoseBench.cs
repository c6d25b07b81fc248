using System;
using System.Diagnostics;
using System.Threading;
using Glint.Core;
using Glint.Vulkan;
using UnityEngine;

namespace Glint.Cli;

/// <summary>Times a radar's poses: the first, which builds the BVHs, and later ones as in a sweep.</summary>
sealed class PoseBench(RadarController radar, Transform target, GpuClock clock)
{
    /// <summary>Turn of the target from one pose to the next.</summary>
    public const double StepDegrees = 0.001;

    const int FirstPoses = 3, PosesARound = 6;

    static readonly TimeSpan FirstPosesTime = TimeSpan.FromSeconds(10), RoundTime = TimeSpan.FromSeconds(2);

    readonly Quaternion _rotation = target == null ? Quaternion.identity : target.rotation;
    int _steps;

    /// <summary>
    /// Times of first poses: gathering (the very first pose only), building BVHs, uploading, and all together with
    /// compiling the kernels.
    /// </summary>
    public Series FirstGather { get; } = new();
    public Series Build { get; } = new();
    public Series FirstUpload { get; } = new();
    public Series FirstPose { get; } = new();

    /// <summary>Times of later poses, one each round: wall time, device time of the kernels, and phases.</summary>
    public Series Pose { get; } = new();
    public Series PoseGpu { get; } = new();
    public Series Gather { get; } = new();
    public Series Upload { get; } = new();
    public Series Trace { get; } = new();
    public Series ReadBack { get; } = new();

    /// <summary>
    /// Time of a later pose outside its kernels. Without a device clock: outside tracing and summing.
    /// </summary>
    public Series Other { get; } = new();

    /// <summary>Sums of the scene with the target unturned, and the statistics of its first pose.</summary>
    public RadarResult First { get; private set; }

    /// <summary>Statistics of a later pose, without the visits.</summary>
    public TraceStatistics Statistics { get; private set; }

    /// <summary>Traces the scene several times, each time from nothing.</summary>
    public void RunFirst(IProgress<double> progress, CancellationToken cancel)
    {
        var total = Stopwatch.StartNew();
        for (int i = 0; i < FirstPoses && (i == 0 || total.Elapsed < FirstPosesTime); i++)
        {
            radar.Release();
            if (target != null)
                radar.ExpectMotion(target);
            double wall = Time(new Part(progress, i, FirstPoses), cancel, out var result);
            First ??= result;
            if (i == 0)
                FirstGather.Add(result.Statistics.Timings.GatherMs);
            Build.Add(result.Statistics.Timings.BuildMs);
            FirstUpload.Add(result.Statistics.Timings.UploadMs);
            FirstPose.Add(wall);
        }
    }

    /// <summary>
    /// Traces poses, each with the target turned by a further step. Wall time and device time take turns, since the
    /// device's clock adds to the wall time.
    /// </summary>
    /// <param name="counts">False for a warm-up.</param>
    public void RunRound(bool counts, IProgress<double> progress, CancellationToken cancel)
    {
        Series wall = new(), gpu = new(), gather = new(), upload = new(), trace = new(),
            readBack = new(), other = new();
        var total = Stopwatch.StartNew();
        for (int i = 0; i < PosesARound && (i == 0 || total.Elapsed < RoundTime); i++)
        {
            Turn();
            wall.Add(Time(new Part(progress, 2 * i, 2 * PosesARound), cancel, out var result));
            Statistics = result.Statistics;
            gather.Add(result.Statistics.Timings.GatherMs);
            upload.Add(result.Statistics.Timings.BuildMs + result.Statistics.Timings.UploadMs);
            trace.Add(result.Statistics.Timings.TraceMs);
            readBack.Add(result.Statistics.Timings.ReadBackMs);
            if (clock.IsSupported)
            {
                Turn();
                gpu.Add(TimeOnDevice(new Part(progress, 2 * i + 1, 2 * PosesARound), cancel, out double onHost));
                other.Add(onHost);
            }
            else
                other.Add(result.Statistics.Timings.GatherMs + result.Statistics.Timings.BuildMs
                    + result.Statistics.Timings.UploadMs);
        }
        if (!counts)
            return;
        Pose.Add(wall.Median);
        Gather.Add(gather.Median);
        Upload.Add(upload.Median);
        Trace.Add(trace.Median);
        ReadBack.Add(readBack.Median);
        Other.Add(other.Median);
        if (gpu.Count > 0)
            PoseGpu.Add(gpu.Median);
    }

    /// <summary>Restores the scene and frees the device's buffers.</summary>
    public void End()
    {
        if (target != null)
            target.rotation = _rotation;
        radar.Release();
    }

    void Turn()
    {
        if (target != null)
            target.rotation = Quaternion.AngleAxis((float)(++_steps * StepDegrees), Vector3.up) * _rotation;
    }

    double Time(IProgress<double> progress, CancellationToken cancel, out RadarResult result)
    {
        var watch = Stopwatch.StartNew();
        result = radar.Trace(RayReadback.None, progress, cancel);
        return watch.Elapsed.TotalMilliseconds;
    }

    double TimeOnDevice(IProgress<double> progress, CancellationToken cancel, out double onHost)
    {
        clock.IsOn = true;
        try
        {
            clock.Reset();
            double wall = Time(progress, cancel, out _), device = clock.Read();
            onHost = wall - device;
            return device;
        }
        finally
        {
            clock.IsOn = false;
        }
    }
}
