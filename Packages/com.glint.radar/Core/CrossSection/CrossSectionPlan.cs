using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// The rows of cross sections, in order: every receiver for each frequency, all these for each pulse if there are
    /// pulses, these for each azimuth, and so on for each elevation.
    /// </summary>
    public sealed class CrossSectionPlan
    {
        /// <summary>Maximum number of rows.</summary>
        public const int Limit = 1000000;

        readonly double[] _azimuths, _elevations, _frequencies, _receiverAzimuths;
        readonly double _receiverElevation;

        // Of the identity.
        const string PulsesName = "pulse_count", RepetitionName = "pulse_repetition_frequency_hz";

        /// <summary>A plan.</summary>
        /// <param name="azimuths">Of the radar, degrees.</param>
        /// <param name="elevations">Of the radar, degrees.</param>
        /// <param name="frequencies">Hertz; taken in ascending order.</param>
        /// <param name="receiverAzimuths">Of receivers apart from the radar, degrees; null: the radar receives.</param>
        /// <param name="receiverElevation">Of these receivers, degrees.</param>
        /// <param name="pulses">Of each direction; null: the scene stands still.</param>
        /// <exception cref="UsageException">
        /// A frequency is given twice, or there are more than <see cref="Limit"/> rows.
        /// </exception>
        public CrossSectionPlan(double[] azimuths, double[] elevations, double[] frequencies,
            double[] receiverAzimuths = null, double receiverElevation = 0, PulseTrain pulses = null)
            : this(azimuths, elevations, frequencies, receiverAzimuths, receiverElevation, pulses, null)
        {
        }

        /// <summary>A plan of a track: a pose for each of its places.</summary>
        /// <inheritdoc cref="CrossSectionPlan(double[], double[], double[], double[], double, PulseTrain)"/>
        public CrossSectionPlan(RadarTrack track, double[] frequencies) : this(new[] { track.AzimuthDegrees },
            new[] { track.ElevationDegrees }, frequencies, null, 0, null, track)
        {
        }

        /// <summary>A plan of receivers at the elevation of the radar.</summary>
        /// <exception cref="UsageException">
        /// The radar has several elevations, a frequency is given twice, or there are more than
        /// <see cref="Limit"/> rows.
        /// </exception>
        /// <inheritdoc cref="CrossSectionPlan(double[], double[], double[], double[], double, PulseTrain)"/>
        public static CrossSectionPlan OfReceivers(double[] azimuths, double[] elevations, double[] frequencies,
            double[] receiverAzimuths, PulseTrain pulses = null) => elevations.Length == 1
                ? new CrossSectionPlan(azimuths, elevations, frequencies, receiverAzimuths, elevations[0], pulses)
                : throw new UsageException($"there are {elevations.Length} elevations, and the receivers have that of "
                    + "the radar: give one elevation");

        CrossSectionPlan(double[] azimuths, double[] elevations, double[] frequencies, double[] receiverAzimuths,
            double receiverElevation, PulseTrain pulses, RadarTrack track)
        {
            (Pulses, Track) = (pulses, track);
            (_azimuths, _elevations) = (azimuths, elevations);
            (_receiverAzimuths, _receiverElevation) = (receiverAzimuths, receiverElevation);
            _frequencies = frequencies.OrderBy(frequency => frequency).ToArray();
            for (int i = 1; i < _frequencies.Length; i++)
                if (_frequencies[i] == _frequencies[i - 1])
                    throw new UsageException($"the frequency {Numbers.Format(_frequencies[i])} Hz is given twice: "
                        + "give each once");
            Count = CountOf((double)Poses * PulseCount * frequencies.Length * Receivers);
        }

        /// <summary>A number of rows that is possible.</summary>
        /// <exception cref="UsageException">There are more than <see cref="Limit"/>.</exception>
        public static int CountOf(double rows) => rows <= Limit
            ? (int)rows
            : throw new UsageException($"there are more than {Limit.ToString("N0", CultureInfo.InvariantCulture)} rows: "
                + "shorten a list, or give its parts to several commands");

        /// <summary>Number of rows.</summary>
        public int Count { get; }

        /// <summary>Directions of the radar.</summary>
        public int Poses => Track?.Count ?? _azimuths.Length * _elevations.Length;

        /// <summary>The track of the radar; null: it turns at one range.</summary>
        public RadarTrack Track { get; }

        /// <summary>Receivers of each pose.</summary>
        public int Receivers => _receiverAzimuths?.Length ?? 1;

        /// <summary>Whether receivers are apart from the radar.</summary>
        public bool IsBistatic => _receiverAzimuths != null;

        /// <summary>Whether there are several receivers, and no fewer than directions of the radar.</summary>
        public bool IsReceiverSweep => Receivers > 1 && Receivers >= Poses;

        /// <summary>The pulses of each direction; null: the scene stands still.</summary>
        public PulseTrain Pulses { get; }

        /// <summary>Number of pulses of each direction; 1 where the scene stands still.</summary>
        public int PulseCount => Pulses?.Count ?? 1;

        /// <summary>Hertz, in ascending order.</summary>
        public IReadOnlyList<double> Frequencies => _frequencies;

        /// <summary>A row.</summary>
        /// <param name="row">Its number, from 0 to <see cref="Count"/> - 1.</param>
        public PlannedCrossSection this[int row]
        {
            get
            {
                int receiver = row % Receivers, frequency = row / Receivers % _frequencies.Length;
                int pulse = row / Receivers / _frequencies.Length % PulseCount;
                int pose = row / Receivers / _frequencies.Length / PulseCount;
                var (azimuth, elevation, range) = Track?[pose]
                    ?? (_azimuths[pose % _azimuths.Length], _elevations[pose / _azimuths.Length], (double?)null);
                return new PlannedCrossSection(pose, pulse, frequency, receiver)
                {
                    Time = Pulses?.TimeOf(pulse),
                    AzimuthDegrees = azimuth, ElevationDegrees = elevation, Range = range,
                    Frequency = _frequencies[frequency],
                    ReceiverAzimuthDegrees = _receiverAzimuths?[receiver],
                    ReceiverElevationDegrees = IsBistatic ? _receiverElevation : (double?)null
                };
            }
        }

        /// <summary>
        /// What is wrong with the place of a stored row, such as "is of azimuth 15 deg, elevation 0 deg, 9000000000 Hz
        /// instead of azimuth 10 deg, elevation 0 deg, 9000000000 Hz"; null: nothing.
        /// </summary>
        /// <param name="row">Its number in the plan.</param>
        public string ProblemOf(int row, StoredRow stored)
        {
            PlannedCrossSection planned = this[row], found = PlannedCrossSection.Of(stored);
            return found.HasThePlaceOf(planned) ? null : $"is of {found} instead of {planned}";
        }

        /// <summary>Adds the lists to the identity of a sweep.</summary>
        public void AddTo(SweepIdentity identity)
        {
            void Add(ResultColumn column, params double[] values) =>
                identity.Add(column.Name, string.Join(",", values.Select(Numbers.Format)));
            Add(CrossSectionColumn.Azimuth, _azimuths);
            Add(CrossSectionColumn.Elevation, _elevations);
            Add(CrossSectionColumn.Frequency, _frequencies);
            Track?.AddTo(identity);
            if (Pulses != null)
            {
                identity.Add(PulsesName, Numbers.Format(Pulses.Count));
                identity.Add(RepetitionName, Numbers.Format(Pulses.RepetitionFrequency));
            }
            if (!IsBistatic)
                return;
            Add(CrossSectionColumn.ReceiverAzimuth, _receiverAzimuths);
            Add(CrossSectionColumn.ReceiverElevation, _receiverElevation);
        }

        /// <summary>The plan that <see cref="AddTo"/> added.</summary>
        /// <exception cref="FormatException">It is not there, or damaged.</exception>
        public static CrossSectionPlan Of(SweepIdentity identity)
        {
            double[] Require(string name) =>
                identity.FindList(name) ?? throw new FormatException($"it has no {name}");
            double[] azimuths = Require(CrossSectionColumn.Azimuth.Name),
                elevations = Require(CrossSectionColumn.Elevation.Name),
                frequencies = Require(CrossSectionColumn.Frequency.Name);
            if (RadarTrack.Of(identity.FindList, azimuths[0], elevations[0]) is RadarTrack track)
                return new CrossSectionPlan(track, frequencies);
            return new CrossSectionPlan(azimuths, elevations, frequencies,
                identity.FindList(CrossSectionColumn.ReceiverAzimuth.Name),
                identity.FindList(CrossSectionColumn.ReceiverElevation.Name)?[0] ?? 0,
                identity.FindList(PulsesName) is double[] pulses
                    ? new PulseTrain(Require(RepetitionName)[0], (int)pulses[0])
                    : null);
        }
    }

    /// <summary>A row of a <see cref="CrossSectionPlan"/>: directions and frequency.</summary>
    public struct PlannedCrossSection
    {
        // Degrees: less than the smallest step of a list.
        const double MaxRounding = 1e-9;

        internal PlannedCrossSection(int pose, int pulse, int frequencyIndex, int receiver) : this() =>
            (Pose, Pulse, FrequencyIndex, Receiver) = (pose, pulse, frequencyIndex, receiver);

        /// <summary>Number of the radar's direction, from 0.</summary>
        public int Pose { get; }

        /// <summary>Number of the pulse of the direction, from 0.</summary>
        public int Pulse { get; }

        /// <summary>Place of the frequency in the plan.</summary>
        public int FrequencyIndex { get; }

        /// <summary>Place of the receiver in the plan.</summary>
        public int Receiver { get; }

        /// <summary>Direction of the radar, degrees: <see cref="RadarAspect.At"/>.</summary>
        public double AzimuthDegrees;

        /// <inheritdoc cref="AzimuthDegrees"/>
        public double ElevationDegrees;

        /// <summary>Metres from the phase centre to a place on a track; null: that of all rows.</summary>
        public double? Range;

        /// <summary>Hertz.</summary>
        public double Frequency;

        /// <summary>Of the pulse, seconds after the first; null without pulses.</summary>
        public double? Time;

        /// <summary>Direction of the receiver, degrees; null: the radar receives.</summary>
        public double? ReceiverAzimuthDegrees;

        /// <inheritdoc cref="ReceiverAzimuthDegrees"/>
        public double? ReceiverElevationDegrees;

        /// <summary>The radar.</summary>
        public RadarAspect Radar => RadarAspect.At(AzimuthDegrees, ElevationDegrees);

        /// <summary>What receives.</summary>
        public RadarAspect ReceiverAspect => ReceiverAzimuthDegrees is double azimuth
            ? RadarAspect.At(azimuth, ReceiverElevationDegrees.Value)
            : Radar;

        /// <summary>The directions, frequency and time of a stored row; its numbers in the plan are 0.</summary>
        public static PlannedCrossSection Of(StoredRow row) => new PlannedCrossSection
        {
            AzimuthDegrees = row[CrossSectionColumn.Azimuth].Value,
            ElevationDegrees = row[CrossSectionColumn.Elevation].Value,
            Frequency = row[CrossSectionColumn.Frequency].Value,
            ReceiverAzimuthDegrees = row[CrossSectionColumn.ReceiverAzimuth],
            ReceiverElevationDegrees = row[CrossSectionColumn.ReceiverElevation],
            Time = row[CrossSectionColumn.Time]
        };

        /// <summary>Whether another row has the same directions, frequency and time.</summary>
        public bool HasThePlaceOf(in PlannedCrossSection other) => IsSame(AzimuthDegrees, other.AzimuthDegrees)
            && IsSame(ElevationDegrees, other.ElevationDegrees) && Frequency == other.Frequency && Time == other.Time
            && ReceiverAzimuthDegrees == other.ReceiverAzimuthDegrees
            && ReceiverElevationDegrees == other.ReceiverElevationDegrees;

        // Those of a track are computed, and another machine's functions may have other last digits.
        static bool IsSame(double degrees, double other) => Math.Abs(degrees - other) < MaxRounding;

        /// <summary>"azimuth 30 deg, elevation 0 deg, 10000000000 Hz".</summary>
        public override string ToString()
        {
            string receiver = ReceiverAzimuthDegrees is double azimuth && ReceiverElevationDegrees is double elevation
                ? $", received at {Numbers.Format(azimuth)} deg, {Numbers.Format(elevation)} deg"
                : "";
            return $"azimuth {Numbers.Format(AzimuthDegrees)} deg, elevation {Numbers.Format(ElevationDegrees)} deg, "
                + $"{Numbers.Format(Frequency)} Hz{receiver}"
                + (Time is double time ? $", {Numbers.Format(time)} s" : "");
        }
    }
}
