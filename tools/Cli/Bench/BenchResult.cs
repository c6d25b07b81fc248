using System.Collections.Generic;
using Glint.Core;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>Results of a benchmark.</summary>
sealed class BenchResult
{
    /// <summary>Name of the scene; its path, null for the built-in one.</summary>
    public string Subject { get; init; }
    public string Scene { get; init; }

    public DeviceInfo Device { get; init; }

    public RadarSettings Settings { get; init; }
    public int Rounds { get; init; }

    /// <summary>Single poses; null if sweeps were timed.</summary>
    public PoseBench Poses { get; init; }

    /// <summary>Sweeps; null if single poses were timed.</summary>
    public SweepBench Sweep { get; init; }

    /// <summary>Wall time of a pose, and device time of its kernels.</summary>
    public Series Pose => Sweep?.Wall ?? Poses.Pose;
    public Series Kernels => Sweep?.Kernels ?? Poses.PoseGpu;

    /// <summary>The diffuse echo of a sea; null if there is none.</summary>
    public ClutterBench Clutter { get; set; }

    public IReadOnlyList<Peer> Peers { get; init; }

    /// <summary>
    /// Nodes and triangle pairs of a pose with the target unturned, counted in a pose that was not timed.
    /// </summary>
    public long NodesVisited { get; set; }
    public long PairsTested { get; set; }

    /// <summary>Null without a comparison.</summary>
    public ReferenceCheck Errors { get; set; }

    /// <summary>Why there is no comparison; null if there is one or none was wanted.</summary>
    public string NotCompared { get; set; }
}
