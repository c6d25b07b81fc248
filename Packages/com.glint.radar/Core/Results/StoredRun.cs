using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Newtonsoft.Json.Linq;

namespace Glint.Core
{
    /// <summary>A finished run as its results folder holds it: results.json, looked through.</summary>
    public sealed class StoredRun
    {
        readonly JToken[] _rows;

        StoredRun(string path, JObject json)
        {
            Json = json;
            string version = (string)json.SelectToken("versions.glint");
            if (version == null || !(json["settings"] is JObject) || !(json["rows"] is JArray rows) || !rows.All(IsRow))
                throw new GlintException($"{path}: is not what a sweep or run of Glint writes: trace it again");
            if (json.Descendants().OfType<JValue>().Any(IsNotFinite))
                throw new GlintException($"{path}: holds a number that is not finite: trace it again");
            _rows = rows.ToArray();
            ScenePath = (string)json.SelectToken("scene.path");
            TargetName = (string)json.SelectToken("scene.target");
            Command = StoredResults.Words(json);
        }

        /// <summary>All of results.json.</summary>
        public JObject Json { get; }

        /// <summary>Asset path of the scene or path of the mesh file; null for none.</summary>
        public string ScenePath { get; }

        /// <summary>Object that was turned; null for none.</summary>
        public string TargetName { get; }

        /// <summary>The words of the command line, its command's name first; null for a run that no command began.</summary>
        public IReadOnlyList<string> Command { get; }

        /// <summary>Poses traced.</summary>
        public int Count => _rows.Length;

        /// <summary>Reads results.json of a folder.</summary>
        /// <exception cref="GlintException">It is not there, cannot be read, or is not what a run writes.</exception>
        public static StoredRun Read(string folder)
        {
            if (File.Exists(folder))
                throw new GlintException($"{folder}: is a file: give the folder that holds {ResultsFolder.JsonName}");
            if (!Directory.Exists(folder))
                throw new GlintException($"{folder}: there is no such folder: give the one that a sweep or run wrote its results to");
            string path = Path.Combine(folder, ResultsFolder.JsonName);
            if (!File.Exists(path))
                throw new GlintException(File.Exists(Path.Combine(folder, ResultsFolder.CsvName))
                    ? $"{folder}: has no {ResultsFolder.JsonName}: the sweep was not finished, or is still at work; let it end"
                    : $"{folder}: holds no results: give the folder that a sweep or run wrote {ResultsFolder.JsonName} to");
            return new StoredRun(path, ReadObject(path));
        }

        /// <summary>Amplitude of a pose, counted from 0.</summary>
        public double Amplitude(int pose) => (double)_rows[pose]["amplitude"];

        /// <summary>Rays received in a pose, counted from 0.</summary>
        public long RaysReceived(int pose) => (long)_rows[pose]["rays_received"];

        /// <summary>Where a pose, counted from 0, stands on an axis; null where the axis was left alone. The angle is 0 then.</summary>
        public double? Value(int pose, SweepAxis axis) => (double?)_rows[pose][axis.Column];

        /// <summary>The pose with the largest amplitude, counted from 0; of equals the first; -1 without poses.</summary>
        public int Strongest()
        {
            int strongest = -1;
            for (int i = 0; i < Count; i++)
                if (strongest < 0 || Amplitude(i) > Amplitude(strongest))
                    strongest = i;
            return strongest;
        }

        static JObject ReadObject(string path)
        {
            try
            {
                return StoredResults.Parse(File.ReadAllText(path));
            }
            catch (Exception error) when (StoredResults.IsUnreadable(error))
            {
                throw StoredResults.Damaged(path, error);
            }
        }

        static bool IsRow(JToken token) => token is JObject row && IsNumber(row["amplitude"]) && IsNumber(row[SweepAxis.Angle.Column]) && row["rays_received"]?.Type == JTokenType.Integer
            && SweepAxis.All.All(axis => row[axis.Column] == null || row[axis.Column].Type == JTokenType.Null || IsNumber(row[axis.Column]));

        static bool IsNumber(JToken token) => token != null && (token.Type == JTokenType.Float || token.Type == JTokenType.Integer);

        static bool IsNotFinite(JValue value) => value.Value is double number && (double.IsNaN(number) || double.IsInfinity(number));
    }
}
