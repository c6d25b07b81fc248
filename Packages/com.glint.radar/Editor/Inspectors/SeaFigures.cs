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
        public static readonly (string field, string label, string tooltip)[] Waves =
        {
            ("Kind", "Spectrum", "How the variance is spread over wavelengths."),
            ("SignificantWaveHeight", "Wave Height (m)",
                "Significant wave height: four standard deviations of the height. 0.001 to 100 m."),
            ("WindSpeed", "Wind (m/s)",
                "10 m above the sea, 0.1 to 100 m/s. It shapes the spectrum and leaves the height alone."),
            ("WindDirectionDegrees", "Wind to (deg)",
                "Where wind and waves run to, as a rotation about Y: 0 to +Z, 90 to +X."),
            ("Choppiness", "Choppiness", "Horizontal displacement over that of waves in deep water: 0 none, 1 theirs, "
                + "up to 10. Crests curl over where it is large."),
            ("TileSize", "Tile (m)",
                "Side of the tile that repeats: a multiple of 1/1024 m, 1 to 8192 m. No wave is longer."),
            ("GridSize", "Grid Points", "Points a side, a power of two from 4 to 1024: "
                + "waves down to nearly twice the tile over them are there."),
            ("Cells", "Cells", "Cells of the mesh a side, 1 to 2048, of two triangles each. "
                + "They sample the sea and do not change it."),
            ("ShortestWave", "Shortest Wave (m)", "Shorter waves are left out. 0: none are."),
            ("Fetch", "Fetch (m)", "Water that the wind has blown over, 100 to 10,000,000 m. JONSWAP only."),
            ("PeakEnhancement", "Peak Enhancement",
                "How much higher the peak is than that of a fully risen sea, 1 to 10. JONSWAP only."),
            ("Seed", "Seed", "Which of all seas with this spectrum. The same number gives the same sea."),
            ("HeightFactor", "Height Factor",
                "Multiplies the height, 0.001 to 1000: 1, or what a stored sea was scaled by."),
        };

        /// <summary>Why the sea cannot be shown; null if it can.</summary>
        public static Finding Check(Sea sea)
        {
            try
            {
                sea.Check();
                return null;
            }
            catch (GlintException problem)
            {
                return new Finding(Severity.Error, problem.Message);
            }
        }

        /// <summary>The figures: label, value, meaning.</summary>
        public static IEnumerable<(string label, string value, string tooltip)> Rows(Sea sea)
        {
            var shown = sea.CurrentSnapshot;
            var waves = shown == null ? sea.Waves : shown.Settings;
            yield return ("Shown", shown == null
                ? FormattableString.Invariant($"waves at {sea.TimeSeconds:0.###} s")
                    : $"snapshot {Name(sea, sea.Snapshot)}",
                "A stored snapshot, or a tile made from Waves where there are none.");
            yield return ("Waves", FormattableString.Invariant(
                $"{waves.Kind}, {waves.SignificantWaveHeight:0.###} m high, wind {waves.WindSpeed:0.###} m/s to {waves.WindDirectionDegrees:0.###} deg"),
                "Spectrum, significant wave height asked for, and wind that shapes it.");
            yield return ("Tile",
                FormattableString.Invariant($"{waves.TileSize:0.###} m, {2L * waves.Cells * waves.Cells:N0} triangles"),
                "Side of the tile that repeats, and its triangles.");
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
