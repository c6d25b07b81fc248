using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>What is made of the responses of a run over a band.</summary>
    public sealed class EchoSettings
    {
        // In the words of echo.md.
        const string RangeMeaning =
            "half of the path out and back, 0 at the phase centre, positive away from the radar";

        const string SpeedMeaning = "half of the rate at which the path shortens: positive towards the radar";

        const string On = "on", Off = "off";

        /// <summary>Width of the band, hertz: the number of frequencies times their step.</summary>
        public double Bandwidth { get; set; }

        /// <summary>Name of the window over the band: <see cref="Window.Names"/>.</summary>
        public string Window { get; set; }

        /// <summary>The radar, for received power; null: cross sections only.</summary>
        public EchoRadar Radar { get; set; }

        /// <summary>How targets are detected; null: not at all.</summary>
        public EchoDetection Detection { get; set; }

        /// <summary>Whether a MAT-file is written.</summary>
        public bool HasMatlab { get; set; }

        /// <summary>Whether a SigMF recording is written.</summary>
        public bool HasSigMf { get; set; }

        /// <summary>The image made of the looks of a sweep; null for none.</summary>
        public IsarSettings Image { get; set; }

        /// <summary>The band of a plan.</summary>
        public FrequencyBand BandOf(CrossSectionPlan plan) => new FrequencyBand(plan.Frequencies[0],
            Bandwidth / plan.Frequencies.Count, plan.Frequencies.Count);

        /// <summary>From the responses of a plan to profiles: the unambiguous range around the phase centre.</summary>
        /// <param name="padding">Cells a bin, at least.</param>
        public RangeTransform RangeOf(CrossSectionPlan plan, int padding = 8)
        {
            var band = BandOf(plan);
            return new RangeTransform(band, Core.Window.Named(Window), padding, -0.5 * band.UnambiguousRange);
        }

        /// <summary>From the responses of pulses to maps; null without pulses.</summary>
        /// <param name="range">Makes the profile of each pulse.</param>
        /// <param name="padding">Rows a bin of speed, at least.</param>
        public RangeDopplerTransform DopplerOf(CrossSectionPlan plan, RangeTransform range, int padding = 2) =>
            plan.Pulses == null
                ? null
                : new RangeDopplerTransform(range, BandOf(plan), plan.Pulses, Core.Window.Named(Window), padding);

        /// <summary>Adds the settings to those of results.json.</summary>
        public void AddTo(List<RunSetting> settings, CrossSectionPlan plan)
        {
            var band = BandOf(plan);
            settings.Add(new RunSetting("profile_range", RangeMeaning));
            settings.Add(new RunSetting("bandwidth", Bandwidth, "Hz"));
            settings.Add(new RunSetting("frequencies", band.Count, "1"));
            settings.Add(new RunSetting("range_resolution", band.RangeResolution, "m"));
            settings.Add(new RunSetting("unambiguous_range", band.UnambiguousRange, "m"));
            settings.Add(new RunSetting("window", Window));
            Radar?.AddTo(settings);
            Detection?.AddTo(settings);
            if (plan.Pulses != null)
            {
                settings.Add(new RunSetting("doppler_speed", SpeedMeaning));
                settings.Add(new RunSetting("pulses", plan.Pulses.Count, "1"));
                settings.Add(new RunSetting("prf", plan.Pulses.RepetitionFrequency, "Hz"));
                settings.Add(new RunSetting("speed_resolution", plan.Pulses.SpeedResolution(band.Centre), "m/s"));
                settings.Add(new RunSetting("blind_speed", plan.Pulses.BlindSpeed(band.Centre), "m/s"));
            }
            Image?.AddTo(settings);
            settings.Add(new RunSetting("mat", HasMatlab ? On : Off));
            settings.Add(new RunSetting("sigmf", HasSigMf ? On : Off));
        }

        /// <summary>The settings that <see cref="AddTo"/> added.</summary>
        /// <exception cref="FormatException">They are not there.</exception>
        public static EchoSettings Of(RunInfo info) => new EchoSettings
        {
            Bandwidth = Find(info, "bandwidth").Number, Window = Find(info, "window").Text,
            Radar = EchoRadar.Of(info), Detection = EchoDetection.Of(info), Image = IsarSettings.Of(info),
            HasMatlab = Find(info, "mat").Text == On,
            HasSigMf = Find(info, "sigmf").Text == On
        };

        /// <summary>The polarisations of a run.</summary>
        /// <exception cref="FormatException">They are not there.</exception>
        internal static IReadOnlyList<Polarisation> PolarisationsOf(RunInfo info) =>
            Polarisation.Read(Find(info, "polarisations").Text);

        /// <summary>A setting of results.json.</summary>
        /// <exception cref="FormatException">It is not there.</exception>
        internal static RunSetting Find(RunInfo info, string name) => Has(info, name)
            ? info.Settings.First(setting => setting.Name == name)
            : throw new FormatException($"it has no {name}");

        /// <summary>Whether there is a setting in results.json.</summary>
        internal static bool Has(RunInfo info, string name) => info.Settings.Any(setting => setting.Name == name);
    }

    /// <summary>A radar at a range from the phase centre: from cross sections to received power.</summary>
    public sealed class EchoRadar
    {
        const string PowerName = "transmit_power", GainName = "antenna_gain", LossName = "loss",
            NoiseName = "noise_figure", SeedName = "noise_seed", RangeName = "range";

        /// <summary>Transmit power, watts.</summary>
        public double Power { get; set; }

        /// <summary>Gain of the antenna, which sends and receives, decibels of an isotropic one.</summary>
        public double GainDb { get; set; }

        /// <summary>Pattern of the antenna and its direction; null: the same gain everywhere.</summary>
        public EchoAntenna Antenna { get; set; }

        /// <summary>Losses, decibels.</summary>
        public double LossDb { get; set; }

        /// <summary>Noise figure of the receiver, decibels; null: no noise.</summary>
        public double? NoiseFigureDb { get; set; }

        /// <summary>Seed of the noise.</summary>
        public int Seed { get; set; }

        /// <summary>Distance of the phase centre, metres.</summary>
        public double Range { get; set; }

        /// <summary>Received amplitudes in the root of a watt, from S in metres, without noise.</summary>
        /// <param name="direction">Where radar and receiver are.</param>
        /// <param name="responses">In order of the frequencies.</param>
        public Complex[] Receive(FrequencyBand band, in PlannedCrossSection direction,
            IReadOnlyList<Complex> responses)
        {
            Complex sent = FieldAt(direction.ElevationDegrees),
                received = FieldAt(direction.ReceiverElevationDegrees ?? direction.ElevationDegrees);
            return responses.Select((response, n) => new RadarEquation(Power, band.Frequency(n), LossDb)
                .Amplitude(sent, received, response, Range)).ToArray();
        }

        Complex FieldAt(double elevation) =>
            Antenna?.Field(GainDb, elevation) ?? Math.Sqrt(PowerLevel.FromDecibels(GainDb));

        /// <summary>The noise of the receiver over a band; null if there is none.</summary>
        public ThermalNoise NoiseOf(FrequencyBand band) => NoiseFigureDb is double figure
            ? new ThermalNoise(Seed, band.Bandwidth, figure)
            : null;

        internal void AddTo(List<RunSetting> settings)
        {
            settings.Add(new RunSetting(PowerName, Power, "W"));
            settings.Add(new RunSetting(GainName, GainDb, "dB"));
            Antenna?.AddTo(settings);
            settings.Add(new RunSetting(LossName, LossDb, "dB"));
            if (!(NoiseFigureDb is double figure))
                return;
            settings.Add(new RunSetting(NoiseName, figure, "dB"));
            settings.Add(new RunSetting(SeedName, Seed, "1"));
        }

        internal static EchoRadar Of(RunInfo info)
        {
            double Number(string name) => EchoSettings.Find(info, name).Number;
            if (!EchoSettings.Has(info, PowerName))
                return null;
            bool hasNoise = EchoSettings.Has(info, NoiseName);
            return new EchoRadar
            {
                Power = Number(PowerName), GainDb = Number(GainName), Antenna = EchoAntenna.Of(info),
                LossDb = Number(LossName),
                NoiseFigureDb = hasNoise ? Number(NoiseName) : (double?)null,
                Seed = hasNoise ? (int)Number(SeedName) : 0, Range = Number(RangeName)
            };
        }
    }

    /// <summary>The image of a sweep.</summary>
    public sealed class IsarSettings
    {
        const string SideName = "image_side", PixelsName = "image_pixels";

        /// <summary>Side of the image, metres.</summary>
        public double Side { get; set; }

        /// <summary>Pixels along a side.</summary>
        public int Pixels { get; set; }

        /// <summary>
        /// A bin of down range on the image's horizontal plane, metres: c / (2 B cos e), e the elevation.
        /// </summary>
        public static double DownBin(FrequencyBand band, CrossSectionPlan plan) =>
            band.RangeResolution / Math.Cos(ElevationOf(plan));

        /// <summary>
        /// A bin of cross range on it, metres: lambda / 2 over the angle that all looks make. Azimuths at the elevation
        /// e make cos e times their own angle; places of a track make the angle at which the track is seen.
        /// </summary>
        public static double CrossBin(FrequencyBand band, CrossSectionPlan plan)
        {
            double azimuths = plan[plan.Count - 1].AzimuthDegrees - plan[0].AzimuthDegrees,
                angle = plan.Track is RadarTrack track
                    ? Math.Atan(track.Places[track.Count - 1] / track.Range) - Math.Atan(track.Places[0] / track.Range)
                    : azimuths * Math.PI / 180 * Math.Cos(ElevationOf(plan));
            return Signal.Wavelength(band.Centre) * (plan.Poses - 1.0) / (2 * plan.Poses * Math.Abs(angle));
        }

        // Of all azimuths, or of the middle of the track, radians.
        static double ElevationOf(CrossSectionPlan plan) =>
            (plan.Track?.ElevationDegrees ?? plan[0].ElevationDegrees) * Math.PI / 180;

        internal void AddTo(List<RunSetting> settings)
        {
            settings.Add(new RunSetting(SideName, Side, "m"));
            settings.Add(new RunSetting(PixelsName, Pixels, "1"));
        }

        internal static IsarSettings Of(RunInfo info) => !EchoSettings.Has(info, SideName)
            ? null
            : new IsarSettings
            {
                Side = EchoSettings.Find(info, SideName).Number,
                Pixels = (int)EchoSettings.Find(info, PixelsName).Number
            };
    }
}
