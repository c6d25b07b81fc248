using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// Joins the parts of a sweep (--shard) into the files of the whole sweep; only timings differ.
    /// </summary>
    public static class ResultsMerge
    {
        /// <summary>
        /// Reads the parts, checks that they are all parts of one sweep, each once, and writes the whole.
        /// </summary>
        /// <param name="folders">Results folders of the parts, in any order.</param>
        /// <param name="output">Results folder to write, none of the parts'.</param>
        /// <returns>The folder written.</returns>
        /// <exception cref="GlintException">
        /// A part is missing, given twice, not finished, damaged, changed or of another sweep, or the output cannot be
        /// written; the message names it.
        /// </exception>
        public static ResultsFolder Merge(IReadOnlyList<string> folders, string output)
        {
            if (IsOneOf(folders, output))
                throw IsAPart(output);
            var parts = folders.Select(folder => (folder, results: Read(folder)))
                .OrderBy(part => part.results.Info.Sweep.Shard.Value.Number).ToArray();
            var first = parts[0];
            int count = first.results.Info.Sweep.Shard.Value.Count;
            foreach (var part in parts)
                CheckBelongs(part.folder, part.results, first.folder, first.results);
            for (int i = 1; i < parts.Length; i++)
                if (parts[i].results.Info.Sweep.Shard.Equals(parts[i - 1].results.Info.Sweep.Shard))
                    throw new GlintException($"{parts[i - 1].folder} and {parts[i].folder} are both part "
                        + $"{parts[i].results.Info.Sweep.Shard}: give each part once");
            var missing = Enumerable.Range(1, count)
                .Except(parts.Select(part => part.results.Info.Sweep.Shard.Value.Number)).ToArray();
            if (missing.Length > 0)
                throw new GlintException($"{(missing.Length == 1 ? "a part is" : "parts are")} missing: "
                    + $"{string.Join(", ", missing.Take(8).Select(number => new SweepShard(number, count)))}"
                    + $"{(missing.Length > 8 ? $" and {missing.Length - 8} more" : "")}: sweep with --shard for each, "
                    + "and give its folder too");
            CheckRows(parts);
            return Write(parts.Select(part => part.results).ToArray(), folders, output);
        }

        /// <summary>Whether the output is one of the parts.</summary>
        public static bool IsOneOf(IReadOnlyList<string> folders, string output) =>
            folders.Any(folder => FullPathOf(folder) == FullPathOf(output));

        /// <summary>Normalised path of a folder; links are not resolved.</summary>
        public static string FullPathOf(string folder) => Path.GetFullPath(folder).TrimEnd('/', '\\');

        static StoredRun Read(string folder)
        {
            if (File.Exists(folder))
                throw new GlintException($"{folder}: is a file: give the folder that holds {ResultsFolder.JsonName}");
            if (!Directory.Exists(folder))
                throw new GlintException($"{folder}: there is no such folder: give the results folders of the parts");
            string path = Path.Combine(folder, ResultsFolder.JsonName);
            if (File.Exists(Path.Combine(folder, ResultsFolder.PartialName)))
                throw new GlintException($"{folder}: its sweep is not finished: finish it with --resume");
            if (!File.Exists(path))
                throw new GlintException($"{folder}: has no {ResultsFolder.JsonName}: "
                    + "give the results folders of the parts");
            var results = StoredRun.ReadFile(path);
            return results.Info.Sweep?.Shard != null
                ? results
                : throw new GlintException($"{folder}: is not part of a sweep made with --shard");
        }

        static void CheckBelongs(string folder, StoredRun run, string firstFolder, StoredRun firstRun)
        {
            if (run.Table != firstRun.Table)
                throw new GlintException($"{folder} holds results of glint {run.Table.Name} and {firstFolder} of glint "
                    + $"{firstRun.Table.Name}: give the parts of one run");
            SweepIdentity part = run.Info.Sweep, first = firstRun.Info.Sweep;
            if (part.Shard.Value.Count != first.Shard.Value.Count)
                throw new GlintException($"{folder} is part {part.Shard} and {firstFolder} is part {first.Shard}: "
                    + "their sweeps have different numbers of parts");
            string difference = part.WithShard(null).DifferenceFrom(first.WithShard(null));
            if (difference != null)
                throw new GlintException($"{folder} is of another sweep than {firstFolder}: {difference}");
        }

        // A part that has lost rows, or whose rows or plan were edited.
        static void CheckRows((string folder, StoredRun results)[] parts)
        {
            var plan = PlanOf(parts[0].results);
            int poses = plan?.count ?? parts.Sum(part => part.results.Rows.Count);
            foreach (var (folder, results) in parts)
            {
                var shard = results.Info.Sweep.Shard.Value;
                int rows = results.Rows.Count, expected = shard.End(poses) - shard.First(poses);
                if (rows != expected)
                    throw new GlintException(plan == null
                        ? $"{string.Join(", ", parts.Select(part => part.folder))}: have "
                            + $"{string.Join(", ", parts.Select(part => part.results.Rows.Count))} rows, "
                            + $"and no sweep of {poses} poses has such parts: a file was changed; restore it"
                        : $"{Path.Combine(folder, ResultsFolder.JsonName)}: has {rows} rows where part {shard} of "
                            + $"{poses} poses has {expected}: a file was changed; trace the part again");
            }
            if (plan == null)
                return;
            foreach (var (folder, results) in parts)
                CheckPlaces(folder, results, results.Info.Sweep.Shard.Value.First(poses), plan.Value.problemOf);
        }

        static void CheckPlaces(string folder, StoredRun part, int first, Func<int, StoredRow, string> problemOf)
        {
            string file = part.Table.IsArray ? part.Table.CsvName : ResultsFolder.JsonName;
            for (int i = 0; i < part.Rows.Count; i++)
                if (problemOf(first + i, part.Rows[i]) is string problem)
                    throw new GlintException($"{Path.Combine(folder, file)}: row {i + 1} {problem}: it was changed; "
                        + $"restore it, or trace part {part.Info.Sweep.Shard} again");
        }

        // Number of rows, and what is wrong with the place of one. Null where the identity does not have the whole plan.
        static (int count, Func<int, StoredRow, string> problemOf)? PlanOf(StoredRun run)
        {
            try
            {
                if (run.Table == ResultTable.Sweep)
                {
                    var sweep = SweepPlan.Of(run.Info.Sweep);
                    return (sweep.Count, sweep.ProblemOf);
                }
                var plan = CrossSectionPlan.Of(run.Info.Sweep);
                return (plan.Count, plan.ProblemOf);
            }
            catch (Exception error) when (error is FormatException || error is GlintException)
            {
                return null;
            }
        }

        static GlintException IsAPart(string output) => new GlintException(
            $"{output}: is one of the parts, which the whole would replace: choose another results folder");

        static ResultsFolder Write(StoredRun[] parts, IReadOnlyList<string> folders, string output)
        {
            var info = parts[parts.Length - 1].Info;
            // Time from the first start to the last end.
            info.StartedUtc = parts.Min(part => part.Info.StartedUtc);
            // Not with DateTime.AddMilliseconds, which rounds to milliseconds in Mono.
            info.ElapsedMs = parts.Max(part =>
                (part.Info.StartedUtc - info.StartedUtc).TotalMilliseconds + part.Info.ElapsedMs);
            info.Sweep = info.Sweep.WithShard(null);
            var unlocked = folders.Where(part => !FolderLock.IsIn(part)).ToArray();
            using (var folder = ResultsFolder.Open(output, parts[0].Table))
            {
                // By way of a link.
                if (unlocked.Any(FolderLock.IsIn))
                    throw IsAPart(output);
                folder.Append(parts.SelectMany(part => part.Rows).ToArray());
                folder.Finish(info);
                return folder;
            }
        }
    }
}
