using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>Display options of the window's charts.</summary>
    [Serializable]
    sealed class ChartChoice
    {
        /// <summary>
        /// Name of the axis; if the run does not sweep it, the fastest axis is shown.
        /// </summary>
        public string Axis = "";

        /// <summary>Amplitudes in decibels; polar chart; raw instead of normalised amplitudes.</summary>
        public bool InDecibels, IsPolar, IsRaw;

        /// <summary>Index of the pose whose phases are shown, from 0; -1: the strongest.</summary>
        public int Pose = -1;

        /// <summary>The axis for these poses.</summary>
        public SweepAxis AxisOf(IReadOnlyList<PoseFigures> rows)
        {
            var axes = SweepChart.AxesOf(rows);
            return axes.FirstOrDefault(axis => axis.Name == Axis) ?? axes[0];
        }

        public SweepChart Amplitude(IReadOnlyList<PoseFigures> rows, Comparison compared) =>
            new SweepChart(rows, AxisOf(rows), IsRaw ? Quantity.Amplitude : Quantity.Normalised,
                InDecibels, IsPolar, compared);

        public SweepChart Received(IReadOnlyList<PoseFigures> rows, Comparison compared) =>
            new SweepChart(rows, AxisOf(rows), Quantity.RaysReceived, false, IsPolar, compared);

        public SweepChart Hit(IReadOnlyList<PoseFigures> rows, Comparison compared) =>
            new SweepChart(rows, AxisOf(rows), Quantity.RaysHit, false, IsPolar, compared);

        /// <summary>The chosen pose, or the strongest; null without poses.</summary>
        public PoseFigures Chosen(IReadOnlyList<PoseFigures> rows)
        {
            int row = Row(rows);
            return row < 0 ? null : rows[row];
        }

        /// <summary>Index of the chosen pose, from 0; -1 without poses.</summary>
        public int Row(IReadOnlyList<PoseFigures> rows)
        {
            if (Pose >= 0 && Pose < rows.Count)
                return Pose;
            int strongest = -1;
            for (int i = 0; i < rows.Count; i++)
                if (strongest < 0 || rows[i].Amplitude > rows[strongest].Amplitude)
                    strongest = i;
            return strongest;
        }
    }
}
