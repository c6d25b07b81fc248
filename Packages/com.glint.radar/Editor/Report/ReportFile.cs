using System;
using System.IO;
using System.Text;
using Glint.Core;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace Glint.Editor
{
    /// <summary>
    /// The report of a run: one HTML file that opens offline, from a template and the run's figures.
    /// </summary>
    public static class ReportFile
    {
        /// <summary>Name of the file in a results folder.</summary>
        public const string Name = "report.html";

        /// <summary>Placeholder of the figures in the template.</summary>
        internal const string Placeholder = "@GLINT_REPORT_DATA@";

        // Of every page.
        const string PageStart = "<!DOCTYPE html>";

        /// <summary>The page.</summary>
        /// <param name="template">Editor/Report/Template.txt.</param>
        /// <param name="scene">The scene in the form of the report's page; null: not shown.</param>
        /// <param name="noScene">Why there is no scene, as a sentence; null if there is one.</param>
        /// <param name="screen">The turn of a radar screen in the form of the report's page; null: none.</param>
        /// <exception cref="GlintException">
        /// The template does not have exactly one placeholder, or the run is a part of range profiles.
        /// </exception>
        public static string Fill(string template, StoredRun run, JObject scene, string noScene,
            JObject screen = null)
        {
            int index = template.IndexOf(Placeholder, StringComparison.Ordinal);
            if (index < 0 || template.IndexOf(Placeholder, index + 1, StringComparison.Ordinal) >= 0)
                throw new GlintException("the report's template is damaged: "
                    + "restore Editor/Report/Template.txt of the package");
            var echo = run.Table.HasProfiles ? new EchoReport(run) : null;
            var data = new JObject
            {
                ["glint"] = GlintVersion.Text,
                ["run"] = echo?.RunToJson()
                    ?? (JToken)new JRaw(ResultsJson.Line(run.Info, run.Rows, run.Table)),
                ["echo"] = echo?.ToJson(),
                ["screen"] = screen,
                ["scene"] = scene,
                ["no_scene"] = noScene
            };
            // Only '<' can end a script element.
            string json = data.ToString(Formatting.None).Replace("<", "\\u003c");
            return template.Substring(0, index) + json + template.Substring(index + Placeholder.Length);
        }

        /// <summary>Refuses a place where no report can be: before work on it begins.</summary>
        /// <exception cref="GlintException">
        /// The path is a folder, its folder does not exist, or a file that is no report is there.
        /// </exception>
        public static void Check(string path)
        {
            if (Directory.Exists(path))
                throw new GlintException($"{path}: is a folder: name a file in it with {ReportOptions.Out.Flag}");
            Try(path, () =>
            {
                string folder = Path.GetDirectoryName(Path.GetFullPath(path));
                if (!Directory.Exists(folder))
                    throw new GlintException($"{path}: the folder {folder} does not exist: create it, "
                        + $"or name another file with {ReportOptions.Out.Flag}");
                if (!FileDraft.MayReplace(path, IsPage))
                    throw new GlintException($"{path}: is there, and is no report that could be replaced: "
                        + $"name another file with {ReportOptions.Out.Flag}");
            });
        }

        /// <summary>Writes a page atomically.</summary>
        /// <inheritdoc cref="Check"/>
        public static void Write(string path, string page)
        {
            Check(path);
            Try(path, () => FileDraft.Write(path, file =>
            {
                using (var text = new StreamWriter(file, new UTF8Encoding(false)))
                    text.Write(page);
            }));
        }

        static bool IsPage(Stream file)
        {
            var start = new char[PageStart.Length];
            using (var text = new StreamReader(file))
                return text.ReadBlock(start, 0, start.Length) == start.Length
                    && new string(start).Equals(PageStart, StringComparison.OrdinalIgnoreCase);
        }

        static void Try(string path, Action work)
        {
            try
            {
                work();
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException
                || error is ArgumentException || error is NotSupportedException)
            {
                throw new GlintException($"{path}: the report cannot be written: {error.Message.TrimEnd('.')}; "
                    + $"name another file with {ReportOptions.Out.Flag}", error);
            }
        }
    }
}
