using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Newtonsoft.Json.Linq;

namespace Glint.Editor
{
    /// <summary>The part of a report that shows range profiles.</summary>
    sealed class EchoReport
    {
        // Levels of a report: of more the highest of neighbouring cells is shown.
        const int MaxLevels = 1 << 22;

        readonly StoredRun _run;
        readonly EchoProfiles _echo;

        // Of directions and polarisations.
        readonly Complex[][][] _profiles;

        /// <exception cref="GlintException">The run is part of another one.</exception>
        public EchoReport(StoredRun run)
        {
            if (run.Info.Sweep.Shard is SweepShard shard)
                throw new GlintException($"the results are part {shard} of a run, and a range profile takes all of its "
                    + "frequencies: join the parts with glint merge");
            _run = run;
            _echo = new EchoProfiles(run.Info, run.Rows);
            _profiles = ProfilesOf(_echo.Responses);
        }

        /// <summary>The run in the form of results.json, with one row for each direction: its highest echo.</summary>
        public JObject RunToJson()
        {
            var run = StoredRun.Parse(ResultsJson.Line(_run.Info, Array.Empty<StoredRow>(), ResultTable.Echo));
            foreach (var polarisation in _echo.Polarisations)
            {
                string name = polarisation.Name.ToUpperInvariant();
                run["columns"][$"{polarisation}_dbsm"]["title"] = $"Highest echo, {name}";
                run["columns"][RangeColumn(polarisation)] =
                    new JObject { ["title"] = $"Range of the highest echo, {name}", ["unit"] = "m" };
            }
            run["rows"] = new JArray(Enumerable.Range(0, _echo.Directions).Select(RowToJson));
            return run;
        }

        /// <summary>
        /// The profiles: levels by direction, polarisation and cell in hundredths of a decibel, 16 bits, as base64,
        /// little-endian; -32,768: no echo.
        /// </summary>
        public JObject ToJson()
        {
            int group = GroupOf(1);
            var quantities = new JArray { Quantity("dBsm", _profiles, group) };
            if (_echo.Settings.Radar != null)
                quantities.Add(Quantity("dBW", ProfilesOf(_echo.Received), group));
            var json = RangesOf(group);
            json["unambiguous"] = _echo.Band.UnambiguousRange;
            json["window"] = _echo.Settings.Window;
            json["polarisations"] = new JArray(_echo.Polarisations.Select(polarisation => polarisation.Name));
            json["quantities"] = quantities;
            json["doppler"] = _echo.Doppler == null ? null : MapsToJson();
            json["image"] = _echo.Settings.Image == null ? null : ImageToJson();
            json["detections"] = _echo.Settings.Detection == null
                ? null
                : new JArray(Enumerable.Range(0, _echo.Directions).Select(DetectionsToJson));
            return json;
        }

        // The maps: levels by direction, polarisation, speed and range, as the profiles.
        JObject MapsToJson()
        {
            int group = GroupOf(_echo.Doppler.Rows);
            Complex[][][] Maps(Func<int, Polarisation, int, Complex[]> values) =>
                OfAll((direction, polarisation) => _echo.Map(_echo.Doppler, direction, polarisation, values));
            var quantities = new JArray { Quantity("dBsm", Maps(_echo.Responses), group) };
            if (_echo.Settings.Radar != null)
                quantities.Add(Quantity("dBW", Maps(_echo.Received), group));
            var json = RangesOf(group);
            json["speed_start"] = _echo.Doppler.SpeedOf(0);
            json["speed_step"] = _echo.Doppler.SpeedOf(1) - _echo.Doppler.SpeedOf(0);
            json["rows"] = _echo.Doppler.Rows;
            json["blind_speed"] = _echo.Plan.Pulses.BlindSpeed(_echo.Band.Centre);
            json["quantities"] = quantities;
            return json;
        }

        // Levels by polarisation, row down range and column cross range, as the profiles.
        JObject ImageToJson()
        {
            var transform = _echo.NewImage();
            int group = 1;
            while (Math.Pow(transform.Pixels / group, 2) * _echo.Polarisations.Count > MaxLevels)
                group *= 2;
            int pixels = transform.Pixels / group;
            return new JObject
            {
                ["pixels"] = pixels, ["group"] = group, ["start"] = transform.PlaceOf(0.5 * (group - 1)),
                ["step"] = group * transform.Pixel, ["azimuth"] = _echo.MiddleAzimuth,
                ["centre"] = new JArray("xyz".Select(axis =>
                    _run.Info.Settings.First(setting => setting.Name == $"phase_centre_{axis}").Number)),
                ["levels"] = ReportModel.Base64(_echo.Polarisations.SelectMany(polarisation =>
                {
                    var image = _echo.Image(polarisation);
                    return Enumerable.Range(0, pixels * pixels).Select(pixel => LevelOf(
                        Enumerable.Range(0, group * group).Max(part => ScatteringMatrix.Dbsm(image[
                            (pixel / pixels * group + part / group) * transform.Pixels
                            + pixel % pixels * group + part % group]))));
                }).ToArray(), sizeof(short))
            };
        }

