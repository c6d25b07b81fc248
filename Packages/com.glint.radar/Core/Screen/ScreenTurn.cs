using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

namespace Glint.Core
{
    /// <summary>A turn of a radar screen as files have it.</summary>
    public sealed class ScreenTurn
    {
        const string Bearing = "bearing_deg", Range = "range_m", Power = "power_dbw", Brightness = "video",
            Noise = "noise_dbw", Heading = "heading_deg", Detected = "detected", Excess = "over_threshold_db";

        /// <summary>True bearings of the spokes in degrees.</summary>
        public IReadOnlyList<double> Bearings { get; private set; }

        /// <summary>Ranges of the middles of the cells in metres.</summary>
        public IReadOnlyList<double> Ranges { get; private set; }

        /// <summary>Powers in dBW, spoke by spoke, behind beam and pulse, before the receiver's controls.</summary>
        public IReadOnlyList<double> Powers { get; private set; }

        /// <summary>Brightness, 0 to 1, spoke by spoke.</summary>
        public IReadOnlyList<double> Video { get; private set; }

        /// <summary>
        /// Detections, in order: places among <see cref="Powers"/>, and decibels over their thresholds; null if none were
        /// asked for.
        /// </summary>
        public IReadOnlyList<(int index, double overThreshold)> Detections { get; private set; }

        /// <summary>Mean power of the noise in dBW.</summary>
        public double NoiseDbw { get; private set; }

        /// <summary>True heading of the own ship at the end in degrees.</summary>
        public double HeadingDegrees { get; private set; }

        /// <summary>A turn that was read from the device.</summary>
        /// <param name="levels">dB over noise, spoke by spoke.</param>
        /// <param name="video">The same of the brightness.</param>
        /// <param name="detected">Null if no detections were asked for.</param>
        public static ScreenTurn Of(ScreenGeometry geometry, IEnumerable<float> levels, IEnumerable<float> video,
            IEnumerable<ScreenDetected> detected, double headingDegrees)
        {
            double noise = PowerLevel.ToDecibels(geometry.NoisePower);
            int spokes = geometry.Radar.Spokes;
            return new ScreenTurn
            {
                Bearings = Enumerable.Range(0, spokes).Select(i => 360.0 * i / spokes).ToArray(),
                Ranges = Enumerable.Range(0, geometry.Radar.Cells).Select(i => (i + 0.5) * geometry.CellSize).ToArray(),
                Powers = levels.Select(level => level + noise).ToArray(),
                Video = video.Select(value => (double)value).ToArray(), NoiseDbw = noise,
                Detections = detected?.Select(each => (each.Index, each.OverThresholdDb)).ToArray(),
                HeadingDegrees = headingDegrees
            };
        }

        /// <summary>Reads what <see cref="Write"/> wrote.</summary>
        /// <exception cref="GlintException">It is not there, or damaged.</exception>
        public static ScreenTurn Read(string path)
        {
            try
            {
                var arrays = NumpyArchive.Read(path);
                var turn = new ScreenTurn
                {
                    Bearings = arrays[Bearing], Ranges = arrays[Range], Powers = arrays[Power],
                    Video = arrays[Brightness],
                    Detections = arrays.ContainsKey(Detected)
                        ? arrays[Detected].Zip(arrays[Excess], (index, excess) => ((int)index, excess)).ToArray()
                        : null,
                    NoiseDbw = arrays[Noise].First(), HeadingDegrees = arrays[Heading].First()
                };
                int count = turn.Bearings.Count * turn.Ranges.Count;
                if (count == 0 || turn.Powers.Count != count || turn.Video.Count != count
                    || turn.Detections != null && turn.Detections.Any(each => each.index < 0 || each.index >= count))
                    throw new InvalidDataException("its arrays do not fit each other");
                return turn;
            }
            catch (Exception error) when (error is IOException || error is InvalidDataException
                || error is UnauthorizedAccessException || error is KeyNotFoundException
                || error is InvalidOperationException || error is ArgumentException)
            {
                throw new GlintException($"{path}: cannot be read as a turn: {error.Message.TrimEnd('.')}; run glint ppi "
                    + "again", error);
            }
        }

        /// <summary>Writes video.npz.</summary>
        public void Write(Stream output)
        {
            int[] one = { 1 }, spokes = { Bearings.Count }, cells = { Ranges.Count },
                both = { Bearings.Count, Ranges.Count };
            using (var arrays = new NumpyArchive(output))
            {
                arrays.Add(Bearing, spokes, Bearings);
                arrays.Add(Range, cells, Ranges);
                arrays.Add(Power, both, Powers);
                arrays.Add(Brightness, both, Video);
                arrays.Add(Noise, one, new[] { NoiseDbw });
                arrays.Add(Heading, one, new[] { HeadingDegrees });
                if (Detections == null)
                    return;
                int[] detections = { Detections.Count };
                arrays.Add(Detected, detections, Detections.Select(each => (double)each.index));
                arrays.Add(Excess, detections, Detections.Select(each => each.overThreshold));
            }
        }

        /// <summary>Writes video.csv: a line for each cell.</summary>
        public void WriteTable(Stream output) => WriteLines(output, $"{Bearing},{Range},{Power},{Brightness}",
            Enumerable.Range(0, Powers.Count).Select(i => $"{PlaceOf(i)},{Decibels(Powers[i])},"
                + Video[i].ToString("0.####", CultureInfo.InvariantCulture)));

        /// <summary>Writes detections.csv: a line for each detection.</summary>
        public void WriteDetections(Stream output) => WriteLines(output, $"{Bearing},{Range},level_db,{Excess}",
            Detections.Select(each => $"{PlaceOf(each.index)},{Decibels(Powers[each.index] - NoiseDbw)},"
                + Decibels(each.overThreshold)));

        string PlaceOf(int index) => $"{Numbers.Format(Bearings[index / Ranges.Count])},"
            + Numbers.Format(Ranges[index % Ranges.Count]);

        static string Decibels(double level) => level.ToString("0.00", CultureInfo.InvariantCulture);

        static void WriteLines(Stream output, string header, IEnumerable<string> lines)
        {
            using (var text = new StreamWriter(output, new UTF8Encoding(false), 1 << 16, true) { NewLine = "\n" })
            {
                text.WriteLine(header);
                foreach (string line in lines)
                    text.WriteLine(line);
            }
        }
    }
}
