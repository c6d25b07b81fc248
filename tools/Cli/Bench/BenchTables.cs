using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Spectre.Console;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>A benchmark's figures as tables.</summary>
sealed class BenchTables(Terminal terminal)
{
    readonly TableText _text = new(terminal);

    public IEnumerable<string> Lines(BenchResult result)
    {
        var settings = result.Settings;
        yield return Text($"{result.Subject} on {result.Device.Name}, driver {result.Device.Driver}");
        yield return Text(
            $"{settings.RaysAcross} x {settings.RaysDown} rays{RegionText(settings.Region)}, at most {settings.MaxBounces} bounces, {settings.FrequencyHz / 1e9:g6} GHz; medians and lowest of {result.Rounds} rounds");
        var tables = result.Sweep == null
            ? new[] { Times(result), Clutter(result.Clutter), Statistics(result), Errors(result), Peers(result) }
            : [SweepTimes(result.Sweep), SweepStatistics(result.Sweep), Peers(result)];
        foreach (var table in tables.Where(table => table != null))
        {
            yield return "";
            foreach (string line in _text.Lines(table))
                yield return line;
        }
        if (result.NotCompared != null)
            yield return result.NotCompared;
        foreach (var peer in result.Peers)
            yield return $"{peer.Name} ended with: {peer.LastLine}";
        if (result.Peers.Count > 0)
            yield return "Ratios: the peer's median over Glint's, and its lowest over Glint's lowest.";
    }

    Table Times(BenchResult result)
    {
        var poses = result.Poses;
        var table = _text.New(1, "time, ms", "median", "lowest");
        void Add(string what, Series series) => table.AddRow(Escaped(what, Ms(series.Median), Ms(series.Lowest)));
        Add("first pose: gather", poses.FirstGather);
        Add("first pose: build BVHs", poses.Build);
        Add("first pose: upload", poses.FirstUpload);
        Add("first pose", poses.FirstPose);
        Add("next pose: gather", poses.Gather);
        Add("next pose: build and upload", poses.Upload);
        Add("next pose: trace and sum", poses.Trace);
        Add("  of it read-back", poses.ReadBack);
        Add("next pose", poses.Pose);
        if (poses.PoseGpu.Count > 0)
            Add("next pose: kernels, by the device's clock", poses.PoseGpu);
        Add(poses.PoseGpu.Count > 0 ? "next pose: all but the kernels" : "next pose: all but trace and sum",
            poses.Other);
        return table;
    }

    Table Clutter(ClutterBench clutter)
    {
        if (clutter == null)
            return null;
        var table = _text.New(1, "diffuse echo of the sea", "facets", "lit, %", "a sum, ms", "kernels, ms", "lowest",
            "/ rays");
        foreach (var row in clutter.Rows)
            table.AddRow(Escaped(row.What, Text($"{row.Facets:N0}"), Text($"{100 * row.Echo.LitFraction:0.0}"),
                Ms(row.Wall.Median), Ms(row.Kernels.Median), Ms(row.Kernels.Lowest),
                Text($"{row.Kernels.Median / clutter.Rays.Median:0.000}")));
        table.AddRow(Escaped("rays without clutter", "", "", "", Ms(clutter.Rays.Median), Ms(clutter.Rays.Lowest), ""));
        return table;
    }

    Table SweepTimes(SweepBench sweep)
    {
        var table = _text.New(1, Text($"sweep of {sweep.Poses:N0} poses, ms a pose"), "median", "lowest");
        void Add(string what, Series series) => table.AddRow(Escaped(what, Ms(series.Median), Ms(series.Lowest)));
        Add("from the first row to the last", sweep.Wall);
        foreach (var (_, title, time) in sweep.Parts)
            Add("  " + title, time);
        if (sweep.Kernels.Count > 0)
            Add("kernels, by the device's clock", sweep.Kernels);
        return table;
    }

    Table SweepStatistics(SweepBench sweep)
    {
        var table = _text.New(1, "a pose", "");
        void Add(string what, double mean) => table.AddRow(Escaped(what, Text($"{mean:#,0.##}")));
        Add("poses a second", 1000 / sweep.Wall.Median);
        if (sweep.Kernels.Count > 0)
            Add("wall time over kernels", sweep.Wall.Median / sweep.Kernels.Median);
        Add("dispatches", sweep.Mean(pose => pose.Dispatches));
        Add("round trips", sweep.Mean(pose => pose.RoundTrips));
        Add("bytes uploaded", sweep.Mean(pose => pose.BytesUploaded));
        Add("bytes read back", sweep.Mean(pose => pose.BytesReadBack));
        return table;
    }

