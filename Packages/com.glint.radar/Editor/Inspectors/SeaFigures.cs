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

        /// <summary>Labels and tooltips of the fields of <see cref="SeaClutterSettings"/>, in their order.</summary>
        public static readonly (string field, string label, string tooltip)[] Clutter = SeaClutterSettings.Measures
            .Select(measure => measure.Row)
            .Prepend(("Level", "Level", "Mean of the diffuse echo: of the waves, or of a published model."))
            .Prepend(("IsOn", "Clutter", "Diffuse echo of the sea, and the reflection of its water. Off: the tiles "
                + "are perfect mirrors.")).ToArray();

        /// <summary>Why the sea cannot be shown or has no clutter, or looks wrong; null if neither.</summary>
        public static Finding Check(Sea sea)
        {
            SeaClutter clutter = null;
            var refusal = Finding.Of(sea.Check) ?? Finding.Of(() => clutter = sea.CurrentClutter());
            if (refusal != null)
                return refusal;
            if (sea.Material == null)
                return new Finding(Severity.Warning, sea.HasNoMaterial, AssignMaterial(sea));
            return clutter?.ShortWaves.StepWarning == null ? null
                : new Finding(Severity.Warning, $"Sea of '{sea.name}': {clutter.ShortWaves.StepWarning}");
        }

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
            if (waves.SwellHeight > 0)
                yield return ("Swell", FormattableString.Invariant(
                    $"{waves.SwellHeight:0.###} m high, {waves.SwellPeriod:0.###} s, to {waves.SwellDirectionDegrees:0.###} deg"),
                    "Significant height, period of the peak, and direction of the swell.");
            yield return ("Tile",
                FormattableString.Invariant($"{waves.TileSize:0.###} m, {2L * waves.Cells * waves.Cells:N0} triangles"),
                "Side of the repeated tile, and its triangles.");
            yield return ("Tiles", FormattableString.Invariant(
                    $"{sea.TileCount:N0}, {2L * waves.Cells * waves.Cells * sea.TileCount:N0} triangles"),
                "All are instances of one mesh and take little more memory than one.");
            foreach (var row in ClutterRows(sea))
                yield return row;
        }

        // None while clutter is off or refused.
        static IEnumerable<(string label, string value, string tooltip)> ClutterRows(Sea sea)
        {
            SeaClutter clutter = null;
            if (Finding.Of(() => clutter = sea.CurrentClutter()) != null || clutter == null)
                yield break;
            var waves = clutter.ShortWaves;
            yield return ("Clutter wind", FormattableString.Invariant($"{waves.Wind:0.0} m/s"),
                "Wind of the waves that the mesh leaves out.");
            yield return ("Mesh ends at", FormattableString.Invariant(
                    $"{waves.Cut:0.###} rad/m, waves of {2 * Math.PI / waves.Cut:0.###} m"),
                "The mesh carries the longer waves, clutter and roughness are of the shorter ones.");
            yield return ("Step there", FormattableString.Invariant($"{waves.Step:+0.0;-0.0;0.0} dB"),
                "Density of the short waves over that of the mesh's waves.");
            yield return ("Height left out", FormattableString.Invariant($"{1e3 * waves.Height:0.0} mm"),
                "Root mean square height of the waves that the mesh leaves out: it weakens the mirrored field.");
            yield return ("Breaking", FormattableString.Invariant($"{100 * clutter.BreakingFraction:0.00} %"),
                "Fraction of the facets that break.");
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
