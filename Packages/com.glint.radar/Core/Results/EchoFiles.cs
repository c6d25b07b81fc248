using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;

namespace Glint.Core
{
    /// <summary>Writes the files of range profiles from the rows of a whole run.</summary>
    static class EchoFiles
    {
        static readonly ResultColumn[] s_keys =
        {
            CrossSectionColumn.Azimuth, CrossSectionColumn.Elevation, CrossSectionColumn.ReceiverAzimuth,
            CrossSectionColumn.ReceiverElevation
        };

        /// <summary>Writes profile.csv: a line for each range of each direction.</summary>
        public static void WriteTable(Stream output, WholeRun run)
        {
            var echo = run.Echo;
            WriteLevels(output, echo, new[] { "range_m" }, (direction, polarisation, values) =>
                echo.Profile(values(direction, polarisation, 0)), cell => Numbers.Format(echo.Range.RangeOf(cell)));
        }

        /// <summary>Writes doppler.csv: a line for each speed and range of each direction.</summary>
        public static void WriteMaps(Stream output, WholeRun run)
        {
            var echo = run.Echo;
            int columns = echo.Range.Cells;
            WriteLevels(output, echo, new[] { "speed_mps", "range_m" }, (direction, polarisation, values) =>
                echo.Map(echo.Doppler, direction, polarisation, values), cell =>
                $"{Numbers.Format(echo.Doppler.SpeedOf(cell / columns))},"
                + Numbers.Format(echo.Range.RangeOf(cell % columns)));
        }

        /// <summary>Writes detections.csv: a line for each cell above the threshold.</summary>
        public static void WriteDetections(Stream output, WholeRun run)
        {
            var echo = run.Echo;
            using (var text = NewText(output))
            {
                text.WriteLine(string.Join(",", s_keys.Select(column => column.Name).Concat(new[]
                    {
                        "polarisation", "range_m", "speed_mps", echo.Settings.Radar == null ? "level_dbsm" : "level_dbw"
                    })));
                for (int direction = 0; direction < echo.Directions; direction++)
                    foreach (var polarisation in echo.Polarisations)
                        foreach (var detected in echo.Settings.Detection.Detect(echo, direction, polarisation))
                            text.WriteLine($"{KeyOf(echo, direction)},{polarisation},{Numbers.Format(detected.Range)},"
                                + (detected.Speed is double speed ? Numbers.Format(speed) : "") + ","
                                + Numbers.Format(detected.Level));
            }
        }

        // A line for each cell of each direction: its place, and the level of each polarisation in each unit.
        static void WriteLevels(Stream output, EchoProfiles echo, string[] places,
            Func<int, Polarisation, Func<int, Polarisation, int, Complex[]>, Complex[]> cellsOf,
            Func<int, string> placeOf)
        {
            var sources = new List<(string unit, Func<int, Polarisation, int, Complex[]> values)>
                { ("dbsm", echo.Responses) };
            if (echo.Settings.Radar != null)
                sources.Add(("dbw", echo.Received));
            using (var text = NewText(output))
            {
                text.WriteLine(string.Join(",", s_keys.Select(column => column.Name).Concat(places).Concat(
                    sources.SelectMany(source => Polarisation.All.Select(each => $"{each}_{source.unit}")))));
                string[] placesOfCells = null;
                for (int direction = 0; direction < echo.Directions; direction++)
                {
                    string key = KeyOf(echo, direction);
                    var levels = sources.SelectMany(source => Polarisation.All.Select(each =>
                        cellsOf(direction, each, source.values))).ToArray();
                    int cells = levels.First(each => each != null).Length;
                    placesOfCells ??= Enumerable.Range(0, cells).Select(placeOf).ToArray();
                    for (int cell = 0; cell < cells; cell++)
                    {
                        text.Write(key);
                        text.Write(',');
                        text.Write(placesOfCells[cell]);
                        WriteLevels(text, levels, cell);
                    }
                }
            }
        }

        /// <summary>Writes the decibels of a cell: none for what was not asked for, or for 0; and ends the line.</summary>
        public static void WriteLevels(TextWriter text, Complex[][] cells, int cell)
        {
            foreach (var each in cells)
            {
                text.Write(',');
                if (each != null && each[cell] != Complex.Zero)
                    Numbers.Write(text, ScatteringMatrix.Dbsm(each[cell]));
            }
            text.WriteLine();
        }

        static string KeyOf(EchoProfiles echo, int direction) =>
            string.Join(",", s_keys.Select(echo.RowsOf(direction)[0].Cell));

