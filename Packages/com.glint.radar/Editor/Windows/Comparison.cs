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
        Comparison(string title, IReadOnlyList<PoseFigures> rows)
        {
            Title = title;
            Rows = rows;
        }

        public string Title { get; }

        public IReadOnlyList<PoseFigures> Rows { get; }

        /// <summary>A published table.</summary>
        /// <exception cref="GlintException">It is missing or damaged.</exception>
        public static Comparison With(PublishedTable table) =>
            new Comparison(table.Title,
                PublishedTable.Read(table.Name).Select(row => PoseFigures.Of(row, table.Axis)).ToArray());

        /// <summary>A results folder.</summary>
        /// <exception cref="GlintException">It holds no results, or damaged ones.</exception>
        public static Comparison With(string folder) =>
            new Comparison(Path.GetFileName(Path.GetFullPath(folder).TrimEnd('/', '\\')), PoseFigures.OfFolder(folder));

        /// <summary>
        /// The differences, a line for each of amplitude, rays received and rays hit; or why there are none.
        /// </summary>
        /// <param name="rows">The run to compare with this one.</param>
        public string Text(IReadOnlyList<PoseFigures> rows)
        {
            var pairs = Pairs(rows);
            if (pairs.Count == 0)
                return $"{Title}: no pose in common.";
            return $"{Title}: {pairs.Count} {(pairs.Count == 1 ? "pose" : "poses")} in common.\n"
                + string.Join("\n", new[] { Quantity.Normalised, Quantity.RaysReceived, Quantity.RaysHit }
                    .Select(quantity => new Difference(quantity, pairs).ToString()));
        }

        /// <summary>
        /// Pairs of poses with equal values on every axis that both runs sweep. There are none if the other run sweeps
        /// an axis that this one does not: the pose would be ambiguous.
        /// </summary>
        public IReadOnlyList<(PoseFigures Ours, PoseFigures Theirs)> Pairs(IReadOnlyList<PoseFigures> rows)
        {
            if (SweepAxis.All.Any(axis => SweepChart.Varies(Rows, axis) && rows.All(row => row[axis] == null)))
                return Array.Empty<(PoseFigures, PoseFigures)>();
            var common = SweepAxis.All
                .Where(axis => rows.Any(row => row[axis].HasValue) && Rows.Any(row => row[axis].HasValue)).ToArray();
            string PoseKey(PoseFigures pose) =>
                string.Join(",", common.Select(axis => pose[axis].HasValue ? Numbers.Format(pose[axis].Value) : ""));
            var theirs = Rows.GroupBy(PoseKey).ToDictionary(group => group.Key, group => group.First());
            return rows.Where(row => theirs.ContainsKey(PoseKey(row)))
                .Select(row => (row, theirs[PoseKey(row)])).ToArray();
        }
    }
}
