using System;
using System.IO;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint echo</c> beside those of <c>glint rcs</c>.</summary>
    public static class EchoOptions
    {
        const string Group = "Band and profile", PulseGroup = "Pulses and motion", RadarGroup = "Received power",
            DetectionGroup = "Detection", ResultGroup = "Results", ImageGroup = "Image";

        static readonly Interval s_bandwidth = Interval.Closed(1, 1e12), s_count = Interval.Closed(2, 1 << 16),
            s_power = Interval.Closed(1e-12, 1e12), s_gain = Interval.Closed(-50, 100),
            s_decibels = Interval.Closed(0, 100), s_seed = Interval.Closed(0, int.MaxValue),
            s_pulses = Interval.Closed(2, 1 << 16), s_repetition = Interval.Closed(1e-3, 1e9),
            s_speed = Interval.Closed(-1e4, 1e4), s_turnRate = Interval.Closed(-3600, 3600),
            s_falseAlarm = Interval.Closed(1e-12, 0.5), s_widths = Interval.Closed(0.01, 179),
            s_angles = Interval.Closed(-179, 179);

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
            Help = "Weights over the band, which lower the sidelobes of an echo and widen it. taylor has three near "
                + "sidelobes of -35 dB on each side."
        };

        /// <summary>Number of pulses; null when not given.</summary>
        public static readonly Option<int?> Pulses =
            new Option<int?>("pulses", "M", text => Values.Whole(text, s_pulses))
            {
                Group = PulseGroup,
                Range = s_pulses.ToString(),
                Excludes = new (Option, string)[]
                    { (CrossSectionOptions.Reference, "the reference tracer computes a scene that stands still") },
                Help = "Number of pulses at the rate of --prf, for a range-Doppler map of each direction. One trace "
                    + "gives all of them: objects keep their velocities, and what the radar sees of them."
            };

        /// <summary>Pulse repetition frequency, hertz.</summary>
        public static readonly Option<double> Repetition = Options.Needing(Pulses, Options.Number("prf", "HZ", "1000",
            s_repetition, PulseGroup, InputKind.Any, "Pulse repetition frequency in hertz. Speeds are unambiguous up "
                + "to half of the blind speed, lambda PRF / 2; a bin of speed is the blind speed over M."));

        /// <summary>Velocity of the mesh, metres a second; null when not given.</summary>
        public static readonly Option<double3?> Velocity = OfMovingMesh(
            new Option<double3?>("velocity", "X,Y,Z", text => Values.Point(text, s_speed))
            {
                Range = "each " + s_speed,
                Help = "Velocity of the mesh in m/s, in Unity's axes (after --up). Without it: 0."
            });

        /// <summary>Turn rate of the mesh, degrees a second; null when not given.</summary>
        public static readonly Option<double?> TurnRate = OfMovingMesh(
            new Option<double?>("turn-rate", "DEG/S", text => Values.Real(text, s_turnRate))
            {
                Range = s_turnRate.ToString(),
                Help = "Turn rate of the mesh about the vertical through the phase centre in degrees a second, "
                    + "positive as azimuths. Without it: 0."
            });

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
        public static readonly Option<double?> Gain = Options.Needing(Power,
            new Option<double?>("gain", "DBI", text => Values.Real(text, s_gain))
            {
                Group = RadarGroup,
                Range = s_gain.ToString(),
                Help = "Gain in dBi of the antenna, which sends and receives, in the middle of its beam. Without it: "
                    + "10 log10(26000 / (AZ EL)) of the beam widths of --antenna, without that 0."
            });

        /// <summary>Name of a pattern, or the file of a table; null when not given.</summary>
        public static readonly Option<string> AntennaPattern = Options.Needing(Power,
            new Option<string>("antenna", "PATTERN", Values.NotEmpty)
            {
                Group = RadarGroup,
                Choices = EchoAntenna.Names,
                Help = "Pattern of the antenna: gaussian, sinc (sidelobes of -13 dB), csc2 (in elevation), or a CSV "
                    + "file with the columns angle_deg, azimuth_db and elevation_db, levels over the gain. The whole "
                    + "target has the gain of the phase centre: it may take a tenth of the beam. Without it: the same "
                    + "gain everywhere."
            });

        /// <summary>Beam widths in azimuth and elevation, degrees; null when not given.</summary>
        public static readonly Option<double2?> Beam = Options.Needing(AntennaPattern,
            new Option<double2?>("beam", "AZ,EL", text => Values.Pair(text, s_widths))
            {
                Group = RadarGroup,
                Range = "each " + s_widths,
                Help = "Beam widths between the points of half power, in azimuth and in elevation, in degrees. A file "
                    + "has its own."
            });

        /// <summary>Where the cosecant begins and ends, degrees; null when not given.</summary>
        public static readonly Option<double2?> Cosecant = Options.Needing(AntennaPattern,
            new Option<double2?>("cosecant", "FROM,TO", text => ReadCosecant(text))
            {
                Group = RadarGroup,
                Range = "each " + s_angles,
                Help = "Elevations from the middle of the beam between which the power of csc2 falls with 1 / sin^2, "
                    + "in degrees, negative downwards."
            });

        /// <summary>Azimuth of the beam's middle from the phase centre, degrees.</summary>
        public static readonly Option<double> Squint = Options.Needing(AntennaPattern, Options.Number("squint", "DEG", "0",
            s_angles, RadarGroup, InputKind.Any,
            "Azimuth of the middle of the beam from the direction to the phase centre in degrees, to the right."));

        /// <summary>Elevation of the beam's middle, degrees; null when not given.</summary>
        public static readonly Option<double?> Tilt = Options.Needing(AntennaPattern,
            new Option<double?>("tilt", "DEG", text => Values.Real(text, s_angles))
            {
                Group = RadarGroup,
                Range = s_angles.ToString(),
                Help = "Elevation of the middle of the beam over the horizontal in degrees, whatever --elevation is. "
                    + "Without it: the beam has the elevation of the phase centre."
            });

        /// <summary>Losses, decibels.</summary>
        public static readonly Option<double> Loss = Options.Needing(Power, Options.Number("loss", "DB", "0", s_decibels,
            RadarGroup, InputKind.Any, "Losses of transmitter, lines and receiver together in dB."));

        /// <summary>Noise figure, decibels; null when not given.</summary>
        public static readonly Option<double?> NoiseFigure = Options.Needing(Power,
            new Option<double?>("noise-figure", "DB", text => Values.Real(text, s_decibels))
            {
                Group = RadarGroup,
                Range = s_decibels.ToString(),
                Help = "Noise figure F of the receiver in dB: noise of the power k T0 B F is added to each received "
                    + "amplitude, T0 290 K. Without it: no noise."
            });

        /// <summary>Seed of the noise.</summary>
        public static readonly Option<int> Seed = Options.Needing(NoiseFigure, Options.Whole("seed", "N", "0", s_seed,
            RadarGroup, "Seed of the noise: the same number gives the same noise."));

        /// <summary>How targets are detected; null when not given.</summary>
        public static readonly Option<string> Detect = NewDetect("the cells of profiles, or of maps with --pulses",
            " It needs --noise-figure, or a scene with a Sea whose clutter is on.");

        /// <summary>False alarms a cell.</summary>
        public static readonly Option<double> FalseAlarm = NewFalseAlarm(Detect);

        /// <summary>Whether a MAT-file is written.</summary>
        public static readonly Option<bool> Matlab = Options.Switch("mat", ResultGroup,
            "Also write echo.mat, the arrays of echo.npz for MATLAB and Octave.");

        /// <summary>Whether a SigMF recording is written.</summary>
        public static readonly Option<bool> SigMf = Options.Switch("sigmf", ResultGroup,
            "Also write echo.sigmf-data and echo.sigmf-meta, the complex profiles as a SigMF recording.");

        /// <summary>All options, in the order of the help.</summary>
        public static readonly Option[] All = new Option[]
            {
                Frequency, Bandwidth, Frequencies, Window, Pulses, Repetition, Velocity, TurnRate, Power, Gain,
                AntennaPattern, Beam, Cosecant, Squint, Tilt, Loss, NoiseFigure, Seed, Detect, FalseAlarm
            }.Concat(CrossSectionOptions.All.Where(option =>
                option != CrossSectionOptions.Frequency && option != CrossSectionOptions.Contributions
                && option != CrossSectionOptions.Out)).Concat(new Option[] { CrossSectionOptions.Out, Matlab, SigMf })
            .ToArray();

        /// <summary>The options of <c>glint isar</c> beside those of <c>glint echo</c>.</summary>
        public static readonly Option<double?> Side =
            new Option<double?>("side", "M", text => Values.Real(text, SweepAxis.Range.List.Range))
            {
                Group = ImageGroup,
                Range = SweepAxis.Range.List.Range.ToString(),
                Help = "Side of the square image in metres. Without it: twice the distance of the target's farthest "
                    + "corner from the phase centre."
            };

        /// <inheritdoc cref="Side"/>
        public static readonly Option<double?> Pixel =
            new Option<double?>("pixel", "M", text => Values.Real(text, SweepAxis.Range.List.Range))
            {
                Group = ImageGroup,
                Range = SweepAxis.Range.List.Range.ToString(),
                Help = "Side of a pixel in metres. Without it: half of the finer of the two bins."
            };

        /// <summary>Places of the radar on a track, metres; null when not given: azimuths at an infinite range.</summary>
        public static readonly Option<double[]> Track = Options.Needing(CrossSectionOptions.Range, new Option<double[]>(
            "track", "LIST", new NumberList("place", Interval.Closed(-1e6, 1e6), "metres", ("-50:50:0.5", "-1,0,1")).Read)
        {
            Group = ImageGroup,
            Range = "each from -1e6 to 1e6",
            Help = "Places of the radar on a straight, level track, as a range in metres, to the right of its middle. The "
                + "middle has --azimuth, --elevation and --range; the radar looks at the phase centre from everywhere "
                + "(spotlight SAR). Each place takes a trace."
        });

        /// <summary>All options of <c>glint isar</c>, in the order of the help.</summary>
        public static readonly Option[] AllOfImage = All.Where(option => option != CrossSectionOptions.Bistatic
            && option != CrossSectionOptions.Receivers && option.Group != PulseGroup && option.Group != RadarGroup
            && option.Group != DetectionGroup)
            .Concat(new Option[] { Track, Side, Pixel }).ToArray();

        /// <summary>The image of a command line.</summary>
        /// <param name="band">The band of the plan.</param>
        /// <param name="plan">Of the command line.</param>
        /// <param name="extent">Distance of the target's farthest corner from the phase centre, metres.</param>
        /// <exception cref="UsageException">The looks make no image, or it has too many pixels.</exception>
        public static IsarSettings ImageOf(CommandLine line, FrequencyBand band, CrossSectionPlan plan, double extent)
        {
            if (line.IsGiven(Track))
                RequireSteps(Track, line.Get(Track), "places", "-50:50:0.5");
            else
                RequireSteps(CrossSectionOptions.Azimuth, line.Get(CrossSectionOptions.Azimuth), "azimuths", "-1:1:0.05");
            double[] elevations = line.Get(CrossSectionOptions.Elevation);
            if (elevations.Length > 1)
                throw new UsageException($"{CrossSectionOptions.Elevation.Flag}: an image takes one elevation");
            if (!(Math.Abs(elevations[0]) < 90))
                throw new UsageException($"{CrossSectionOptions.Elevation.Flag}: from above a horizontal image has no "
                    + "down range: give an elevation between -90 and 90 degrees");
            if (line.IsGiven(CrossSectionOptions.Range) && !line.IsGiven(Track))
                throw new UsageException($"{CrossSectionOptions.Range.Flag}: an image of azimuths is one from far away: give "
                    + $"{Track.Flag} {Track.ValueName} too, or leave the range out");
            double finer = Math.Min(IsarSettings.DownBin(band, plan), IsarSettings.CrossBin(band, plan)),
                side = line.Get(Side) ?? 2 * extent,
                pixels = Math.Max(1, Math.Ceiling(side / (line.Get(Pixel) ?? finer / 2)));
            return pixels <= IsarTransform.MaxPixels
                ? new IsarSettings { Side = side, Pixels = (int)pixels }
                : throw new UsageException(FormattableString.Invariant(
                    $"the image has {pixels:0} pixels along a side, at most {IsarTransform.MaxPixels} are possible: give a smaller {Side.Flag}, or a larger {Pixel.Flag}"));
        }

        static void RequireSteps(Option option, double[] values, string noun, string example)
        {
            double step = values.Length < 2 ? 0 : (values[values.Length - 1] - values[0]) / (values.Length - 1);
            if (step == 0 || values.Where((value, i) => Math.Abs(value - values[0] - i * step) > 1e-6).Any())
                throw new UsageException($"{option.Flag}: an image takes at least two {noun} at equal steps: give "
                    + $"FROM:TO:STEP, such as {example}");
        }

        /// <summary>What is made of the responses.</summary>
        /// <exception cref="UsageException">The band begins below 0 Hz.</exception>
        public static EchoSettings SettingsOf(CommandLine line)
        {
            double bandwidth = line.Get(Bandwidth), centre = line.Get(Frequency);
            if (bandwidth >= 2 * centre)
                throw new UsageException($"{Bandwidth.Flag} {Numbers.Format(bandwidth)}: must be below twice "
                    + $"{Frequency.Flag}, {Numbers.Format(2 * centre)} Hz");
            var antenna = AntennaOf(line);
            return new EchoSettings
            {
                Bandwidth = bandwidth, Window = line.Get(Window), HasMatlab = line.Get(Matlab),
                HasSigMf = line.Get(SigMf),
                Detection = line.Get(Detect) is string detection
                    ? new EchoDetection { Level = detection, FalseAlarmRate = line.Get(FalseAlarm) }
                    : null,
                Radar = line.Get(Power) is double power
                    ? new EchoRadar
                    {
                        Power = power, GainDb = line.Get(Gain) ?? antenna?.UsualGainDb ?? 0, Antenna = antenna,
                        LossDb = line.Get(Loss),
                        NoiseFigureDb = line.Get(NoiseFigure), Seed = line.Get(Seed),
                        Range = line.Get(CrossSectionOptions.Range).Value
                    }
                    : null
            };
        }

        static double2 ReadCosecant(string text)
        {
            var angles = Values.Pair(text, s_angles);
            return Core.AntennaPattern.LeadAway(angles.x, angles.y) ? angles
                : throw new FormatException("the angles must lead away from 0 on one side, such as -5,-30");
        }

        static EchoAntenna AntennaOf(CommandLine line)
        {
            string pattern = line.Get(AntennaPattern);
            if (pattern == null)
                return null;
            bool isNamed = EchoAntenna.Names.Contains(pattern);
            Require(line, Beam, pattern, isNamed);
            Require(line, Cosecant, pattern, pattern == EchoAntenna.Cosecant);
            var antenna = isNamed
                ? new EchoAntenna(pattern, line.Get(Beam).Value, line.Get(Cosecant))
                : Read(pattern);
            (antenna.Squint, antenna.Tilt) = (line.Get(Squint), line.Get(Tilt));
            return antenna;
        }

        static void Require(CommandLine line, Option option, string pattern, bool isNeeded)
        {
            if (line.IsGiven(option) != isNeeded)
                throw new UsageException($"{AntennaPattern.Flag} {Values.Shown(pattern)}: "
                    + (isNeeded ? $"give {option.Flag} {option.ValueName}" : $"it has no {option.Flag}"));
        }

        static EchoAntenna Read(string path)
        {
            try
            {
                return File.Exists(path)
                    ? new EchoAntenna(File.ReadAllText(path))
                    : throw new FileNotFoundException("there is no such file");
            }
            catch (Exception problem) when (problem is FormatException || problem is IOException
                || problem is UnauthorizedAccessException || problem is GlintException)
            {
                throw new GlintException($"{AntennaPattern.Flag} {Values.Shown(path)}: {problem.Message.TrimEnd('.')}; give one of "
                    + $"{string.Join(", ", EchoAntenna.Names)}, or a file with a table of a pattern", problem);
            }
        }

        /// <summary>The plan of a command line, with the frequencies of its band.</summary>
        /// <param name="reach">Of <see cref="EchoBand.Reach"/>.</param>
        /// <exception cref="UsageException">The lists do not go together, or are too long.</exception>
        public static CrossSectionPlan PlanOf(CommandLine line, double reach)
        {
            double bandwidth = line.Get(Bandwidth),
                count = line.Get(Frequencies) ?? EchoBand.CountFor(reach, bandwidth);
            if (!s_count.Contains(count))
                throw new UsageException(FormattableString.Invariant(
                    $"{Bandwidth.Flag} {Numbers.Format(bandwidth)}: the target takes {count:0} frequencies, at most {1 << 16} are possible: give a smaller band, or {Frequencies.Flag}, with echoes folded into the unambiguous range"));
            return CrossSectionOptions.PlanOf(line,
                EchoBand.Frequencies(line.Get(Frequency), bandwidth, (int)count),
                line.Get(Pulses) is int pulses ? new PulseTrain(line.Get(Repetition), pulses) : null);
        }

        /// <summary>The motion of the mesh of a command line.</summary>
        /// <param name="pivot">What it turns about, metres.</param>
        public static RigidMotion MotionOf(CommandLine line, double3 pivot) => new RigidMotion
        {
            Velocity = line.Get(Velocity) ?? 0, Pivot = pivot,
            AngularVelocity = new double3(0, math.radians(line.Get(TurnRate) ?? 0), 0)
        };

        /// <summary>A new option --detect.</summary>
        /// <param name="cells">What is detected in.</param>
        internal static Option<string> NewDetect(string cells, string needs = "") =>
            new Option<string>("detect", "CFAR", ReadDetection)
            {
                Group = DetectionGroup,
                Choices = EchoDetection.Names,
                Range = "one of " + string.Join(", ", EchoDetection.Names),
                Help = $"Also write detections.csv, {cells} above a threshold of constant false-alarm rate: a multiple "
                    + "of the mean of the cells around (ca), or of the cell at three quarters of their order (os), "
                    + "which other targets change little." + needs
            };

        /// <summary>A new option --false-alarm.</summary>
        internal static Option<double> NewFalseAlarm(Option detect) => Options.Needing(detect,
            Options.Number("false-alarm", "RATE", "1e-6", s_falseAlarm, DetectionGroup, InputKind.Any,
                "False alarms a cell in noise. In spiky clutter there are more."));

        static string ReadWindow(string text)
        {
            Core.Window.Named(text);
            return text;
        }

        static string ReadDetection(string text) => EchoDetection.Names.Contains(text)
            ? text
            : throw new FormatException($"must be one of {string.Join(", ", EchoDetection.Names)}");

        static Option<T> OfMovingMesh<T>(Option<T> option)
        {
            (option.Group, option.Inputs) = (PulseGroup, InputKind.MeshFile);
            option.Refusal = "only for mesh files: objects of a scene have a RadarMotion or Rigidbody of their own";
            return Options.Needing(Pulses, option);
        }
    }
}
