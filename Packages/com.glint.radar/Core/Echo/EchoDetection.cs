using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Detection of targets on profiles, or on maps where there are pulses: on received power with its noise if there
    /// is a radar.
    /// </summary>
    public sealed class EchoDetection
    {
        const string LevelName = "detection", RateName = "false_alarm_rate";

        // Reference cells on a side: along the range of a profile, and of a map, and rows of a map. Of a window's main
        // lobe this many bins are guarded.
        const int OfProfile = 16, OfMap = 8, RowsOfMap = 4, GuardBins = 2;

        static readonly string[] s_names = { "ca", "os" };

        /// <summary>Names of <see cref="CfarLevel"/>, in its order.</summary>
        public static IReadOnlyList<string> Names => s_names;

        /// <summary>The level of a name.</summary>
        public static CfarLevel LevelOf(string name) => (CfarLevel)Array.IndexOf(s_names, name);

        /// <summary>What is taken for the level of noise and clutter: one of <see cref="Names"/>.</summary>
        public string Level { get; set; }

        /// <summary>False alarms a cell.</summary>
        public double FalseAlarmRate { get; set; }

        /// <summary>
        /// The detections of a direction, in order of the cells: column and row of a map, row 0 of a profile. Cells are
        /// those of a transform without padding, whose noise is nearly independent.
        /// </summary>
        /// <param name="echo">Of the run.</param>
        public IEnumerable<EchoDetected> Detect(EchoProfiles echo, int direction, Polarisation polarisation)
        {
            var range = echo.Settings.RangeOf(echo.Plan, 1);
            var doppler = echo.Settings.DopplerOf(echo.Plan, range, 1);
            var values = echo.Settings.Radar == null
                ? (Func<int, Polarisation, int, Complex[]>)echo.Responses
                : echo.Received;
            var cells = doppler == null
                ? range.Profile(values(direction, polarisation, 0))
                : echo.Map(doppler, direction, polarisation, values);
            int Guard(int size, int bins) => (int)Math.Ceiling(GuardBins * (double)size / bins);
            int guard = Guard(range.Cells, echo.Band.Count);
            var level = LevelOf(Level);
            if (doppler == null)
                return Detected(new Cfar(level, FalseAlarmRate, OfProfile, guard), cells, 0, range, null);
            // The first and the last speed are neighbours.
            int guardRows = Guard(doppler.Rows, echo.Plan.PulseCount);
            return Detected(new Cfar(level, FalseAlarmRate, OfMap, guard, RowsOfMap, guardRows), cells,
                RowsOfMap + guardRows, range, doppler);
        }

        static IEnumerable<EchoDetected> Detected(Cfar cfar, Complex[] cells, int addedRows, RangeTransform range,
            RangeDopplerTransform doppler)
        {
            int added = addedRows * range.Cells;
            double[] power = PowerLevel.Of(Enumerable.Range(-added, cells.Length + 2 * added)
                .Select(cell => cells[(cell % cells.Length + cells.Length) % cells.Length]));
            return cfar.Detect(power, range.Cells).Select(cell => cell - added)
                .Where(cell => cell >= 0 && cell < cells.Length).Select(cell => new EchoDetected
                {
                    Range = range.RangeOf(cell % range.Cells), Speed = doppler?.SpeedOf(cell / range.Cells),
                    Level = ScatteringMatrix.Dbsm(cells[cell])
                });
        }

        internal void AddTo(List<RunSetting> settings)
        {
            settings.Add(new RunSetting(LevelName, Level));
            settings.Add(new RunSetting(RateName, FalseAlarmRate, "1"));
        }

        internal static EchoDetection Of(RunInfo info) => !EchoSettings.Has(info, LevelName)
            ? null
            : new EchoDetection
            {
                Level = EchoSettings.Find(info, LevelName).Text,
                FalseAlarmRate = EchoSettings.Find(info, RateName).Number
            };
    }

    /// <summary>A cell above the threshold.</summary>
    public struct EchoDetected
    {
        /// <summary>Metres.</summary>
        public double Range;

        /// <summary>Metres a second, positive towards the radar; null without pulses.</summary>
        public double? Speed;

        /// <summary>dBW with a radar, else dBsm.</summary>
        public double Level;
    }
}
