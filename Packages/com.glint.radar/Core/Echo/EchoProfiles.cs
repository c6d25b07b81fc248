using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading.Tasks;

namespace Glint.Core
{
    /// <summary>
    /// The responses and range profiles of a whole run, by direction and polarisation. A direction is a pose and one
    /// of its receivers, the receivers of a pose after each other.
    /// </summary>
    public sealed class EchoProfiles
    {
        readonly IReadOnlyList<StoredRow> _rows;
        readonly ThermalNoise _noise;
        readonly Func<IsarTransform, IReadOnlyList<Complex[]>, Complex[]> _backproject;
        readonly Dictionary<Polarisation, Complex[]> _images = new Dictionary<Polarisation, Complex[]>();

        /// <summary>The profiles of a run.</summary>
        /// <param name="rows">All rows of the plan.</param>
        /// <exception cref="FormatException">The run is no whole run of echoes.</exception>
        public EchoProfiles(RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            Plan = CrossSectionPlan.Of(info.Sweep);
            if (rows.Count != Plan.Count)
                throw new FormatException($"it has {rows.Count} of {Plan.Count} rows");
            Settings = EchoSettings.Of(info);
            Band = Settings.BandOf(Plan);
            Range = Settings.RangeOf(Plan);
            Doppler = Settings.DopplerOf(Plan, Range);
            Polarisations = EchoSettings.PolarisationsOf(info);
            _noise = Settings.Radar?.NoiseOf(Band);
            _rows = rows;
            _backproject = info.Backproject ?? ((transform, profiles) => transform.Image(profiles));
        }

        /// <summary>Directions and frequencies.</summary>
        public CrossSectionPlan Plan { get; }

        /// <summary>What is made of the responses.</summary>
        public EchoSettings Settings { get; }

        /// <summary>The frequencies.</summary>
        public FrequencyBand Band { get; }

        /// <summary>Makes the profiles.</summary>
        public RangeTransform Range { get; }

        /// <summary>Makes the range-Doppler maps; null without pulses.</summary>
        public RangeDopplerTransform Doppler { get; }

        /// <summary>The elements of the scattering matrix that were asked for.</summary>
        public IReadOnlyList<Polarisation> Polarisations { get; }

        /// <summary>Number of directions.</summary>
        public int Directions => DirectionsOf(Plan);

        /// <summary>Number of directions of a run.</summary>
        /// <exception cref="FormatException">It has no plan.</exception>
        public static int DirectionsOf(RunInfo info) => DirectionsOf(CrossSectionPlan.Of(info.Sweep));

        static int DirectionsOf(CrossSectionPlan plan) => plan.Poses * plan.Receivers;

        /// <summary>The rows of a direction and pulse, in order of the frequencies.</summary>
        public IReadOnlyList<StoredRow> RowsOf(int direction, int pulse = 0) => Enumerable.Range(0, Band.Count)
            .Select(frequency => _rows[NumberOf(direction, pulse, frequency)]).ToArray();

        /// <summary>The direction, as planned for its first frequency.</summary>
        public PlannedCrossSection Planned(int direction) => Plan[NumberOf(direction, 0, 0)];

        /// <summary>S of the first pulse in metres in order of the frequencies; null if it was not asked for.</summary>
        public Complex[] Responses(int direction, Polarisation polarisation) => Responses(direction, polarisation, 0);

        /// <inheritdoc cref="Received(int, Polarisation, int)"/>
        public Complex[] Received(int direction, Polarisation polarisation) => Received(direction, polarisation, 0);

        /// <summary>S of a pulse in metres in order of the frequencies; null if it was not asked for.</summary>
        public Complex[] Responses(int direction, Polarisation polarisation, int pulse) =>
            Polarisations.Contains(polarisation)
                ? RowsOf(direction, pulse)
                    .Select(row => CrossSectionColumn.Amplitude(row, polarisation).Value).ToArray()
                : null;

