using System;
using System.IO;
using Glint.Core;
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
            var run = StoredRun.Read(line.Input);
            int pose = line.Get(ReportOptions.Pose);
            if (pose > run.Count)
                throw new GlintException($"{ReportOptions.Pose.Flag} {pose}: must be from 1 to {run.Count}, "
                    + $"the poses of {line.Input}, or none");
            string path = line.IsGiven(ReportOptions.Out)
                ? line.Get(ReportOptions.Out)
                : Path.Combine(line.Input, ReportFile.Name);
            int shown = pose > 0 ? pose - 1 : run.Strongest();
            Write(run, pose == ReportOptions.NoPose || shown < 0 ? (Func<ReportScene>)null : () =>
                SceneCapture.Of(run, shown, SceneCapture.Open(run), progress), path);
            progress.Print($"written: {path} ({new FileInfo(path).Length / 1e6:0.0} MB)");
            return Batch.Done;
        }

        /// <summary>Writes a report.</summary>
        /// <param name="capture">Traces the pose shown in 3-D; null: no 3-D view.</param>
        /// <exception cref="GlintException">The report cannot be written.</exception>
        public static void Write(StoredRun run, Func<ReportScene> capture, string path)
        {
            ReportScene scene = null;
            string problem = "No pose was requested.";
            if (capture != null)
                (scene, problem) = TryCapture(capture);
            ReportFile.Write(path, ReportFile.Fill(Template(), run, scene, problem));
        }

        // A report without the scene is still useful.
        static (ReportScene, string) TryCapture(Func<ReportScene> capture)
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
