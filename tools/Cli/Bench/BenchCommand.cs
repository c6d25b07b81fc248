using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using Glint.Host;
using Glint.Reference;

namespace Glint.Cli;

/// <summary>
/// The command glint bench: times poses and peers in turns, runs the reference tracer, reports the figures.
/// </summary>
sealed class BenchCommand(Terminal terminal)
{
    // Of a plate and of a sphere.
    static readonly string[] s_crossSectionPlots = ["rcs-plate.svg", "rcs-sphere.svg"];

    /// <returns>The report, line by line.</returns>
    /// <exception cref="GlintException">A file, the scene, the device or a peer fails.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public string[] Execute(CommandLine line, IProgressSink progress)
    {
        OutputFile json = OutputFile.Of(line, Options.Json), sceneFile = OutputFile.Of(line, Options.WriteScene),
            plot = OutputFile.Of(line, Options.Accuracy) ?? OutputFile.Of(line, Options.Tubes);
        OutputFile.RequireDifferent(json, sceneFile, plot);
        var plots = line.IsGiven(Options.CrossSectionPlots)
            ? OutputFile.In(Options.CrossSectionPlots.Flag, line.Get(Options.CrossSectionPlots), s_crossSectionPlots)
            : null;
        var loaded = LoadedScene.Open(line);
        try
        {
            if (plot != null)
                return line.IsGiven(Options.Accuracy) ? Accuracy(line, loaded.Radar, json, plot, progress)
                    : Tubes(line, loaded.Radar, json, plot, progress);
            if (plots != null)
                return CrossSectionPlots(loaded.Radar, plots, progress);
            if (line.IsGiven(Options.CrossSections))
                return Points(line, loaded.Radar, json, progress);
            var result = Measure(line, loaded, sceneFile, progress);
            result.Clutter?.Dispose();
            json?.Write(stream => BenchJson.Write(stream, result));
            return [.. new BenchTables(terminal).Lines(result), .. Written(sceneFile, json)];
        }
        finally
        {
            loaded.Radar.Release();
        }
    }

    string[] Accuracy(CommandLine line, RadarController radar, OutputFile json, OutputFile plot, IProgressSink progress)
    {
        var result = new AccuracyBench(radar.Kernel, line.Get(Options.Rounds), progress).Run();
        json?.Write(stream => AccuracyJson.Write(stream, result));
        plot.Write(stream => AccuracyPlot.Write(stream, result));
        return [.. new AccuracyTables(terminal).Lines(result), .. Written(plot, json)];
    }

    string[] Tubes(CommandLine line, RadarController radar, OutputFile json, OutputFile plot, IProgressSink progress)
    {
        var result = new TubeBench(radar.Kernel, radar.TubeKernel, line.Get(Options.Rounds), GraphicsDevice.Current.Clock, progress).Run();
        json?.Write(stream => TubeJson.Write(stream, result));
        plot.Write(stream => TubePlot.Write(stream, result));
        return [.. new TubeTables(terminal).Lines(result), .. Written(plot, json)];
    }

    static string[] CrossSectionPlots(RadarController radar, OutputFile[] files, IProgressSink progress)
    {
        using var tracer = new CrossSectionTracer(radar.ClutterKernel, "plots of cross sections");
        var curves = new CrossSectionCurves(tracer, progress);
        files[0].Write(stream => CrossSectionPlot.Write(stream, "Plate of 6 x 10.5 inches, 5.12 GHz",
            "angle from the normal, degrees", (-60, 10), curves.Plate()));
        files[1].Write(stream => CrossSectionPlot.Write(stream, "Metal sphere of 1 m diameter, 10 GHz, bistatic",
            "angle between radar and receiver, degrees", (-20, 40), curves.Sphere()));
        return [.. Written(files)];
    }

    string[] Points(CommandLine line, RadarController radar, OutputFile json, IProgressSink progress)
    {
        var result = new PointBench(line, radar, progress).Run();
        json?.Write(stream => PointJson.Write(stream, result));
        return [.. new PointTables(terminal).Lines(result), .. Written(json)];
    }

    static IEnumerable<string> Written(params OutputFile[] files) =>
        files.Where(file => file != null).Select(file => $"written: {file.Path}");

