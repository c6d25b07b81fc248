using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Newtonsoft.Json;

namespace Glint.Core
{
    /// <summary>Writes results.json. Numbers have the same digits as in results.csv.</summary>
    public sealed class ResultsJson
    {
        /// <summary>Version of the form of results.json and results.partial; files that name none have 0.</summary>
        public const int Schema = 1;

        /// <summary>Name of the version in the file.</summary>
        public const string SchemaName = "schema";

        /// <summary>Form of times, in UTC.</summary>
        public const string TimeFormat = "yyyy-MM-dd'T'HH:mm:ss'Z'";

        /// <summary>Name of the table in the file; that of sweeps is not named.</summary>
        public const string TableName = "table";

        /// <summary>Name of the part of a sweep in the file.</summary>
        public const string ShardName = "shard";

        /// <summary>Name of the objects' names in the file.</summary>
        public const string ObjectNames = "object_names";

        /// <summary>Name of the number of rows in the file, where they are in a file of their own.</summary>
        public const string RowCount = "row_count";

        readonly JsonTextWriter _json;
        readonly ResultTable _table;

        ResultsJson(JsonTextWriter json, ResultTable table) => (_json, _table) = (json, table);

        /// <summary>Writes the file of a run.</summary>
        public static void Write(TextWriter output, RunInfo info, IReadOnlyList<StoredRow> rows, ResultTable table)
        {
            using (var json = new JsonTextWriter(output) { Formatting = Formatting.Indented, CloseOutput = false })
                new ResultsJson(json, table).Write(info, rows);
            output.Write('\n');
        }

        /// <summary>The same in one line, without its end.</summary>
        public static string Line(RunInfo info, IReadOnlyList<StoredRow> rows, ResultTable table) =>
            Line(table, json => json.Write(info, rows));

        /// <summary>The first line of an unfinished sweep, without its end.</summary>
        public static string Line(DateTime startedUtc, SweepIdentity sweep, ResultTable table) => Line(table, json =>
        {
            json.Start(startedUtc);
            json.WriteSweep(sweep);
            json._json.WriteEndObject();
        });

        /// <summary>A row in one line, without its end.</summary>
        public static string Line(StoredRow row, ResultTable table)
        {
            var text = new StringWriter(CultureInfo.InvariantCulture);
            WriteRow(text, row, table);
            return text.ToString();
        }

        /// <summary>Writes a row in one line, without its end: columns by hand, for there may be many rows.</summary>
        public static void WriteRow(TextWriter text, StoredRow row, ResultTable table)
        {
            var columns = table.ColumnsOf(row);
            text.Write('{');
            for (int i = 0; i < columns.Count; i++)
            {
                if (i > 0)
                    text.Write(',');
                text.Write(columns[i].JsonName);
                if (row[columns[i]] is double value)
                    Numbers.Write(text, value);
                else
                    text.Write("null");
            }
            text.Write(!table.HasTimings && row.PhaseHistogram == null && row.Contributions == null
                ? "}"
                : "," + Line(table, json => json.WriteBesideColumns(row)).Substring(1));
        }

        static string Line(ResultTable table, Action<ResultsJson> write)
        {
            var text = new StringWriter(CultureInfo.InvariantCulture);
            using (var json = new JsonTextWriter(text) { Formatting = Formatting.None })
                write(new ResultsJson(json, table));
            return text.ToString();
        }

        void Write(RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            Start(info.StartedUtc);
            Number("elapsed_ms", info.ElapsedMs);
            WriteCommand(info.Command);
            WriteScene(info);
            WriteSettings(info.Settings);
            if (info.Sweep != null)
                WriteSweep(info.Sweep);
            WriteMachine(info);
            if (_table.HasTimings)
                WriteTimings(rows);
            WriteColumns(rows);
            WriteRows(rows);
            _json.WriteEndObject();
        }

        void WriteRows(IReadOnlyList<StoredRow> rows)
        {
            if (_table.IsArray)
            {
                Number(RowCount, rows.Count);
                Text("rows", _table.CsvName);
                return;
            }
            Open("rows", array: true);
            foreach (var row in rows)
                _json.WriteRawValue(Line(row, _table));
            _json.WriteEndArray();
        }

        void WriteCommand(IReadOnlyList<string> arguments)
        {
            if (arguments == null)
            {
                Text("command", null);
                return;
            }
            Texts("command", arguments);
        }

        void WriteScene(RunInfo info)
        {
            Open("scene");
            Text("path", info.ScenePath);
            Text("target", info.TargetName);
            Number("objects", info.Objects);
            Number("triangles", info.Triangles);
            if (info.ObjectNames != null)
                Texts(ObjectNames, info.ObjectNames);
            _json.WriteEndObject();
        }

