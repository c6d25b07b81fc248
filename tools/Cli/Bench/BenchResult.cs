using System.Collections.Generic;
using Glint.Core;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>All that a benchmark found out.</summary>
sealed class BenchResult
{
    /// <summary>Name of the scene; its path, null for the built-in one.</summary>
    public string Subject { get; init; }
    public string Scene { get; init; }

    public DeviceInfo Device { get; init; }

    public RadarSettings Settings { get; init; }
    public int Rounds { get; init; }
    public PoseBench Poses { get; init; }
    public IReadOnlyList<Peer> Peers { get; init; }

    /// <summary>
    /// Nodes and triangle pairs of a pose of the scene as it stands, counted in one that was not timed.
    /// </summary>
    public long NodesVisited { get; set; }
    public long PairsTested { get; set; }

    /// <summary>Null when nothing was compared.</summary>
    public ReferenceCheck Errors { get; set; }

    /// <summary>Why nothing was compared; null when it was, or when that was asked for.</summary>
    public string NotCompared { get; set; }
}