        /// <summary>
        /// Received amplitudes of a pulse in the root of a watt, with noise; null if it was not asked for, or without a
        /// radar.
        /// </summary>
        public Complex[] Received(int direction, Polarisation polarisation, int pulse)
        {
            if (Settings.Radar == null || !(Responses(direction, polarisation, pulse) is Complex[] responses))
                return null;
            var received = Settings.Radar.Receive(Band, Planned(direction), responses);
            // The same noise whatever other polarisations were asked for.
            long number = 4 * ((long)direction * Plan.PulseCount + pulse) + 2 * polarisation.Received
                + polarisation.Sent;
            return _noise?.AddTo(received, number) ?? received;
        }

        /// <summary>The range profile of responses or of received amplitudes; null of null.</summary>
        public Complex[] Profile(Complex[] responses) => responses == null ? null : Range.Profile(responses);

        /// <summary>
        /// The range-Doppler map of a direction, row by row: in metres, or with a radar in the root of a watt; null if
        /// the polarisation was not asked for.
        /// </summary>
        /// <param name="transform"><see cref="Doppler"/>, or another one of the same plan.</param>
        /// <param name="values"><see cref="Responses(int, Polarisation, int)"/> or
        /// <see cref="Received(int, Polarisation, int)"/>.</param>
        public Complex[] Map(RangeDopplerTransform transform, int direction, Polarisation polarisation,
            Func<int, Polarisation, int, Complex[]> values) => Polarisations.Contains(polarisation)
                ? transform.Map(Enumerable.Range(0, Plan.PulseCount)
                    .Select(pulse => values(direction, polarisation, pulse)).ToArray())
                : null;

        /// <summary>Azimuth of the image's axes in degrees: the middle of the looks, or of the track.</summary>
        public double MiddleAzimuth => Plan.Track?.AzimuthDegrees
            ?? 0.5 * (Planned(0).AzimuthDegrees + Planned(Directions - 1).AzimuthDegrees);

        /// <summary>From the profiles to the image; only with <see cref="EchoSettings.Image"/>.</summary>
        public IsarTransform NewImage() => NewImage(Settings.RangeOf(Plan, IsarTransform.Padding));

        /// <summary>The image in metres, row by row; null if the polarisation was not asked for.</summary>
        public Complex[] Image(Polarisation polarisation)
        {
            if (!Polarisations.Contains(polarisation))
                return null;
            if (_images.TryGetValue(polarisation, out var known))
                return known;
            var range = Settings.RangeOf(Plan, IsarTransform.Padding);
            var profiles = new Complex[Directions][];
            Parallel.For(0, Directions, direction =>
                profiles[direction] = range.Profile(Responses(direction, polarisation)));
            return _images[polarisation] = _backproject(NewImage(range), profiles);
        }

        /// <summary>
        /// Makes all images, if there are any: from then on they are known, and any thread may read all members.
        /// </summary>
        internal void MakeImages()
        {
            if (Settings.Image != null)
                foreach (var polarisation in Polarisations)
                    Image(polarisation);
        }

        IsarTransform NewImage(RangeTransform range)
        {
            var looks = Enumerable.Range(0, Directions).Select(Planned).ToArray();
            return new IsarTransform(range, Band, looks.Select(look => look.Radar).ToArray(), MiddleAzimuth,
                Window.Named(Settings.Window), Settings.Image.Side, Settings.Image.Pixels,
                looks.Select(look => look.Range ?? double.PositiveInfinity).ToArray());
        }

        int NumberOf(int direction, int pulse, int frequency) =>
            ((direction / Plan.Receivers * Plan.PulseCount + pulse) * Band.Count + frequency) * Plan.Receivers
            + direction % Plan.Receivers;
    }

    /// <summary>The highest echo of a profile.</summary>
    public static class EchoPeak
    {
        /// <summary>The cell of the largest magnitude; of equals the first.</summary>
        public static int Of(IReadOnlyList<Complex> profile)
        {
            int peak = 0;
            double highest = -1;
            for (int cell = 0; cell < profile.Count; cell++)
            {
                var value = profile[cell];
                double power = value.Real * value.Real + value.Imaginary * value.Imaginary;
                if (power > highest)
                    (peak, highest) = (cell, power);
            }
            return peak;
        }
    }
}
