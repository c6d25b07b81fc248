using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>Transmitter, antenna and range gates of a radar with a screen.</summary>
    [Serializable]
    public struct ScreenRadar
    {
        /// <summary>Metres of a nautical mile.</summary>
        public const double NauticalMile = 1852;

        static readonly Interval s_fractions = Interval.Closed(0, 1), s_downwards = Interval.Closed(-90, 0);

        /// <summary>The numbers, in the order of the declaration.</summary>
        public static readonly IReadOnlyList<Measure> Measures = new MeasureList<ScreenRadar>
        {
            { nameof(Frequency), it => it.Frequency, "Frequency", "Hz", SeaScattering.Frequencies,
                "Frequency of the transmitter." },
            { nameof(Power), it => it.Power, "Power", "W", Interval.Closed(1e-3, 1e8), "Peak power of a pulse." },
            { nameof(PulseNanoseconds), it => it.PulseNanoseconds, "Pulse", "ns", Interval.Closed(10, 10000),
                "Length of a pulse. Its inverse is the bandwidth of the receiver." },
            { nameof(NoiseFigureDb), it => it.NoiseFigureDb, "Noise Figure", "dB", Interval.Closed(0, 100),
                "Noise figure of the receiver." },
            { nameof(LossDb), it => it.LossDb, "Loss", "dB", Interval.Closed(0, 100),
                "Losses of transmitter, lines and receiver together." },
            { nameof(BeamWidth), it => it.BeamWidth, "Beam Width", "deg", Interval.Closed(0.1, 30),
                "Horizontal width of the beam between the points of half power." },
            { nameof(VerticalBeamWidth), it => it.VerticalBeamWidth, "Vertical Beam Width", "deg",
                Interval.Closed(1, 179), "Vertical width of the beam between the points of half power." },
            { nameof(CosecantFrom), it => it.CosecantFrom, "Cosecant From", "deg", s_downwards,
                "Elevation below which the power of the pattern Cosecant falls with 1 / sin^2." },
            { nameof(CosecantTo), it => it.CosecantTo, "Cosecant To", "deg", s_downwards,
                "Elevation below which the pattern Cosecant has nothing." },
            { nameof(TurnsAMinute), it => it.TurnsAMinute, "Turns a Minute", "", Interval.Closed(1, 240),
                "Turns of the antenna a minute, clockwise." },
            { nameof(RangeScale), it => it.RangeScale, "Range Scale", "m", Interval.Closed(100, 2e5),
                "Range at the edge of the picture. A nautical mile is 1,852 m." },
            { nameof(PulseRate), it => it.PulseRate, "Pulse Rate", "Hz", Interval.Closed(0, 1e6),
                "Pulses a second: echoes from further away than c / (2 Pulse Rate) are shown that much nearer. 0: they "
                    + "are not shown." },
            { nameof(BlindFrom), it => it.BlindFrom, "Blind From", "deg", Interval.Closed(-360, 360),
                "Left end of the sector in which nothing is sent, clockwise from the bow." },
            { nameof(BlindWidth), it => it.BlindWidth, "Blind Width", "deg", Interval.Closed(0, 360),
                "Width of that sector. 0: none." },
            { nameof(Spokes), it => it.Spokes, "Spokes", "", Interval.Closed(256, 16384),
                "Bearings of a turn, a power of two. At least three across the beam." },
            { nameof(Cells), it => it.Cells, "Cells", "", Interval.Closed(64, 8192),
                "Range cells from the radar to the edge of the picture." },
            { nameof(SeaReflection), it => it.SeaReflection, "Sea Reflection", "", s_fractions,
                "Amplitude of the image of a reflector in a smooth sea, which interferes with the direct echo. "
                    + "0: none." },
            { nameof(RainRate), it => it.RainRate, "Rain", "mm/h", Interval.Closed(0, 100),
                "Rain around the radar: its echo, and what it takes from all others." },
            { nameof(Seed), it => it.Seed, "Seed", "", Interval.Closed(0, int.MaxValue),
                "Seed of noise and speckle. The same number gives the same picture." }
        };

        /// <summary>Hertz.</summary>
        public double Frequency;

        /// <summary>Peak power, watts.</summary>
        public double Power;

        /// <summary>Length of a pulse, ns.</summary>
        public double PulseNanoseconds;

        /// <summary>Noise figure, dB.</summary>
        public double NoiseFigureDb;

        /// <summary>Losses, dB.</summary>
        public double LossDb;

        /// <summary>Horizontal half-power width, degrees.</summary>
        public double BeamWidth;

        /// <summary>Vertical half-power width, degrees.</summary>
        public double VerticalBeamWidth;

        /// <summary>The antenna's pattern.</summary>
        public ScreenPattern Pattern;

        /// <summary>Where the cosecant begins, degrees of elevation.</summary>
        public double CosecantFrom;

        /// <summary>Where it ends, degrees of elevation.</summary>
        public double CosecantTo;

        /// <summary>Turns of the antenna a minute.</summary>
        public double TurnsAMinute;

        /// <summary>Range of the last cell's end, metres.</summary>
        public double RangeScale;

        /// <summary>Pulses a second; 0: echoes come before the next pulse.</summary>
        public double PulseRate;

        /// <summary>Left end of the sector in which nothing is sent, degrees clockwise from the bow.</summary>
        public double BlindFrom;

        /// <summary>Width of that sector, degrees.</summary>
        public double BlindWidth;

        /// <summary>Bearings of a turn, a power of two.</summary>
        public int Spokes;

        /// <summary>Range cells.</summary>
        public int Cells;

        /// <summary>Amplitude of the image in the sea over that of the reflector, 0 to 1.</summary>
        public double SeaReflection;

        /// <summary>mm/h.</summary>
        public double RainRate;

        /// <summary>Of noise and speckle.</summary>
        public int Seed;

        /// <summary>Polarisation of the echo of the sea: horizontal, as of slotted waveguides, or vertical.</summary>
        public ScreenPolarisation Polarisation;

        /// <summary>Metres from which on echoes come after the next pulse; infinite without a pulse rate.</summary>
        public double UnambiguousRange =>
            PulseRate > 0 ? Signal.SpeedOfLight / 2 / PulseRate : double.PositiveInfinity;

        /// <summary>A marine radar in X band: 25 kW, 1.2 x 22 degrees, 24 turns a minute, 6 nautical miles.</summary>
        public static ScreenRadar Default => new ScreenRadar
        {
            Frequency = 9.41e9, Power = 25000, PulseNanoseconds = 80, NoiseFigureDb = 5, BeamWidth = 1.2,
            VerticalBeamWidth = 22, TurnsAMinute = 24, RangeScale = 6 * NauticalMile, Spokes = 4096, Cells = 1024,
            Seed = 1
        };

        /// <summary>Refuses values out of range.</summary>
        /// <param name="subject">Whose settings they are, for messages.</param>
        /// <exception cref="GlintException">A value is out of its range.</exception>
        public void Validate(string subject)
        {
            foreach (var measure in Measures)
                Require.Within(subject, measure, this);
            if ((Spokes & (Spokes - 1)) != 0)
                throw new GlintException($"{subject}: spokes {Spokes} must be a power of two: 1024, 2048, 4096");
            if (!Enum.IsDefined(typeof(ScreenPattern), Pattern))
                throw new GlintException($"{subject}: there is no pattern {(int)Pattern}: choose one of "
                    + string.Join(", ", Enum.GetNames(typeof(ScreenPattern))));
            if (Pattern != ScreenPattern.Table)
                RequireSpokes(subject, BeamWidth);
            if (UnambiguousRange < RangeScale)
                throw new GlintException(FormattableString.Invariant(
                    $"{subject}: at a pulse rate of {PulseRate:g6} Hz the next pulse leaves before echoes from beyond {UnambiguousRange:0} m are back, and the range scale is {RangeScale:g6} m: use a rate of {Math.Floor(Signal.SpeedOfLight / 2 / RangeScale)} Hz at most, or a smaller scale"));
            double longest = RangeScale / 4, pulse = Signal.SpeedOfLight / 2e9 * PulseNanoseconds;
            if (pulse > longest)
                throw new GlintException($"{subject}: a pulse of {RadarSettings.Text(PulseNanoseconds)} ns is "
                    + $"{pulse:0} m long and the range scale is {RadarSettings.Text(RangeScale)} m: use a shorter pulse "
                    + "or a larger scale");
        }

        /// <summary>Refuses spokes that are too few for a beam.</summary>
        /// <exception cref="GlintException">They are fewer than three.</exception>
        public void RequireSpokes(string subject, double beamWidth)
        {
            if (beamWidth * Spokes < 3 * 360)
                throw new GlintException($"{subject}: {Spokes} spokes are fewer than three across the beam of "
                    + $"{RadarSettings.Text(beamWidth)} deg: use more spokes or a wider beam");
        }
    }

    /// <summary>Patterns of a screen's antenna, in the order of <see cref="EchoAntenna.Names"/>.</summary>
    public enum ScreenPattern
    {
        /// <summary>No sidelobes.</summary>
        Gaussian,

        /// <summary>An aperture of constant field: sidelobes of -13 dB, nothing behind it.</summary>
        Sinc,

        /// <summary>Gaussian in azimuth; in elevation 1 / sin^2 below the beam.</summary>
        Cosecant,

        /// <summary>That of a table.</summary>
        Table
    }

    /// <summary>What a radar with a screen sends and receives.</summary>
    public enum ScreenPolarisation
    {
        /// <summary>HH.</summary>
        Horizontal,

        /// <summary>VV.</summary>
        Vertical
    }
}
