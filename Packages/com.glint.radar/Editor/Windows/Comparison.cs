using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>A second run for comparison, and the differences at the poses of both.</summary>
    sealed class Comparison
    {
        Comparison(string title, IReadOnlyList<StoredRow> rows) =>
            (Title, Rows) = (title, rows);

        public string Title { get; }

        public IReadOnlyList<StoredRow> Rows { get; }

        /// <summary>A published table.</summary>
        /// <exception cref="GlintException">It is missing or damaged.</exception>
        public static Comparison With(PublishedTable table) =>
            new Comparison(table.Title,
                PublishedTable.Read(table.Name).Select(row => new StoredRow((ResultColumn.Of(table.Axis), row.Step),
                (ResultColumn.Amplitude, row.Amplitude), (ResultColumn.Normalised, row.Amplitude),
                (ResultColumn.RaysReceived, row.RaysReceived), (ResultColumn.RaysHit, row.RaysHit))).ToArray());

        /// <summary>A results folder.</summary>
        /// <exception cref="GlintException">It holds no results, or damaged ones.</exception>
        public static Comparison With(string folder) =>
            new Comparison(Path.GetFileName(Path.GetFullPath(folder).TrimEnd('/', '\\')), StoredRun.RowsOf(folder));

        /// <summary>
        /// The differences, a line for each of amplitude, rays received and rays hit; or why there are none.
        /// </summary>
        /// <param name="rows">The run to compare with this one.</param>
        public string Text(IReadOnlyList<StoredRow> rows)
        {
            var pairs = Pairs(rows);
            if (pairs.Count == 0)
                return $"{Title}: no pose in common.";
            return $"{Title}: {pairs.Count} {(pairs.Count == 1 ? "pose" : "poses")} in common.\n"
                + string.Join("\n", new[] { ResultColumn.Normalised, ResultColumn.RaysReceived, ResultColumn.RaysHit }
                    .Select(column => Difference(column, pairs)));
        }

        /// <summary>
        /// Pairs of poses with equal values on every axis that both runs sweep. There are none if the other run sweeps
        /// an axis that this one does not: the pose would be ambiguous.
        /// </summary>
        public IReadOnlyList<(StoredRow Ours, StoredRow Theirs)> Pairs(IReadOnlyList<StoredRow> rows)
        {
            if (SweepAxis.All.Any(axis => SweepChart.Varies(Rows, axis) && rows.All(row => row[axis] == null)))
                return Array.Empty<(StoredRow, StoredRow)>();
            var common = SweepAxis.All
                .Where(axis => rows.Any(row => row[axis].HasValue) && Rows.Any(row => row[axis].HasValue)).ToArray();
            string PoseKey(StoredRow pose) =>
                string.Join(",", common.Select(axis => pose[axis].HasValue ? Numbers.Format(pose[axis].Value) : ""));
            var theirs = Rows.GroupBy(PoseKey).ToDictionary(group => group.Key, group => group.First());
            return rows.Where(row => theirs.ContainsKey(PoseKey(row)))
                .Select(row => (row, theirs[PoseKey(row)])).ToArray();
        }

        // The largest either way, ours less theirs, and the root of the mean square.
        static string Difference(ResultColumn column, IReadOnlyList<(StoredRow Ours, StoredRow Theirs)> pairs)
        {
            double Of((StoredRow Ours, StoredRow Theirs) pair) => pair.Ours[column].Value - pair.Theirs[column].Value;
            var at = pairs.OrderByDescending(pair => Math.Abs(Of(pair))).First();
            double largest = Of(at), theirs = at.Theirs[column].Value;
            if (largest == 0)
                return $"{column.Title}: equal";
            string share = theirs > 0 ? FormattableString.Invariant($" ({100 * largest / theirs:+0.##;-0.##} %)") : "";
            double rms = Math.Sqrt(pairs.Average(pair => Of(pair) * Of(pair)));
            return FormattableString.Invariant(
                $"{column.Title}: at most {largest:+#,0.####;-#,0.####}{share} at {at.Ours.Name}, rms {rms:#,0.####}");
        }
    }
}
