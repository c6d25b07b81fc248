using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Editor
{
    /// <summary>Histogram of the phases of a pose's received rays.</summary>
    sealed class PhaseChart
    {
        /// <param name="pose">Null for none.</param>
        public PhaseChart(PoseFigures pose)
        {
            var bins = pose?.PhaseHistogram ?? Array.Empty<int>();
            int largest = bins.Append(0).Max();
            Y = ChartScale.Around(0, Math.Max(1, largest), 4);
            Heights = bins.Select(bin => Y.Of(bin)).ToArray();
            Text = pose == null ? "No pose is chosen."
                : pose.PhaseHistogram == null ? $"{pose.Name}: the phases are not known."
                : pose.RaysReceived == 0 ? $"{pose.Name}: no ray was received."
                : FormattableString.Invariant(
                    $"{pose.Name}: {pose.RaysReceived:#,0} {(pose.RaysReceived == 1 ? "ray" : "rays")} in bins of {360.0 / bins.Length:0.##} degrees. Rays of like phase add up; spread evenly over all phases they cancel.");
        }

        /// <summary>Heights of the bars from phase 0 to 360 degrees, 0 to 1.</summary>
        public IReadOnlyList<double> Heights { get; }

        /// <summary>Number of rays.</summary>
        public ChartScale Y { get; }

        /// <summary>Phase in degrees.</summary>
        public ChartScale X { get; } = ChartScale.Over(0, 360, 4);

        /// <summary>Description of the chart.</summary>
        public string Text { get; }
    }
}
