using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;

namespace Glint.Cli;

/// <summary>An experiment as it was swept, beside what was published.</summary>
/// <param name="Published">Null where no table was.</param>
sealed record SweepResult(Experiment Experiment, IReadOnlyList<PublishedRow> Published, IReadOnlyList<SweepRow> Rows)
{
    /// <summary>Pose by pose. The published row is null where no table was.</summary>
    public IEnumerable<(double Step, PublishedRow Theirs, RadarResult Ours)> Poses =>
        Rows.Select(
            row => (StepOf(row.Pose), Published?.Single(published => published.Step == StepOf(row.Pose)), row.Result));

    /// <summary>What the steps are: "deg" or "snapshot".</summary>
    public string StepName => Rows[0].Pose.AngleDegrees.HasValue ? "deg" : "snapshot";

    /// <summary>The angle in degrees; where nothing is turned the snapshot.</summary>
    public static double StepOf(SweepPose pose) => pose.AngleDegrees ?? pose.Snapshot.Value;
}
