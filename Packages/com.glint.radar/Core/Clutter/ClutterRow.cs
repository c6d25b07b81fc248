using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>The mean echo and the texture of a sea in one direction at one frequency: a row of clutter.csv.</summary>
    public sealed class ClutterRow
    {
        /// <summary>Number of the snapshot; null for a sea without.</summary>
        public int? Snapshot { get; set; }

        /// <summary>Time of the sea, seconds.</summary>
        public double TimeSeconds { get; set; }

        /// <summary>As of <see cref="RadarAspect.At"/>.</summary>
        public double AzimuthDegrees { get; set; }

        /// <summary>Radar and sea.</summary>
        public ClutterConditions Conditions { get; set; }

        /// <summary>Mean over the tile, without speckle.</summary>
        public Sigma0 Sigma0 { get; set; }

        /// <summary>Part of the sea that the radar sees.</summary>
        public double LitFraction { get; set; }

        /// <summary>Cells of the shapes.</summary>
        public int Cells { get; set; }

        /// <summary>Shape of the texture; null where there are too few cells, or it does not vary.</summary>
        public double? ShapeVV { get; set; }

        /// <inheritdoc cref="ShapeVV"/>
        public double? ShapeHH { get; set; }

        /// <summary>Measured shape; null where it is not defined.</summary>
        public double? MeasuredShapeVV { get; set; }

        /// <inheritdoc cref="MeasuredShapeVV"/>
        public double? MeasuredShapeHH { get; set; }

        /// <summary>
        /// Sigma0 in decibels of the published models, in the order of <see cref="ClutterColumn.Models"/>; null where a
        /// model does not hold.
        /// </summary>
        public IReadOnlyList<(double? VV, double? HH)> Models { get; set; }

        /// <summary>"grazing 3 deg, azimuth 90 deg, 1e10 Hz".</summary>
        public override string ToString() => FormattableString.Invariant(
            $"grazing {Conditions.GrazingDegrees:g4} deg, azimuth {AzimuthDegrees:g4} deg, {Conditions.Frequency:g6} Hz");
    }
}
