using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;

namespace Glint.Cli;

/// <summary>The ship turned on every snapshot of a sea.</summary>
/// <param name="Name">Name in file names and markers.</param>
/// <param name="Published">The published experiment with the ship on one sea of this state.</param>
/// <param name="Rows">Rows of every angle for each snapshot.</param>
sealed record SnapshotsResult(string Name, string Title, IReadOnlyList<PublishedRow> Published,
    IReadOnlyList<SweepRow> Rows)
{
    public static string NameOf(Experiment ship) => $"{ship.Name}-all-snapshots";

    public static string TitleOf(Experiment ship) => $"{ship.Title}, every snapshot";

    public int Snapshots => Rows.Max(row => row.Pose.Snapshot.Value);

    /// <summary>The rows of all snapshots at each angle.</summary>
    public IEnumerable<(PublishedRow Theirs, Series Received, Series Amplitude, Series Hit)> Angles =>
        Published.Select(theirs =>
        {
            var ours = Rows.Where(row => row.Pose.AngleDegrees == theirs.Step).Select(row => row.Result).ToArray();
            return (theirs, new Series(ours.Select(result => (double)result.RaysReceived)),
                new Series(ours.Select(result => result.Amplitude)),
                new Series(ours.Select(result => (double)result.RaysHit)));
        });
}
