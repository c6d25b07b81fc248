using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Newtonsoft.Json;

namespace Glint.Core
{
    /// <summary>Writes results.json. Numbers have the same digits as in results.csv.</summary>
    sealed class ResultsJson
    {
        public const string TimeFormat = "yyyy-MM-dd'T'HH:mm:ss'Z'", ShardName = "shard";

        readonly JsonTextWriter _json;

        ResultsJson(JsonTextWriter json) => _json = json;

        public static void Write(TextWriter output, RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            using (var json = new JsonTextWriter(output) { Formatting = Formatting.Indented, CloseOutput = false })
                new ResultsJson(json).Write(info, rows);
            output.Write('\n');
        }

        /// <summary>The same in one line, without its end.</summary>
        public static string Line(RunInfo info, IReadOnlyList<StoredRow> rows) => Line(json => json.Write(info, rows));

        /// <summary>The first line of an unfinished sweep, without its end.</summary>
        public static string Line(DateTime startedUtc, SweepIdentity sweep) => Line(json =>
        {
            json._json.WriteStartObject();
            json.Time(startedUtc);
            json.WriteSweep(sweep);
            json._json.WriteEndObject();
        });

        /// <summary>A row in one line, without its end.</summary>
        public static string Line(StoredRow row) => Line(json => json.WriteRow(row));

        static string Line(Action<ResultsJson> write)
        {
            var text = new StringWriter(CultureInfo.InvariantCulture);
            using (var json = new JsonTextWriter(text) { Formatting = Formatting.None })
                write(new ResultsJson(json));
            return text.ToString();
        }

        void Write(RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            _json.WriteStartObject();
            Time(info.StartedUtc);
            Number("elapsed_ms", info.ElapsedMs);
            WriteCommand(info.Command);
            WriteScene(info);
            WriteSettings(info.Settings);
            if (info.Sweep != null)
                WriteSweep(info.Sweep);
            WriteMachine(info);
            WriteTimings(Sum(rows));
            WriteUnits();
            Open("rows", array: true);
            foreach (var row in rows)
                WriteRow(row);
            _json.WriteEndArray();
            _json.WriteEndObject();
        }

        void WriteCommand(IReadOnlyList<string> arguments)
        {
            if (arguments == null)
            {
                Text("command", null);
                return;
            }
            Open("command", array: true);
            foreach (string argument in arguments)
                _json.WriteValue(argument);
            _json.WriteEndArray();
        }

        void WriteScene(RunInfo info)
        {
            Open("scene");
            Text("path", info.ScenePath);
            Text("target", info.TargetName);
            Number("objects", info.Objects);
            Number("triangles", info.Triangles);
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

        void WriteUnits()
        {
            Open("units");
            foreach (var column in ResultColumn.All)
                Text(column.Name, column.Unit);
            _json.WriteEndObject();
        }

        void WriteRow(StoredRow row)
        {
            _json.WriteStartObject();
            int column = 0;
            foreach (string cell in row.Cells)
                Raw(ResultColumn.All[column++].Name, cell);
            WriteTimings(row.Timings);
            if (row.PhaseHistogram != null)
                WriteHistogram(row.PhaseHistogram);
            _json.WriteEndObject();
        }

        // On one line, for readability.
        void WriteHistogram(int[] bins)
        {
            Open("phase_histogram", array: true);
            var formatting = _json.Formatting;
            _json.Formatting = Formatting.None;
            foreach (int bin in bins)
                _json.WriteValue(bin);
            _json.WriteEndArray();
            _json.Formatting = formatting;
        }

        void WriteTimings(Timings timings)
        {
            Open("timings");
            Number("gather_ms", timings.GatherMs);
            Number("build_ms", timings.BuildMs);
            Number("upload_ms", timings.UploadMs);
            Number("trace_ms", timings.TraceMs);
            Number("read_back_ms", timings.ReadBackMs);
            _json.WriteEndObject();
        }

        static Timings Sum(IReadOnlyList<StoredRow> rows)
        {
            var sum = new Timings();
            foreach (var row in rows)
            {
                sum.GatherMs += row.Timings.GatherMs;
                sum.BuildMs += row.Timings.BuildMs;
                sum.UploadMs += row.Timings.UploadMs;
                sum.TraceMs += row.Timings.TraceMs;
                sum.ReadBackMs += row.Timings.ReadBackMs;
            }
            return sum;
        }

        void Open(string name, bool array = false)
        {
            _json.WritePropertyName(name);
            if (array)
                _json.WriteStartArray();
            else
                _json.WriteStartObject();
        }

        void Time(DateTime startedUtc) =>
            Text("started_utc", startedUtc.ToString(TimeFormat, CultureInfo.InvariantCulture));

        void Text(string name, string text)
        {
            _json.WritePropertyName(name);
            _json.WriteValue(text);
        }

        void Number(string name, double number) => Raw(name, Numbers.Format(number));

        void Raw(string name, string number)
        {
            _json.WritePropertyName(name);
            _json.WriteRawValue(number ?? "null");
        }
    }
}
