using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;

namespace Glint.Cli;

/// <summary>The sweep of an experiment with its published table.</summary>
/// <param name="Published">Null without a published table.</param>
sealed record SweepResult(Experiment Experiment, IReadOnlyList<PublishedRow> Published, IReadOnlyList<SweepRow> Rows)
{
    /// <summary>The poses; the published row is null without a table.</summary>
    public IEnumerable<(double Step, PublishedRow Theirs, RadarResult Ours)> Poses =>
        Rows.Select(
            row => (StepOf(row.Pose), Published?.Single(published => published.Step == StepOf(row.Pose)), row.Result));

    /// <summary>Unit of the steps: "deg" or "snapshot".</summary>
    public string StepName => Rows[0].Pose.AngleDegrees.HasValue ? "deg" : "snapshot";

    /// <summary>Angle in degrees; without a turning target the snapshot.</summary>
    public static double StepOf(SweepPose pose) => pose.AngleDegrees ?? pose.Snapshot.Value;
}
