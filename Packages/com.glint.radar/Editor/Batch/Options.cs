using System;
using System.Linq;
using System.Reflection;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>
    /// Every option of every command. Both hosts parse, check and explain by this table;
    /// nothing of it is repeated elsewhere.
    /// </summary>
    public static class Options
    {
        const string SweepGroup = "Sweep";
        const string ResultGroup = "Results";
        const string RadarGroup =
            "Radar (a scene has its own settings, which these replace; the defaults hold without a scene)";
        const string MeshGroup = "Mesh files (refused with a scene, which has its own camera and objects)";
        const string BuiltInGroup = "Built-in scene (refused with an INPUT)";
        const string BenchGroup = "Benchmark";
        const string VerifyGroup = "Verification";
        const string DeviceGroup = "Device";

        const string InSceneInstead = "only for mesh files: a scene has its own camera and objects, change it there";
        const string WithoutInput = "only for the built-in scene: leave INPUT out";

        // Coordinates go into single precision, which holds both ends.
        static readonly Interval Length = SweepAxis.Range.List.Range;
        static readonly Interval Coordinate = Interval.Closed(-1e6, 1e6);
        static readonly Interval GrazingAngle = SweepAxis.Grazing.List.Range;
        static readonly Interval CarrierFrequency = SweepAxis.Frequency.List.Range;
        static readonly Interval RaysOfAxis = Interval.Closed(1, RadarSettings.RaysPerAxisLimit);
        static readonly Interval RaysFromEdge = Interval.Closed(0, RadarSettings.RaysPerAxisLimit);
        static readonly Interval AmplitudeTolerance =
            Interval.Closed(RadarSettings.MinToleranceDb, RadarSettings.MaxToleranceDb);
        static readonly Interval Triangles = Interval.Closed(1000, 50000000);
        static readonly Interval TimedPoses = Interval.Closed(3, 100000);
        static readonly Interval FacetCount = Interval.Closed(100, 8000000);

        // The lists of a sweep, in the order of SweepAxis.All.
        static readonly Option<double[]>[] s_axes = SweepAxis.All.Select(axis =>
            new Option<double[]>(axis.OptionName, axis.ValueName, axis.List.Read)
            {
                Group = SweepGroup,
                Inputs = axis.NeedsSea ? InputKind.Scene : InputKind.Any,
                Refusal = axis.NeedsSea ? "only for scenes, which may have a Sea with snapshots" : null,
                Help = axis.Help
            }).ToArray();

        /// <summary>Angles of a sweep, degrees; null when not given, as those of the other axes.</summary>
        public static readonly Option<double[]> Angles = Of(SweepAxis.Angle),
            GrazingAngles = Of(SweepAxis.Grazing), Distances = Of(SweepAxis.Range),
            Frequencies = Of(SweepAxis.Frequency), Snapshots = Of(SweepAxis.Snapshot);

        /// <summary>The lists of a sweep, in the order of the help.</summary>
        internal static readonly Option[] Axes = s_axes.Reverse().ToArray();

        /// <summary>The object of the scene that a sweep turns or moves the radar about, by its name.</summary>
        public static readonly Option<string> Target = new Option<string>("target", "NAME", Values.NotEmpty)
        {
            Group = SweepGroup,
            Inputs = InputKind.Scene,
            Refusal = "only for scenes: the mesh of a file is turned as a whole",
            Needs = SweepAxis.All.Reverse().Where(axis => axis.NeedsTarget).Select(axis => (Option)Of(axis)).ToArray(),
            Help = "The object of the scene that --angles turn, and that --grazing and --distance move the radar "
                + "about, by its name or its path from the root (Fleet/Ship). With a scene these need it."
        };

        /// <summary>The values of an axis of a sweep; null when not given.</summary>
        public static Option<double[]> Of(SweepAxis axis) => s_axes[axis.Index];

        /// <summary>Folder for the result files; null when not given.</summary>
        public static readonly Option<string> Out = Text("out", "DIR", ResultGroup,
            "Folder for results.csv and results.json, of glint merge for the files of the whole, created with its "
                + "parents if missing.");

        /// <summary>Folder of the project for meshes and prefabs; null when not given.</summary>
        public static readonly Option<string> AssetFolder = Text("out", "DIR", ResultGroup,
            "Folder of the project for mesh and prefab, such as Assets/Mine; "
                + "created with its parents if missing. Required with any other option.");

        /// <summary>Whether to resume an unfinished sweep.</summary>
        public static readonly Option<bool> Resume = Switch("resume", ResultGroup,
            "Resume an interrupted sweep and keep its finished poses. Refused if the folder holds another sweep. "
                + "Without rows to keep, the sweep starts from the beginning.");

        /// <summary>The part of a sweep to do; null when not given.</summary>
        public static readonly Option<SweepShard?> Shard =
            new Option<SweepShard?>("shard", "K/N", text => SweepShard.Parse(text))
            {
                Group = SweepGroup,
                Help = "Only part K of N, a range of consecutive poses, K from 1: for N processes, each with its own "
                    + "--out and, if wanted, --device. glint merge joins the parts."
            };

        /// <summary>Rays across and down.</summary>
        public static readonly Option<int2> Size =
            new Option<int2>("size", "WxH", text => Values.Size(text, RaysOfAxis))
            {
                Group = RadarGroup,
                Range = "each " + RaysOfAxis,
                DefaultText = "1920x1080",
                Help = "Rays across and down, one through the centre of each pixel."
            };

        /// <summary>The part of the picture to trace; all of it when not given.</summary>
        public static readonly Option<RayRegion> Region =
            new Option<RayRegion>("region", "L,B,W,H", text => Values.Region(text, RaysFromEdge))
            {
                Group = RadarGroup,
                Range = "within the picture",
                Help = "The part of the picture to trace, in rays: left, bottom, width, height, counted from the left "
                    + "and the bottom edge. The rays outside are not emitted. Without it: the whole picture."
            };

        /// <summary>Carrier frequency, hertz.</summary>
        public static readonly Option<double> Frequency = Number("frequency", "HZ", "10e9", CarrierFrequency,
            RadarGroup, InputKind.Any, "Carrier frequency in hertz.");

        /// <summary>Maximum number of reflections of a ray.</summary>
        public static readonly Option<int> Bounces = Whole("bounces", "N", "4",
            Interval.Closed(1, RadarSettings.BounceLimit), RadarGroup, "Maximum number of reflections of a ray.");

        /// <summary>Whether the sampling error is left out.</summary>
        public static readonly Option<bool> NoSamplingError = Switch("no-sampling-error", RadarGroup,
            "Leave out the estimate of the sampling error, which traces smaller rays around received ones: "
                + "this is faster, and the columns sampling_error, largest_path_step_wavelengths and undersampled "
                + "are empty.");

        /// <summary>Tolerance of the amplitude, decibels; 0 when not given.</summary>
        public static readonly Option<double> Tolerance = new Option<double>("tolerance", "DB",
            text => Values.Real(text, AmplitudeTolerance))
        {
            Group = RadarGroup,
            Range = AmplitudeTolerance.ToString(),
            Excludes = new (Option, string)[] { (NoSamplingError, "the error decides when the tolerance is met") },
            Help = "The error of the amplitude asked for in dB: 95 % of the amplitudes are within it. Instead of one "
                + "phasor a ray, the amplitude is integrated over ray tubes, which are clipped at the edges of facets "
                + "and receiver, until the tolerance is met. The columns of amplitudes then have the converged values, "
                + "those of rays count the rays traced, sampling_error has the standard error, and undersampled is 1 "
                + "where the tolerance is not met. Of --size only the aspect ratio and the scale of the columns "
                + "amplitude, in_phase and quadrature matter."
        };

        /// <summary>Clutter of the scene's seas; each sea's own setting when not given.</summary>
        public static readonly Option<ClutterChoice> Clutter =
            new Option<ClutterChoice>("clutter", "on|off|LEVEL", ClutterChoice.Read)
            {
                Group = RadarGroup,
                Inputs = InputKind.Scene,
                Refusal = "only seas of a scene have clutter: leave it out",
                Choices = ClutterChoice.Names,
                Range = "one of " + string.Join(", ", ClutterChoice.Names),
                Help = "Switches the diffuse echo of the scene's seas on or off. physics is the echo of the waves; the "
                    + "other levels scale it so that its mean is that of a published model, for each polarisation and "
                    + "grazing angle, and keep texture, speckle and motion. on: the level of the sea's settings. With "
                    + "clutter each row of a sweep also has the cross section of what the picture shows, that of the "
                    + "clutter, and signal to clutter, in VV and HH. Without it: the setting of each Sea."
            };

        /// <summary>Width and height of the receiver, metres.</summary>
        public static readonly Option<double2> Receiver =
            new Option<double2>("receiver", "M|WxH", text => Values.Area(text, Length))
            {
                Group = RadarGroup,
                Range = "each " + Length,
                DefaultText = "3",
                Help = "Side of the square receiver in metres, or its width and height. With a mesh file it is 0.2 m "
                    + "behind the radar. For parallel rays it is where they start, and by default as large as their "
                    + "rectangle."
            };

        /// <summary>Unit of the mesh file's coordinates.</summary>
        public static readonly Option<LengthUnit> Unit = OfMesh(new Option<LengthUnit>("unit", "UNIT", LengthUnit.Parse)
        {
            Range = "one of " + string.Join(", ", LengthUnit.All.Select(unit => unit.Name)),
            Choices = LengthUnit.All.Select(unit => unit.Name).ToArray(),
            DefaultText = "m",
            Help = "Unit of the file's coordinates."
        });

        /// <summary>Axis of the mesh file that points up.</summary>
        public static readonly Option<UpAxis> Up = OfMesh(new Option<UpAxis>("up", "AXIS", Values.Up)
        {
            Range = "y or z",
            Choices = new[] { "y", "z" },
            DefaultText = "y",
            Help = "Axis of the file that points up. y keeps the coordinates in Unity's axes (x right, y up, z "
                + "forward); z maps (x, y, z) to (x, z, y)."
        });

        /// <summary>Distance from the radar to the point it is aimed at, metres.</summary>
        public static readonly Option<double> Distance = Number("distance", "M", "50", Length, MeshGroup,
            InputKind.MeshFile, "Distance from the radar to its aim point, in metres.");

        /// <summary>Elevation of the radar above the horizontal through the point it is aimed at, degrees.</summary>
        public static readonly Option<double> Grazing = Number("grazing", "DEG", "10", GrazingAngle,
            MeshGroup, InputKind.MeshFile,
            "Grazing angle in degrees: how far the radar looks down. Below 0 it looks up.");

        /// <summary>Compass direction of the radar's position, degrees.</summary>
        public static readonly Option<double> Azimuth = Number("azimuth", "DEG", "0", Interval.Closed(-360, 360),
            MeshGroup, InputKind.MeshFile,
            "Position of the radar, in degrees about the vertical, positive as Unity's rotation about Y. At 0 it is "
                + "on the -Z side and looks along +Z.");

        /// <summary>Vertical field of view, degrees.</summary>
        public static readonly Option<double> Fov = Number("fov", "DEG", "60", Interval.Closed(1e-5, 179),
            MeshGroup, InputKind.MeshFile,
            "Vertical field of view in degrees, within the limits of Unity's cameras.");

        /// <summary>Metres from ray to ray where they are parallel; 0 when not given.</summary>
        public static readonly Option<double> Spacing =
            OfMesh(new Option<double>("spacing", "M", text => Values.Real(text, Length))
            {
                Range = Length.ToString(),
                Excludes = new (Option, string)[]
                {
                    (Size, "the spacing decides how many rays there are"), (Fov, "parallel rays have no field of view")
                },
                Help = "Spacing in metres of parallel rays (a plane wave), in place of a field of view. They start "
                    + "at --distance from a rectangle across the line of sight. It just covers the mesh (in a sweep: "
                    + "at each angle), or has the size of --aperture."
            });

        /// <summary>
        /// Width and height of the rectangle that parallel rays leave; 0 when not given: fitted to the mesh.
        /// </summary>
        public static readonly Option<double2> Aperture =
            OfMesh(new Option<double2>("aperture", "M|WxH", text => Values.Area(text, Length))
            {
                Needs = new Option[] { Spacing },
                Range = "each " + Length,
                Help = "With --spacing: side of the square that parallel rays start from, or its width and height, "
                    + "in metres, enlarged to whole spacings. Its centre is the radar's position."
            });

        /// <summary>The point that the radar is aimed at, metres, Unity's axes.</summary>
        public static readonly Option<double3> Aim =
            OfMesh(new Option<double3>("aim", "X,Y,Z", text => Values.Point(text, Coordinate))
            {
                Range = "each " + Coordinate,
                DefaultText = "0,0,0",
                Help = "The point that the radar is aimed at, in metres, Unity's axes (after --unit and --up)."
            });

        /// <summary>Seed of the built-in scene.</summary>
        public static readonly Option<int> Seed = Whole("seed", "N", "1", Interval.Closed(0, int.MaxValue),
            BuiltInGroup, "Seed of the sea: the same number gives the same waves.", InputKind.BuiltIn);

        /// <summary>About as many triangles has the built-in scene's sea.</summary>
        public static readonly Option<int> SeaTriangles = Whole("sea-triangles", "N", "35000", Triangles, BuiltInGroup,
            "Approximate number of triangles of the sea.", InputKind.BuiltIn);

        /// <summary>About as many triangles has the built-in scene's ship.</summary>
        public static readonly Option<int> ShipTriangles = Whole("ship-triangles", "N", "44000", Triangles,
            BuiltInGroup, "Approximate number of triangles of the ship.", InputKind.BuiltIn);

        /// <summary>Rounds of poses and peers.</summary>
        public static readonly Option<int> Rounds = Whole("rounds", "N", "11", Interval.Closed(1, 1000), BenchGroup,
            "Number of rounds after a warm-up. In each a few poses are timed, then each peer runs once. "
                + "The poses of a round give their median.");

        /// <summary>Other programs to time in the same run.</summary>
        public static readonly Option<PeerCommand[]> Peers =
            new Option<PeerCommand[]>("peer", "NAME=COMMAND", text => new[] { PeerCommand.Parse(text) })
            {
                Group = BenchGroup,
                Join = (before, more) => before.Concat(more).ToArray(),
                Help = "A program to time in the same run, by the shell; {scene} in COMMAND is the path of the scene "
                    + "in the form of --write-scene. Every line it prints with a number before \" ms\" is a time, "
                    + "named by the words before the first number of the line; a start counts by its medians. "
                    + "May be given more than once."
            };

        /// <summary>Rays that the reference tracer traces as well: 0 none, 1 all, N every N-th.</summary>
        public static readonly Option<int> Reference =
            new Option<int>("reference", "all|none|N", text => Values.Share(text, Interval.Closed(1, 1000000)))
            {
                Choices = new[] { "all", "none" },
                Group = BenchGroup,
                Help = "Which rays are traced in double precision too, for the errors: all, none, or every N-th. "
                    + "Without it: all, when rays and triangles are at most 4 million each."
            };

        /// <summary>Poses of a timed sweep.</summary>
        public static readonly Option<int> TimedSweep =
            new Option<int>("sweep", "N", text => Values.Whole(text, TimedPoses))
            {
                Group = BenchGroup,
                Inputs = InputKind.MeshFile | InputKind.BuiltIn,
                Refusal = "a scene has no target to turn: give a mesh file, or leave INPUT out",
                Range = TimedPoses.ToString(),
                Excludes = new (Option, string)[] { (Reference, "a sweep is timed, and not compared") },
                Help = "Instead: sweeps of N poses, with poses in flight and rows written to a temporary folder, as "
                    + "glint sweep works. A round is a sweep by the wall clock, another by the device's clock, and "
                    + "each peer once."
            };

        /// <summary>About as many facets has the sea whose diffuse echo is timed.</summary>
        public static readonly Option<int> TimedFacets =
            new Option<int>("facets", "N", text => Values.Whole(text, FacetCount))
            {
                Group = BenchGroup,
                Inputs = InputKind.BuiltIn,
                Refusal = "a scene has its own sea, whose echo is timed if its clutter is on: leave it out, or INPUT",
                Range = FacetCount.ToString(),
                Excludes = new (Option, string)[] { (TimedSweep, "a sweep has no clutter") },
                Help = "Also: the diffuse echo of a sea of about N facets of 1 m2, with one shadow ray a facet and one "
                    + "sum, at 1, 3, 10 and 45 degrees of grazing."
            };

        /// <summary>About as many rays are compared with the reference tracer's.</summary>
        public static readonly Option<int> Rays = Whole("rays", "N", "100000",
            Interval.Closed(1, 1000000000), VerifyGroup,
            "Approximate number of rays to compare, spread evenly over the picture, and as many received ones; all "
                + "if there are fewer.");

        /// <summary>File for the figures; null when not given.</summary>
        public static readonly Option<string> Json = Text("json", "FILE", ResultGroup,
            "File for the figures, as JSON.");

        /// <summary>File for the triangles; null when not given.</summary>
        public static readonly Option<string> WriteScene = Text("write-scene", "FILE", BenchGroup,
            "File for the triangles: number of vertices and of triangles (int32), x, y, z of each vertex "
                + "(float32, metres, the world's axes), three vertex numbers of each triangle (int32), little-endian.");

        /// <summary>Azimuths of cross sections by ray tubes and by points, degrees; null when not given.</summary>
        public static readonly Option<double[]> CrossSections =
            new Option<double[]>("rcs", "LIST", CrossSectionRanges.Azimuths.Read)
            {
                Group = BenchGroup,
                Inputs = InputKind.MeshFile | InputKind.BuiltIn,
                Refusal = "point sampling is measured on a mesh file: give one, or leave INPUT out",
                Range = CrossSectionRanges.Azimuth.ToString(),
                Excludes = new Option[] { Reference, Peers, TimedSweep, TimedFacets, WriteScene }
                    .Select(option => (option, "cross sections are compared with those of uniform points")).ToArray(),
                Help = "Instead: the rays that cross sections take to 0.1 dB at these azimuths, in degrees, and at "
                    + "--grazing, by ray tubes and by uniform points, each with --rounds random grids, three "
                    + "at least. Without a GPU it takes minutes. Without INPUT: of a metal sphere of 1 m radius with "
                    + "facets to 1/50 wavelength."
            };

        /// <summary>The GPU to work on: index or part of the name; null when not given.</summary>
        public static readonly Option<string> Device = new Option<string>("device", "DEVICE", Values.NotEmpty)
        {
            Group = DeviceGroup,
            UnityRemedy = "in Unity use Unity's own -force-device-index",
            Help = "The GPU to use: its index or part of its name, as glint info lists them. "
                + "Without it a discrete GPU, then an integrated or virtual one, then the CPU."
        };

        /// <summary>File for the plot of error against time; null when not given.</summary>
        public static readonly Option<string> Accuracy = OwnScenes("accuracy", "[FILE]", "accuracy.svg",
            "Instead: error against run time in built-in scenes, each traced with increasing numbers of rays "
                + "and compared with the converged result. FILE is the plot, as SVG; without it: accuracy.svg.");

        /// <summary>File for the plot of ray tubes beside uniform rays; null when not given.</summary>
        public static readonly Option<string> Tubes = OwnScenes("tubes", "[FILE]", "tubes.svg",
            "Instead: error, rays and run time of ray tubes and of uniform rays in built-in scenes, which "
                + "take turns. FILE is the plot, as SVG; without it: tubes.svg.", (Accuracy, OwnRadars));

        /// <summary>Folder for the plots of cross sections beside published ones; null when not given.</summary>
        public static readonly Option<string> CrossSectionPlots = OwnScenes("rcs-plots", "[DIR]", ".",
            "Instead: cross sections of a plate with fringe fields beside the method of moments, and of a sphere "
                + "beside Mie's series. DIR receives the plots, rcs-plate.svg and rcs-sphere.svg, and is created if "
                + "missing; without it: the current folder.",
            (Accuracy, OwnRadars), (Tubes, OwnRadars), (Rounds, "each direction is traced once"),
            (Json, "it writes plots alone"));

        /// <summary>Settings of a radar: the options of all commands that trace one pose.</summary>
        internal static readonly Option[] Radar =
        {
            Size, Region, Frequency, Bounces, NoSamplingError, Receiver, Unit, Up, Distance, Grazing, Azimuth, Fov,
            Spacing, Aperture, Aim
        };

        /// <summary>The option for a measure, which is a plain double or int.</summary>
        /// <param name="standard">Settings with its value when it is not given.</param>
        internal static Option Of(Measure measure, object standard, string group)
        {
            string name = measure.Title.ToLowerInvariant().Replace(' ', '-');
            string text = Numbers.Format(measure.Of(standard)),
                help = measure.Unit.Length == 0 ? measure.Help : $"{measure.Help} Unit: {measure.Unit}.";
            if (FieldOf(measure, standard).FieldType == typeof(int))
                return Whole(name, "N", text, measure.Range, group, help);
            return Number(name, measure.Unit.Length == 0 || measure.Unit.Contains(' ') ? "X"
                : measure.Unit.ToUpperInvariant(), text, measure.Range, group, InputKind.Any, help);
        }

        /// <summary>Sets a measure among settings.</summary>
        /// <param name="value">A double, of a whole number an int.</param>
        internal static void Set(Measure measure, object settings, object value) =>
            FieldOf(measure, settings).SetValue(settings, value);

        // A trimmed program keeps the fields of types that are named.
        static FieldInfo FieldOf(Measure measure, object settings) => settings is SeaSettings
            ? typeof(SeaSettings).GetField(measure.Field)
            : typeof(ShipSettings).GetField(measure.Field);

        internal static Option<bool> Switch(string name, string group, string help) =>
            new Option<bool>(name, "", Values.Given)
            {
                Group = group, IsSwitch = true, ImpliedText = Values.GivenText, Help = help
            };

        internal static Option<string> Text(string name, string valueName, string group, string help) =>
            new Option<string>(name, valueName, Values.NotEmpty) { Group = group, Help = help };

        const string OwnRadars = "it has its own scenes and radars";

        // A benchmark whose scenes and radars no option changes.
        static Option<string> OwnScenes(string name, string valueName, string implied, string help,
            params (Option, string)[] others) =>
            new Option<string>(name, valueName, Values.NotEmpty)
            {
                Group = BenchGroup,
                Inputs = InputKind.BuiltIn,
                Refusal = "it has its own scenes: leave INPUT out",
                ImpliedText = implied,
                Excludes = new Option[]
                {
                    Reference, Peers, TimedSweep, TimedFacets, CrossSections, WriteScene, Seed, SeaTriangles,
                    ShipTriangles, Size, Region, Frequency, Bounces, NoSamplingError, Receiver
                }
                    .Select(option => (option, OwnRadars)).Concat(others).ToArray(),
                Help = help
            };

        internal static Option<T> Needing<T>(Option needed, Option<T> option)
        {
            option.Needs = new[] { needed };
            return option;
        }

        static Option<T> OfMesh<T>(Option<T> option)
        {
            (option.Group, option.Inputs, option.Refusal) = (MeshGroup, InputKind.MeshFile, InSceneInstead);
            return option;
        }

        internal static Option<double> Number(string name, string valueName, string standard, Interval range,
            string group, InputKind inputs, string help) =>
            new Option<double>(name, valueName, text => Values.Real(text, range))
            {
                Group = group,
                Inputs = inputs,
                Refusal = inputs == InputKind.MeshFile ? InSceneInstead : null,
                Range = range.ToString(),
                DefaultText = standard,
                Help = help
            };

        internal static Option<double[]> List(string name, NumberList list, string standard, string group,
            string help) =>
            new Option<double[]>(name, "LIST", list.Read)
            {
                Group = group, Range = "each " + list.Range, DefaultText = standard, Help = help
            };

        internal static Option<int> Whole(string name, string valueName, string standard, Interval range, string group,
            string help, InputKind inputs = InputKind.Any) =>
            new Option<int>(name, valueName, text => Values.Whole(text, range))
            {
                Group = group,
                Inputs = inputs,
                Refusal = inputs == InputKind.BuiltIn ? WithoutInput : null,
                Range = range.ToString(),
                DefaultText = standard,
                Help = help
            };
    }

    /// <summary>A program that a benchmark times in alternation with Glint.</summary>
    public readonly struct PeerCommand
    {
        PeerCommand(string name, string command)
        {
            Name = name;
            Command = command;
        }

        /// <summary>Name in the tables.</summary>
        public string Name { get; }

        /// <summary>Its command line, for the shell.</summary>
        public string Command { get; }

        /// <summary>Reads NAME=COMMAND.</summary>
        /// <exception cref="FormatException">Name or command is missing.</exception>
        public static PeerCommand Parse(string text)
        {
            int equals = text.IndexOf('=');
            string name = equals < 0 ? "" : text.Substring(0, equals).Trim(),
                command = text.Substring(equals + 1).Trim();
            return name.Length > 0 && command.Length > 0
                ? new PeerCommand(name, command)
                : throw new FormatException("must be NAME=COMMAND, such as \"Embree=./embree {scene}\"");
        }
    }
}