        JArray DetectionsToJson(int direction) => new JArray(_echo.Polarisations.SelectMany(polarisation =>
            _echo.Settings.Detection.Detect(_echo, direction, polarisation).Select(detected => new JObject
            {
                ["polarisation"] = polarisation.Name, ["range"] = detected.Range, ["speed"] = detected.Speed,
                ["level"] = detected.Level
            })));

        // Neighbouring cells of range of which the highest is shown.
        int GroupOf(int rows)
        {
            int group = 1, cells = _echo.Range.Cells;
            long lines = (long)_echo.Directions * _echo.Polarisations.Count * rows;
            while (lines * (cells / group) > MaxLevels && group < cells)
                group *= 2;
            return group;
        }

        JObject RangesOf(int group) => new JObject
        {
            ["start"] = _echo.Range.RangeOf(0.5 * (group - 1)), ["step"] = group * _echo.Range.CellSize,
            ["cells"] = _echo.Range.Cells / group, ["group"] = group
        };

        static string RangeColumn(Polarisation polarisation) => $"{polarisation}_range_m";

        Complex[][][] ProfilesOf(Func<int, Polarisation, Complex[]> responses) =>
            OfAll((direction, polarisation) => _echo.Profile(responses(direction, polarisation)));

        Complex[][][] OfAll(Func<int, Polarisation, Complex[]> valuesOf) => Enumerable.Range(0, _echo.Directions)
            .Select(direction => _echo.Polarisations
                .Select(polarisation => valuesOf(direction, polarisation)).ToArray())
            .ToArray();

        JObject RowToJson(int direction)
        {
            var rows = _echo.RowsOf(direction);
            var json = StoredRun.Parse(ResultsJson.Line(rows[0], _run.Table));
            json[CrossSectionColumn.Frequency.Name] = _echo.Band.Centre;
            for (int i = 0; i < _echo.Polarisations.Count; i++)
            {
                var polarisation = _echo.Polarisations[i];
                var profile = _profiles[direction][i];
                int cell = EchoPeak.Of(profile);
                json[$"{polarisation}_dbsm"] =
                    profile[cell] == Complex.Zero ? null : (JToken)ScatteringMatrix.Dbsm(profile[cell]);
                json[$"{polarisation}_re_m"] = profile[cell].Real;
                json[$"{polarisation}_im_m"] = profile[cell].Imaginary;
                json[RangeColumn(polarisation)] = _echo.Range.RangeOf(cell);
            }
            // Of all frequencies and pulses, which may be of several traces.
            foreach (var column in new[] { CrossSectionColumn.Error, CrossSectionColumn.ErrorDb,
                CrossSectionColumn.OutsidePhysicalOptics, CrossSectionColumn.CoarseShare, CrossSectionColumn.Tubes,
                CrossSectionColumn.Rays })
                json[column.Name] = rows.Max(row => row[column].Value);
            json[CrossSectionColumn.ToleranceMet.Name] =
                rows.Min(row => row[CrossSectionColumn.ToleranceMet].Value);
            return json;
        }

        static JObject Quantity(string unit, Complex[][][] profiles, int group) => new JObject
        {
            ["unit"] = unit,
            ["levels"] = ReportModel.Base64(profiles.SelectMany(direction => direction)
                .SelectMany(profile => Levels(profile, group)).ToArray(), sizeof(short))
        };

        static IEnumerable<short> Levels(Complex[] profile, int group)
        {
            for (int first = 0; first < profile.Length; first += group)
            {
                double highest = Enumerable.Range(first, group).Max(cell => ScatteringMatrix.Dbsm(profile[cell]));
                yield return LevelOf(highest);
            }
        }

        // The least value is that of no echo.
        static short LevelOf(double decibels) => double.IsNegativeInfinity(decibels)
            ? short.MinValue
            : (short)Math.Max(-short.MaxValue, Math.Min(short.MaxValue, Math.Round(100 * decibels)));
    }
}
