using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Editor;

namespace Glint.Cli;

/// <summary>Plots of sweeps and published tables: amplitude, rays received and rays hit over the steps.</summary>
static class ExperimentPlots
{
    public const string Ours = "#0072b2", Theirs = "#d55e00";

    public static void Write(Stream stream, SweepResult sweep)
    {
        var poses = sweep.Poses.ToArray();
        Panel NewPanel(string title, Func<double, ValueScale> scale, Func<Glint.Core.RadarResult, double> ours,
            Func<PublishedRow, double> theirs)
        {
            var lines = new List<ChartLine> { new("Glint", Ours, [.. poses.Select(pose => ours(pose.Ours))]) };
            if (sweep.Published != null)
                lines.Insert(0, new("published", Theirs, [.. poses.Select(pose => theirs(pose.Theirs))]));
            return new Panel(title, scale(lines.Max(line => line.Values.Max())), [.. lines]);
        }
        Chart.Write(stream, sweep.Experiment.Title, [.. poses.Select(pose => pose.Step)],
            sweep.StepName == "deg" ? "turn, degrees" : sweep.StepName,
            NewPanel("amplitude, dB (20 log A)", ValueScale.Decibels, ours => ours.Amplitude,
                theirs => theirs.Amplitude),
            NewPanel("rays received", ValueScale.Counts, ours => ours.RaysReceived, theirs => theirs.RaysReceived),
            NewPanel("rays hit", ValueScale.Linear, ours => ours.RaysHit, theirs => theirs.RaysHit));
    }

    public static void Write(Stream stream, SnapshotsResult ships)
    {
        var angles = ships.Angles.ToArray();
        Panel NewPanel(string title, Func<double, ValueScale> scale,
            Func<PublishedRow, double> theirs, Func<int, Series> ours)
        {
            var all = Enumerable.Range(0, angles.Length).Select(ours).ToArray();
            ChartLine[] lines =
            [
                new("published, one snapshot", Theirs, [.. angles.Select(angle => theirs(angle.Theirs))]),
                new("Glint, median and range of all", Ours, [.. all.Select(series => series.Median)],
                    [.. all.Select(series => series.Lowest)], [.. all.Select(series => series.Highest)]),
            ];
            return new Panel(title, scale(Math.Max(lines[0].Values.Max(), lines[1].Highest.Max())), lines);
        }
        Chart.Write(stream, ships.Title, [.. angles.Select(angle => angle.Theirs.Step)], "turn, degrees",
            NewPanel("amplitude, dB (20 log A)", ValueScale.Decibels, theirs => theirs.Amplitude,
                i => angles[i].Amplitude),
            NewPanel("rays received", ValueScale.Counts, theirs => theirs.RaysReceived, i => angles[i].Received),
            NewPanel("rays hit", ValueScale.Linear, theirs => theirs.RaysHit, i => angles[i].Hit));
    }
}