        /// <summary>Writes echo.npz.</summary>
        public static void WriteNumpy(Stream output, WholeRun run)
        {
            using (var file = new NumpyArchive(output))
                AddArrays(file, run);
        }

        /// <summary>Writes echo.mat, the arrays of echo.npz.</summary>
        public static void WriteMatlab(Stream output, WholeRun run)
        {
            using (var file = new MatlabFile(output))
                AddArrays(file, run);
        }

        /// <summary>Writes echo.sigmf-data: the profiles of the pulses of each polarisation and direction.</summary>
        public static void WriteSigMfData(Stream output, WholeRun run)
        {
            var echo = run.Echo;
            SigMfFile.WriteData(output, Recorded(echo).Select(each => echo.Profile(echo.Settings.Radar == null
                ? echo.Responses(each.direction, each.polarisation, each.pulse)
                : echo.Received(each.direction, each.polarisation, each.pulse))));
        }

        /// <summary>Writes echo.sigmf-meta.</summary>
        public static void WriteSigMfMeta(Stream output, WholeRun run)
        {
            var echo = run.Echo;
            var global = new List<(string, object)> { ("unit", echo.Settings.Radar == null ? "m" : "W^0.5") };
            if (echo.Plan.Pulses != null)
                global.Add(("pulse_repetition_frequency_hz", echo.Plan.Pulses.RepetitionFrequency));
            using (var text = NewText(output))
                SigMfFile.WriteMeta(text, echo.Band, echo.Range, global, Recorded(echo).Select(each =>
                {
                    var row = echo.RowsOf(each.direction, each.pulse)[0];
                    return s_keys.Append(CrossSectionColumn.Time).Where(column => row[column] != null)
                        .Select(column => (column.Name, (object)row[column].Value))
                        .Append(("polarisation", each.polarisation.Name));
                }));
        }

        static IEnumerable<(int direction, Polarisation polarisation, int pulse)> Recorded(EchoProfiles echo) =>
            Enumerable.Range(0, echo.Directions).SelectMany(direction =>
                echo.Polarisations.SelectMany(polarisation => Enumerable.Range(0, echo.Plan.PulseCount)
                    .Select(pulse => (direction, polarisation, pulse))));

        static void AddArrays(IArrayFile file, WholeRun run)
        {
            var echo = run.Echo;
            CrossSectionArrays.AddTo(file, run.Info, run.Rows);
            // The image has the profiles in it, which are much more than the responses.
            if (echo.Settings.Image != null)
                return;
            int cells = echo.Range.Cells;
            file.Add("range", new[] { cells }, Enumerable.Range(0, cells).Select(cell => echo.Range.RangeOf(cell)));
            void Add(string name, int[] sizes, Func<int, Polarisation, IEnumerable<Complex>> values) => file.Add(name,
                new[] { echo.Plan.Poses, echo.Plan.Receivers, 2, 2 }.Concat(sizes).ToArray(),
                Enumerable.Range(0, echo.Directions).SelectMany(direction =>
                    Polarisation.Matrix.SelectMany(polarisation => values(direction, polarisation)
                        ?? Enumerable.Repeat(new Complex(double.NaN, double.NaN),
                            sizes.Aggregate((all, size) => all * size)))));
            void AddMaps(string name, Func<int, Polarisation, int, Complex[]> values) => Add(name,
                new[] { echo.Doppler.Rows, cells },
                (direction, each) => echo.Map(echo.Doppler, direction, each, values));
            Add("profile", new[] { cells }, (direction, each) => echo.Profile(echo.Responses(direction, each)));
            int pulses = echo.Plan.PulseCount;
            if (echo.Doppler != null)
            {
                file.Add("speed", new[] { echo.Doppler.Rows },
                    Enumerable.Range(0, echo.Doppler.Rows).Select(row => echo.Doppler.SpeedOf(row)));
                AddMaps("map", echo.Responses);
            }
            if (echo.Settings.Radar == null)
                return;
            Add("received", echo.Doppler == null ? new[] { echo.Band.Count } : new[] { pulses, echo.Band.Count },
                (direction, each) => echo.Polarisations.Contains(each)
                    ? Enumerable.Range(0, pulses).SelectMany(pulse => echo.Received(direction, each, pulse))
                    : null);
            Add("received_profile", new[] { cells }, (direction, each) => echo.Profile(echo.Received(direction, each)));
            if (echo.Doppler != null)
                AddMaps("received_map", echo.Received);
        }

        static StreamWriter NewText(Stream output) =>
            new StreamWriter(output, new UTF8Encoding(false), 1 << 16, true) { NewLine = "\n" };
    }
}
