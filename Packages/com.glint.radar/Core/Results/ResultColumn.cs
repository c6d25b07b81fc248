using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>
    /// One column of result files. CSV and JSON follow the table <see cref="All"/>.
    /// </summary>
    public sealed class ResultColumn
    {
        static readonly ResultColumn[] Table =
        {
            new ResultColumn(SweepAxis.Angle.Column, SweepAxis.Angle.Unit, row => row.Pose.AngleDegrees ?? 0),
            new ResultColumn("amplitude", "1", row => row.Result.Amplitude),
            new ResultColumn("amplitude_db", "dB", row => row.Result.AmplitudeDb, true),
            new ResultColumn("in_phase", "1", row => row.Result.InPhase),
            new ResultColumn("quadrature", "1", row => row.Result.Quadrature),
            new ResultColumn("rays_emitted", "1", row => row.Result.RaysEmitted),
            new ResultColumn("rays_hit", "1", row => row.Result.RaysHit),
            new ResultColumn("rays_received", "1", row => row.Result.RaysReceived),
            new ResultColumn("ratio", "1", row => row.Result.Ratio),
            new ResultColumn("bounces", "1", row => row.Result.Bounces),
            new ResultColumn("segments", "1", row => row.Result.Segments),
            new ResultColumn("path_length_m", "m", row => row.Result.PathLengthMeters),
            new ResultColumn("trace_ms", "ms", row => row.Result.Statistics.Timings.TraceMs),
            new ResultColumn("amplitude_normalised", "1", row => row.Result.NormalisedAmplitude),
            new ResultColumn("sampling_error", "1", row => row.Result.SamplingError, true),
            new ResultColumn("largest_path_step_wavelengths", "wavelengths", row => row.Result.LargestPathStep,
                true),
            new ResultColumn("undersampled", "1",
                row => row.Result.Sampling?.Undersampled == true ? 1 : row.Result.Sampling.HasValue ? 0 : (double?)null,
                true),
            new ResultColumn("ray_area_m2", "m2", row => row.Result.RayArea, true),
            new ResultColumn(SweepAxis.Snapshot),
            new ResultColumn(SweepAxis.Grazing),
            new ResultColumn(SweepAxis.Range),
            new ResultColumn(SweepAxis.Frequency)
        };

        readonly Func<SweepRow, double?> _value;

        ResultColumn(string name, string unit, Func<SweepRow, double?> value, bool mayBeEmpty = false)
        {
            Name = name;
            Unit = unit;
            _value = value;
            MayBeEmpty = mayBeEmpty;
        }

        ResultColumn(SweepAxis axis) : this(axis.Column, axis.Unit, row => row.Pose[axis], true)
        {
        }

        /// <summary>Every column, in the order of the files.</summary>
        public static IReadOnlyList<ResultColumn> All => Table;

        /// <summary>Name in the CSV's first line and in the JSON's rows.</summary>
        public string Name { get; }

        /// <summary>Unit; "1" for a plain number.</summary>
        public string Unit { get; }

        /// <summary>Whether a row may have no value.</summary>
        internal bool MayBeEmpty { get; }

        /// <summary>The value; null if the row has none, such as the decibels of amplitude 0.</summary>
        /// <exception cref="GlintException">The value is NaN or infinite.</exception>
        public double? Value(SweepRow row)
        {
            double? value = _value(row);
            if (value is double number && (double.IsNaN(number) || double.IsInfinity(number)))
                throw new GlintException($"{Name} is not finite{At(row.Pose)}: check the scene for huge coordinates, "
                    + "and report it if there are none");
            return value;
        }

        static string At(SweepPose pose)
        {
            string where = pose.ToString();
            return where.Length == 0 ? "" : " at " + where;
        }
    }
}
