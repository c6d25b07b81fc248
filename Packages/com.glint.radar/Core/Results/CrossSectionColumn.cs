using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>The columns of rcs.csv.</summary>
    public static class CrossSectionColumn
    {
        /// <summary>Direction of the radar.</summary>
        public static readonly ResultColumn Azimuth =
            Of("azimuth_deg", "Azimuth", "deg", row => row.Planned.AzimuthDegrees);

        /// <inheritdoc cref="Azimuth"/>
        public static readonly ResultColumn Elevation =
            Of("elevation_deg", "Elevation", "deg", row => row.Planned.ElevationDegrees);

        /// <summary>Frequency.</summary>
        public static readonly ResultColumn Frequency =
            Of("frequency_hz", "Frequency", "Hz", row => row.Planned.Frequency);

        /// <summary>Direction of the receiver; none where the radar receives.</summary>
        public static readonly ResultColumn ReceiverAzimuth = ResultColumn.MissingAllowed(
            Of("receiver_azimuth_deg", "Azimuth of the receiver", "deg", row => row.Planned.ReceiverAzimuthDegrees));

        /// <inheritdoc cref="ReceiverAzimuth"/>
        public static readonly ResultColumn ReceiverElevation = ResultColumn.MissingAllowed(Of("receiver_elevation_deg",
            "Elevation of the receiver", "deg", row => row.Planned.ReceiverElevationDegrees));

        /// <summary>
        /// Standard error of the integration, decibels: of the polarisation that has the largest one beside its amplitude.
        /// </summary>
        public static readonly ResultColumn ErrorDb =
            Of("integration_error_db", "Error of the integration", "dB", row => row.Accuracy.ErrorDb);

        /// <summary>Standard error of the integration, of the amplitudes of VV and HH.</summary>
        public static readonly ResultColumn Error =
            Of("integration_error_m", "Error of the integration, of S", "m", row => row.Error);

        /// <summary>Whether the error is as small as was asked for.</summary>
        public static readonly ResultColumn ToleranceMet =
            Flag("tolerance_met", "Tolerance met", row => row.MeetsTolerance);

        /// <summary>Whether physical optics does not hold.</summary>
        public static readonly ResultColumn OutsidePhysicalOptics =
            Flag("outside_physical_optics", "Outside physical optics", row => row.IsOutsidePhysicalOptics);

        /// <summary>Share of the area whose facets are too coarse for a curved surface.</summary>
        public static readonly ResultColumn CoarseShare =
            Of("coarse_area_share", "Share of the area with coarse facets", "1", row => row.CoarseShare);

        /// <summary>Tubes of the trace that the row is from.</summary>
        public static readonly ResultColumn Tubes = Of("tubes", "Tubes", "1", row => row.Tubes);

        /// <summary>Rays of the trace that the row is from.</summary>
        public static readonly ResultColumn Rays = Of("rays", "Rays", "1", row => row.Rays);

        /// <summary>Time of a pulse after the first; only with pulses.</summary>
        public static readonly ResultColumn Time = Optional(Of("time_s", "Time", "s", row => row.Planned.Time));

        // Rows of older files do not have these.
        static readonly ResultColumn[] s_ofLastVersion =
        {
            ResultColumn.MissingAllowed(Of("bounces", "Bounces at most", "1", row => row.Bounces)),
            ResultColumn.MissingAllowed(Of("cross_integration_error_m", "Error of the integration, of S of HV and VH", "m",
                row => row.CrossError))
        };

        static readonly (ResultColumn re, ResultColumn im)[] s_amplitudes =
            Polarisation.All.Select(polarisation => (Of(polarisation, "re", "real part", amplitude => amplitude.Real),
                Of(polarisation, "im", "imaginary part", amplitude => amplitude.Imaginary))).ToArray();

        /// <summary>Every column, in the order of the file.</summary>
        public static IReadOnlyList<ResultColumn> All { get; } = ResultColumn.Number(
            new[] { Azimuth, Elevation, Frequency, ReceiverAzimuth, ReceiverElevation }
                .Concat(Polarisation.All.SelectMany((polarisation, i) =>
                    new[] { Level(polarisation), s_amplitudes[i].re, s_amplitudes[i].im }))
                .Concat(new[]
                {
                    ErrorDb, Error, ToleranceMet, OutsidePhysicalOptics,
                    CoarseShare, Tubes, Rays, Time
                }).Concat(s_ofLastVersion).ToArray());

        /// <summary>Those of responses over a band, whose arrays have a place for each: all but the last two.</summary>
        public static IReadOnlyList<ResultColumn> OfEchoes { get; } = All.Except(s_ofLastVersion).ToArray();

        /// <summary>The amplitude of a polarisation in a row, metres; null if it was not asked for.</summary>
        public static Complex? Amplitude(StoredRow row, Polarisation polarisation)
        {
            var (re, im) = s_amplitudes[((IList<Polarisation>)Polarisation.All).IndexOf(polarisation)];
            return row[re] is double real && row[im] is double imaginary
                ? new Complex(real, imaginary)
                : (Complex?)null;
        }

        static ResultColumn Level(Polarisation polarisation) => ResultColumn.MissingAllowed(Of($"{polarisation.Name}_dbsm",
            $"Cross section, {polarisation.Name.ToUpperInvariant()}", "dBsm",
            row => row.Amplitude(polarisation) is Complex amplitude && amplitude != Complex.Zero
                ? ScatteringMatrix.Dbsm(amplitude)
                : (double?)null));

        static ResultColumn Of(Polarisation polarisation, string part, string partTitle, Func<Complex, double> value) =>
            ResultColumn.MissingAllowed(Of($"{polarisation.Name}_{part}_m",
                $"S {polarisation.Name.ToUpperInvariant()}, {partTitle}", "m",
                row => row.Amplitude(polarisation) is Complex amplitude ? value(amplitude) : (double?)null));

        static ResultColumn Of(string name, string title, string unit, Func<CrossSectionRow, double?> value) =>
            ResultColumn.Of(name, title, unit, value);

        static ResultColumn Flag(string name, string title, Func<CrossSectionRow, bool> value)
        {
            var column = Of(name, title, "1", row => value(row) ? 1 : 0);
            column.IsFlag = true;
            return column;
        }

        static ResultColumn Optional(ResultColumn column)
        {
            column.IsOptional = true;
            return ResultColumn.MissingAllowed(column);
        }
    }
}
