using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>
    /// Cross sections over azimuth, of the radar or of the receivers, ready to be drawn in polar coordinates: a curve
    /// for each polarisation. All else is that of the last row: elevation, frequency, and the receiver or the radar.
    /// </summary>
    /// <remarks>
    /// The plot is the view from above with the -Z side at the top: azimuth 0 is at the top, and azimuths grow
    /// clockwise. Radius 0 is the lowest level of the scale, radius 1 the highest.
    /// </remarks>
    sealed class PolarPlot
    {
        /// <summary>Range of decibels below the maximum; lower values are drawn in the centre.</summary>
        public const double DeepestDb = 40;

        const int MaxCurves = 2, MaxRings = 5;

        // Of the largest step, by which the gap of a whole turn may exceed it.
        const double Rounding = 1e-9;

        readonly double _first, _span;

        /// <param name="rows">One at least.</param>
        /// <param name="isOverReceivers">The rows have receivers, and azimuths are theirs.</param>
        public PolarPlot(IReadOnlyList<CrossSectionRow> rows, bool isOverReceivers = false)
        {
            var last = rows[rows.Count - 1].Planned;
            double AzimuthOf(CrossSectionRow row) =>
                isOverReceivers ? row.Planned.ReceiverAzimuthDegrees.Value : row.Planned.AzimuthDegrees;
            var cut = rows.Where(row => row.Planned.ElevationDegrees == last.ElevationDegrees
                && row.Planned.Frequency == last.Frequency
                && (isOverReceivers ? row.Planned.Pose == last.Pose : row.Planned.Receiver == last.Receiver))
                .OrderBy(AzimuthOf).ToArray();
            // Co-polarised ones first.
            var shown = Polarisation.All.Where(polarisation => cut[0].Amplitude(polarisation).HasValue)
                .OrderBy(polarisation => polarisation.Received == polarisation.Sent ? 0 : 1).Take(MaxCurves).ToArray();
            double[] azimuths = Array.ConvertAll(cut, AzimuthOf);
            (_first, _span) = (azimuths[0], azimuths[azimuths.Length - 1] - azimuths[0]);
            Levels = ScaleOf(shown.SelectMany(polarisation => cut.Select(row => LevelOf(row, polarisation))));
            IsWholeTurn = azimuths.Length > 2
                && 360 - _span <= (1 + Rounding) * azimuths.Zip(azimuths.Skip(1), (a, b) => b - a).Max();
            Curves = Array.ConvertAll(shown, polarisation => new PolarCurve
            {
                Name = polarisation.Name.ToUpperInvariant(),
                Points = Array.ConvertAll(cut, row => new ChartPoint
                {
                    X = _span > 0 ? (AzimuthOf(row) - _first) / _span : 0,
                    Y = Math.Max(0, Levels.Of(LevelOf(row, polarisation)))
                })
            });
            Title = FormattableString.Invariant(
                $"dBsm, elevation {last.ElevationDegrees:0.###}°, {last.Frequency / 1e9:0.######} GHz");
            if (!(last.ReceiverAzimuthDegrees is double receiver))
                return;
            OtherAzimuth = isOverReceivers ? last.AzimuthDegrees : receiver;
            Notes = isOverReceivers
                ? new[] { "over receivers", FormattableString.Invariant($"radar at {last.AzimuthDegrees:0.###}°") }
                : new[]
                {
                    FormattableString.Invariant($"receiver at {receiver:0.###}°"),
                    FormattableString.Invariant($"elevation {last.ReceiverElevationDegrees:0.###}°")
                };
        }

        /// <summary>The curves, in the order of their colours.</summary>
        public IReadOnlyList<PolarCurve> Curves { get; }

        /// <summary>Levels in dBsm: from the centre to the rim, with a ring for each tick.</summary>
        public ChartScale Levels { get; }

        /// <summary>Whether the azimuths go all around, so that the last point is joined to the first.</summary>
        public bool IsWholeTurn { get; }

        /// <summary>What the levels are.</summary>
        public string Title { get; }

        /// <summary>
        /// Azimuth of the receiver, or of the radar where the curves are over receivers, degrees; null: the radar
        /// receives.
        /// </summary>
        public double? OtherAzimuth { get; }

        /// <summary>What is at <see cref="OtherAzimuth"/>, in lines.</summary>
        public IReadOnlyList<string> Notes { get; } = Array.Empty<string>();

        /// <summary>Azimuth of a point of a curve, degrees.</summary>
        public double AzimuthOf(in ChartPoint point) => _first + point.X * _span;

        static double LevelOf(CrossSectionRow row, Polarisation polarisation) =>
            ScatteringMatrix.Dbsm(row.Amplitude(polarisation).Value);

        static ChartScale ScaleOf(IEnumerable<double> levels)
        {
            var finite = levels.Where(level => !double.IsInfinity(level)).ToArray();
            double max = finite.Length > 0 ? finite.Max() : 0;
            double min = finite.Length > 0 ? Math.Max(finite.Min(), max - DeepestDb) : -DeepestDb;
            return ChartScale.Around(min, max, MaxRings);
        }
    }

    /// <summary>A polarisation over azimuth.</summary>
    sealed class PolarCurve
    {
        /// <summary>"VV".</summary>
        public string Name;

        /// <summary>By azimuth; Y is the radius, 0 to 1.</summary>
        public IReadOnlyList<ChartPoint> Points;
    }
}
