using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint rcs</c>.</summary>
    public static class CrossSectionOptions
    {
        const string Group = "Cross section", ResultGroup = "Results";

        static readonly Interval s_rows = Interval.Closed(1, CrossSectionPlan.Limit);

        /// <summary>Azimuths of the radar, degrees.</summary>
        public static readonly Option<double[]> Azimuth = Options.List("azimuth", CrossSectionRanges.Azimuths, "0",
            Group, "Azimuths of the radar in degrees, positive as Unity's rotation about Y: FROM:TO:STEP or a list "
                + "with commas. At 0 it is on the -Z side and looks along +Z.");

        /// <summary>Elevations of the radar, degrees.</summary>
        public static readonly Option<double[]> Elevation = Options.List("elevation", CrossSectionRanges.Elevations,
            "0", Group, "Elevations of the radar above the horizontal in degrees, as a range or list.");

        /// <summary>Frequencies, hertz.</summary>
        public static readonly Option<double[]> Frequency = Options.List("frequency", SweepAxis.Frequency.List, "10e9",
            Group, "Frequencies in hertz, as a range or list. One trace gives those within 10 %, fewer of a surface "
                + "with a material.");

        /// <summary>Elements of the scattering matrix.</summary>
        public static readonly Option<Polarisation[]> Polarisations =
            new Option<Polarisation[]>("polarisation", "LIST", Polarisation.Read)
            {
                Group = Group,
                Choices = new[] { "all", "vv", "hh", "vv,hh" },
                Range = "all, or of vv, hv, vh, hh",
                DefaultText = "all",
                Help = "The polarisations to write, received before sent: hv is received in H and sent in V. V is the "
                    + "radar's up, H its right. The columns of the others are empty."
            };

        /// <summary>The error asked for, decibels.</summary>
        public static readonly Option<double> Tolerance = Options.Number("tolerance", "DB", "0.1",
            CrossSectionRanges.Tolerance, Group, InputKind.Any,
            "The error asked for in dB: 95 % of the amplitudes are within it, of each polarisation that is written. It is "
                + "the error of the integration, not of physical optics. Rays are traced until it is met; rows that do "
                + "not meet it are marked (column tolerance_met). Weak cross-polarised echoes take many rays.");

        /// <summary>Level below which the tolerance is relative to this level, dBsm; null when not given.</summary>
        public static readonly Option<double?> Floor =
            new Option<double?>("floor", "DBSM", text => Values.Real(text, CrossSectionRanges.Level))
            {
                Group = Group,
                Range = CrossSectionRanges.Level.ToString(),
                Help = "Cross section in dBsm below which the tolerance is relative to this one, so that nulls take no "
                    + "endless work. Without it: 40 dB below pi a^2, with a the radius of the sphere around the target."
            };

        /// <summary>Whether edges add their fringe fields.</summary>
        public static readonly Option<bool> Edges = new Option<bool>("edges", "on|off", ReadSwitch)
        {
            Group = Group,
            Choices = new[] { "on", "off" },
            Range = "on or off",
            DefaultText = "on",
            Help = "Whether metal edges add their fringe fields; off for pure physical optics."
        };

        /// <summary>Direction of a receiver apart from the radar, degrees; null when not given.</summary>
        public static readonly Option<double2?> Bistatic =
            new Option<double2?>("bistatic", "AZ,EL", text => ReadDirection(text))
            {
                Group = Group,
                Range = $"azimuth {CrossSectionRanges.Azimuth}, elevation {CrossSectionRanges.Elevation}",
                Help = "A fixed receiver, in azimuth and elevation in degrees. Without it the radar receives. Rows "
                    + "whose receiver is more than 120 degrees from the radar, outside the forward lobe, are marked "
                    + "(column outside_physical_optics)."
            };

        /// <summary>Azimuths of receivers apart from the radar, degrees; null when not given.</summary>
        public static readonly Option<double[]> Receivers =
            new Option<double[]>("receivers", "LIST", CrossSectionRanges.Azimuths.Read)
            {
                Group = Group,
                Range = "each " + CrossSectionRanges.Azimuth,
                Excludes = new (Option, string)[] { (Bistatic, "both set the receiver") },
                Help = "Azimuths of receivers in degrees, as a range or list, at the elevation of the radar: a "
                    + "bistatic sweep from one illumination. --elevation then has one value."
            };

        /// <summary>Distance to radar and receivers, metres; null when not given: the far field.</summary>
        public static readonly Option<double?> Range =
            new Option<double?>("range", "M", text => Values.Real(text, SweepAxis.Range.List.Range))
            {
                Group = Group,
                Range = SweepAxis.Range.List.Range.ToString(),
                Help = "Distance in metres from the phase centre to radar and receiver, for a spherical wave. Without "
                    + "it: a plane wave and the far field. glint isar takes it with --track only."
            };

        /// <summary>Bend of edges above which they are sharp, degrees.</summary>
        public static readonly Option<double> Crease = Options.Number("crease", "DEG",
            Numbers.Format(CrossSectionPose.DefaultCreaseDegrees), CrossSectionRanges.Crease, Group, InputKind.Any,
            "Edges bent by more than this angle in degrees are sharp; facets that meet at smaller ones are one curved "
                + "surface.");

        /// <summary>Materials of surfaces; null when not given.</summary>
        public static readonly Option<MaterialAssignment[]> Material =
            new Option<MaterialAssignment[]>("material", "NAME=MATERIAL",
                text => new[] { MaterialAssignment.Read(text) })
            {
                Group = Group,
                Join = (before, more) => before.Concat(more).ToArray(),
                Help = "Material of the surface NAME (usemtl of an OBJ file, the RadarMaterial of a scene), or of all "
                    + "others with *: metal, with layers metal,e',e'',mu',mu'',t outermost first (t in metres), a "
                    + "half-space open,e',e'',mu',mu'', or the name of a published material. Put * into quotes, "
                    + "which keep it from the shell: \"*=itu_wood\". Without it: metal, or that of the scene. May be "
                    + "given more than once."
            };

        /// <summary>Whether the contributions of parts are written.</summary>
        public static readonly Option<bool> Contributions = Options.Switch("contributions", Group,
            "Also write contributions.csv, what each object and each number of bounces contribute, and hotspots.csv, "
                + "the triangles that return most: coherent sums. Each row takes one more trace.");

        /// <summary>Folder for the result files; null when not given.</summary>
        public static readonly Option<string> Out = Options.Text("out", "DIR", ResultGroup,
            "Folder for the files of results, created with its parents if missing. They are results.json; of glint rcs "
                + "rcs.csv, rcs.npz and those of --contributions; of glint echo profile.csv, echo.npz, responses.csv and "
                + "those of its options; of glint isar image.csv, image.npz, a PNG file for each polarisation, echo.npz and "
                + "responses.npy.");

        /// <summary>Rows that are computed in double precision too; 0 when not given.</summary>
        public static readonly Option<int> Reference =
            new Option<int>("reference", "[N]", text => Values.Whole(text, s_rows))
            {
                Group = ResultGroup,
                Range = s_rows.ToString(),
                ImpliedText = "3",
                Excludes = new (Option, string)[]
                    { (Options.Resume, "it compares the first rows that the command itself computes") },
                Help = "Afterwards compute the first N rows (3 without N) with the double-precision reference tracer "
                    + "too, and print both and their difference. A row takes seconds to minutes. The exit code is 1 if "
                    + "a difference is above --tolerance."
            };

        /// <summary>All options, in the order of the help.</summary>
        public static readonly Option[] All =
        {
            Azimuth, Elevation, Frequency, Polarisations, Tolerance, Floor, Options.Bounces, Edges, Bistatic,
            Receivers, Range, Crease, Material, Contributions, Options.Shard, Out, Options.Resume, Reference,
            Options.Unit, Options.Up, Options.Device
        };

        /// <summary>The plan of a command line.</summary>
        /// <param name="pulses">Of each direction; null: the scene stands still.</param>
        /// <exception cref="UsageException">The lists do not go together.</exception>
        public static CrossSectionPlan PlanOf(CommandLine line, double[] frequencies, PulseTrain pulses = null)
        {
            double[] azimuths = line.Get(Azimuth), elevations = line.Get(Elevation);
            CrossSectionPlan plan;
            if (line.Get(EchoOptions.Track) is double[] places)
                plan = azimuths.Length * elevations.Length == 1
                    ? new CrossSectionPlan(new RadarTrack(places, azimuths[0], elevations[0], line.Get(Range).Value),
                        frequencies)
                    : throw new UsageException($"{EchoOptions.Track.Flag}: its middle has one azimuth and one elevation: "
                        + $"give one for {Azimuth.Flag} and for {Elevation.Flag}");
            else if (line.Get(Receivers) is double[] receivers)
                plan = CrossSectionPlan.OfReceivers(azimuths, elevations, frequencies, receivers, pulses);
            else if (line.Get(Bistatic) is double2 receiver)
                plan = new CrossSectionPlan(azimuths, elevations, frequencies, new[] { receiver.x }, receiver.y,
                    pulses);
            else
                plan = new CrossSectionPlan(azimuths, elevations, frequencies, pulses: pulses);
            if (line.Get(Options.Shard) is SweepShard shard && shard.Count > plan.Count)
                throw new UsageException($"{Options.Shard.Flag} {shard}: there are {plan.Count} rows: "
                    + "use at most as many parts");
            return plan;
        }

        static bool ReadSwitch(string text)
        {
            switch (text)
            {
                case "on": return true;
                case "off": return false;
                default: throw new FormatException("must be on or off");
            }
        }

        static double2 ReadDirection(string text)
        {
            var parts = text.Split(',');
            if (parts.Length != 2 || !Values.TryReal(parts[0], out double azimuth)
                || !Values.TryReal(parts[1], out double elevation))
                throw new FormatException("must be AZ,EL, two numbers of degrees, such as 90,0");
            return CrossSectionRanges.Azimuth.Contains(azimuth) && CrossSectionRanges.Elevation.Contains(elevation)
                ? new double2(azimuth, elevation)
                : throw new FormatException($"must have an azimuth {CrossSectionRanges.Azimuth} and an elevation {CrossSectionRanges.Elevation}");
        }
    }
}
