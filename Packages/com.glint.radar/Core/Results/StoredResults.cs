using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace Glint.Core
{
    /// <summary>What <see cref="ResultsJson"/> wrote, read again: whole files, and the lines of a sweep that is not finished.</summary>
    sealed class StoredResults
    {
        StoredResults(RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            Info = info;
            Rows = rows;
        }

        public RunInfo Info { get; }

        public IReadOnlyList<StoredRow> Rows { get; }

        /// <summary>Reads a results.json.</summary>
        /// <exception cref="GlintException">It cannot be read or is damaged; the message names it and the way out.</exception>
        public static StoredResults Read(string path)
        {
            try
            {
                var json = Parse(File.ReadAllText(path));
                var info = new RunInfo
                {
                    StartedUtc = Time(json), ElapsedMs = Number(json, "elapsed_ms"),
                    Command = Words(json), ScenePath = Text(json, "scene", "path"), TargetName = Text(json, "scene", "target"),
                    Objects = (long)Number(json, "scene", "objects"), Triangles = (long)Number(json, "scene", "triangles"),
                    DeviceName = Text(json, "device", "name"), GraphicsApi = Text(json, "device", "graphics_api"),
                    GlintVersion = Text(json, "versions", "glint"), UnityVersion = Text(json, "versions", "unity"), Host = Text(json, "versions", "host"), OperatingSystem = Text(json, "versions", "operating_system"),
                    Sweep = json["sweep"] is JObject sweep ? Identity(sweep) : null,
                };
                foreach (var setting in ((JObject)Find(json, "settings")).Properties())
                    info.Settings.Add(setting.Value is JObject number ? new RunSetting(setting.Name, Number(number, "value"), Text(number, "unit")) : new RunSetting(setting.Name, (string)setting.Value));
                return new StoredResults(info, ((JArray)Find(json, "rows")).Select(row => new StoredRow((JObject)row)).ToArray());
            }
            catch (Exception error) when (IsUnreadable(error))
            {
                throw Damaged(path, error);
            }
        }

        /// <summary>One JSON object; dates stay texts.</summary>
        public static JObject Parse(string text)
        {
            using (var reader = new JsonTextReader(new StringReader(text)) { DateParseHandling = DateParseHandling.None })
            {
                var json = JObject.Load(reader);
                while (reader.Read())
                    if (reader.TokenType != JsonToken.Comment)
                        throw new FormatException("there is something behind its end");
                return json;
            }
        }

        /// <summary>The command line; null where there is none.</summary>
        public static string[] Words(JObject json) => (json["command"] as JArray)?.Select(word => (string)word).ToArray();

        public static DateTime Time(JObject json) =>
            DateTime.ParseExact(Text(json, "started_utc"), ResultsJson.TimeFormat, CultureInfo.InvariantCulture, DateTimeStyles.AssumeUniversal | DateTimeStyles.AdjustToUniversal);

        public static SweepIdentity Identity(JObject json)
        {
            var identity = new SweepIdentity();
            foreach (var entry in json.Properties())
                if (entry.Name == ResultsJson.ShardName)
                    identity.Shard = SweepShard.Parse((string)entry.Value);
                else
                    identity.Add(entry.Name, (string)entry.Value);
            return identity;
        }

        /// <summary>Whether an error says that a file cannot be read or is not what it should be.</summary>
        public static bool IsUnreadable(Exception error) => error is IOException || error is UnauthorizedAccessException || error is JsonException
            || error is FormatException || error is InvalidCastException || error is ArgumentException || error is OverflowException;

        public static GlintException Damaged(string path, Exception error) => new GlintException(
            $"{path}: cannot be read{(error is IOException || error is UnauthorizedAccessException ? "" : " as results, it is damaged")}: {error.Message.TrimEnd('.')}; restore it, or make it anew (the sweep without --resume)", error);

        static JToken Find(JObject json, params string[] path)
        {
            JToken at = json;
            foreach (string name in path)
                at = (at as JObject)?[name] ?? throw new FormatException($"it has no {name}");
            return at;
        }

        static string Text(JObject json, params string[] path) => (string)Find(json, path);

        static double Number(JObject json, params string[] path) => Find(json, path).Value<double>();
    }
}
