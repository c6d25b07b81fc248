using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using Glint.Host;
using Spectre.Console;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>
/// The command glint experiments: runs the published sweeps, the ship on every snapshot and seas of many seeds, and
/// writes tables, plots and figures.
/// </summary>
sealed class ExperimentsCommand(Terminal terminal)
{
    /// <returns>The report, line by line.</returns>
    /// <exception cref="GlintException">A file, a scene or the device fails.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public string[] Execute(CommandLine line, IProgressSink progress)
    {
        var files = new ExperimentFiles(ExperimentOptions.Out.Flag,
            line.Get(ExperimentOptions.Out) ?? RunDescription.DefaultFolder("experiments"));
        var watch = Stopwatch.StartNew();
        var runs = new ExperimentRuns(progress);
        var result = new ExperimentsResult { Device = GraphicsDevice.Current.Info };
        foreach (var experiment in Experiment.All)
            result.Sweeps.Add(runs.Sweep(experiment));
        result.Reflector = runs.Pictures(Experiment.CornerReflector, ReflectorPicture.Angles);
        foreach (var (sea, ship) in Experiment.Seas)
            result.Ships.Add(runs.SweepAllSnapshots(sea, ship));
        foreach (var stored in StoredSeas.All)
            result.Seas.AddRange(runs.Study(
                Experiment.Seas.Single(pair => Path.GetFileNameWithoutExtension(pair.Sea.Scene) == stored.Name).Sea,
                stored, line.Get(ExperimentOptions.Seeds)));
        result.Elapsed = watch.Elapsed;
        return [.. Report(result), $"written: {files.Write(result)}"];
    }

    IEnumerable<string> Report(ExperimentsResult result)
    {
        var text = new TableText(terminal);
        var table = text.New(1, "medians, times the published", "poses", "hit", "received", "amplitude, dB");
        foreach (var sweep in result.Sweeps.Where(sweep => sweep.Published != null))
        {
            var agreement = new Agreement(sweep);
            table.AddRow(
                Escaped(sweep.Experiment.Title, Text($"{agreement.Poses}"), Text($"{agreement.Hit.Median:0.000}"),
                    Text($"{agreement.Received.Median:0.00}"), Text($"{agreement.AmplitudeDb.Median:+0.0;-0.0;0.0}")));
        }
        foreach (string row in text.Lines(table))
            yield return row;
        yield return "";
        foreach (var family in result.Seas.Where(family => family.IsStored))
            yield return Text(
                $"{family.Sea}: {family.First.ReturningSnapshots} of {family.First.Snapshots.Count} stored snapshots return rays, as {family.ReturningSnapshots} of {family.Snapshots} of all seeds do; published: {result.PublishedReturns(family.Sea).ReturningSnapshots} of {result.PublishedReturns(family.Sea).Snapshots}");
    }
}
