using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// Detection of targets on a turn at a constant false-alarm rate, along the range of each spoke: on the levels behind
    /// beam and pulse, before the receiver's controls.
    /// </summary>
    [Serializable]
    public struct ScreenDetection
    {
        // Reference cells on a side.
        const int Reference = 16;

        /// <summary>The numbers.</summary>
        public static readonly IReadOnlyList<Measure> Measures = new MeasureList<ScreenDetection>
        {
            { nameof(FalseAlarmRate), it => it.FalseAlarmRate, "False Alarm Rate", "",
                Interval.Closed(1e-12, 0.5), "False alarms a cell in noise. In spiky clutter there are more." }
        };

        /// <summary>What is taken for the level of noise and clutter.</summary>
        public CfarLevel Level;

        /// <summary>False alarms a cell.</summary>
        public double FalseAlarmRate;

        /// <summary>The mean of the reference cells, and one false alarm in a million cells.</summary>
        public static ScreenDetection Default => new ScreenDetection { FalseAlarmRate = 1e-6 };

        /// <inheritdoc cref="ScreenRadar.Validate"/>
        public void Validate(string subject)
        {
            foreach (var measure in Measures)
                Require.Within(subject, measure, this);
        }

        /// <summary>The cells of a turn above the threshold, spoke by spoke.</summary>
        /// <param name="levels">dB over noise, spoke by spoke.</param>
        public List<ScreenDetected> Detect(ScreenGeometry geometry, float[] levels)
        {
            double[] power = levels.Select(level => PowerLevel.FromDecibels(level)).ToArray();
            int cells = geometry.Radar.Cells;
            // The echo of a point covers one cell less than the pulse on each side.
            // Noise is correlated over the pulse.
            int pulse = geometry.Pulse.Length;
            var cfar = new Cfar(Level, FalseAlarmRate, Reference, pulse, step: pulse);
            return cfar.Detect(power, cells).Select(index => new ScreenDetected
            {
                Index = index,
                BearingDegrees = 360.0 * (index / cells) / geometry.Radar.Spokes,
                Range = (index % cells + 0.5) * geometry.CellSize, LevelDb = levels[index],
                OverThresholdDb = levels[index] - PowerLevel.ToDecibels(cfar.Threshold(power, cells, index))
            }).ToList();
        }
    }

    /// <summary>A cell of a turn above the threshold.</summary>
    public struct ScreenDetected
    {
        /// <summary>Place in the turn, spoke by spoke.</summary>
        public int Index;

        /// <summary>True bearing of the spoke, degrees from north, clockwise.</summary>
        public double BearingDegrees;

        /// <summary>Of the middle of the cell, metres.</summary>
        public double Range;

        /// <summary>dB over noise.</summary>
        public double LevelDb;

        /// <summary>dB over the threshold.</summary>
        public double OverThresholdDb;
    }
}
