using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>The part of a run shown in the window's chart.</summary>
    [Serializable]
    sealed class ChartChoice
    {
        /// <summary>
        /// Name of the axis; if the run does not sweep it, the fastest axis is shown.
        /// </summary>
        public string Axis = "";

        /// <summary>Title of the column; an unknown title selects the normalised amplitude.</summary>
        public string Column = ResultColumn.Normalised.Title;

        /// <summary>Amplitudes in decibels.</summary>
        public bool InDecibels;

        /// <summary>The pose that is marked, from 0; -1 for the strongest.</summary>
        public int Pose = -1;

        /// <summary>The columns to choose from.</summary>
        public static IEnumerable<ResultColumn> Columns =>
            ResultColumn.All.Where(column => column.Axis == null && !column.IsFlag);

        /// <summary>The axis for these poses.</summary>
        public SweepAxis AxisOf(IReadOnlyList<StoredRow> rows)
        {
            var axes = SweepChart.AxesOf(rows);
            return axes.FirstOrDefault(axis => axis.Name == Axis) ?? axes[0];
        }

        public SweepChart Chart(IReadOnlyList<StoredRow> rows, Comparison compared) =>
            new SweepChart(rows, AxisOf(rows),
                Columns.FirstOrDefault(column => column.Title == Column) ?? ResultColumn.Normalised,
                InDecibels, compared);

        /// <summary>The chosen pose, or the strongest; null without poses.</summary>
        public StoredRow Chosen(IReadOnlyList<StoredRow> rows)
        {
            int row = Row(rows);
            return row < 0 ? null : rows[row];
        }

        /// <summary>Index of the chosen pose, from 0; -1 without poses.</summary>
        public int Row(IReadOnlyList<StoredRow> rows) =>
            Pose >= 0 && Pose < rows.Count ? Pose : StoredRun.StrongestOf(rows);
    }
}
