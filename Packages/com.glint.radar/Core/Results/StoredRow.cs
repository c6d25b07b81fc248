using System;
using System.Collections.Generic;
using System.Linq;
using Newtonsoft.Json.Linq;

namespace Glint.Core
{
    /// <summary>
    /// The part of a row that results.json needs: without the rays, which may be millions.
    /// </summary>
    sealed class StoredRow
    {
        static readonly Dictionary<string, int> s_indices = Enumerable.Range(0, ResultColumn.All.Count)
            .ToDictionary(i => ResultColumn.All[i].Name);

        readonly double?[] _values;

        /// <exception cref="GlintException">A value is NaN or infinite.</exception>
        public StoredRow(SweepRow row)
        {
            _values = ResultColumn.All.Select(column => column.Value(row)).ToArray();
            Timings = row.Result.Statistics.Timings;
            PhaseHistogram = row.Result.PhaseHistogram?.ToArray();
        }

        /// <summary>A row that was written as JSON.</summary>
        /// <exception cref="FormatException">It lacks a value.</exception>
        public StoredRow(JObject row)
        {
            _values = ResultColumn.All.Select(column => Value(row, column)).ToArray();
            Timings = new Timings
            {
                GatherMs = Time(row, "gather_ms"), BuildMs = Time(row, "build_ms"), UploadMs = Time(row, "upload_ms"),
                TraceMs = Time(row, "trace_ms"), ReadBackMs = Time(row, "read_back_ms"),
            };
            PhaseHistogram = row["phase_histogram"]?.ToObject<int[]>();
        }

        /// <summary>The value of a column, by its name; null if empty.</summary>
        public double? this[string column] => _values[s_indices[column]];

        /// <summary>
        /// Texts in the order of <see cref="ResultColumn.All"/>; null for an empty value. Numbers have their shortest
        /// text, which is the one that was read.
        /// </summary>
        public IEnumerable<string> Cells =>
            _values.Select(value => value.HasValue ? Numbers.Format(value.Value) : null);

        public Timings Timings { get; }

        /// <summary>Null when the row has none.</summary>
        public int[] PhaseHistogram { get; }

        public string ToCsv() => string.Join(",", Cells) + "\n";

        static double? Value(JObject row, ResultColumn column)
        {
            var value = row[column.Name] ?? throw new FormatException($"a row has no {column.Name}");
            switch (value.Type)
            {
                case JTokenType.Null when column.MayBeEmpty: return null;
                case JTokenType.Integer:
                case JTokenType.Float: return value.Value<double>();
                default: throw new FormatException($"{column.Name} of a row is no number");
            }
        }

        static double Time(JObject row, string name) =>
            (row["timings"]?[name] ?? throw new FormatException($"a row has no {name}")).Value<double>();
    }
}
