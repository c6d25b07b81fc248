using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>Figures of a RadarScreen for an inspector.</summary>
    static class ScreenFigures
    {
        /// <summary>Labels and tooltips of the fields of <see cref="ScreenRadar"/>, in their order.</summary>
        public static readonly (string field, string label, string tooltip)[] Radar = ScreenRadar.Measures
            .Select(measure => measure.Row)
            .Append((nameof(ScreenRadar.Pattern), "Pattern", "Pattern of the antenna. Beam widths are those of the "
                + "analytic ones; Table has its own, in Pattern Table."))
            .Append((nameof(ScreenRadar.Polarisation), "Polarisation",
                "Polarisation of the echo of the sea: that of slotted waveguides is horizontal.")).ToArray();

        /// <summary>The same of <see cref="ScreenReceiver"/>.</summary>
        public static readonly (string field, string label, string tooltip)[] Receiver = ScreenReceiver.Measures
            .Select(measure => measure.Row)
            .Append((nameof(ScreenReceiver.TrailMotion), "Trail Motion",
                "Relative: trails keep their place beside the own ship. True: over the ground."))
            .ToArray();

        /// <summary>The same of <see cref="ScreenDisplay"/>.</summary>
        public static readonly (string field, string label, string tooltip)[] Display = ScreenDisplay.Measures
            .Select(measure => measure.Row)
            .Prepend((nameof(ScreenDisplay.Orientation), "Orientation", "What is at the top: the bow, or north."))
            .Append((nameof(ScreenDisplay.HasHeadingLine), "Heading Line", "Draws the heading of the own ship."))
            .Append((nameof(ScreenDisplay.HasBearingLine), "Show Bearing Line",
                "Draws the electronic bearing line.")).ToArray();

        /// <summary>The same of <see cref="ScreenDetection"/>.</summary>
        public static readonly (string field, string label, string tooltip)[] Detection = ScreenDetection.Measures
            .Select(measure => measure.Row)
            .Prepend((nameof(ScreenDetection.Level), "Level",
                "Level of noise and clutter: the mean of the cells around, or the one at three quarters of their order."))
            .ToArray();

        /// <summary>Why the screen cannot turn; null if it can.</summary>
        public static Finding Check(RadarScreen screen) => Finding.Of(screen.Check);

        /// <summary>The figures: label, value, meaning; none while a setting is out of its range.</summary>
        public static IEnumerable<(string label, string value, string tooltip)> Rows(RadarScreen screen)
        {
            if (Check(screen) != null)
                yield break;
            var geometry = screen.NewGeometry();
            var radar = geometry.Radar;
            yield return ("Cell", FormattableString.Invariant(
                    $"{geometry.CellSize:0.##} m by {360.0 / radar.Spokes:0.###} deg"),
                "Range cell, and angle between spokes.");
            yield return ("Pulse", FormattableString.Invariant($"{geometry.PulseLength:0.#} m"),
                "Half of the pulse's length: closer echoes are one.");
            yield return ("Beam", FormattableString.Invariant($"{geometry.BeamWidth:0.##} deg"),
                "Width of the beam between the points of half power.");
            yield return ("Noise", FormattableString.Invariant(
                $"{PowerLevel.ToDecibels(geometry.NoisePower):0.0} dBW"), "Mean power of the receiver's noise.");
            yield return ("10 m2 over noise", FormattableString.Invariant(
                    $"{geometry.OverNoiseDb(10, radar.RangeScale):0.0} dB"),
                "A reflector of 10 m2 at the edge of the picture in free space.");
            if (screen.PointCount > 0)
                yield return ("Meshes", FormattableString.Invariant(
                        $"{screen.PointCount} points, {screen.PointSpacing:0.0#} m"),
                    "Points of the meshes' surfaces that echo, and their distance on large objects.");
        }
    }
}
