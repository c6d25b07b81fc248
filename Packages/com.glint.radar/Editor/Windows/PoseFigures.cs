using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>Figures of a pose for charts and comparisons: traced, stored, or published.</summary>
    sealed class PoseFigures
    {
        readonly double?[] _values = new double?[SweepAxis.All.Count];

        PoseFigures()
        {
        }

        /// <summary>Figures of a stored row.</summary>
        public PoseFigures(StoredRow row)
        {
            for (int i = 0; i < _values.Length; i++)
                _values[i] = row[SweepAxis.All[i].Column];
            Amplitude = row["amplitude"].Value;
            Normalised = row["amplitude_normalised"].Value;
            SamplingError = row["sampling_error"] ?? 0;
            RaysReceived = row["rays_received"].Value;
            RaysHit = row["rays_hit"].Value;
            IsUndersampled = row["undersampled"] == 1;
            PhaseHistogram = row.PhaseHistogram;
        }

        /// <summary>Figures of a published row.</summary>
        /// <param name="axis">Axis of the table.</param>
        public static PoseFigures Of(PublishedRow row, SweepAxis axis)
        {
            var figures = new PoseFigures
            {
                Amplitude = row.Amplitude, Normalised = row.Amplitude, RaysReceived = row.RaysReceived,
                RaysHit = row.RaysHit
            };
            figures._values[axis.Index] = row.Step;
            return figures;
        }

        /// <summary>The rows of a results folder, also of an unfinished sweep.</summary>
        /// <exception cref="GlintException">There are none, or they cannot be read.</exception>
        public static IReadOnlyList<PoseFigures> OfFolder(string folder)
        {
            string partial = Path.Combine(folder, ResultsFolder.PartialName);
            if (!File.Exists(partial))
                return Of(StoredRun.Read(folder).Rows);
            return Of(UnfinishedSweep.Read(partial)?.Rows ?? (IReadOnlyList<StoredRow>)Array.Empty<StoredRow>());
        }

        static IReadOnlyList<PoseFigures> Of(IReadOnlyList<StoredRow> rows) =>
            rows.Select(row => new PoseFigures(row)).ToArray();

        /// <summary>
        /// Value on an axis, in its unit; null if the axis is not swept, except the angle of a stored row, which is 0.
        /// </summary>
        public double? this[SweepAxis axis] => _values[axis.Index];

        /// <summary>"15 deg", "snapshot 3, 15 deg"; "the pose" if nothing is swept.</summary>
        public string Name => new SweepPose(_values).ToString() is var text && text.Length > 0 ? text : "the pose";

        /// <summary>The pose and its figures, in a line.</summary>
        public string Text()
        {
            string level = Signal.Decibels(Normalised) is double decibels
                ? FormattableString.Invariant($" ({decibels:0.##} dB)")
                : "";
            string error = SamplingError > 0 ? FormattableString.Invariant($" +- {SamplingError:g2}") : "";
            return FormattableString.Invariant(
                $"{Name}: normalised amplitude {Normalised:g5}{level}{error}{(IsUndersampled ? ", undersampled" : "")}, {RaysReceived:#,0} of {RaysHit:#,0} rays that hit were received");
        }

        public double Amplitude { get; private set; }

        /// <summary>The amplitude as if the picture had 2,073,600 rays.</summary>
        public double Normalised { get; private set; }

        /// <summary>
        /// Estimated error of <see cref="Normalised"/>; 0 if unknown.
        /// </summary>
        public double SamplingError { get; private set; }

        public double RaysReceived { get; private set; }

        public double RaysHit { get; private set; }

        /// <summary>Whether the amplitude is unreliable.</summary>
        public bool IsUndersampled { get; private set; }

        /// <summary>Received rays by phase; null if unknown.</summary>
        public int[] PhaseHistogram { get; private set; }
    }
}