        void WriteSettings(IReadOnlyList<RunSetting> settings)
        {
            Open("settings");
            foreach (var setting in settings)
            {
                if (setting.Unit == null)
                {
                    Text(setting.Name, setting.Text);
                    continue;
                }
                Open(setting.Name);
                Number("value", setting.Number);
                Text("unit", setting.Unit);
                _json.WriteEndObject();
            }
            _json.WriteEndObject();
        }

        void WriteSweep(SweepIdentity sweep)
        {
            Open("sweep");
            foreach (var entry in sweep.Entries)
                Text(entry.Key, entry.Value);
            if (sweep.Shard.HasValue)
                Text(ShardName, sweep.Shard.ToString());
            _json.WriteEndObject();
        }

        void WriteMachine(RunInfo info)
        {
            Open("device");
            Text("name", info.DeviceName);
            Text("graphics_api", info.GraphicsApi);
            _json.WriteEndObject();
            Open("versions");
            Text("glint", info.GlintVersion);
            Text("unity", info.UnityVersion);
            Text("host", info.Host);
            Text("operating_system", info.OperatingSystem);
            _json.WriteEndObject();
        }

        // What readers need to show a column; what does not hold for it is left out.
        void WriteColumns(IReadOnlyList<StoredRow> rows)
        {
            Open("columns");
            foreach (var column in _table.ColumnsOf(rows))
            {
                Open(column.Name);
                OnOneLine(() => WriteColumn(column));
            }
            _json.WriteEndObject();
        }

        void WriteColumn(ResultColumn column)
        {
            Text("title", column.Title);
            Text("unit", column.Unit);
            if (column.IsAmplitude)
                Raw("is_amplitude", "true");
            if (column.IsFlag)
                Raw("is_flag", "true");
            if (column.Error != null)
                Text("error", column.Error.Name);
            if (column.Missing != null)
                Text("missing", column.Missing);
            if (column.Axis is SweepAxis axis)
            {
                Open("axis");
                Number("order", axis.Index);
                Text("plural", axis.Plural);
                Text("text", axis.Text);
                Text("shown_unit", axis.ShownUnit);
                Number("shown_scale", axis.ShownScale);
                Raw("is_whole", axis.List.IsWhole ? "true" : "false");
                _json.WriteEndObject();
            }
            _json.WriteEndObject();
        }

        void WriteBesideColumns(StoredRow row)
        {
            _json.WriteStartObject();
            if (_table.HasTimings)
                WriteTimings(new[] { row });
            if (row.PhaseHistogram != null)
                WriteHistogram(row.PhaseHistogram);
            if (row.Contributions != null)
            {
                _json.WritePropertyName(ContributionsJson.Name);
                ContributionsJson.Write(_json, row.Contributions);
            }
            _json.WriteEndObject();
        }

        void WriteHistogram(IReadOnlyList<long> bins)
        {
            Open("phase_histogram", array: true);
            foreach (long bin in bins)
                _json.WriteValue(bin);
            _json.WriteEndArray();
        }

        void OnOneLine(Action write)
        {
            var formatting = _json.Formatting;
            _json.Formatting = Formatting.None;
            write();
            _json.Formatting = formatting;
        }

        // Sums over all rows.
        void WriteTimings(IReadOnlyList<StoredRow> rows)
        {
            Open("timings");
            Number("gather_ms", rows.Sum(row => row.Timings.GatherMs));
            Number("build_ms", rows.Sum(row => row.Timings.BuildMs));
            Number("upload_ms", rows.Sum(row => row.Timings.UploadMs));
            Number("trace_ms", rows.Sum(row => row.Timings.TraceMs));
            Number("read_back_ms", rows.Sum(row => row.Timings.ReadBackMs));
            _json.WriteEndObject();
        }

        void Open(string name, bool array = false)
        {
            _json.WritePropertyName(name);
            if (array)
                _json.WriteStartArray();
            else
                _json.WriteStartObject();
        }

        void Start(DateTime startedUtc)
        {
            _json.WriteStartObject();
            Number(SchemaName, Schema);
            if (_table != ResultTable.Sweep)
                Text(TableName, _table.Name);
            Text("started_utc", startedUtc.ToString(TimeFormat, CultureInfo.InvariantCulture));
        }

        void Text(string name, string text)
        {
            _json.WritePropertyName(name);
            _json.WriteValue(text);
        }

        void Texts(string name, IReadOnlyList<string> texts)
        {
            Open(name, array: true);
            foreach (string text in texts)
                _json.WriteValue(text);
            _json.WriteEndArray();
        }

        void Number(string name, double number) => Raw(name, Numbers.Format(number));

        void Raw(string name, string number)
        {
            _json.WritePropertyName(name);
            _json.WriteRawValue(number ?? "null");
        }
    }
}
