using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// One column of result files. The table <see cref="All"/> is the only place that knows those of sweeps:
    /// CSV, JSON, the window's charts and the HTML report follow it. <see cref="CrossSectionColumn"/> has those of
    /// cross sections.
    /// </summary>
    public sealed class ResultColumn
    {
        /// <summary>In place of a value that was left out by <see cref="RadarSettings.SkipSamplingError"/>.</summary>
        public const string NotEstimated = "not estimated";

        /// <summary>Estimated error of <see cref="Normalised"/>, in its unit.</summary>
        public static readonly ResultColumn SamplingError =
            new ResultColumn("sampling_error", "Sampling error", "1", row => row.Result.SamplingError)
            {
                MayBeMissing = true, Missing = NotEstimated
            };

        /// <summary>Amplitude of the rays traced.</summary>
        public static readonly ResultColumn Amplitude =
            new ResultColumn("amplitude", "Amplitude", "1", row => row.Result.Amplitude) { IsAmplitude = true };

        /// <summary>Amplitude as if the picture had 2,073,600 rays.</summary>
        public static readonly ResultColumn Normalised = new ResultColumn("amplitude_normalised",
            "Amplitude, normalised", "1", row => row.Result.NormalisedAmplitude)
        { IsAmplitude = true, Error = SamplingError };

        /// <summary>Rays that hit anything.</summary>
        public static readonly ResultColumn RaysHit =
            new ResultColumn("rays_hit", "Rays hit", "1", row => row.Result.RaysHit);

        /// <summary>Rays that reached the receiver.</summary>
        public static readonly ResultColumn RaysReceived =
            new ResultColumn("rays_received", "Rays received", "1", row => row.Result.RaysReceived);

        /// <summary>1 where amplitude and error are not to be trusted, else 0.</summary>
        public static readonly ResultColumn Undersampled = new ResultColumn("undersampled", "Undersampled", "1",
            row => row.Result.Sampling is SamplingReport sampling ? sampling.Undersampled ? 1 : 0 : (double?)null)
        { MayBeMissing = true, Missing = NotEstimated, IsFlag = true };

        static readonly ResultColumn[] Table = Number(new[]
        {
            new ResultColumn(SweepAxis.Angle),
            Amplitude,
            new ResultColumn("amplitude_db", "Amplitude in decibels", "dB", row => row.Result.AmplitudeDb)
            {
                MayBeMissing = true
            },
            new ResultColumn("in_phase", "In phase", "1", row => row.Result.InPhase),
            new ResultColumn("quadrature", "Quadrature", "1", row => row.Result.Quadrature),
            new ResultColumn("rays_emitted", "Rays emitted", "1", row => row.Result.RaysEmitted),
            RaysHit,
            RaysReceived,
            new ResultColumn("ratio", "Received over hit", "1", row => row.Result.Ratio),
            new ResultColumn("bounces", "Bounces", "1", row => row.Result.Bounces),
            new ResultColumn("segments", "Segments", "1", row => row.Result.Segments),
            new ResultColumn("path_length_m", "Path length", "m", row => row.Result.PathLengthMeters),
            new ResultColumn("trace_ms", "Trace time", "ms", row => row.Result.Statistics.Timings.TraceMs),
            Normalised,
            SamplingError,
            new ResultColumn("largest_path_step_wavelengths", "Largest path step", "wavelengths",
                row => row.Result.LargestPathStep)
            { MayBeMissing = true, Missing = NotEstimated },
            Undersampled,
            new ResultColumn("ray_area_m2", "Ray area", "m2", row => row.Result.RayArea) { MayBeMissing = true }
        }.Concat(SweepAxis.Columns.Skip(1).Select(axis => new ResultColumn(axis)))
            .Concat(Polarisation.All.Where(it => it.Sent == it.Received).SelectMany(EchoColumns)).ToArray());

        Func<object, double?> _value;

        ResultColumn(string name, string title, string unit, Func<SweepRow, double?> value)
            : this(name, title, unit) => _value = row => value((SweepRow)row);

        ResultColumn(string name, string title, string unit) =>
            (Name, Title, Unit, JsonName) = (name, title, unit, $"\"{name}\":");

        // The angle is 0 where nothing is turned; another axis that is left alone has no value.
        ResultColumn(SweepAxis axis) : this(axis.Column, axis.Title, axis.Unit,
            row => row.Pose[axis] ?? (axis == SweepAxis.Angle ? 0 : (double?)null)) =>
            (Axis, MayBeMissing) = (axis, axis != SweepAxis.Angle);

        // Of scenes with a sea that has clutter.
        static IEnumerable<ResultColumn> EchoColumns(Polarisation polarisation)
        {
            string suffix = polarisation.Name, name = suffix.ToUpperInvariant();
            ResultColumn Column(string column, string title, string unit, Func<PoseEcho, double?> value) =>
                new ResultColumn(column, title, unit, row => row.Result.Echo == null ? null : value(row.Result.Echo))
                {
                    MayBeMissing = true, IsOptional = true
                };
            yield return Column($"sigma_{suffix}_dbsm", $"Cross section {name}", "dBsm",
                echo => echo.SigmaDbsm(polarisation));
            yield return Column($"sigma_clutter_{suffix}_dbsm", $"Clutter {name}", "dBsm",
                echo => echo.ClutterDbsm(polarisation));
            yield return Column($"signal_to_clutter_{suffix}_db", $"Signal to clutter {name}", "dB",
                echo => echo.SignalToClutterDb(polarisation));
        }

        /// <summary>Every column, in the order of the files.</summary>
        public static IReadOnlyList<ResultColumn> All => Table;

        /// <summary>Name in the CSV's first line and in the JSON's rows.</summary>
        public string Name { get; }

        /// <summary>The name before a value in JSON.</summary>
        internal string JsonName { get; }

        /// <summary>For headings and charts, without the unit.</summary>
        public string Title { get; }

        /// <summary>Unit; "1" for a plain number.</summary>
        public string Unit { get; }

        /// <summary>Whether a row, or a whole file, may lack the value.</summary>
        public bool MayBeMissing { get; internal set; }

        /// <summary>The column, with rows that may have no value.</summary>
        internal static ResultColumn MissingAllowed(ResultColumn column)
        {
            column.MayBeMissing = true;
            return column;
        }

        /// <summary>Whether files whose rows have no such value are without the column.</summary>
        public bool IsOptional { get; internal set; }

        /// <summary>Text in place of a missing value; null for none.</summary>
        public string Missing { get; private set; }

        /// <summary>Whether it is an amplitude, never below 0, that can be shown in decibels.</summary>
        public bool IsAmplitude { get; private set; }

        /// <summary>Whether it is 1 for yes and 0 for no.</summary>
        public bool IsFlag { get; internal set; }

        /// <summary>Column of the error to either side, in the same unit; null for none.</summary>
        public ResultColumn Error { get; private set; }

        /// <summary>The axis whose values it has; null for what is measured.</summary>
        public SweepAxis Axis { get; private set; }

        /// <summary>Place in its table.</summary>
        internal int Index { get; private set; }

        /// <summary>Title and unit.</summary>
        public string Label => Unit == "1" ? Title : $"{Title}, {Unit}";

        /// <summary>The value; null if the row has none, such as the decibels of amplitude 0.</summary>
        /// <exception cref="GlintException">The value is NaN or infinite.</exception>
        public double? Value(SweepRow row) => Value(row, row.Pose);

        /// <summary>A column of another table than <see cref="All"/>.</summary>
        internal static ResultColumn Of<TRow>(string name, string title, string unit, Func<TRow, double?> value) =>
            new ResultColumn(name, title, unit) { _value = row => value((TRow)row) };

        /// <summary>Gives the columns of a table their places.</summary>
        internal static ResultColumn[] Number(ResultColumn[] table)
        {
            for (int i = 0; i < table.Length; i++)
                table[i].Index = i;
            return table;
        }

        /// <summary>The value; null if the row has none.</summary>
        /// <param name="row">A row of the column's table.</param>
        /// <param name="where">The pose of the row, for the message; its text may be empty.</param>
        /// <exception cref="GlintException">The value is NaN or infinite.</exception>
        internal double? Value(object row, object where)
        {
            double? value = _value(row);
            if (value is double number && (double.IsNaN(number) || double.IsInfinity(number)))
                throw new GlintException(Name + " is not finite" + (where.ToString().Length == 0 ? "" : $" at {where}") + ": "
                    + "check the scene for huge coordinates, and report it if there are none");
            // -0 becomes 0, as it is read from the files.
            return value + 0.0;
        }

        /// <summary>The column of an axis.</summary>
        public static ResultColumn Of(SweepAxis axis) => Table.First(column => column.Axis == axis);
    }
}
