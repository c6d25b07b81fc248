using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using Newtonsoft.Json.Linq;

namespace Glint.Editor
{
    /// <summary>The part of a report that shows the turn of a radar screen.</summary>
    static class ScreenReport
    {
        // Cells of a report: of more the highest of neighbouring cells is shown.
        const int MaxCells = 1 << 22;

        // Smallest step between levels over noise, dB, of which a byte holds 256.
        const double MinStep = 0.1;

        /// <summary>
        /// The turn in a folder of <c>glint ppi</c>: levels over noise and video, each a byte a cell, spoke by spoke, as
        /// base64.
        /// </summary>
        /// <exception cref="GlintException">It cannot be read.</exception>
        public static JObject Of(string folder)
        {
            var turn = ScreenTurn.Read(Path.Combine(folder, ResultTable.Screen.CsvName));
            int spokeGroup = 1, cellGroup = 1;
            while ((long)turn.Bearings.Count / spokeGroup * (turn.Ranges.Count / cellGroup) > MaxCells)
                if (turn.Bearings.Count / spokeGroup > turn.Ranges.Count / cellGroup)
                    spokeGroup *= 2;
                else
                    cellGroup *= 2;
            int all = turn.Ranges.Count, cells = (all + cellGroup - 1) / cellGroup,
                spokes = turn.Bearings.Count / spokeGroup;
            // A group's middle is the bearing of its number.
            int PlaceOf(int index) =>
                (index / all + spokeGroup / 2) / spokeGroup % spokes * cells + index % all / cellGroup;
            string Bytes(IEnumerable<double> values)
            {
                var bytes = new byte[spokes * cells];
                foreach (var (value, index) in values.Select((value, index) => (value, index)))
                    bytes[PlaceOf(index)] = Math.Max(bytes[PlaceOf(index)],
                        (byte)Math.Max(0, Math.Min(byte.MaxValue, Math.Round(value))));
                return ReportModel.Base64(bytes, sizeof(byte));
            }
            double size = 2 * turn.Ranges[0];
            var levels = turn.Powers.Select(power => power - turn.NoiseDbw).ToArray();
            var shown = levels.Where(double.IsFinite).DefaultIfEmpty();
            double lowest = shown.Min(), step = Math.Max(MinStep, (shown.Max() - lowest) / byte.MaxValue);
            return new JObject
            {
                ["spokes"] = spokes, ["cells"] = cells, ["cell_size"] = cellGroup * size,
                ["range_scale"] = all * size, ["noise_dbw"] = turn.NoiseDbw, ["heading"] = turn.HeadingDegrees,
                ["is_reduced"] = spokeGroup * cellGroup > 1, ["lowest_level"] = lowest, ["level_step"] = step,
                ["levels"] = Bytes(levels.Select(level => (level - lowest) / step)),
                ["video"] = Bytes(turn.Video.Select(video => video * byte.MaxValue)),
                ["detection_count"] = turn.Detections?.Count,
                ["detections"] = turn.Detections == null
                    ? null
                    : ReportModel.Base64(turn.Detections.Select(each => PlaceOf(each.index)).Distinct().ToArray(),
                        sizeof(int))
            };
        }
    }
}
