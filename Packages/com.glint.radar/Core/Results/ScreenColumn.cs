using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>The columns of the detections of <c>glint ppi</c>.</summary>
    public static class ScreenColumn
    {
        /// <summary>Every column, in the order of the file.</summary>
        public static IReadOnlyList<ResultColumn> All { get; } = ResultColumn.Number(new[]
        {
            Of("bearing_deg", "Bearing", "deg", row => row.BearingDegrees), Of("range_m", "Range", "m", row => row.Range),
            Of("level_db", "Level over noise", "dB", row => row.LevelDb),
            Of("over_threshold_db", "Over the threshold", "dB", row => row.OverThresholdDb)
        });

        static ResultColumn Of(string name, string title, string unit, Func<ScreenDetected, double?> value) =>
            ResultColumn.Of(name, title, unit, value);
    }
}
