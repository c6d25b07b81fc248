using System.Collections.Generic;
using System.Linq;

namespace Glint.Cli;

/// <summary>Seas that differ in nothing but the seed; the stored seed's is the first.</summary>
/// <param name="Sea">Name of the stored sea that they are like.</param>
/// <param name="IsStored">
/// Whether wind and choppiness are those of the stored sea: then the first is the stored sea itself.
/// </param>
sealed record SeaFamily(string Sea, bool IsStored, IReadOnlyList<SeaTrial> Trials)
{
    public SeaTrial First => Trials[0];

    public int Snapshots => Trials.Sum(trial => trial.Snapshots.Count);

    public int ReturningSnapshots => Trials.Sum(trial => trial.ReturningSnapshots);

    public double Share => (double)ReturningSnapshots / Snapshots;

    /// <summary>Returning snapshots of each sea.</summary>
    public Series PerSea => new(Trials.Select(trial => (double)trial.ReturningSnapshots));

    /// <summary>Other seas with fewer returning snapshots than the first, with as many, and with more.</summary>
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
