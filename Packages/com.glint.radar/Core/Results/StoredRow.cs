using System.Linq;

namespace Glint.Core
{
    /// <summary>What results.json needs of a row once it is in results.csv: not the rays, which may be millions.</summary>
    sealed class StoredRow
    {
        public StoredRow(SweepRow row)
        {
            Cells = ResultColumn.All.Select(column => column.Text(row)).ToArray();
            Timings = row.Result.Timings;
            PhaseHistogram = (int[])row.Result.PhaseHistogram?.Clone();
        }

        /// <summary>Texts in the order of <see cref="ResultColumn.All"/>; null where there is no value.</summary>
        public string[] Cells { get; }

        public Timings Timings { get; }

        /// <summary>Null when the row has none.</summary>
        public int[] PhaseHistogram { get; }

        public string ToCsv() => string.Join(",", Cells) + "\n";
    }
}
