using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>The commands, for both hosts.</summary>
    public static class Commands
    {
        /// <summary>Summary of the commands, in one line.</summary>
        public const string Summary = "Glint, a radar for Unity: shoots rays from a radar, "
            + "bounces them through the scene on the GPU and sums what returns.";

        /// <summary>Description of INPUT.</summary>
        public const string InputHelp =
            "A scene (.unity) or a mesh file (.obj, .stl). A scene is given by its path on disk or by its asset path: "
            + "Scenes/X.unity is Packages/com.glint.scenes/X.unity in Unity. Commands for the mesh files of the examples "
            + "are on the page batch.md: ship.stl is that of glint ship --stl ship.stl.";

        const string SceneHelp = "A scene (.unity), by its path on disk or by its asset path: "
            + "Scenes/X.unity is Packages/com.glint.scenes/X.unity in Unity.";

        const string FoldersHelp = "The results folders of all parts, in any order.";

        /// <summary>The shells supported by <see cref="Completion"/>.</summary>
        public static readonly IReadOnlyList<string> Shells = new[] { "bash", "zsh", "fish" };

        const string ResultsHelp = "A folder that a sweep or run has written to: one with results.json.";

        const string WithoutInputHelp =
            "Without it: a rough sea with a ship on it, before the camera of the published experiment.";

        /// <summary>Description of the exit codes.</summary>
        public const string ExitCodes = "0 done; 1 something is wrong with a file, the scene or the device; "
            + "2 the command line is wrong; 130 stopped by Ctrl-C.";

        /// <summary>Traces every pose of a plan.</summary>
        public static readonly Command Sweep = new Command("sweep", "Step through angles, grazing angles, distances, "
            + "frequencies or snapshots of a sea, trace every pose and write results.csv and results.json.")
        {
            Options = Options.Axes.Concat(new Option[]
                {
                    Options.Target, Options.Shard, Options.Out, Options.Resume, Options.Size,
                    Options.Region, Options.Bounces, Options.Tolerance, Options.NoSamplingError, Options.Clutter,
                    Options.Receiver, Options.Unit, Options.Up, Options.Azimuth, Options.Fov,
                    Options.Spacing, Options.Aperture, Options.Aim, Options.Device
                }).ToArray(),
            Required = new Option[] { Options.Target },
            OneOf = Options.Axes,
            Notes = new[]
                {
                    "The target turns about the vertical through its own position and is put back afterwards. The mesh "
                        + "of a file is turned as a whole, about the vertical through the origin of its coordinates.",
                    "With several lists every value is traced with every value of the others: "
                        + "the angle changes from pose to pose, then the grazing angle, the distance, the frequency, "
                        + "and the snapshot slowest.",
                    "Without --out the files go to Results/<name of the input> beside the project's Assets."
                },
            Handler = Batch.TracePoses,
            UnityMethod = "Glint.Editor.Batch.Sweep",
            Examples = new[]
                {
                    Example("sweep Scenes/CornerReflector.unity --target \"Corner Reflector\" --angles 0:45:1",
                        "The published experiment, 46 poses."),
                    Example("sweep Scenes/SeaState6.unity --snapshots 1:10", "The ten stored snapshots of a sea."),
                    Example("sweep ship.stl --angles 0:345:15 --distance 500 --fov 10 --tolerance 1 --out ship",
                        "A mesh file in a full circle at 500 m, to 1 dB."),
                    Example("sweep Scenes/ShipFreeSpace.unity --target Ship --angles 0:345:15 --grazing 5,10,20 "
                            + "--distance 500:2000:500 --tolerance 1",
                        "A ship in a full circle, at three grazing angles and four ranges: 288 poses."),
                    Example("sweep Scenes/ShipFreeSpace.unity --target Ship --angles 0:359:1 --shard 2/4 --device 1 "
                            + "--out ship/2",
                        "The second quarter, on the second GPU; --resume continues it after a kill."),
                    Example("sweep plate.obj --angles -10,-5,0,5,10 --grazing 0 --fov 5 --size 640x360",
                        "Five angles of an upright plate, which returns rays at 0 only; fewer rays.")
                }
        };

        /// <summary>Joins the parts of a sweep.</summary>
        public static readonly Command Merge =
            new Command("merge",
                "Merge the parts of a sweep, of cross sections, of range profiles or of an image (--shard) into the "
                + "files of the whole.")
            {
                Inputs = InputKind.Folders,
                Options = new Option[] { Options.Out },
                Required = new Option[] { Options.Out },
                Notes = new[]
                {
                    "The files equal those of an undivided run, except for timings. "
                        + "All parts are needed, each once, finished, and traced with the same options, scene, "
                        + "kind of device and version."
                },
                Handler = Batch.MergeParts,
                UnityMethod = "Glint.Editor.Batch.Merge",
                Examples =
                    new[] { Example("merge ship/1 ship/2 ship/3 ship/4 --out ship/all", "Four parts, in any order.") }
            };

        /// <summary>Traces one pose.</summary>
        public static readonly Command Run =
            new Command("run", "Trace one pose of a scene or a mesh file.")
            {
                Options = Options.Radar.Prepend(Options.Tolerance).Prepend(Options.Out).Append(Options.Clutter)
                    .Append(Options.Device).ToArray(),
                Notes = new[] { "Without --out the result is printed and no file is written." },
                Handler = Batch.TracePoses,
                UnityMethod = "Glint.Editor.Batch.Run",
                Examples = new[]
                {
                    Example("run Scenes/CornerReflector.unity", "Print the result of the scene's radar."),
                    Example("run boat.obj --distance 200 --grazing 5 --azimuth 90 --frequency 9.4e9 --out boat",
                        "A boat seen from -X at 9.4 GHz; write the files to boat."),
                    Example("run boat.obj --distance 10000 --grazing 5 --spacing 0.005",
                        "The boat in a plane wave from 10 km, a ray every 5 mm."),
                    Example("run Scenes/CornerReflector.unity --tolerance 0.1",
                        "The amplitude of infinitely many rays, to 0.1 dB.")
                }
            };

        /// <summary>Computes cross sections.</summary>
        public static readonly Command Rcs = new Command("rcs", "Compute radar cross sections of a scene or a mesh "
            + "file in dBsm, to an accuracy that is asked for, and write rcs.csv, rcs.npz and results.json.")
        {
            Options = CrossSectionOptions.All,
            Notes = new[]
                {
                    "Units: angles in degrees, frequencies in hertz, lengths in metres, cross sections in dBsm, and "
                        + "the complex amplitudes S, with |S|^2 the cross section, in metres. Coordinates of a mesh "
                        + "file have the unit of --unit.",
                    "Method: physical optics with geometrical optics from bounce to bounce, and fringe fields of metal "
                        + "edges. The error that is asked for and written is that of the integration, not of physical "
                        + "optics.",
                    "Phases are relative to the origin of a mesh file's coordinates, or to the centre of the box "
                        + "around a scene's objects. The scene's camera and radar do not matter: all its visible "
                        + "meshes are the target.",
                    "Every receiver is computed for each frequency, all these for each azimuth, and these for each "
                        + "elevation. Without --out the files go to Results/<name of the input>-rcs beside the "
                        + "project's Assets."
                },
            Handler = CrossSectionCommand.Execute,
            UnityMethod = "Glint.Editor.Batch.Rcs",
            Examples = new[]
                {
                    Example("rcs ship.stl --azimuth 0:355:5 --frequency 10e9 --polarisation vv,hh --tolerance 3 --out ship-rcs",
                        "A full circle at 10 GHz, to 3 dB."),
                    Example("rcs plate.obj --azimuth -60:60:1 --polarisation vv,hh --edges off --tolerance 0.02",
                        "Pure physical optics of a plate, more accurate."),
                    Example("rcs boat.obj --frequency 9e9:9.5e9:2e6 --elevation 3 --material \"*=itu_wood\"",
                        "Many frequencies; all surfaces of one published material."),
                    Example("rcs boat.obj --azimuth 30 --receivers -150:150:1",
                        "A bistatic sweep from one illumination."),
                    Example("rcs Scenes/ShipFreeSpace.unity --azimuth 0:359:1 --shard 2/4 --out ship/2",
                        "The second quarter; glint merge joins the parts.")
                }
        };

        /// <summary>Computes range profiles.</summary>
        public static readonly Command Echo = new Command("echo", "Compute the responses of a scene or a mesh file over "
            + "a band of frequencies, and its range profiles in dBsm and dBW, and write profile.csv, echo.npz and "
            + "results.json.")
        {
            Options = EchoOptions.All,
            Notes = new[]
                {
                    "Each frequency of the band is computed exactly, as by glint rcs, to the error that is asked for. "
                        + "A window and a Fourier transform make the range profile: the peak of a point is its cross "
                        + "section in dBsm, whatever the window.",
                    "Range is half of the path out and back, in metres: 0 at the phase centre, positive away from the "
                        + "radar. The phase centre is the origin of a mesh file's coordinates, or the centre of the box "
                        + "around a scene's objects. Echoes outside the unambiguous range, c / 2 over the step of the "
                        + "frequencies, are folded into it.",
                    "With --power the files also have received power in dBW by the radar equation, with the receiver's "
                        + "noise if --noise-figure is given.",
                    "With --pulses each direction has a range-Doppler map too, in doppler.csv. A mesh file moves by "
                        + "--velocity and --turn-rate, an object of a scene by its component RadarMotion, a sea with "
                        + "clutter by its waves. Speed is positive towards the radar.",
                    "Without --out the files go to Results/<name of the input>-echo beside the project's Assets."
                },
            Handler = EchoCommand.Execute,
            UnityMethod = "Glint.Editor.Batch.Echo",
            Examples = new[]
                {
                    Example("echo ship.stl --azimuth 30 --bandwidth 300e6 --polarisation vv --tolerance 1 --out ship-echo",
                        "A range profile of a ship with bins of 0.5 m."),
                    Example("echo boat.obj --azimuth 0:180:6 --bandwidth 600e6 --window hamming --polarisation vv "
                            + "--out boat-echo",
                        "A profile every 6 degrees; glint report shows them as a waterfall."),
                    Example("echo boat.obj --frequency 9.41e9 --range 5000 --power 25000 --gain 30 --noise-figure 5 "
                            + "--mat --sigmf",
                        "Received power at 5 km with noise, for MATLAB and as a SigMF recording too."),
                    Example("echo boat.obj --azimuth 30 --pulses 64 --prf 2000 --velocity 0,0,-6 --range 5000 "
                            + "--power 25000 --gain 30 --noise-figure 5 --detect ca",
                        "A range-Doppler map of a boat that moves, and what is detected in it.")
                }
        };

        /// <summary>Computes an image of a sweep of looks.</summary>
        public static readonly Command Isar = new Command("isar", "Compute an ISAR image of a scene or a mesh file in "
            + "dBsm from a sweep of small angles or a track of the radar, and write image.csv, image.npz, a PNG file for each polarisation, "
            + "responses.npy, echo.npz and results.json.")
        {
            Options = EchoOptions.AllOfImage,
            Required = new Option[] { CrossSectionOptions.Azimuth },
            Notes = new[]
                {
                    "The responses of all azimuths are those of glint echo. Backprojection puts them on a horizontal "
                        + "plane through the phase centre: down range away from the radar at the middle azimuth, cross "
                        + "range to its right. A point on the plane keeps its cross section; one above it is moved "
                        + "towards the radar, unless the elevation is 0.",
                    "On this plane a bin of down range is c / (2 B cos e), e the elevation. A bin of cross range is "
                        + "the wavelength over twice the angle of all azimuths in radians and cos e; the unambiguous "
                        + "cross range has as many bins as there are azimuths.",
                    "Without --out the files go to Results/<name of the input>-isar beside the project's Assets."
                },
            Handler = EchoCommand.Execute,
            UnityMethod = "Glint.Editor.Batch.Isar",
            Examples = new[]
                {
                    Example("isar boat.obj --azimuth 25:35:0.25 --elevation 5 --frequency 3e9 --bandwidth 600e6 "
                            + "--polarisation vv",
                        "An image with bins of 0.25 m in range and 0.28 m in cross range."),
                    Example("isar boat.obj --azimuth 30 --elevation 20 --range 500 --track -40:40:1 --frequency 3e9 "
                            + "--bandwidth 600e6 --polarisation vv",
                        "Spotlight SAR from a track of 80 m, 500 m away.")
                }
        };

        /// <summary>Computes the diffuse echo of a sea.</summary>
        public static readonly Command Clutter = new Command("clutter", "Compute sigma0, the lit fraction and the "
            + "texture of the sea of a scene over grazing angle, wind direction and frequency, beside published models, "
            + "and write clutter.csv and results.json.")
        {
            Inputs = InputKind.Scene,
            Options = ClutterOptions.All,
            Notes = new[]
                {
                    "The sea has no end: the echo is that of one tile under a plane wave, shaded by as many copies of "
                        + "the tile towards the radar as its shadows are long. Objects in the sea do not matter.",
                    "Models are those of the sea's state: of its requested height, of the height of its spectrum where "
                        + "the fetch limits it, or of its wind. Where a model does not hold, its columns are empty.",
                    "The grazing angle changes from row to row, then the azimuth, the frequency, and the snapshot or "
                        + "time slowest. Without --out the files go to Results/<name of the scene>-clutter beside the "
                        + "project's Assets."
                },
            Handler = ClutterCommand.Execute,
            UnityMethod = "Glint.Editor.Batch.Clutter",
            Examples = new[]
                {
                    Example("clutter Scenes/SeaState5.unity --clutter on --cell 8x8",
                        "The stored sea, whose clutter is off, at twelve grazing angles."),
                    Example("clutter Assets/Sea.unity --grazing 1:10:1 --azimuth 0,90,180 --frequency 3e9,9.4e9 "
                            + "--times 0:45:5 --out sea",
                        "A sea of your own in three directions, at two frequencies and ten times."),
                    Example("clutter Assets/Sea.unity --clutter nrl", "With the mean of a published model.")
                }
        };

        /// <summary>Turns the radar screen of a scene.</summary>
        public static readonly Command Ppi = new Command("ppi", "Turn the radar screen (PPI) of a scene, frame by "
            + "frame, and write the last turn as picture.png and video.npz.")
        {
            Inputs = InputKind.Scene,
            Options = ScreenOptions.All,
            Notes = new[]
                {
                    "The scene has one RadarScreen, whose settings hold. Ships with Underway move, and seas whose motion "
                        + "is Waves; scripts do not run.",
                    "picture.png is the picture, results.json has the settings. video.npz has bearing_deg, range_m, "
                        + "power_dbw and video (spoke by cell), noise_dbw and heading_deg. "
                        + "Powers are those behind beam and pulse, before the receiver's controls.",
                    "Without --out the files go to Results/<name of the scene>-ppi beside the project's Assets."
                },
            Handler = ScreenCommand.Execute,
            UnityMethod = "Glint.Editor.Batch.Ppi",
            Examples = new[]
                {
                    Example("ppi Scenes/HarbourApproach.unity --out harbour", "Two turns: 5 s of the scene."),
                    Example("ppi Scenes/HarbourApproach.unity --turns 24 --udp 4378",
                        "A minute of radar video for a chart plotter on this machine.")
                }
        };

        /// <summary>Makes an HTML report of results.</summary>
        public static readonly Command Report = new Command("report", "Write one HTML file of a sweep, run, "
            + "cross sections, range profiles, sea clutter or a radar screen that opens offline: charts, table, and the "
            + "scene in 3-D with its received rays or hot spots.")
        {
            Inputs = InputKind.Results,
            Options = new Option[] { ReportOptions.Out, ReportOptions.Pose, Options.Device },
            Notes = new[]
                {
                    "One pose is traced again for the 3-D view and the radar's picture. "
                        + "If its scene or mesh file cannot be opened, the report says so and has everything else; "
                        + "a relative path of a mesh file is resolved from the current folder.",
                    "Of cross sections and range profiles nothing is traced again. Contributions and hot spots are there if "
                        + "glint rcs had --contributions."
                },
            Handler = ReportCommand.Write,
            UnityMethod = "Glint.Editor.Batch.Report",
            Examples = new[]
                {
                    Example("report Results/corner", "Results/corner/report.html, with the strongest pose in 3-D."),
                    Example("report Results/corner --pose 10 --out corner.html",
                        "The tenth pose in 3-D, in a file with another name."),
                    Example("report Results/corner --pose none",
                        "Without the scene, if there is no GPU or it takes too long.")
                }
        };

        /// <summary>Times poses and other programs. Only in the headless host.</summary>
        public static readonly Command Bench = new Command("bench", "Time a pose, count its work, "
            + "and compare its sums with a double-precision tracer and its times with other programs.")
        {
            Inputs = InputKind.File | InputKind.BuiltIn,
            Options = new Option[]
                {
                    Options.Rounds, Options.TimedSweep, Options.TimedFacets, Options.CrossSections, Options.Peers,
                    Options.Reference, Options.Json, Options.WriteScene, Options.Seed, Options.SeaTriangles, Options.ShipTriangles,
                    Options.Clutter
                }.Concat(Options.Radar).Concat(new Option[]
                {
                    Options.Accuracy, Options.Tubes, Options.CrossSectionPlots, Options.Device
                }).ToArray(),
            Notes = new[]
                {
                    "A pose is timed as in a sweep: the target (the ship, the mesh of a file) is turned by a "
                        + "thousandth of a degree, changes are uploaded, rays are traced and summed. "
                        + "Sums and errors are those of the unturned target."
                },
            Examples = new[]
                {
                    Example("bench", "The built-in scene, 1920 x 1080 rays."),
                    Example("bench --size 7680x4320 --reference none --json 8k.json",
                        "33 million rays, with the figures in a file."),
                    Example("bench --sweep 200", "Poses a second of a sweep, and where its wall time goes."),
                    Example("bench --facets 4000000 --reference none",
                        "The diffuse echo of a sea of 2 x 2 km beside a pose."),
                    Example("bench --accuracy --json accuracy.json",
                        "Run time against error: the plot, tables and figures."),
                    Example("bench --rcs 20,45,70 --json rcs.json",
                        "Rays of ray tubes and of point sampling, on a sphere."),
                    Example("bench --peer \"Embree=./embree {scene}\"", "In turns with another program.")
                }
        };

        /// <summary>
        /// Compares rays one by one with those of the reference tracer. Only in the headless host.
        /// </summary>
        public static readonly Command Verify = new Command("verify",
            "Trace a scene and compare its rays one by one with those of a double-precision tracer.")
        {
            Options = Options.Radar.Prepend(Options.Json).Prepend(Options.Rays).Append(Options.Device).ToArray(),
            Notes = new[]
                {
                    "A ray is right if it takes the same path and, if received, its length agrees within 10 "
                        + "micrometres. It is also right if it passes a triangle's edge too closely for float32 to "
                        + "tell the side. The exit code is 1 if a ray is wrong."
                },
            Examples = new[]
                {
                    Example("verify Scenes/CornerReflector.unity", "Its 676 received rays, and some 100,000 of all."),
                    Example("verify ship.stl --distance 10000 --fov 0.3 --json ship.json",
                        "A mesh from 10 km, with the figures in a file.")
                }
        };

        /// <summary>Repeats the published experiments. Only in the headless host.</summary>
        public static readonly Command Experiments = new Command("experiments",
            "Repeat the published experiments and write tables and plots of the results beside the published ones.")
        {
            Inputs = InputKind.None,
            Options = new Option[] { ExperimentOptions.Out, ExperimentOptions.Seeds, Options.Device },
            Notes = new[]
                {
                    "It sweeps the scenes that this project stores: the corner reflector, both seas, the ship alone "
                        + "and on each sea. Then it turns the ship on every stored snapshot, and makes other seas with "
                        + "other seeds, winds and choppinesses, to count how often a sea returns rays.",
                    "Without --out the files go to Results/experiments beside the project's Assets. An existing "
                        + "experiments.md keeps its text: only the parts between its markers are replaced."
                },
            Examples = new[]
                {
                    Example("experiments", "All experiments."),
                    Example("experiments --seeds 1 --out figures", "One seed: the stored seas and their neighbours in "
                        + "wind and choppiness; the files go to figures.")
                }
        };

        /// <summary>Makes snapshots of a sea.</summary>
        public static readonly Command Sea =
            new Command("sea", "Make snapshots of a sea from a wave spectrum, as meshes and prefabs of the project.")
            {
                Inputs = InputKind.None,
                Options = SeaOptions.All,
                Notes = new[] { "Without options it makes the seas stored in Meshes again: the same settings give "
                    + "the same files on any machine." },
                Handler = GeneratedAssets.WriteSea,
                UnityMethod = "Glint.Editor.Batch.Sea",
                Examples = new[]
                {
                    Example("sea", "The stored seas, sea states 5 and 6."),
                    Example("sea --sea-state 4 --wind 9 --tile 256 --grid 256 --cells 256 --times 0:27:3 --out "
                        + "Assets/Seas/State4", "Ten snapshots of a larger, longer sea.")
                }
            };

        /// <summary>Makes the ship.</summary>
        public static readonly Command Ship =
            new Command("ship", "Make a naval vessel from its measures, as a mesh and a prefab of the project or as an STL file.")
            {
                Inputs = InputKind.None,
                Options = ShipOptions.All,
                Notes = new[] { "Without options it makes the ship stored in Meshes again: the same settings give "
                    + "the same files on any machine." },
                Handler = GeneratedAssets.WriteShip,
                UnityMethod = "Glint.Editor.Batch.Ship",
                Examples = new[]
                {
                    Example("ship", "The stored ship."),
                    Example("ship --length 70 --out Assets/Ships/Longer", "A longer one."),
                    Example("ship --length 130 --beam 16 --triangles 500000 --stl frigate.stl",
                        "A large ship, fine enough for cross sections at 10 GHz.")
                }
            };

        /// <summary>Makes the corner reflector.</summary>
        public static readonly Command Reflector = new Command("reflector",
            "Make the corner reflector of the published experiment and its radar, as prefabs of the project.")
        {
            Inputs = InputKind.None,
            Options = new Option[0],
            Notes = new[] { "It writes the two prefabs that Scenes/CornerReflector.unity shows to "
                    + "Meshes/CornerReflector. Their geometry is that of Reference/CornerReflector.cs." },
            Handler = CornerReflectorAssets.Write,
            UnityMethod = "Glint.Editor.Batch.Reflector",
            Examples = new[] { Example("reflector", "The stored prefabs.") }
        };

        /// <summary>Lists devices, limits and versions.</summary>
        public static readonly Command Info =
            new Command("info", "List the GPUs, the limits of the one in use, and the versions.")
            {
                NeedsProject = false,
                Inputs = InputKind.None,
                Options = new Option[] { Options.Device },
                Examples = new[]
                {
                    Example("info", "Versions, GPUs, and the one in use."),
                    Example("info --device llvmpipe", "The limits of Mesa's software device.")
                }
            };

        /// <summary>Prints a completion script for a shell. Only in the headless host.</summary>
        public static readonly Command Completion = new Command("completion",
            "Print a shell script that completes commands, options, choices and file names of glint.")
        {
            NeedsProject = false,
            Inputs = InputKind.Shell,
            Options = new Option[0],
            Examples = new[]
                {
                    Example("completion bash",
                        "For bash: put  source <(glint completion bash)  into ~/.bashrc."),
                    Example("completion zsh",
                        "For zsh: put  source <(glint completion zsh)  into ~/.zshrc, after compinit."),
                    Example("completion fish",
                        "For fish: glint completion fish > ~/.config/fish/completions/glint.fish")
                }
        };

        /// <summary>Every command.</summary>
        public static IReadOnlyList<Command> All { get; } =
            new[]
            {
                Sweep, Merge, Run, Rcs, Echo, Isar, Clutter, Ppi, Report, Sea, Ship, Reflector, Experiments, Bench, Verify, Info,
                Completion
            };

        /// <summary>Description of INPUT for a command.</summary>
        public static string InputHelpOf(Command command) => command.Inputs == InputKind.Folders ? FoldersHelp
            : command.Inputs == InputKind.Results ? ResultsHelp
            : command.Inputs == InputKind.Shell ? string.Join(", ", Shells) + "."
            : command.Inputs == InputKind.Scene ? SceneHelp
            : command.HasBuiltIn ? $"{InputHelp} {WithoutInputHelp}"
            : InputHelp;

        static KeyValuePair<string, string> Example(string line, string meaning) =>
            new KeyValuePair<string, string>(line, meaning);
    }

    /// <summary>The options of <c>glint experiments</c>.</summary>
    public static class ExperimentOptions
    {
        const string Group = "Experiments";

        /// <summary>Folder for tables, plots and figures; null when not given.</summary>
        public static readonly Option<string> Out = Options.Text("out", "DIR", Group,
            "Folder for experiments.md, experiments.json and the plots in images/, "
                + "created with its parents if missing.");

        /// <summary>Seas with the same wind and choppiness.</summary>
        public static readonly Option<int> Seeds = Options.Whole("seeds", "N", "20", Interval.Closed(1, 1000), Group,
            "Seas of each wind and choppiness: the stored one, "
                + "and others that differ only in the seed.");
    }
}
