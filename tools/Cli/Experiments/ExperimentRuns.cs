using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Cli;

/// <summary>Runs the experiments in the open project without saving the scenes.</summary>
sealed class ExperimentRuns(IProgressSink progress)
{
    static string Project => Path.GetDirectoryName(Application.dataPath);

    /// <summary>Sweeps an experiment's scene as stored.</summary>
    /// <exception cref="GlintException">
    /// The scene or the published table is missing or unreadable, or cannot be traced.
    /// </exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public SweepResult Sweep(Experiment experiment)
    {
        var published = Published(experiment);
        var line = experiment.Line;
        return InScene(line, loaded => new SweepResult(experiment, published,
            Trace(experiment.Title, loaded, new SweepPlan(axis => line.Get(Options.Of(axis))),
                loaded.Sea, RayReadback.Received)));
    }

    /// <summary>Sweeps the ship of the free-space scene on every snapshot of a sea.</summary>
    /// <exception cref="GlintException">As for a sweep.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public SnapshotsResult SweepAllSnapshots(Experiment sea, Experiment ship)
    {
        var published = Published(ship);
        var turned = Experiment.ShipInFreeSpace with { Options = ship.Options };
        return InScene(turned.Line, loaded =>
        {
            EditorSceneManager.OpenScene(
                new ProjectPaths(Project).ToAssetPath(sea.Scene, Directory.GetCurrentDirectory()),
                OpenSceneMode.Additive);
            var shown = SceneSearch.FindSea(sea.Scene);
            var plan = new SweepPlan(turned.Line.Get(Options.Angles), [.. Enumerable.Range(1, shown.Snapshots.Count)]);
            string title = SnapshotsResult.TitleOf(ship);
            return new SnapshotsResult(SnapshotsResult.NameOf(ship), title, published,
                Trace(title, loaded, plan, shown, RayReadback.None));
        });
    }

    /// <summary>Traces seas like a stored one, with other seeds, winds and choppinesses.</summary>
    /// <param name="sea">The stored sea's experiment, whose radar is used for all.</param>
    /// <exception cref="GlintException">As for a sweep.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public IReadOnlyList<SeaFamily> Study(Experiment sea, SeaRecipe stored, int seeds) =>
        InScene(sea.Line, loaded => new SeaStudy(loaded.Radar, loaded.Sea, progress).Run(stored, seeds));

    /// <summary>Pictures of an experiment's radar with its target turned to each of some angles.</summary>
    /// <param name="angles">Degrees.</param>
    /// <exception cref="GlintException">As for a sweep.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public IReadOnlyList<RadarPreviewImage> Pictures(Experiment experiment, params double[] angles) =>
        InScene(experiment.Line, loaded =>
        {
            var rotation = loaded.Target.rotation;
            return (IReadOnlyList<RadarPreviewImage>)[.. angles.Select(angle =>
            {
                loaded.Target.rotation = Quaternion.AngleAxis((float)angle, Vector3.up) * rotation;
                return loaded.Radar.TracePreview(progress.Cancel);
            })];
        });

    static IReadOnlyList<PublishedRow> Published(Experiment experiment) =>
        experiment.Published == null ? null : PublishedTable.Read(experiment.Published);

    IReadOnlyList<SweepRow> Trace(string title, LoadedScene loaded, SweepPlan plan, Sea sea, RayReadback readback)
    {
        using var run = new SweepRun(
            new SweepSetup(loaded.Radar, plan) { Target = loaded.Target, Sea = sea, Scene = loaded.Scene })
        {
            PosesAhead = int.MaxValue
        };
        var rows = new List<SweepRow>();
        progress.Start(title, run.Count);
        try
        {
            while (!run.IsComplete)
            {
                rows.Add(run.Step(progress, progress.Cancel, readback));
                progress.Advance(run.Done, rows[^1].Pose.ToString());
            }
        }
        finally
        {
            progress.Finish();
        }
        return rows;
    }

    static T InScene<T>(CommandLine line, Func<LoadedScene, T> work)
    {
        var loaded = LoadedScene.Open(line);
        try
        {
            return work(loaded);
        }
        finally
        {
            loaded.Radar.Release();
        }
    }
}
