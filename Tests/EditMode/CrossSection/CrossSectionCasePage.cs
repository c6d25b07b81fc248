using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>
    /// Documentation~/rcs-cases.md: the published cases, and every row of them beside what the kernels made of it.
    /// <see cref="CrossSectionCaseTests"/> writes it, and compares it with new traces.
    /// </summary>
    static class CrossSectionCasePage
    {
        /// <summary>Names of the cases in the order of the table, known before assets can be loaded.</summary>
        public static readonly (string Name, string Title)[] Cases =
        {
            ("plate_po", "plate, closed form"), ("plate_po_oblique", "plate, oblique, closed form"),
            ("plate_bistatic", "plate, bistatic, closed form"),
            ("plate_forward", "plate, lobe of its shadow, closed form"),
            ("plate_near", "plate at a finite range, Fresnel integrals"), ("dihedral_plane", "dihedral, closed form"),
            ("dihedral_turned_0", "dihedral about the line of sight, closed form"),
            ("dihedral_turned_22p5", "the same, turned by 22.5 degrees"),
            ("dihedral_turned_45", "the same, turned by 45 degrees"),
            ("trihedral_triple", "trihedrals, triple bounce on the axis, closed form"),
            ("trihedral_triple_cut", "the same, off the axis"), ("sphere_mie", "sphere, Mie"),
            ("sphere_bistatic", "sphere, bistatic, Mie"), ("cylinder_broadside", "cylinders, exact series"),
            ("cylinder_tilted", "cylinders, tilted, physical optics"), ("top_hat_double", "top hat, double bounce"),
            ("two_plates", "two plates, closed form"), ("hidden_plate", "plate behind a plate, closed form"),
            ("plate_pec_layer", "plate with a dielectric layer"),
            ("plate_magnetic_layer", "plate with a magnetic layer"),
            ("plate_half_space", "plate, dielectric half-space"), ("plate_sea_water", "plate of sea water"),
            ("trihedral_all", "trihedrals, all bounces, converged"),
            ("dihedral_100deg", "dihedral of 100 degrees, converged"),
            ("dihedral_oblique", "dihedral, oblique, converged"),
            ("dihedral_bistatic", "dihedral, bistatic, converged"),
            ("two_plates_bistatic", "two plates, bistatic, converged"),
            ("plate_edges", "plate with fringe fields, converged")
        };

        // Part of a row's tolerance by which a printed value may differ: other devices round otherwise.
        const double StaleTolerance = 0.1;

        // Of an amplitude as large as its error.
        const double MaxErrorDb = 6;

        // Values are printed with four digits after the point, the published ones too.
        const double Rounding = 5.1e-5;

        const string Rows = "## Rows";

        // Columns of a row.
        const int Expected = 3, Tolerance = 4, Got = 5, Difference = 6;

        static string FilePath => Path.Combine(Path.GetDirectoryName(Application.dataPath),
            "Packages/com.glint.radar/Documentation~/rcs-cases.md");

        /// <summary>Asserts that the page has these rows and no others, all within their tolerances.</summary>
        public static void AssertHasRows(IEnumerable<(string Name, PublishedRow[] Rows)> cases)
        {
            var printed = Read();
            Assert.That(printed.Select(cells => string.Join(" | ", cells.Take(Got))), Is.EqualTo(cases.SelectMany(
                each => each.Rows.Select(row => string.Join(" | ", Labels(each.Name, row, each.Rows))))));
            foreach (var cells in printed)
            {
                double difference = Number(cells[Got]) - Number(cells[Expected]);
                Assert.That(Math.Abs(difference), Is.LessThanOrEqualTo(Number(cells[Tolerance]) + Rounding),
                    string.Join(" | ", cells));
                Assert.That(Number(cells[Difference]), Is.EqualTo(difference).Within(2 * Rounding),
                    string.Join(" | ", cells));
            }
        }

        /// <summary>Asserts that the page has the values of all rows of a case.</summary>
        public static void AssertHas(IReadOnlyCollection<CrossSectionCaseRow> traced)
        {
            var all = traced.Select(row => row.Row).ToArray();
            var printed = Read().ToLookup(cells => string.Join(" | ", cells.Take(Got)), cells => Number(cells[Got]));
            foreach (var row in traced)
                Assert.That(printed[string.Join(" | ", Labels(row.Case, row.Row, all))], Is.EqualTo(new[] { row.Dbsm })
                    .Within(StaleTolerance * row.Row.ToleranceDb + Rounding), $"{row}: the page is out of date");
        }

        /// <param name="traced">All rows in the order of the table.</param>
        public static void Write(IReadOnlyCollection<CrossSectionCaseRow> traced)
        {
            var cases = traced.GroupBy(row => row.Case).Select(rows => rows.ToArray()).ToArray();
            Assert.That(cases.Select(rows => rows[0].Case), Is.EqualTo(Cases.Select(each => each.Name)),
                "trace all cases");
            var text = new StringBuilder(Introduction(traced.Count)).Append(@"
## Cases

| case | what | conditions | rows | largest difference, dB | over its tolerance | rays a pose | ms a pose |
| --- | --- | --- | ---: | ---: | ---: | ---: | ---: |
");
            foreach (var (rows, title) in cases.Zip(Cases, (rows, each) => (rows, each.Title)))
                text.Append(SummaryOf(rows, title));
            text.Append($@"
{Rows}

| case | directions | pol. | expected, dBsm | tolerance, dB | got, dBsm | difference, dB | error said, dB | tubes | rays | ms |
| --- | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
");
            foreach (var rows in cases)
            {
                var all = rows.Select(row => row.Row).ToArray();
                foreach (var row in rows)
                    text.Append(LineOf(row, all));
            }
            File.WriteAllText(FilePath, text.ToString().Replace("\r", ""));
        }

        static string Introduction(int rows) => FormattableString.Invariant($@"# Cross sections beside published values

All {rows} rows of the {Cases.Length} cases that [rcs.md](rcs.md#validation) names: closed forms, Mie's series and converged integrals of an independent double-precision program. Each is within its tolerance. The command

    GLINT_WRITE_PAGES=1 tools/test CrossSectionCaseTests

writes this page again. Without the variable the same tests trace each row and compare it with the page. A value that differs from the printed one by more than {StaleTolerance} times the tolerance fails, and so does a missing row.

- **Expected** values and tolerances are those of `Tests/EditMode/CrossSection/CrossSectionCases.txt`. Tolerances grow towards nulls, where 1/1000 of the case's largest amplitude is many decibels. A pose is traced with {CrossSectionCaseTests.PartOfTolerance} of the smallest tolerance of its rows, VV and HH apart from VH and HV. -120 dBsm stands for no echo.
- **Directions** are theta, from the vertical, and phi to the radar, in degrees; after ""to"" those to the receiver, where it is elsewhere ([conventions](rcs.md#conventions)). Conditions that differ within a case follow.
- **Error said** is the standard error of the integration in decibels of this amplitude.
- **Tubes, rays and ms** are those of the whole pose, which its rows share. A tube counts once for each bounce and receiver. Rays include those that look for borders. The time is that of a second trace, whose scene is on the device.

Measured on {SystemInfo.graphicsDeviceName} with {Environment.ProcessorCount} processor cores, which other programs may have used too; Glint {GlintVersion.Text}.
");

        static string SummaryOf(CrossSectionCaseRow[] rows, string title) => Line(rows[0].Case, title,
            string.Join(", ", Shared(rows.Select(row => row.Row).ToArray())), Text(rows.Length),
            Text(rows.Max(row => Math.Abs(row.Difference)), "0.000"),
            Text(rows.Max(row => Math.Abs(row.Difference) / row.Row.ToleranceDb), "0.00"),
            Text(rows.Average(row => row.Rays), "0"), Text(rows.Average(row => row.Milliseconds), "0.0"));

        // Errors as large as the amplitude say nothing in decibels.
        static string LineOf(CrossSectionCaseRow row, PublishedRow[] ofCase) => Line(
            Labels(row.Case, row.Row, ofCase).Concat(new[]
            {
                Text(row.Dbsm, "0.0000"), Text(row.Difference, "+0.0000;-0.0000;0.0000"),
                row.ErrorDb < MaxErrorDb ? Text(row.ErrorDb, "0.0000") : "-", Text(row.Tubes), Text(row.Rays),
                Text(row.Milliseconds, "0.0")
            }).ToArray());

        // The cells that tell a row: case, directions, polarisation, published value and tolerance.
        static string[] Labels(string name, PublishedRow row, PublishedRow[] ofCase) => new[]
        {
            name, string.Join(", ", row.Conditions.Except(Shared(ofCase)).Prepend(row.Directions)),
            row.Polarisation.Name.ToUpperInvariant(), Text(row.Dbsm, "0.0000"), Text(row.ToleranceDb, "0.00")
        };

        static IEnumerable<string> Shared(PublishedRow[] ofCase) =>
            ofCase[0].Conditions.Where((condition, i) => ofCase.All(row => row.Conditions[i] == condition));

        // Cells of the rows.
        static string[][] Read() => File.ReadAllLines(FilePath).SkipWhile(line => line != Rows)
            .Where(line => line.StartsWith("| ", StringComparison.Ordinal)).Skip(2)
            .Select(line => line.Trim('|', ' ').Split('|').Select(cell => cell.Trim()).ToArray()).ToArray();

        static string Line(params string[] cells) => $"| {string.Join(" | ", cells)} |\n";

        static string Text(IFormattable value, string format = null) =>
            value.ToString(format, CultureInfo.InvariantCulture);

        static double Number(string cell) => double.Parse(cell, NumberStyles.Float, CultureInfo.InvariantCulture);
    }
}
