using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The controls of a radar's receiver, from the level of an echo to its brightness.</summary>
    [Serializable]
    public struct ScreenReceiver
    {
        static readonly Interval s_fractions = Interval.Closed(0, 1);

        /// <summary>The numbers, in the order of the declaration.</summary>
        public static readonly IReadOnlyList<Measure> Measures = new MeasureList<ScreenReceiver>
        {
            { nameof(GainDb), it => it.GainDb, "Gain", "dB", Interval.Closed(-100, 100),
                "Added to the level over noise before it is shown. -10 hides nearly all noise, 0 shows it." },
            { nameof(DynamicRangeDb), it => it.DynamicRangeDb, "Dynamic Range", "dB", Interval.Closed(1, 150),
                "Levels from black to full brightness." },
            { nameof(SensitivityTimeRange), it => it.SensitivityTimeRange, "Sensitivity Time", "m",
                Interval.Closed(0, 1e5),
                "Range up to which the gain rises with the cube of the range, against clutter of the sea. 0: none." },
            { nameof(RainFilter), it => it.RainFilter, "Rain Filter", "", s_fractions,
                "Share of the level one pulse nearer that is subtracted: shows where areas of echo begin. 0: none." },
            { nameof(ClutterFilter), it => it.ClutterFilter, "Clutter Filter", "", s_fractions,
                "Share of the mean level around a cell that is subtracted. 0: none." },
            { nameof(PersistenceTurns), it => it.PersistenceTurns, "Persistence", "turns", Interval.Closed(0, 100),
                "Turns in which a picture fades to 1/e. 0: it does not fade, and the next turn replaces it." },
            { nameof(TrailTurns), it => it.TrailTurns, "Trails", "turns", Interval.Closed(0, 10000),
                "Turns in which trails fade to 1/e. 0: none." }
        };

        /// <summary>dB.</summary>
        public double GainDb;

        /// <summary>dB from black to full brightness.</summary>
        public double DynamicRangeDb;

        /// <summary>Range in metres of full gain; 0: everywhere.</summary>
        public double SensitivityTimeRange;

        /// <summary>0 to 1.</summary>
        public double RainFilter;

        /// <summary>0 to 1.</summary>
        public double ClutterFilter;

        /// <summary>Turns in which the picture fades to 1/e; 0: none.</summary>
        public double PersistenceTurns;

        /// <summary>Turns in which trails fade to 1/e; 0: no trails.</summary>
        public double TrailTurns;

        /// <summary>Whether trails are relative to the own ship or true.</summary>
        public TrailMotion TrailMotion;

        /// <summary>
        /// Exponents of the fading of video and trails in a turn. 0: video does not fade, and the next turn replaces
        /// it; there are no trails.
        /// </summary>
        public double2 FadeATurn => new double2(FadeOf(PersistenceTurns), FadeOf(TrailTurns));

        /// <summary>What the next turn keeps of video.</summary>
        public double KeptATurn => PersistenceTurns > 0 ? Math.Exp(-FadeATurn.x) : 0;

        /// <summary>No filters, a picture that fades over two turns.</summary>
        public static ScreenReceiver Default => new ScreenReceiver
        {
            GainDb = -10, DynamicRangeDb = 40, PersistenceTurns = 2
        };

        /// <inheritdoc cref="ScreenRadar.Validate"/>
        public void Validate(string subject)
        {
            foreach (var measure in Measures)
                Require.Within(subject, measure, this);
        }

        static double FadeOf(double turns) => turns > 0 ? 1 / turns : 0;
    }
}
