using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace Glint.Core
{
    /// <summary>
    /// What <see cref="ResultsJson"/> wrote, read again: the results.json of a run, for reports,
    /// to be merged or resumed; and, by its parts, the lines of a sweep that is not finished.
    /// </summary>
    public sealed class StoredRun
    {
        StoredRun(JObject json, string path)
        {
            Table = TableOf(json);
            if (json.Descendants().OfType<JValue>().Any(IsNotFinite))
                throw new FormatException("it holds a number that is not finite");
            Info = new RunInfo
            {
                StartedUtc = Time(json), ElapsedMs = Number(json, "elapsed_ms"),
                Command = (json["command"] as JArray)?.Select(word => (string)word).ToArray(),
                ScenePath = Text(json, "scene", "path"), TargetName = Text(json, "scene", "target"),
                Objects = (long)Number(json, "scene", "objects"), Triangles = (long)Number(json, "scene", "triangles"),
                ObjectNames = (json["scene"][ResultsJson.ObjectNames] as JArray)
                    ?.Select(name => (string)name).ToArray(),
                DeviceName = Text(json, "device", "name"), GraphicsApi = Text(json, "device", "graphics_api"),
                GlintVersion = Text(json, "versions", "glint"), UnityVersion = Text(json, "versions", "unity"),
                Host = Text(json, "versions", "host"), OperatingSystem = Text(json, "versions", "operating_system"),
                Sweep = json["sweep"] is JObject sweep ? Identity(sweep) : null,
            };
            foreach (var setting in ((JObject)Find(json, "settings")).Properties())
                Info.Settings.Add(setting.Value is JObject number
                    ? new RunSetting(setting.Name, Number(number, "value"), Text(number, "unit"))
                    : new RunSetting(setting.Name, (string)setting.Value));
            Rows = Table.IsArray
                ? ArrayOf(path, (int)Number(json, ResultsJson.RowCount))
                : ((JArray)Find(json, "rows")).Select(row => new StoredRow((JObject)row, Table)).ToArray();
            if (Info.ObjectNames != null || ContributionFiles.AreIn(Rows))
                CheckContributions(Info.ObjectNames?.Count ?? 0);
        }

        void CheckContributions(int objects)
        {
            for (int i = 0; i < Rows.Count; i++)
                if (CrossSectionContributions.ProblemOf(Rows[i].Contributions, objects) is string problem)
                    throw new FormatException($"row {i + 1} {problem}");
        }

        IReadOnlyList<StoredRow> ArrayOf(string path, int count)
        {
            var rows = RowArray.Read(Path.Combine(Path.GetDirectoryName(path), Table.CsvName), Table);
            return rows.Count == count
                ? rows
                : throw new FormatException($"{Table.CsvName} beside it has {rows.Count} of {count} rows");
        }

        /// <summary>What the rows hold.</summary>
        public ResultTable Table { get; }

        /// <summary>Everything in the file except the rows.</summary>
        public RunInfo Info { get; }

        /// <summary>A row a pose, in the order of the sweep.</summary>
        public IReadOnlyList<StoredRow> Rows { get; }

        /// <summary>Poses traced.</summary>
        public int Count => Rows.Count;

        /// <summary>Reads results.json of a sweep or run in a folder.</summary>
        /// <exception cref="GlintException">
        /// It is not there, cannot be read, or is not what a sweep or run writes.
        /// </exception>
        public static StoredRun Read(string folder)
        {
            var run = ReadAny(folder);
            return run.Table == ResultTable.Sweep
                ? run
                : throw new GlintException($"{folder}: holds the results of glint {run.Table.Name} "
                    + $"({run.Table.CsvName}): give the folder of a sweep or run");
        }

        /// <summary>Reads results.json of any table in a folder.</summary>
        /// <exception cref="GlintException">It is not there, or cannot be read.</exception>
        public static StoredRun ReadAny(string folder)
        {
            if (File.Exists(folder))
                throw new GlintException($"{folder}: is a file: give the folder that holds {ResultsFolder.JsonName}");
            if (!Directory.Exists(folder))
                throw new GlintException($"{folder}: there is no such folder: "
                    + "give the one that a sweep or run wrote its results to");
            string path = Path.Combine(folder, ResultsFolder.JsonName);
            if (!File.Exists(path))
                throw new GlintException(ResultTable.All.Any(table => File.Exists(Path.Combine(folder, table.CsvName)))
                    ? $"{folder}: has no {ResultsFolder.JsonName}: the sweep was not finished, "
                        + "or is still running: let it end, or start it again"
                    : $"{folder}: holds no results: "
                        + $"give the folder that a sweep or run wrote {ResultsFolder.JsonName} to");
            return ReadFile(path);
        }

        /// <summary>The rows of a results folder, also of an unfinished sweep.</summary>
        /// <exception cref="GlintException">There are none, or they cannot be read.</exception>
        public static IReadOnlyList<StoredRow> RowsOf(string folder)
        {
            string partial = Path.Combine(folder, ResultsFolder.PartialName);
            return !File.Exists(partial)
                ? Read(folder).Rows
                : UnfinishedSweep.Read(partial)?.Rows ?? (IReadOnlyList<StoredRow>)Array.Empty<StoredRow>();
        }

        /// <summary>Reads a results.json.</summary>
        /// <exception cref="GlintException">
        /// It cannot be read, is damaged or of a newer schema; the message names it and the way out.
        /// </exception>
        internal static StoredRun ReadFile(string path)
        {
            try
            {
                var json = Parse(File.ReadAllText(path));
                CheckSchema(json, path);
                return new StoredRun(json, path);
            }
            catch (Exception error) when (IsUnreadable(error))
            {
                throw Damaged(error is JsonReaderException json ? InLine(path, json.LineNumber) : path, error);
            }
        }

        /// <summary>
        /// Where a pose, counted from 0, stands on an axis; null where the axis was left alone. The angle is 0 then.
        /// </summary>
        public double? Value(int pose, SweepAxis axis) => Rows[pose][axis];

        /// <summary>Amplitude of a pose, counted from 0.</summary>
        public double Amplitude(int pose) => Rows[pose][ResultColumn.Amplitude].Value;

        /// <summary>
        /// The pose with the largest amplitude, counted from 0; of equals the first; -1 without poses.
        /// </summary>
        public int Strongest() => StrongestOf(Rows);

        /// <summary>The row with the largest amplitude, counted from 0; of equals the first; -1 without rows.</summary>
        public static int StrongestOf(IReadOnlyList<StoredRow> rows)
        {
            int strongest = -1;
            for (int i = 0; i < rows.Count; i++)
                if (strongest < 0 || rows[i][ResultColumn.Amplitude] > rows[strongest][ResultColumn.Amplitude])
                    strongest = i;
            return strongest;
        }

        /// <summary>One JSON object; dates stay texts.</summary>
        /// <exception cref="JsonException">It is malformed.</exception>
        /// <exception cref="FormatException">There is text after it.</exception>
        public static JObject Parse(string text)
        {
            using (var reader = new JsonTextReader(
                new StringReader(text))
            { DateParseHandling = DateParseHandling.None })
            {
                var json = JObject.Load(reader);
                while (reader.Read())
                    if (reader.TokenType != JsonToken.Comment)
                        throw new FormatException("there is text after its end");
                return json;
            }
        }

        /// <summary>Refuses what a newer Glint wrote in a form that this one does not know.</summary>
        internal static void CheckSchema(JObject json, string path)
        {
            int schema = (int?)json[ResultsJson.SchemaName] ?? 0;
            if (schema > ResultsJson.Schema)
                throw new GlintException($"{path}: has schema {schema}, written by a newer Glint; "
                    + $"version {GlintVersion.Text} reads schema {ResultsJson.Schema} at most: update Glint, "
                    + "or choose another results folder");
        }

        internal static ResultTable TableOf(JObject json) => ResultTable.Find((string)json[ResultsJson.TableName]);

        internal static DateTime Time(JObject json) =>
            DateTime.ParseExact(Text(json, "started_utc"), ResultsJson.TimeFormat, CultureInfo.InvariantCulture,
                DateTimeStyles.AssumeUniversal | DateTimeStyles.AdjustToUniversal);

        internal static SweepIdentity Identity(JObject json)
        {
            var identity = new SweepIdentity();
            foreach (var entry in json.Properties())
                if (entry.Name == ResultsJson.ShardName)
                    identity.Shard = SweepShard.Parse((string)entry.Value);
                else
                    identity.Add(entry.Name, (string)entry.Value);
            return identity;
        }

        /// <summary>Whether an error means that a file is unreadable or damaged.</summary>
        internal static bool IsUnreadable(Exception error) => error is IOException
            || error is UnauthorizedAccessException || error is JsonException
            || error is FormatException || error is InvalidCastException || error is ArgumentException
            || error is OverflowException;

        internal static GlintException Damaged(string path, Exception error) => new GlintException(
            $"{path}: cannot be "
                + $"read{(error is IOException || error is UnauthorizedAccessException ? "" : " as results, it is damaged")}: "
                + $"{(error is JsonException ? "malformed JSON" : error.Message.TrimEnd('.'))}; "
                + "restore it, or run the sweep again without --resume", error);

        /// <summary>A line of a file, from 1, for a message.</summary>
        internal static string InLine(string path, int line) => FormattableString.Invariant($"{path}, line {line}");

        static JToken Find(JObject json, params string[] path)
        {
            JToken at = json;
            foreach (string name in path)
                at = (at as JObject)?[name] ?? throw new FormatException($"it has no {name}");
            return at;
        }

        static string Text(JObject json, params string[] path) => (string)Find(json, path);

        static double Number(JObject json, params string[] path) => Find(json, path).Value<double>();

        static bool IsNotFinite(JValue value) =>
            value.Value is double number && (double.IsNaN(number) || double.IsInfinity(number));
    }
}
