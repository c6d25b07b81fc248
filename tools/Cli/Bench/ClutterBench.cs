using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Glint.Core;
using Glint.Vulkan;
using Unity.Mathematics;

namespace Glint.Cli;

/// <summary>
/// Times sums of the diffuse echo of a sea, with one shadow ray a facet, beside the kernels of a pose's rays alone.
/// </summary>
sealed class ClutterBench : IDisposable
{
    const int SumsARound = 6;

    // Of the sea of --facets: far radar, degrees.
    static readonly double[] s_grazing = [1, 3, 10, 45];

    const double Wind = 10;

    readonly RadarPose _pose;
    readonly RayTracer _rays;
    readonly ClutterTracer _tracer;
    readonly GpuClock _clock;

    ClutterBench(RadarController radar, GpuClock clock, Func<RadarPose, IReadOnlyList<ClutterTime>> rows)
    {
        (_pose, _clock) = (radar.Gather(), clock);
        Rows = rows(_pose);
        _rays = new RayTracer(radar.Kernel, "clutter");
        _tracer = new ClutterTracer(radar.ClutterKernel, "clutter");
    }

    /// <summary>The poses of the sea.</summary>
    public IReadOnlyList<ClutterTime> Rows { get; }

    /// <summary>Device time of the kernels of the pose's rays, without clutter, one figure each round.</summary>
    public Series Rays { get; } = new();

    /// <summary>The seas of a scene, in the picture of its Camera; null if none has clutter.</summary>
    public static ClutterBench OfScene(RadarController radar, GpuClock clock) =>
        radar.Gather().Scene.Seas.Count == 0 ? null : new ClutterBench(radar, clock,
            pose => [new ClutterTime("the Camera's picture", CrossSectionPose.Of(pose))]);

    /// <summary>A tile of about so many facets of 1 m2, shaded by its copies.</summary>
    public static ClutterBench OfFacets(RadarController radar, GpuClock clock, int facets) =>
        new(radar, clock, _ =>
        {
            var sea = SeaOf(facets);
            return [.. s_grazing.Select(grazing => new ClutterTime(FormattableString.Invariant($"{grazing} deg of grazing"),
                sea.PoseOf(0, grazing, RadarSettings.Default.FrequencyHz)))];
        });

    /// <summary>Times each pose. Wall time and device time take turns, as the device's clock adds to the wall time.</summary>
    /// <param name="counts">False for a warm-up.</param>
    public void RunRound(bool counts, CancellationToken cancel)
    {
        var rays = TimeKernels(() => _rays.Trace(_pose, RayReadback.None, null, cancel));
        if (counts)
            Rays.Add(rays);
        foreach (var row in Rows)
        {
            void Sum() => row.Echo = _tracer.Trace(row.Pose, row.Pose.Frequencies[0], null, null, cancel).Single();
            Sum(); // uploads the scene
            double wall = Median(() =>
            {
                var watch = Stopwatch.StartNew();
                Sum();
                return watch.Elapsed.TotalMilliseconds;
            });
            double kernels = TimeKernels(Sum);
            if (!counts)
                continue;
            row.Wall.Add(wall);
            row.Kernels.Add(kernels);
        }
    }

    public void Dispose()
    {
        _rays.Dispose();
        _tracer.Dispose();
    }

    // NaN without a clock.
    double TimeKernels(Action work)
    {
        if (!_clock.IsSupported)
            return double.NaN;
        work();
        _clock.IsOn = true;
        try
        {
            return Median(() =>
            {
                _clock.Reset();
                work();
                return _clock.Read();
            });
        }
        finally
        {
            _clock.IsOn = false;
        }
    }

    static double Median(Func<double> time) => new Series(Enumerable.Range(0, SumsARound).Select(_ => time())).Median;

    static EndlessSea SeaOf(int facets)
    {
        var settings = SeaSettings.Default;
        settings.Cells = (int)Math.Round(Math.Sqrt(facets / 2.0));
        (settings.WindSpeed, settings.TileSize) = (Wind, Math.Round(Math.Sqrt(facets)));
        settings.GridSize = Math.Clamp(math.ceilpow2(settings.Cells) / 2, 4, 1024);
        var surface = new SeaSurface(settings);
        var clutter = new SeaClutter(surface, 0, new double3(0, 0, 1), SeaClutterSettings.On);
        var tile = new MeshInstance { Mesh = surface.Mesh(0), ToWorld = Affine.Identity };
        var sea = new RadarSea(clutter, [new SeaTileInstance(0, 0)]);
        return new EndlessSea(new RadarScene(tile) { Seas = [sea] }, sea);
    }
}

/// <summary>A pose of a sea, and the times of its sums.</summary>
sealed class ClutterTime(string what, CrossSectionPose pose)
{
    public string What { get; } = what;

    public CrossSectionPose Pose { get; } = pose;

    /// <summary>Facets of all seas.</summary>
    public long Facets { get; } = pose.Scene.Seas.Sum(sea =>
        sea.Tiles.Sum(tile => (long)pose.Scene.Instances[tile.Instance].Mesh.TriangleCount));

    /// <summary>Wall time of a sum, and device time of its kernels, milliseconds, one figure each round.</summary>
    public Series Wall { get; } = new();
    public Series Kernels { get; } = new();

    /// <summary>The last echo.</summary>
    public ClutterEcho Echo { get; set; }
}
