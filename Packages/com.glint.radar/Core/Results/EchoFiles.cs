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
        public static void WriteTable(Stream output, RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            var echo = new EchoProfiles(info, rows);
            var sources = new List<(string unit, Func<int, Polarisation, Complex[]> values)>
                { ("dbsm", echo.Responses) };
            if (echo.Settings.Radar != null)
                sources.Add(("dbw", echo.Received));
            using (var text = NewText(output))
            {
                text.WriteLine(string.Join(",", s_keys.Select(column => column.Name).Append("range_m").Concat(
                    sources.SelectMany(source => Polarisation.All.Select(each => $"{each}_{source.unit}")))));
                for (int direction = 0; direction < echo.Directions; direction++)
                {
                    string key = string.Join(",", s_keys.Select(echo.RowsOf(direction)[0].Cell));
                    var profiles = sources.SelectMany(source => Polarisation.All.Select(each =>
                        echo.Profile(source.values(direction, each)))).ToArray();
                    for (int cell = 0; cell < echo.Range.Cells; cell++)
                        text.WriteLine($"{key},{Numbers.Format(echo.Range.RangeOf(cell))},"
                            + string.Join(",", profiles.Select(profile => Level(profile, cell))));
                }
            }
        }

        /// <summary>Writes echo.npz.</summary>
        public static void WriteNumpy(Stream output, RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            using (var file = new NumpyArchive(output))
                AddArrays(file, info, rows);
        }

        /// <summary>Writes echo.mat, the arrays of echo.npz.</summary>
        public static void WriteMatlab(Stream output, RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            using (var file = new MatlabFile(output))
                AddArrays(file, info, rows);
        }

        /// <summary>Writes echo.sigmf-data: the profiles of each polarisation of each direction.</summary>
        public static void WriteSigMfData(Stream output, RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            var echo = new EchoProfiles(info, rows);
            SigMfFile.WriteData(output, Recorded(echo).Select(each => echo.Profile(echo.Settings.Radar == null
                ? echo.Responses(each.direction, each.polarisation)
                : echo.Received(each.direction, each.polarisation))));
        }

        /// <summary>Writes echo.sigmf-meta.</summary>
        public static void WriteSigMfMeta(Stream output, RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            var echo = new EchoProfiles(info, rows);
            var global = new[] { ("unit", (object)(echo.Settings.Radar == null ? "m" : "W^0.5")) };
            using (var text = NewText(output))
                SigMfFile.WriteMeta(text, echo.Band, echo.Range, global, Recorded(echo).Select(each =>
                {
                    var row = echo.RowsOf(each.direction)[0];
                    return s_keys.Where(column => row[column] != null)
                        .Select(column => (column.Name, (object)row[column].Value))
                        .Append(("polarisation", each.polarisation.Name));
                }));
        }

        static IEnumerable<(int direction, Polarisation polarisation)> Recorded(EchoProfiles echo) =>
            Enumerable.Range(0, echo.Directions).SelectMany(direction =>
                echo.Polarisations.Select(polarisation => (direction, polarisation)));

        static void AddArrays(IArrayFile file, RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            var echo = new EchoProfiles(info, rows);
            CrossSectionArrays.AddTo(file, info, rows);
            int cells = echo.Range.Cells;
            file.Add("range", new[] { cells }, Enumerable.Range(0, cells).Select(cell => echo.Range.RangeOf(cell)));
            void Add(string name, int length, Func<int, Polarisation, Complex[]> values) => file.Add(name,
                new[] { echo.Plan.Poses, echo.Plan.Receivers, 2, 2, length },
                Enumerable.Range(0, echo.Directions).SelectMany(direction =>
                    Polarisation.Matrix.SelectMany(polarisation => values(direction, polarisation)
                        ?? Enumerable.Repeat(new Complex(double.NaN, double.NaN), length))));
            Add("profile", cells, (direction, each) => echo.Profile(echo.Responses(direction, each)));
            if (echo.Settings.Radar == null)
                return;
            Add("received", echo.Band.Count, echo.Received);
            Add("received_profile", cells, (direction, each) => echo.Profile(echo.Received(direction, each)));
        }

        /// <summary>Decibels as a text; none for a polarisation that was not asked for, or for 0.</summary>
        public static string Level(Complex[] profile, int cell) => profile == null || profile[cell] == Complex.Zero
            ? null
            : Numbers.Format(ScatteringMatrix.Dbsm(profile[cell]));

        static StreamWriter NewText(Stream output) =>
            new StreamWriter(output, new UTF8Encoding(false), 1 << 16, true) { NewLine = "\n" };
    }
}
