using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Cli;

/// <summary>One sea at each of its times, as the radar sees it without anything on it.</summary>
/// <param name="Waves">What it was made from, its own height factor included.</param>
/// <param name="Snapshots">In the order of the times.</param>
sealed record SeaTrial(SeaSettings Waves, IReadOnlyList<RadarResult> Snapshots)
{
    /// <summary>Snapshots from which at least one ray was received.</summary>
    public int ReturningSnapshots => Snapshots.Count(snapshot => snapshot.RaysReceived > 0);
}
