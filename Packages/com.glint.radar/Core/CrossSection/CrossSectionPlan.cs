using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// The rows of cross sections, in order: every receiver for each frequency, all these for each azimuth, and so on
    /// for each elevation.
    /// </summary>
    public sealed class CrossSectionPlan
    {
        /// <summary>Maximum number of rows.</summary>
        public const int Limit = 1000000;

        readonly double[] _azimuths, _elevations, _frequencies, _receiverAzimuths;
        readonly double _receiverElevation;

        /// <summary>A plan.</summary>
        /// <param name="azimuths">Of the radar, degrees.</param>
        /// <param name="elevations">Of the radar, degrees.</param>
        /// <param name="frequencies">Hertz; taken in ascending order.</param>
        /// <param name="receiverAzimuths">Of receivers apart from the radar, degrees; null: the radar receives.</param>
        /// <param name="receiverElevation">Of these receivers, degrees.</param>
        /// <exception cref="UsageException">
        /// A frequency is given twice, or there are more than <see cref="Limit"/> rows.
        /// </exception>
        public CrossSectionPlan(double[] azimuths, double[] elevations, double[] frequencies,
            double[] receiverAzimuths = null, double receiverElevation = 0)
        {
            (_azimuths, _elevations) = (azimuths, elevations);
            (_receiverAzimuths, _receiverElevation) = (receiverAzimuths, receiverElevation);
            _frequencies = frequencies.OrderBy(frequency => frequency).ToArray();
            for (int i = 1; i < _frequencies.Length; i++)
                if (_frequencies[i] == _frequencies[i - 1])
                    throw new UsageException($"the frequency {Numbers.Format(_frequencies[i])} Hz is given twice: "
                        + "give each once");
            double count = (double)azimuths.Length * elevations.Length * frequencies.Length * Receivers;
            if (count > Limit)
                throw new UsageException($"there are more than {Limit.ToString("N0", CultureInfo.InvariantCulture)} "
                    + "rows: shorten a list, or give its parts to several commands");
            Count = (int)count;
        }

        /// <summary>Number of rows.</summary>
        public int Count { get; }

        /// <summary>Directions of the radar.</summary>
        public int Poses => _azimuths.Length * _elevations.Length;

        /// <summary>Receivers of each pose.</summary>
        public int Receivers => _receiverAzimuths?.Length ?? 1;

        /// <summary>Whether receivers are apart from the radar.</summary>
        public bool IsBistatic => _receiverAzimuths != null;

        /// <summary>Hertz, in ascending order.</summary>
        public IReadOnlyList<double> Frequencies => _frequencies;

        /// <summary>A row.</summary>
        /// <param name="row">Its number, from 0 to <see cref="Count"/> - 1.</param>
        public PlannedCrossSection this[int row]
        {
            get
            {
                int receiver = row % Receivers, frequency = row / Receivers % _frequencies.Length;
                int pose = row / Receivers / _frequencies.Length;
                return new PlannedCrossSection(pose, frequency, receiver)
                {
                    AzimuthDegrees = _azimuths[pose % _azimuths.Length],
                    ElevationDegrees = _elevations[pose / _azimuths.Length],
                    Frequency = _frequencies[frequency],
                    ReceiverAzimuthDegrees = _receiverAzimuths?[receiver],
                    ReceiverElevationDegrees = IsBistatic ? _receiverElevation : (double?)null
                };
            }
        }

        /// <summary>Adds the lists to the identity of a sweep.</summary>
        public void AddTo(SweepIdentity identity)
        {
            void Add(ResultColumn column, params double[] values) =>
                identity.Add(column.Name, string.Join(",", values.Select(Numbers.Format)));
            Add(CrossSectionColumn.Azimuth, _azimuths);
            Add(CrossSectionColumn.Elevation, _elevations);
            Add(CrossSectionColumn.Frequency, _frequencies);
            if (!IsBistatic)
                return;
            Add(CrossSectionColumn.ReceiverAzimuth, _receiverAzimuths);
            Add(CrossSectionColumn.ReceiverElevation, _receiverElevation);
        }

        /// <summary>The plan that <see cref="AddTo"/> added.</summary>
        /// <exception cref="System.FormatException">It is not there, or damaged.</exception>
        public static CrossSectionPlan Of(SweepIdentity identity)
        {
            double[] Find(ResultColumn column) => identity.Entries.FirstOrDefault(entry => entry.Key == column.Name)
                .Value?.Split(',').Select(text => double.Parse(text, CultureInfo.InvariantCulture)).ToArray();
            double[] Require(ResultColumn column) =>
                Find(column) ?? throw new System.FormatException($"it has no {column.Name}");
            return new CrossSectionPlan(Require(CrossSectionColumn.Azimuth), Require(CrossSectionColumn.Elevation),
                Require(CrossSectionColumn.Frequency), Find(CrossSectionColumn.ReceiverAzimuth),
                Find(CrossSectionColumn.ReceiverElevation)?[0] ?? 0);
        }
    }

    /// <summary>A row of a <see cref="CrossSectionPlan"/>: directions and frequency.</summary>
    public struct PlannedCrossSection
    {
        internal PlannedCrossSection(int pose, int frequencyIndex, int receiver) : this() =>
            (Pose, FrequencyIndex, Receiver) = (pose, frequencyIndex, receiver);

        /// <summary>Number of the radar's direction, from 0.</summary>
        public int Pose { get; }

        /// <summary>Place of the frequency in the plan.</summary>
        public int FrequencyIndex { get; }

        /// <summary>Place of the receiver in the plan.</summary>
        public int Receiver { get; }

        /// <summary>Direction of the radar, degrees: <see cref="RadarAspect.At"/>.</summary>
        public double AzimuthDegrees;

        /// <inheritdoc cref="AzimuthDegrees"/>
        public double ElevationDegrees;

        /// <summary>Hertz.</summary>
        public double Frequency;

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

        /// <summary>"azimuth 30 deg, elevation 0 deg, 10000000000 Hz".</summary>
        public override string ToString()
        {
            string receiver = ReceiverAzimuthDegrees is double azimuth
                ? $", received at {Numbers.Format(azimuth)} deg, {Numbers.Format(ReceiverElevationDegrees.Value)} deg"
                : "";
            return $"azimuth {Numbers.Format(AzimuthDegrees)} deg, elevation {Numbers.Format(ElevationDegrees)} deg, "
                + $"{Numbers.Format(Frequency)} Hz{receiver}";
        }
    }
}
