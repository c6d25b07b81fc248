using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Newtonsoft.Json.Linq;

namespace Glint.Core
{
    /// <summary>
    /// A pose in numbers, as files, charts and comparisons take it: traced just now, stored, or published.
    /// It does not hold the rays, which may be millions.
    /// </summary>
    public sealed class StoredRow
    {
        // NaN where there is none. From this place on, in an array that rows may share.
        readonly double[] _values;
        readonly int _first;

        /// <exception cref="GlintException">A value is NaN or infinite.</exception>
        public StoredRow(SweepRow row) : this(ResultTable.Sweep, row, row.Pose)
        {
            Timings = row.Result.Statistics.Timings;
            PhaseHistogram = row.Result.PhaseHistogram?.ToArray();
        }

        StoredRow(CrossSectionRow row, double[] values, int first)
        {
            (_values, _first, Contributions) = (values, first, row.Contributions);
            SetValues(ResultTable.CrossSection, row, row);
        }

        /// <summary>Some rows, found on several threads.</summary>
        /// <exception cref="GlintException">A value is NaN or infinite.</exception>
        public static StoredRow[] Of(IReadOnlyList<CrossSectionRow> rows)
        {
            int columns = ResultTable.CrossSection.Columns.Count;
            var values = new double[rows.Count * columns];
            var stored = new StoredRow[rows.Count];
            Parallel.For(0, stored.Length, i => stored[i] = new StoredRow(rows[i], values, i * columns));
            return stored;
        }

        /// <exception cref="GlintException">A value is NaN or infinite.</exception>
        public StoredRow(ClutterRow row) : this(ResultTable.Clutter, row, row)
        {
        }

        StoredRow(ResultTable table, object row, object where)
        {
            _values = new double[table.Columns.Count];
            SetValues(table, row, where);
        }

        void SetValues(ResultTable table, object row, object where)
        {
            for (int i = 0; i < table.Columns.Count; i++)
                _values[_first + i] = table.Columns[i].Value(row, where) ?? double.NaN;
        }

        /// <summary>A row that was written as JSON.</summary>
        /// <exception cref="FormatException">It lacks a value.</exception>
        internal StoredRow(JObject row, ResultTable table)
        {
            _values = table.Columns.Select(column => Value(row, column) ?? double.NaN).ToArray();
            Contributions = ContributionsJson.Read(row[ContributionsJson.Name]);
            if (!table.HasTimings)
                return;
            Timings = new Timings
            {
                GatherMs = Time(row, "gather_ms"), BuildMs = Time(row, "build_ms"), UploadMs = Time(row, "upload_ms"),
                TraceMs = Time(row, "trace_ms"), ReadBackMs = Time(row, "read_back_ms"),
            };
            PhaseHistogram = Histogram(row["phase_histogram"]);
        }

        /// <summary>A row of a <see cref="RowArray"/>.</summary>
        /// <exception cref="FormatException">It lacks a value.</exception>
        internal StoredRow(double[] numbers, ResultTable table)
        {
            _values = numbers;
            for (int i = 0; i < numbers.Length; i++)
                if (double.IsNaN(numbers[i]) && !table.Columns[i].MayBeMissing)
                    throw new FormatException($"a row has no {table.Columns[i].Name}");
        }

        /// <summary>A row of a sweep of which only some columns are known.</summary>
        public StoredRow(params (ResultColumn column, double value)[] known)
        {
            _values = Enumerable.Repeat(double.NaN, ResultColumn.All.Count).ToArray();
            foreach (var (column, value) in known)
                _values[column.Index] = value;
        }

        /// <summary>The value of a column of the row's table; null where there is none.</summary>
        public double? this[ResultColumn column] =>
            double.IsNaN(_values[_first + column.Index]) ? (double?)null : _values[_first + column.Index];

        /// <summary>Copies the values of all columns, NaN where there is none.</summary>
        internal void CopyTo(byte[] bytes) =>
            Buffer.BlockCopy(_values, _first * sizeof(double), bytes, 0, bytes.Length);

        /// <summary>The value on an axis; null where the axis was left alone, for the angle 0.</summary>
        public double? this[SweepAxis axis] => this[ResultColumn.Of(axis)];

        /// <summary>Times of the pose.</summary>
        public Timings Timings { get; }

        /// <summary>Received rays by phase; null when the row has none.</summary>
        public IReadOnlyList<long> PhaseHistogram { get; }

        /// <summary>Contributions to a cross section; null when the row has none.</summary>
        public CrossSectionContributions Contributions { get; }

        /// <summary>"15 deg", "snapshot 3, 15 deg"; "the pose" if nothing is swept.</summary>
        public string Name =>
            new SweepPose(SweepAxis.All.Select(axis => this[axis]).ToArray()).ToString() is var text && text.Length > 0
                ? text
                : "the pose";

        /// <summary>Whether the amplitude is unreliable; false if that was not estimated.</summary>
        public bool IsUndersampled => this[ResultColumn.Undersampled] == 1;

        /// <summary>The pose and its figures, in a line.</summary>
        public string Text()
        {
            double normalised = this[ResultColumn.Normalised].Value;
            string level = Signal.Decibels(normalised) is double decibels
                ? FormattableString.Invariant($" ({decibels:0.##} dB)")
                : "";
            string error = this[ResultColumn.SamplingError] is double estimate
                ? estimate > 0 ? FormattableString.Invariant($" +- {estimate:g2}") : ""
                : $", sampling error {ResultColumn.NotEstimated}";
            return FormattableString.Invariant(
                $"{Name}: normalised amplitude {normalised:g5}{level}{error}{(IsUndersampled ? ", undersampled" : "")}, {this[ResultColumn.RaysReceived]:#,0} of {this[ResultColumn.RaysHit]:#,0} rays that hit were received");
        }

        /// <summary>
        /// Writes the line of results.csv with some columns. The shortest text of a number is the one that was read.
        /// </summary>
        internal void WriteCsv(TextWriter text, IReadOnlyList<ResultColumn> columns)
        {
            for (int i = 0; i < columns.Count; i++)
            {
                if (i > 0)
                    text.Write(',');
                if (this[columns[i]] is double value)
                    Numbers.Write(text, value);
            }
            text.Write('\n');
        }

        /// <summary>The value as a text; null where there is none.</summary>
        internal string Cell(ResultColumn column) => this[column] is double value ? Numbers.Format(value) : null;

        static double? Value(JObject row, ResultColumn column)
        {
            var value = row[column.Name];
            switch (value?.Type)
            {
                case null when !column.MayBeMissing: throw new FormatException($"a row has no {column.Name}");
                case null:
                case JTokenType.Null when column.MayBeMissing: return null;
                case JTokenType.Integer:
                case JTokenType.Float: return value.Value<double>();
                default: throw new FormatException($"{column.Name} of a row is not a number");
            }
        }

        static long[] Histogram(JToken bins)
        {
            if (bins == null || bins.Type == JTokenType.Null)
                return null;
            return bins is JArray list
                ? list.Select(bin => bin.Value<long>()).ToArray()
                : throw new FormatException("phase_histogram of a row is no list");
        }

        static double Time(JObject row, string name) =>
            (row["timings"]?[name] ?? throw new FormatException($"a row has no {name}")).Value<double>();
    }
}
