using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>Results beside published tables, in Markdown.</summary>
static class ExperimentTables
{
    const string None = "-";

    /// <summary>Agreement of sweeps and tables.</summary>
    public static string Summary(ExperimentsResult result)
    {
        var table = new MarkdownTable("", "poses", "rays hit, times theirs", "both return, neither",
            "rays received, times theirs", "amplitude, dB over theirs", "correlation of amplitudes");
        foreach (var sweep in result.Sweeps.Where(sweep => sweep.Published != null))
        {
            var agreement = new Agreement(sweep);
            table.Add(sweep.Experiment.Title, Text($"{agreement.Poses}"), Range(agreement.Hit, "0.000"),
                Text($"{agreement.Both}, {agreement.Neither}"),
                Range(agreement.Received, "0.00"), Range(agreement.AmplitudeDb, "+0.0;-0.0;0.0"),
                double.IsNaN(agreement.AmplitudeCorrelation) ? None : Text($"{agreement.AmplitudeCorrelation:0.000}"));
        }
        return $"{table}\nMedian (lowest to highest). "
            + "Amplitudes and rays received are compared where both return rays, the correlation is over all poses. "
            + Text($"{result.Device.Name}, driver {result.Device.Driver}, Glint {GlintVersion.Text}.\n");
    }

    /// <summary>Every pose, published and ours.</summary>
    public static string Of(SweepResult sweep)
    {
        string step = sweep.StepName;
        if (sweep.Published == null)
        {
            var ours = new MarkdownTable(step, "amplitude", "rays received", "rays hit", "received / hit, %");
            foreach (var pose in sweep.Poses)
                ours.Add(Step(pose.Step), Amplitude(pose.Ours.Amplitude), Count(pose.Ours.RaysReceived),
                    Count(pose.Ours.RaysHit), Ratio(pose.Ours.Ratio));
            return ours.ToString();
        }
        var table = new MarkdownTable(step, "amplitude, theirs", "ours", "rays received, theirs", "ours",
            "rays hit, theirs", "ours", "received / hit, theirs, %", "ours, %", "amplitude, dB over theirs");
        foreach (var (at, theirs, ours) in sweep.Poses)
            table.Add(Step(at), Amplitude(theirs.Amplitude), Amplitude(ours.Amplitude), Count(theirs.RaysReceived),
                Count(ours.RaysReceived),
                Count(theirs.RaysHit), Count(ours.RaysHit), Ratio(theirs.Ratio), Ratio(ours.Ratio),
                Agreement.Decibels(ours.Amplitude, theirs.Amplitude) is double decibels
                    ? Text($"{decibels:+0.0;-0.0;0.0}")
                    : None);
        return $"{table}\n{Differences(new Agreement(sweep))}\n";
    }

    static string Differences(Agreement agreement)
    {
        string text = Text(
                $"Differences from the table: rays hit {agreement.HitDifferencePercent.Mean:0.0000} % (mean) and {agreement.HitDifferencePercent.Highest:0.0000} % (largest), ")
            + Text(
                $"rays received {agreement.ReceivedDifference.Mean:0.0} and {agreement.ReceivedDifference.Highest:0}");
        var amplitude = agreement.AmplitudeDifferenceDb;
        return amplitude.Count == 0
            ? $"{text}."
            : text + Text(
                $", amplitude {amplitude.Median:0.0} dB (median) and {amplitude.Highest:0.0} dB (largest) in the {amplitude.Count} poses where both receive rays and the published amplitude is above {Agreement.MinComparedAmplitude}.");
    }