    Table Statistics(BenchResult result)
    {
        var (sums, work, first) = (result.Poses.First, result.Poses.Statistics, result.Poses.First.Statistics);
        var table = _text.New(1, "a pose", "", "");
        void Add(string what, long count, string note = "") => table.AddRow(Escaped(what, Text($"{count:N0}"), note));
        Add("rays emitted", sums.RaysEmitted);
        Add("rays hit", sums.RaysHit);
        Add("rays received", sums.RaysReceived);
        Add("bounces", sums.Bounces);
        Add("segments", sums.Segments);
        table.AddRow(Escaped("path length", Text($"{sums.PathLengthMeters:N3}"), "m, up to the last hits"));
        table.AddRow(Escaped("amplitude", Text($"{sums.Amplitude:0.000}"),
            sums.AmplitudeDb is { } decibels ? Text($"{decibels:0.00} dB") : ""));
        Add("objects", sums.Statistics.Objects);
        Add("triangles", sums.Statistics.Triangles);
        Add("nodes visited", result.NodesVisited, Each(result.NodesVisited, sums.Segments, "a segment"));
        Add("triangle pairs tested", result.PairsTested, Each(result.PairsTested, sums.Segments, "a segment"));
        Add("tiles traced", work.TilesTraced, Text($"{work.TilesSkipped:N0} skipped"));
        Add("dispatches", work.Dispatches);
        Add("bytes hashed", work.BytesHashed, Text($"{work.BytesHashedBeside:N0} beside the trace"));
        Add("bytes uploaded", work.BytesUploaded, Text($"{first.BytesUploaded:N0} for the first pose"));
        Add("bytes read back", work.BytesReadBack);
        Add("bytes on the device", work.BytesOnDevice,
            Each(work.BytesOnDevice, sums.Statistics.Triangles, "a triangle"));
        return table;
    }

    Table Errors(BenchResult result)
    {
        if (result.Errors is not { } errors)
            return null;
        var table = _text.New(1, Text($"error, {errors.Reference.RaysEmitted:N0} rays compared"), "", "");
        table.AddRow(
            Escaped("rays hit", Text($"{errors.Hits:+#,0;-#,0;0}"), Text($"of {errors.Reference.RaysHit:N0}")));
        table.AddRow(
            Escaped("bounces", Text($"{errors.Bounces:+#,0;-#,0;0}"), Text($"of {errors.Reference.Bounces:N0}")));
        table.AddRow(Escaped("path length", Text($"{errors.PathLengthRelative:0.0e+0}"), "relative"));
        table.AddRow(Escaped("amplitude", Text($"{errors.Amplitude:0.0e+0}"),
            Text($"of {errors.Reference.Amplitude:0.000}, {errors.AmplitudeRelative:0.0e+0} relative")));
        table.AddRow(Escaped("phase", Text($"{errors.Phase:0.0e+0}"), "rad"));
        return table;
    }

    Table Peers(BenchResult result)
    {
        if (result.Peers.Count == 0)
            return null;
        bool hasClock = result.Kernels.Count > 0;
        var table = _text.New(2, ["peer", "time", "median ms", "lowest ms", "/ pose",
            .. hasClock ? ["/ its kernels"] : Array.Empty<string>()]);
        foreach (var peer in result.Peers)
            foreach (string label in peer.Labels)
            {
                var starts = peer.SeriesOf(label);
                string[] cells =
                    [peer.Name, label, Ms(starts.Median), Ms(starts.Lowest), Ratios(starts, result.Pose),
                        .. hasClock ? [Ratios(starts, result.Kernels)] : Array.Empty<string>()];
                table.AddRow(Escaped(cells));
            }
        return table;
    }

    static string RegionText(RayRegion region) =>
        region.IsWhole ? "" : Text($", of them {region.Width} x {region.Height} from {region.Left}, {region.Bottom}");

    static string Each(long count, long of, string what) => of == 0 ? "" : Text($"{(double)count / of:0.0} {what}");

    static string Ratios(Series peer, Series own) =>
        Text($"{peer.Median / own.Median:0.00}, {peer.Lowest / own.Lowest:0.00}");
}
