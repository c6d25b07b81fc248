using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>
    /// Opens the scene of a stored run, applies one of its poses again, and traces it for a report.
    /// </summary>
    static class SceneCapture
    {
        /// <summary>Maximum number of paths.</summary>
        public const int MaxPaths = 2000;

        /// <summary>The scene of a report.</summary>
        /// <param name="number">Index of the pose, from 0.</param>
        /// <param name="loaded">The scene of the run.</param>
        /// <exception cref="GlintException">It cannot be traced.</exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public static ReportScene Of(StoredRun run, int number, LoadedScene loaded, IProgressSink progress)
        {
            var plan = new SweepPlan(axis =>
                Only(axis == SweepAxis.Angle && loaded.Target == null ? null : run.Value(number, axis)));
            var radar = loaded.Radar;
            progress.Start(loaded.Name, 1);
            try
            {
                using (var sweep = new SweepRun(loaded.Sweep(plan)))
                {
                    var scene = new ReportScene
                    {
                        Number = number, Result = sweep.Step(progress, progress.Cancel).Result, Pose = radar.Gather()
                    };
                    var received = radar.ReceivedPixels(progress.Cancel);
                    scene.Received = received.Length;
                    scene.Paths = Array.ConvertAll(
                        radar.TracePaths(Chosen(received), null, progress.Cancel), path => path.Points());
                    scene.Preview = radar.TracePreview(progress.Cancel);
                    scene.ObjectName = NamesIn(radar, scene.Preview.Objects());
                    progress.Advance(1, null);
                    return scene;
                }
            }
            finally
            {
                progress.Finish();
                radar.Release();
            }
        }

        static IReadOnlyList<double> Only(double? value) => value.HasValue ? new[] { value.Value } : null;

        /// <summary>Opens the scene of a run.</summary>
        /// <exception cref="GlintException">The scene or mesh file does not exist any more.</exception>
        public static LoadedScene Open(StoredRun run) => LoadedScene.Open(LineOf(run));

        // Evenly chosen over the picture.
        static uint[] Chosen(uint[] pixels)
        {
            int count = Math.Min(pixels.Length, MaxPaths);
            return Enumerable.Range(0, count).Select(i => pixels[(long)i * pixels.Length / count]).ToArray();
        }

        // Immediately, because the scene may be closed later.
        static Func<int, string> NamesIn(RadarController radar, IReadOnlyList<int> objects)
        {
            var names = objects.ToDictionary(number => number, number => radar.ObjectAt(number).name);
            return number => names[number];
        }

        // The stored command; the run of a Sweep component has none and uses the scene in its current state.
        static CommandLine LineOf(StoredRun run)
        {
            if (run.Info.Command != null)
                return CommandLine.Parse(
                    run.Info.Command.FirstOrDefault() == Commands.Run.Name ? Commands.Run : Commands.Sweep,
                    run.Info.Command.Skip(1).ToArray());
            if (string.IsNullOrEmpty(run.Info.ScenePath))
                throw new GlintException("the results name no scene: it was not saved when it was traced");
            var words = new List<string> { "--", run.Info.ScenePath };
            if (run.Count > 0 && run.Value(0, SweepAxis.Snapshot) != null)
                words.Insert(0, $"{Options.Snapshots.Flag}=1");
            if (run.Info.TargetName != null)
                words.InsertRange(0,
                    new[] { $"{Options.Target.Flag}={run.Info.TargetName}", $"{Options.Angles.Flag}=0" });
            return CommandLine.Parse(words.Count > 2 ? Commands.Sweep : Commands.Run, words);
        }
    }
}
