using System;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint echo</c> beside those of <c>glint rcs</c>.</summary>
    public static class EchoOptions
    {
        const string Group = "Band and profile", RadarGroup = "Received power", ResultGroup = "Results";

        static readonly Interval s_bandwidth = Interval.Closed(1, 1e12), s_count = Interval.Closed(2, 1 << 16),
            s_power = Interval.Closed(1e-12, 1e12), s_gain = Interval.Closed(-50, 100),
            s_decibels = Interval.Closed(0, 100), s_seed = Interval.Closed(0, int.MaxValue);

        /// <summary>Middle of the band, hertz.</summary>
        public static readonly Option<double> Frequency = Options.Number("frequency", "HZ", "10e9",
            SweepAxis.Frequency.List.Range, Group, InputKind.Any, "Middle of the band in hertz.");

        /// <summary>Width of the band, hertz.</summary>
        public static readonly Option<double> Bandwidth = Options.Number("bandwidth", "HZ", "150e6", s_bandwidth, Group,
            InputKind.Any, "Width B of the band in hertz: a bin of range is c / (2 B), 1 m at 150e6.");

        /// <summary>Number of frequencies; null when not given.</summary>
        public static readonly Option<int?> Frequencies =
            new Option<int?>("frequencies", "N", text => Values.Whole(text, s_count))
            {
                Group = Group,
                Range = s_count.ToString(),
                Help = "Number of frequencies of the band, whose step is B / N; the unambiguous range is N bins. "
                    + "Without it: as many as tell all echoes of up to two bounces apart."
            };

        /// <summary>Name of the window.</summary>
        public static readonly Option<string> Window = new Option<string>("window", "NAME", ReadWindow)
        {
            Group = Group,
            Choices = Core.Window.Names,
            Range = "one of " + string.Join(", ", Core.Window.Names),
            DefaultText = Core.Window.Names[0],
            Help = "Weights over the band, which lower the sidelobes of an echo and widen it. taylor has four near "
                + "sidelobes of -35 dB."
        };

        /// <summary>Transmit power, watts; null when not given.</summary>
        public static readonly Option<double?> Power =
            new Option<double?>("power", "W", text => Values.Real(text, s_power))
            {
                Group = RadarGroup,
                Range = s_power.ToString(),
                Needs = new Option[] { CrossSectionOptions.Range },
                Help = "Peak transmit power in watts: the files then have received power in dBW at --range too."
            };

        /// <summary>Gain of the antenna, decibels.</summary>
        public static readonly Option<double> Gain = Needing(Power, Options.Number("gain", "DBI", "0", s_gain,
            RadarGroup, InputKind.Any, "Gain in dBi of the antenna, which sends and receives."));

        /// <summary>Losses, decibels.</summary>
        public static readonly Option<double> Loss = Needing(Power, Options.Number("loss", "DB", "0", s_decibels,
            RadarGroup, InputKind.Any, "Losses of transmitter, lines and receiver together in dB."));

        /// <summary>Noise figure, decibels; null when not given.</summary>
        public static readonly Option<double?> NoiseFigure = Needing(Power,
            new Option<double?>("noise-figure", "DB", text => Values.Real(text, s_decibels))
            {
                Group = RadarGroup,
                Range = s_decibels.ToString(),
                Help = "Noise figure F of the receiver in dB: noise of the power k T0 B F is added to each received "
                    + "amplitude, T0 290 K. Without it: no noise."
            });

        /// <summary>Seed of the noise.</summary>
        public static readonly Option<int> Seed = Needing(NoiseFigure, Options.Whole("seed", "N", "0", s_seed,
            RadarGroup, "Seed of the noise: the same number gives the same noise."));

        /// <summary>Whether a MAT-file is written.</summary>
        public static readonly Option<bool> Matlab = Options.Switch("mat", ResultGroup,
            "Also write echo.mat, the arrays of echo.npz for MATLAB and Octave.");

        /// <summary>Whether a SigMF recording is written.</summary>
        public static readonly Option<bool> SigMf = Options.Switch("sigmf", ResultGroup,
            "Also write echo.sigmf-data and echo.sigmf-meta, the complex profiles as a SigMF recording.");

        /// <summary>All options, in the order of the help.</summary>
        public static readonly Option[] All = new Option[] { Frequency, Bandwidth, Frequencies, Window, Power, Gain,
            Loss, NoiseFigure, Seed }.Concat(CrossSectionOptions.All.Where(option =>
                option != CrossSectionOptions.Frequency && option != CrossSectionOptions.Contributions
                && option != CrossSectionOptions.Out)).Concat(new Option[] { CrossSectionOptions.Out, Matlab, SigMf })
            .ToArray();

        /// <summary>What is made of the responses.</summary>
        /// <exception cref="UsageException">The band begins below 0 Hz.</exception>
        public static EchoSettings SettingsOf(CommandLine line)
        {
            double bandwidth = line.Get(Bandwidth), centre = line.Get(Frequency);
            if (bandwidth >= 2 * centre)
                throw new UsageException($"{Bandwidth.Flag} {Numbers.Format(bandwidth)}: must be below twice "
                    + $"{Frequency.Flag}, {Numbers.Format(2 * centre)} Hz");
            return new EchoSettings
            {
                Bandwidth = bandwidth, Window = line.Get(Window), HasMatlab = line.Get(Matlab),
                HasSigMf = line.Get(SigMf),
                Radar = line.Get(Power) is double power
                    ? new EchoRadar
                    {
                        Power = power, GainDb = line.Get(Gain), LossDb = line.Get(Loss),
                        NoiseFigureDb = line.Get(NoiseFigure), Seed = line.Get(Seed),
                        Range = line.Get(CrossSectionOptions.Range).Value
                    }
                    : null
            };
        }

        /// <summary>The plan of a command line, with the frequencies of its band.</summary>
        /// <param name="reach">Of <see cref="EchoBand.Reach"/>.</param>
        /// <exception cref="UsageException">The lists do not go together, or are too long.</exception>
        public static CrossSectionPlan PlanOf(CommandLine line, double reach)
        {
            double bandwidth = line.Get(Bandwidth), count = line.Get(Frequencies) ?? EchoBand.CountFor(reach, bandwidth);
            if (!s_count.Contains(count))
                throw new UsageException(FormattableString.Invariant(
                    $"{Bandwidth.Flag} {Numbers.Format(bandwidth)}: the target takes {count:0} frequencies, at most {1 << 16} are possible: give a smaller band, or {Frequencies.Flag}, with echoes folded into the unambiguous range"));
            return CrossSectionOptions.PlanOf(line,
                EchoBand.Frequencies(line.Get(Frequency), bandwidth, (int)count));
        }

        static string ReadWindow(string text)
        {
            Core.Window.Named(text);
            return text;
        }

        static Option<T> Needing<T>(Option needed, Option<T> option)
        {
            option.Needs = new[] { needed };
            return option;
        }
    }
}
