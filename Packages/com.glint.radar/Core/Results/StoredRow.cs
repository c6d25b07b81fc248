using System;
using System.Linq;
using Newtonsoft.Json.Linq;

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

        /// <summary>A row that was written as JSON.</summary>
        /// <exception cref="FormatException">It lacks a value.</exception>
        public StoredRow(JObject row)
        {
            Cells = ResultColumn.All.Select(column => Cell(row, column.Name)).ToArray();
            Timings = new Timings
            {
                GatherMs = Time(row, "gather_ms"), BuildMs = Time(row, "build_ms"), UploadMs = Time(row, "upload_ms"), TraceMs = Time(row, "trace_ms"), ReadBackMs = Time(row, "read_back_ms"),
            };
            PhaseHistogram = row["phase_histogram"]?.ToObject<int[]>();
        }

        /// <summary>Texts in the order of <see cref="ResultColumn.All"/>; null where there is no value.</summary>
        public string[] Cells { get; }

        public Timings Timings { get; }

        /// <summary>Null when the row has none.</summary>
        public int[] PhaseHistogram { get; }

        public string ToCsv() => string.Join(",", Cells) + "\n";

        // The shortest text of a number is the one that was written.
        static string Cell(JObject row, string name)
        {
            var value = row[name] ?? throw new FormatException($"a row has no {name}");
            return value.Type == JTokenType.Null ? null : Numbers.Format(value.Value<double>());
        }

        static double Time(JObject row, string name) => (row["timings"]?[name] ?? throw new FormatException($"a row has no {name}")).Value<double>();
    }
}
