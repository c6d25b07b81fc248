using System;
using System.IO;
using Glint.Core;
using Newtonsoft.Json.Linq;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary><c>glint report</c>: a results folder as one HTML file.</summary>
    static class ReportCommand
    {
        const string TemplatePath = "Packages/com.glint.radar/Editor/Report/Template.txt";

        /// <summary>Writes the report of a command line.</summary>
        /// <returns>The exit code: 0 done.</returns>
        /// <exception cref="GlintException">There are no results, or the report cannot be written.</exception>
        public static int Write(CommandLine line, IProgressSink progress)
        {
            try
            {
                return WriteRun(line, progress);
            }
            catch (FormatException damage)
            {
                throw new GlintException($"{line.Input}: the results are damaged: {damage.Message}; restore them, or "
                    + "run the command again that wrote them", damage);
            }
        }

        static int WriteRun(CommandLine line, IProgressSink progress)
        {
            var run = StoredRun.ReadAny(line.Input);
            int pose = line.Get(ReportOptions.Pose);
            bool hasPoses = run.Table != ResultTable.Clutter && run.Table != ResultTable.Screen;
            if (!hasPoses && line.IsGiven(ReportOptions.Pose) && pose != ReportOptions.NoPose)
                throw new GlintException($"{ReportOptions.Pose.Flag} {pose}: a report of glint {run.Table.Name} shows no "
                    + "pose: leave it out");
            int poses = run.Table.HasProfiles ? EchoProfiles.DirectionsOf(run.Info) : run.Count;
            if (pose > poses)
                throw new GlintException($"{ReportOptions.Pose.Flag} {pose}: must be from 1 to {poses}, "
                    + $"the rows of {line.Input}, or none");
            string path = line.IsGiven(ReportOptions.Out)
                ? line.Get(ReportOptions.Out)
                : Path.Combine(line.Input, ReportFile.Name);
            ReportFile.Check(path);
            bool hasScene = hasPoses && pose != ReportOptions.NoPose && run.Count > 0;
            Write(run, hasScene ? CaptureOf(run, pose - 1, progress) : null, path,
                run.Table == ResultTable.Screen ? ScreenReport.Of(line.Input) : null);
            progress.Print(FormattableString.Invariant($"written: {path} ({new FileInfo(path).Length / 1e6:0.0} MB)"));
            return Batch.Done;
        }

        /// <summary>Writes a report.</summary>
        /// <param name="capture">Makes what is shown in 3-D; null: no 3-D view.</param>
        /// <param name="screen">The turn of a radar screen; null: none.</param>
        /// <exception cref="GlintException">The report cannot be written.</exception>
        public static void Write(StoredRun run, Func<JObject> capture, string path, JObject screen = null)
        {
            JObject scene = null;
            string problem = "No pose was requested.";
            if (capture != null)
                (scene, problem) = TryCapture(capture);
            ReportFile.Write(path, ReportFile.Fill(Template(), run, scene, problem, screen));
        }

        // Of the given row, or of the strongest pose.
        static Func<JObject> CaptureOf(StoredRun run, int row, IProgressSink progress)
        {
            if (run.Table != ResultTable.Sweep)
                return () => CrossSectionScene.Of(run, row).ToJson();
            int shown = row >= 0 ? row : run.Strongest();
            return () => SceneCapture.Of(run, shown, SceneCapture.Open(run), progress).ToJson();
        }

        // A report without the scene is still useful.
        static (JObject, string) TryCapture(Func<JObject> capture)
        {
            try
            {
                return (capture(), null);
            }
            catch (GlintException problem)
            {
                Debug.LogWarning($"the report has no 3-D view: {problem.Message}");
                return (null, problem.Message);
            }
        }

        static string Template()
        {
            var asset = AssetDatabase.LoadAssetAtPath<TextAsset>(TemplatePath);
            if (asset == null)
                throw new GlintException($"{TemplatePath} is missing: restore the package");
            return asset.text;
        }
    }
}
