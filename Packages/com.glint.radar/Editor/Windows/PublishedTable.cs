using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// The tables of the published experiment, which the package carries as text (Editor/Published/README.md).
    /// </summary>
    public sealed class PublishedTable
    {
        /// <summary>Folder of the tables.</summary>
        public const string Folder = "Packages/com.glint.radar/Editor/Published";

        PublishedTable(string name, string title, SweepAxis axis) =>
            (Name, Title, Axis) = (name, title, axis);

        /// <summary>Tables for comparisons with results.</summary>
        public static IReadOnlyList<PublishedTable> All { get; } = new[]
        {
            new PublishedTable("table_a2_corner_reflector", "Corner reflector (Table A.2)", SweepAxis.Angle),
            new PublishedTable("corner_reflector_recovered",
                "Corner reflector, traced in double precision", SweepAxis.Angle),
            new PublishedTable("table_a1_ocean_ss6", "Sea state 6 (Table A.1)", SweepAxis.Snapshot),
            new PublishedTable("table_a3_ship_free_space", "Ship in free space (Table A.3)", SweepAxis.Angle),
            new PublishedTable("table_a4_ship_ss5", "Ship on sea state 5 (Table A.4)", SweepAxis.Angle),
            new PublishedTable("table_a5_ship_ss6", "Ship on sea state 6 (Table A.5)", SweepAxis.Angle)
        };

        /// <summary>Name of the file without extension.</summary>
        public string Name { get; }

        /// <summary>Title for a list.</summary>
        public string Title { get; }

        /// <summary>Axis of the first column.</summary>
        public SweepAxis Axis { get; }

        /// <summary>The rows in the order of the table.</summary>
        /// <exception cref="GlintException">It does not exist, or is malformed.</exception>
        public static IReadOnlyList<PublishedRow> Read(string name)
        {
            string path = $"{Folder}/{name}.csv";
            var asset = AssetDatabase.LoadAssetAtPath<TextAsset>(path);
            if (asset == null)
                throw new GlintException($"{path}: the published table is missing: restore the package");
            return Parse(asset.text, path);
        }

        internal static IReadOnlyList<PublishedRow> Parse(string text, string path)
        {
            var lines = text.Replace("\r", "").TrimEnd('\n').Split('\n');
            int columns = lines[0].Split(',').Length;
            return lines.Skip(1).Select((line, i) => ReadRow(line.Split(','), columns) ?? throw new GlintException(
                $"{path}: line {i + 2} is not a step, an amplitude, rays received and rays hit, in {columns} columns: "
                + "restore the package")).ToArray();
        }

        // The fifth column of most tables is the ratio of the last two.
        static PublishedRow ReadRow(string[] cells, int columns) => cells.Length >= 4 && cells.Length == columns
            && cells.Skip(4).All(cell => TryReal(cell, out _))
            && TryReal(cells[0], out double step) && TryReal(cells[1], out double amplitude)
            && TryCount(cells[2], out long received) && TryCount(cells[3], out long hit)
                ? new PublishedRow(step, amplitude, received, hit)
                : null;

        static bool TryReal(string cell, out double value) =>
            double.TryParse(cell, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && !double.IsNaN(value)
            && !double.IsInfinity(value);

        static bool TryCount(string cell, out long value) =>
            long.TryParse(cell, NumberStyles.None, CultureInfo.InvariantCulture, out value);
    }

    /// <summary>A row of a published table.</summary>
    public sealed class PublishedRow
    {
        /// <summary>A row by its values.</summary>
        public PublishedRow(double step, double amplitude, long raysReceived, long raysHit) =>
            (Step, Amplitude, RaysReceived, RaysHit) = (step, amplitude, raysReceived, raysHit);

        /// <summary>Turn of the target in degrees, or number of the snapshot.</summary>
        public double Step { get; }

        /// <summary>Linear, of 2,073,600 rays.</summary>
        public double Amplitude { get; }

        /// <summary>Rays received.</summary>
        public long RaysReceived { get; }

        /// <summary>Rays whose first segment hits anything.</summary>
        public long RaysHit { get; }

        /// <summary>Rays received over rays hit; 0 when nothing is hit.</summary>
        public double Ratio => RaysHit > 0 ? (double)RaysReceived / RaysHit : 0;
    }
}
