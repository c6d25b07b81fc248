using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>Figures of a Sea for an inspector.</summary>
    static class SeaFigures
    {
        /// <summary>Labels and tooltips of the fields of <see cref="SeaSettings"/>, in their order.</summary>
        public static readonly (string field, string label, string tooltip)[] Waves = SeaSettings.Measures
            .Select(measure => measure.Row)
            .Prepend(("Kind", "Spectrum", "Distribution of the variance over wavelengths."))
            .Append(("HeightFactor", "Height Factor",
                "Multiplies the height, 0.001 to 1000: 1, or the scale of a stored sea.")).ToArray();

        /// <summary>Why the sea cannot be shown, or looks wrong; null if neither.</summary>
        public static Finding Check(Sea sea) => Finding.Of(sea.Check) ?? (sea.Material != null ? null
            : new Finding(Severity.Warning, sea.HasNoMaterial, AssignMaterial(sea)));

        static Fix AssignMaterial(Sea sea) => new Fix("Assign Unity's material", () =>
        {
            Fix.Change(sea, "Assign Unity's material", it => it.Material = ProjectAssets.StandardMaterial);
            sea.Rebuild();
        });

        /// <summary>The figures: label, value, meaning.</summary>
        public static IEnumerable<(string label, string value, string tooltip)> Rows(Sea sea)
        {
            var shown = sea.CurrentSnapshot;
            var waves = shown == null ? sea.Waves : shown.Settings;
            yield return ("Shown", shown == null
                ? FormattableString.Invariant($"waves at {sea.TimeSeconds:0.###} s")
                    : $"snapshot {Name(sea, sea.Snapshot)}",
                "A stored snapshot; without any, a tile made from Waves.");
            string height = waves.SignificantWaveHeight == 0 ? "height of the wind"
                : FormattableString.Invariant($"{waves.SignificantWaveHeight:0.###} m high");
            yield return ("Waves", FormattableString.Invariant(
                $"{waves.Kind}, {height}, wind {waves.WindSpeed:0.###} m/s to {waves.WindDirectionDegrees:0.###} deg"),
                "Spectrum, requested significant wave height, and wind that shapes it.");
            yield return ("Tile",
                FormattableString.Invariant($"{waves.TileSize:0.###} m, {2L * waves.Cells * waves.Cells:N0} triangles"),
                "Side of the repeated tile, and its triangles.");
            yield return ("Tiles", FormattableString.Invariant(
                    $"{sea.TileCount:N0}, {2L * waves.Cells * waves.Cells * sea.TileCount:N0} triangles"),
                "All are instances of one mesh and take little more memory than one.");
        }

        /// <summary>Number (from 1), time and wave height of a snapshot.</summary>
        public static string Name(Sea sea, int number)
        {
            var snapshot = sea.Snapshots.ElementAtOrDefault(number - 1);
            return snapshot == null ? FormattableString.Invariant($"{number} (empty)")
                : FormattableString.Invariant(
                    $"{number}: {snapshot.name}, {snapshot.TimeSeconds:0.###} s, {snapshot.WaveHeight:0.00} m high");
        }
    }
}
