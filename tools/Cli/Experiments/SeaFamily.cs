using System.Collections.Generic;
using System.Linq;

namespace Glint.Cli;

/// <summary>Seas that differ only in the seed; the first has the stored seed.</summary>
/// <param name="Sea">Name of the stored sea.</param>
/// <param name="IsStored">
/// True if wind and choppiness are the stored sea's; the first sea is then the stored sea itself.
/// </param>
sealed record SeaFamily(string Sea, bool IsStored, IReadOnlyList<SeaTrial> Trials)
{
    public SeaTrial First => Trials[0];

    public int Snapshots => Trials.Sum(trial => trial.Snapshots.Count);

    public int ReturningSnapshots => Trials.Sum(trial => trial.ReturningSnapshots);

    public double Share => (double)ReturningSnapshots / Snapshots;

    /// <summary>Number of returning snapshots of each sea.</summary>
    public Series PerSea => new(Trials.Select(trial => (double)trial.ReturningSnapshots));

    /// <summary>Numbers of other seas with fewer, as many and more returning snapshots than the first.</summary>
    public (int Fewer, int AsMany, int More) Rank
    {
        get
        {
            var others = Trials.Skip(1).Select(trial => trial.ReturningSnapshots).ToArray();
            return (others.Count(count => count < First.ReturningSnapshots),
                others.Count(count => count == First.ReturningSnapshots),
                others.Count(count => count > First.ReturningSnapshots));
        }
    }
}
