using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;

namespace Glint.Core
{
    /// <summary>Writes contributions.csv and hotspots.csv from the rows of cross sections.</summary>
    static class ContributionFiles
    {
        // Name of the objects that are summed up, and of the fringe fields of edges.
        const string Others = "others", Edges = "edges";

        static readonly ResultColumn[] s_keys =
        {
            CrossSectionColumn.Azimuth, CrossSectionColumn.Elevation, CrossSectionColumn.Frequency,
            CrossSectionColumn.ReceiverAzimuth, CrossSectionColumn.ReceiverElevation
        };

        /// <summary>Whether rows have contributions.</summary>
        public static bool AreIn(IReadOnlyList<StoredRow> rows) => rows.Any(row => row.Contributions != null);

        /// <summary>A line for each object and each number of bounces of each row.</summary>
        public static void WriteContributions(Stream output, WholeRun run) =>
            Write(output, new[] { "by", "name" }.Concat(Polarisation.All.SelectMany(polarisation => new[]
                { $"{polarisation}_dbsm", $"{polarisation}_re_m", $"{polarisation}_im_m" })), run.Rows, row =>
                row.Contributions.Objects
                    .Select(each => Cells("object", NameOf(run.Info, each.Number), each.S))
                    .Concat(row.Contributions.Bounces.Select(each =>
                        Cells("bounces", each.Number == 0 ? Edges : $"{each.Number}", each.S))));

        /// <summary>A line for each triangle that returns much, of each row, the strongest first.</summary>
        public static void WriteHotSpots(Stream output, WholeRun run) =>
            Write(output, new[] { "object", "triangle" }.Concat(Polarisation.All.Select(polarisation =>
                $"{polarisation}_dbsm")), run.Rows, row => row.Contributions.HotSpots.Select(spot =>
                new[] { NameOf(run.Info, spot.Object), $"{spot.Triangle}" }
                    .Concat(spot.Dbsm.Select(level => level is double dbsm ? Numbers.Format(dbsm) : null))));

        static void Write(Stream output, IEnumerable<string> names, IReadOnlyList<StoredRow> rows,
            Func<StoredRow, IEnumerable<IEnumerable<string>>> lines)
        {
            using (var text = new StreamWriter(output, new UTF8Encoding(false), 1 << 16, true) { NewLine = "\n" })
            {
                text.WriteLine(string.Join(",", s_keys.Select(column => column.Name).Concat(names)));
                foreach (var row in rows)
                {
                    string key = string.Join(",", s_keys.Select(row.Cell));
                    foreach (var cells in lines(row))
                        text.WriteLine(key + "," + string.Join(",", cells));
                }
            }
        }

        static IEnumerable<string> Cells(string by, string name, ScatteringMatrix s) =>
            new[] { by, name }.Concat(Polarisation.All.SelectMany(polarisation => Cells(polarisation.Of(s))));

        static string[] Cells(Complex amplitude)
        {
            if (double.IsNaN(amplitude.Real))
                return new string[3];
            return new[]
            {
                amplitude == Complex.Zero ? null : Numbers.Format(ScatteringMatrix.Dbsm(amplitude)),
                Numbers.Format(amplitude.Real), Numbers.Format(amplitude.Imaginary)
            };
        }

        static string NameOf(RunInfo info, int number)
        {
            string name = number == CrossSectionContributions.Others ? Others : info.ObjectNames[number];
            return name.IndexOfAny(new[] { ',', '"', '\n', '\r' }) < 0 ? name : $"\"{name.Replace("\"", "\"\"")}\"";
        }
    }
}