    /// <summary>Every angle: the ship's own rays and those that met the sea.</summary>
    public static string Of(IReadOnlyList<SeaShare> angles)
    {
        var table = new MarkdownTable(["deg", "amplitude in free space", "on the sea",
            "on the sea, rays of the ship alone", "these rays", "lost", "rays that met the sea",
            .. Enumerable.Range(1, angles[0].Added.Length)
                .Select(bounces => bounces == 1 ? "by 1 bounce" : Text($"by {bounces}"))]);
        foreach (var angle in angles)
            table.Add([Step(angle.Step), Amplitude(angle.FreeSpace), Amplitude(angle.OnSea), Amplitude(angle.ShipAlone),
                Count(angle.Unchanged), Count(angle.Lost), Count(angle.Added.Sum()),
                .. angle.Added.Select(count => Count(count))]);
        return table.ToString();
    }

    /// <summary>Every angle, published and ours over all snapshots.</summary>
    public static string Of(SnapshotsResult ships)
    {
        var table = new MarkdownTable("deg", "amplitude, theirs", "ours, median", "lowest", "highest",
            "rays received, theirs", "ours, median", "lowest", "highest", "rays hit, theirs", "ours, median");
        foreach (var (theirs, received, amplitude, hit) in ships.Angles)
            table.Add(Step(theirs.Step), Amplitude(theirs.Amplitude), Amplitude(amplitude.Median),
                Amplitude(amplitude.Lowest), Amplitude(amplitude.Highest),
                Count(theirs.RaysReceived), Count(received.Median), Count(received.Lowest),
                Count(received.Highest), Count(theirs.RaysHit), Count(hit.Median));
        return $"{table}\nOver {ships.Snapshots} snapshots.\n";
    }

    /// <summary>Each wind and choppiness, then each seed of the stored pair.</summary>
    public static string OfSeas(ExperimentsResult result)
    {
        var families = new MarkdownTable("sea", "wind, m/s", "choppiness", "snapshots that return", "share, %",
            "of each seed's, median (lowest to highest)", "seeds with none", "stored seed",
            "other seeds with fewer, as many, more");
        foreach (var family in result.Seas)
        {
            var waves = family.First.Waves;
            var (fewer, asMany, more) = family.Rank;
            families.Add(family.Sea + (family.IsStored ? ", as stored" : ""), Text($"{waves.WindSpeed:0.##}"),
                Text($"{waves.Choppiness:0.##}"), Text($"{family.ReturningSnapshots} of {family.Snapshots}"),
                Text($"{100 * family.Share:0.0}"),
                Range(family.PerSea, "0.#"),
                Text($"{family.Trials.Count(trial => trial.ReturningSnapshots == 0)} of {family.Trials.Count}"),
                Text($"{family.First.ReturningSnapshots} of {family.First.Snapshots.Count}"),
                Text($"{fewer}, {asMany}, {more}"));
        }
        return families + string.Concat(result.Seas.Where(family => family.IsStored)
            .Select(family => $"\n{family.Sea}, wind and choppiness as stored:\n\n{Seeds(family)}"));
    }

    static string Seeds(SeaFamily family)
    {
        var table = new MarkdownTable("seed", "snapshots that return", "rays received, snapshot by snapshot",
            "rays hit, median (lowest to highest)");
        foreach (var trial in family.Trials)
            table.Add(Text($"{trial.Waves.Seed}{(trial == family.First ? " (stored)" : "")}"),
                Text($"{trial.ReturningSnapshots}"),
                string.Join(" ", trial.Snapshots.Select(snapshot => Text($"{snapshot.RaysReceived}"))),
                Range(new Series(trial.Snapshots.Select(snapshot => (double)snapshot.RaysHit)), "#,0"));
        return table.ToString();
    }

    static string Step(double value) => Numbers.Format(value);

    static string Amplitude(double value) => Text($"{value:0.00}");

    static string Count(double value) => Text($"{value:#,0.#}");

    static string Ratio(double value) => Text($"{100 * value:0.0000}");

    static string Range(Series series, string format) =>
        series.Count == 0
            ? None
            : $"{Shown(series.Median, format)} ({Shown(series.Lowest, format)} to {Shown(series.Highest, format)})";

    static string Shown(double value, string format) =>
        value.ToString(format, System.Globalization.CultureInfo.InvariantCulture);
}
