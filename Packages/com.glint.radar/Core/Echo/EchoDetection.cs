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

        // From a reference cell to the next, noise bandwidths of the window: the power of noise there is correlated by
        // less than 1/20. At 1e-6 the mean gives the asked rate within a fifth (EchoDetectionTests).
        const double StepBandwidths = 1.5;

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
        /// those of a transform with the least padding.
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
            var (cfar, reach) = DetectorOf(Window.Named(echo.Settings.Window), echo.Band.Count, range.Cells,
                doppler == null ? 1 : echo.Plan.PulseCount, doppler?.Rows ?? 1);
            return Detected(cfar, cells, reach, range, doppler);
        }

        /// <summary>
        /// The detector of profiles or maps, and how many rows on either side of a cell it takes reference cells from.
        /// The window correlates noise over neighbouring cells, and padding divides a bin into several of them:
        /// reference cells are as far apart as makes them nearly independent.
        /// </summary>
        /// <param name="pulses">1 for profiles.</param>
        internal (Cfar cfar, int reach) DetectorOf(Window window, int frequencies, int cells, int pulses, int rows)
        {
            int StepOf(int size, int bins) =>
                (int)Math.Ceiling(StepBandwidths * window.NoiseBandwidth * size / bins);
            int GuardOf(int size, int bins, int step) =>
                Math.Max(step - 1, (int)Math.Ceiling(GuardBins * (double)size / bins));
            // Echoes outside the unambiguous range are folded: the first and the last cell are neighbours, and so are
            // the first and the last speed. Reference cells keep clear of the tested cell there, and rows of each
            // other.
            int step = StepOf(cells, frequencies), guard = GuardOf(cells, frequencies, step),
                reference = Math.Max(1, Math.Min(pulses == 1 ? OfProfile : OfMap, (cells - 2 * guard) / step));
            var level = LevelOf(Level);
            if (pulses == 1)
                return (new Cfar(level, FalseAlarmRate, reference, guard, step: step), 0);
            int rowStep = StepOf(rows, pulses), most = Math.Max(0, (rows - rowStep) / 2),
                guardRows = Math.Min(most, GuardOf(rows, pulses, rowStep)),
                referenceRows = Math.Min(RowsOfMap, (most - guardRows) / rowStep);
            return (new Cfar(level, FalseAlarmRate, reference, guard, referenceRows, guardRows, step, rowStep),
                guardRows + referenceRows * rowStep);
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