    static BenchResult Measure(CommandLine line, LoadedScene loaded, OutputFile sceneFile, IProgressSink progress)
    {
        var device = GraphicsDevice.Current;
        var peers = (line.Get(Options.Peers) ?? []).Select(peer => new Peer(peer)).ToArray();
        bool isSweep = line.IsGiven(Options.TimedSweep);
        var result = new BenchResult
        {
            Subject = loaded.Name,
            Scene = loaded.Scene,
            Device = device.Info,
            Settings = loaded.Radar.Gather().Settings,
            Rounds = line.Get(Options.Rounds),
            Poses = isSweep ? null : new PoseBench(loaded.Radar, loaded.Target, device.Clock),
            Sweep = isSweep ? new SweepBench(loaded, line.Get(Options.TimedSweep), device.Clock) : null,
            Peers = peers,
        };
        if (!isSweep)
        {
            Step("first poses", progress, () => result.Poses.RunFirst(progress, progress.Cancel));
            Step("sea", progress, () => result.Clutter = line.IsGiven(Options.TimedFacets)
                ? ClutterBench.OfFacets(loaded.Radar, device.Clock, line.Get(Options.TimedFacets))
                : ClutterBench.OfScene(loaded.Radar, device.Clock));
        }

        var pose = loaded.Radar.Gather();
        var scene = pose.Scene;
        sceneFile?.Write(stream => BinaryScene.Write(stream, WorldMesh.Of(scene)));
        string peerScene = sceneFile?.Path;
        try
        {
            if (peerScene == null && peers.Any(peer => peer.WantsScene))
            {
                peerScene = Path.Combine(Path.GetTempPath(), $"glint-bench-{Guid.NewGuid():N}.bin");
                WriteTemporary(scene, peerScene);
            }
            RunRounds(result, peerScene, progress);
        }
        finally
        {
            if (sceneFile == null && peerScene != null)
                File.Delete(peerScene);
        }
        if (isSweep)
            return result;
        result.Poses.End();
        using var tracer = new RayTracer(loaded.Radar.Kernel, loaded.Name);
        Step("counted pose", progress, () => Count(result, tracer, pose, progress));
        Compare(result, line, tracer, pose, progress);
        return result;
    }

    // Glint and the peers take turns, so that a slow phase of the machine affects all. The first round is a warm-up.
    static void RunRounds(BenchResult result, string scene, IProgressSink progress)
    {
        int parts = 1 + result.Peers.Count;
        string own = result.Sweep == null ? "poses" : "sweeps";
        progress.Start(result.Peers.Count == 0 ? own : $"{own} and peers", result.Rounds + 1);
        try
        {
            for (int round = 0; round <= result.Rounds; round++)
            {
                progress.Cancel.ThrowIfCancellationRequested();
                var part = new Part(progress, 0, parts);
                if (result.Sweep == null)
                    result.Poses.RunRound(round > 0, part, progress.Cancel);
                else
                    result.Sweep.RunRound(round > 0, part, progress.Cancel);
                result.Clutter?.RunRound(round > 0, progress.Cancel);
                for (int i = 0; i < result.Peers.Count; i++)
                {
                    result.Peers[i].Run(scene, round > 0, progress.Cancel);
                    progress.Report((i + 2.0) / parts);
                }
                progress.Advance(round + 1, null);
            }
        }
        finally
        {
            progress.Finish();
        }
    }

    static void Count(BenchResult result, RayTracer tracer, RadarPose pose, IProgressSink progress)
    {
        tracer.CountVisits = true;
        var statistics = tracer.Trace(pose, RayReadback.None, progress, progress.Cancel).Statistics;
        tracer.CountVisits = false;
        (result.NodesVisited, result.PairsTested) = (statistics.NodesVisited, statistics.PairsTested);
    }

    static void Compare(BenchResult result, CommandLine line, RayTracer tracer, RadarPose pose, IProgressSink progress)
    {
        int every = line.Get(Options.Reference);
        if (!line.IsGiven(Options.Reference))
        {
            if (Math.Max(result.Settings.RaysEmitted, pose.Scene.TriangleCount) <= ReferenceCheck.Affordable)
                every = 1;
            else
                result.NotCompared = FormattableString.Invariant(
                    $"not compared: {result.Settings.RaysEmitted:N0} rays and {pose.Scene.TriangleCount:N0} triangles take long; --reference 100 compares every 100th ray, --reference all compares them all");
        }
        if (every == 0)
            return;
        if (every == 1)
        {
            Step("reference", progress, () => result.Errors = ReferenceCheck.All(pose, result.Poses.First,
                new Part(progress, 0, 1), progress.Cancel));
            return;
        }
        Step("reference", progress, () =>
        {
            var rays = tracer.Trace(pose, RayReadback.All, new Part(progress, 0, 2), progress.Cancel).Rays;
            result.Errors = ReferenceCheck.Some(pose, rays, every, new Part(progress, 1, 2), progress.Cancel);
        });
    }

    static void Step(string what, IProgressSink progress, Action work)
    {
        progress.Start(what, 1);
        try
        {
            work();
            progress.Advance(1, null);
        }
        finally
        {
            progress.Finish();
        }
    }

    static void WriteTemporary(RadarScene scene, string path)
    {
        try
        {
            using var stream = File.Create(path);
            BinaryScene.Write(stream, WorldMesh.Of(scene));
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            throw new GlintException($"{path}: the scene of the peers cannot be written: {error.Message.TrimEnd('.')}; "
                + $"name a file with {Options.WriteScene.Flag}", error);
        }
    }
}
