using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Cli;

/// <summary>The radar's results of one sea without a ship, at each of its times.</summary>
/// <param name="Waves">The sea's settings, with its own height factor.</param>
/// <param name="Snapshots">Results in the order of the times.</param>
sealed record SeaTrial(SeaSettings Waves, IReadOnlyList<RadarResult> Snapshots)
{
    /// <summary>Number of snapshots with at least one received ray.</summary>
    public int ReturningSnapshots => Snapshots.Count(snapshot => snapshot.RaysReceived > 0);
}
