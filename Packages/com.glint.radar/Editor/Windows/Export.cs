using System;
using System.IO;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>Exports the files of a sweep.</summary>
    static class Export
    {
        /// <summary>Copies results.csv or results.json.</summary>
        /// <param name="folder">Results folder.</param>
        /// <param name="name">Name of the file in it.</param>
        /// <param name="path">Path of the copy; an existing file is replaced.</param>
        /// <exception cref="GlintException">It does not exist, or the copy cannot be written.</exception>
        public static void Copy(string folder, string name, string path)
        {
            string file = Path.Combine(folder, name);
            if (!File.Exists(file))
                throw new GlintException($"{file}: is not "
                    + $"there{(name == ResultsFolder.JsonName ? ": it is written when the sweep is complete" : ": trace a sweep first")}");
            if (Path.GetFullPath(file) != Path.GetFullPath(path))
                Write(path, () => File.ReadAllBytes(file));
        }

        /// <summary>Writes the bytes of a picture.</summary>
        /// <exception cref="GlintException">They cannot be written.</exception>
        public static void Picture(byte[] png, string path) => Write(path, () => png);

        /// <summary>
        /// Writes the HTML report, with the pose in 3-D if the open scene is that of the results; no scene is opened or
        /// closed.
        /// </summary>
        /// <param name="folder">Of the results.</param>
        /// <param name="pose">Index of the pose shown in 3-D, from 0.</param>
        /// <param name="form">Radar and target of the open scene.</param>
        /// <exception cref="GlintException">There are no results, or the report cannot be written.</exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public static void Report(string folder, int pose, SweepForm form, string path, IProgressSink progress)
        {
            var run = StoredRun.Read(folder);
            ReportCommand.Write(run, () => SceneCapture.Of(run, pose, OpenScene(run, form), progress).ToJson(), path);
        }

        static LoadedScene OpenScene(StoredRun run, SweepForm form)
        {
            if (form.Radar == null || form.Radar.gameObject.scene.path != run.Info.ScenePath)
                throw new GlintException("the scene of these results, "
                    + $"{run.Info.ScenePath ?? "which they do not name"}, is not open");
            if (run.Info.TargetName != null && (form.Target == null || form.Target.name != run.Info.TargetName))
                throw new GlintException($"the target of these results, '{run.Info.TargetName}', "
                    + "is not the chosen one");
            bool hasSnapshots = run.Count > 0 && run.Value(0, SweepAxis.Snapshot) != null;
            return LoadedScene.InOpenScene(form.Radar, run.Info.TargetName == null ? null : form.Target,
                hasSnapshots ? SceneSearch.FindSea(run.Info.ScenePath) : null);
        }

        // The content is read first: the path may be a link to the file that it is read from.
        static void Write(string path, Func<byte[]> read)
        {
            try
            {
                var content = read();
                FileDraft.Write(path, file => file.Write(content, 0, content.Length));
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException
                || error is ArgumentException || error is NotSupportedException)
            {
                throw new GlintException(
                    $"{path}: cannot be written: {error.Message.TrimEnd('.')}; choose another file", error);
            }
        }
    }
}
