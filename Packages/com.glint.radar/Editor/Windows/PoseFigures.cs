using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>A pose in numbers, as charts and comparisons take it: traced just now, stored, or published.</summary>
    sealed class PoseFigures
    {
        readonly double?[] _values = new double?[SweepAxis.All.Count];

        PoseFigures()
        {
        }

        /// <summary>Of a row that was written or read.</summary>
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

        /// <summary>Of a published row.</summary>
        /// <param name="axis">What the table steps through.</param>
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

        /// <summary>The rows of a results folder, of a sweep that is not finished too.</summary>
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
        /// Where it stands on an axis, in its unit; null where the axis was left alone.
        /// Of a stored row the angle is 0 then.
        /// </summary>
        public double? this[SweepAxis axis] => _values[axis.Index];

        /// <summary>"15 deg", "snapshot 3, 15 deg"; "the pose" where nothing was moved.</summary>
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
        /// About how far <see cref="Normalised"/> is from that of endlessly many rays; 0 where it is not known.
        /// </summary>
        public double SamplingError { get; private set; }

        public double RaysReceived { get; private set; }

        public double RaysHit { get; private set; }

        /// <summary>Whether the amplitude is not to be trusted.</summary>
        public bool IsUndersampled { get; private set; }

        /// <summary>Received rays by phase; null where it is not known.</summary>
        public int[] PhaseHistogram { get; private set; }
    }
}
