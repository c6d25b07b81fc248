using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class CommandLineTests
    {
        [Test]
        public void Sweep_OfAScene_HasItsValues()
        {
            var line = Parse(Commands.Sweep, "Scenes/X.unity", "--target", "Corner Reflector",
                "--angles", "0:45:1", "--out", "results");

            Assert.That(line.Input, Is.EqualTo("Scenes/X.unity"));
            Assert.That(line.InputKind, Is.EqualTo(InputKind.Scene));
            Assert.That(line.Get(Options.Target), Is.EqualTo("Corner Reflector"));
            Assert.That(line.Get(Options.Angles).Length, Is.EqualTo(46));
            Assert.That(line.Get(Options.Out), Is.EqualTo("results"));
        }

        [Test]
        public void Sweep_OfSnapshots_NeedsNoTargetAndNoAngles()
        {
            var line = Parse(Commands.Sweep, "Scenes/X.unity", "--snapshots", "1:10");

            Assert.That(line.Get(Options.Snapshots).Length, Is.EqualTo(10));
            Assert.That(line.Get(Options.Angles), Is.Null);
        }

        [TestCase("--target is missing", "x.unity", "--snapshots", "1:10", "--angles", "0")]
        [TestCase("--target: needs --angles ANGLES, --grazing LIST or --distance LIST", "x.unity",
            "--snapshots", "1:10", "--target", "Ship")]
        [TestCase("sweep: nothing to step through: give --angles ANGLES, --grazing LIST, --distance LIST, "
            + "--frequency LIST or --snapshots LIST", "x.unity")]
        [TestCase("sweep: nothing to step through: give --angles ANGLES, --grazing LIST, "
            + "--distance LIST or --frequency LIST", "x.obj")]
        [TestCase("--target is missing: sweep needs --target NAME", "x.unity", "--grazing", "1:10:1")]
        [TestCase("--target is missing: sweep needs --target NAME", "x.unity", "--distance", "100")]
        [TestCase("--snapshots: only for scenes", "x.obj", "--snapshots", "1:10")]
        public void Sweep_OfHalfAnAxis_IsRefused(string part, params string[] arguments) =>
            Assert.That(Assert.Throws<UsageException>(() => Parse(Commands.Sweep, arguments)).Message,
                Does.Contain(part));

        [TestCase("x.obj", "--grazing", "-10:10:5")]
        [TestCase("x.obj", "--distance", "1,2,3,5")]
        [TestCase("x.unity", "--frequency", "9e9:10e9:0.25e9")]
        [TestCase("x.unity", "--frequency", "1e9,2e9", "--snapshots", "1,2")]
        public void Sweep_OfAnyAxis_NeedsNoOther(params string[] arguments) =>
            Assert.That(() => Parse(Commands.Sweep, arguments), Throws.Nothing);

        [Test]
        public void Sweep_OfLists_HasTheirNumbers()
        {
            var line = Parse(Commands.Sweep, "x.unity", "--target", "Ship", "--grazing", "1,2", "--distance=50:100:25",
                "--frequency", "9e9:9.2e9:0.1e9");

            Assert.That(line.Get(Options.GrazingAngles), Is.EqualTo(new double[] { 1, 2 }));
            Assert.That(line.Get(Options.Distances), Is.EqualTo(new double[] { 50, 75, 100 }));
            Assert.That(line.Get(Options.Frequencies), Is.EqualTo(new[] { 9e9, 9.1e9, 9.2e9 }));
            Assert.That(line.Get(Options.Angles), Is.Null);
        }

        [Test]
        public void Sweep_InAPartOrResumed_IsTaken()
        {
            // A switch takes no value, so the next word is the input.
            var line = Parse(Commands.Sweep, "--resume", "x.obj", "--angles", "0:9:1", "--shard", "2/3");

            Assert.That((line.Input, line.Get(Options.Resume), line.Get(Options.Shard)),
                Is.EqualTo(("x.obj", true, (SweepShard?)new SweepShard(2, 3))));
            line = Parse(Commands.Sweep, "x.obj", "--angles", "0:9:1");
            Assert.That((line.Get(Options.Resume), line.Get(Options.Shard)), Is.EqualTo((false, (SweepShard?)null)));
        }

        [TestCase("--resume yes: takes no value", "--resume=yes")]
        [TestCase("--resume: given twice", "--resume", "--resume")]
        [TestCase("--shard 0/3: must be K/N", "--shard", "0/3")]
        [TestCase("--shard 4/3: must be K/N", "--shard", "4/3")]
        [TestCase("--shard 1: must be K/N", "--shard", "1")]
        [TestCase("--shard 1/2/3: must be K/N", "--shard", "1/2/3")]
        [TestCase("--shard 1/100001: must be K/N", "--shard", "1/100001")]
        public void Sweep_InAPartOrResumedWrongly_IsRefused(string part, params string[] arguments) =>
            Assert.That(Assert.Throws<UsageException>(() =>
                    Parse(Commands.Sweep, arguments.Concat(new[] { "--angles", "0:9:1", "x.obj" }).ToArray())).Message,
                Does.StartWith(part));

        [Test]
        public void Merge_OfFolders_HasThemInOrder()
        {
            Assert.That(Parse(Commands.Merge, "b", "a.obj", "--out", "c", "d").Folders,
                Is.EqualTo(new[] { "b", "a.obj", "d" }));
            AssertRefused(Commands.Merge, "merge: DIR is missing: give the results folders of all parts", "--out", "c");
            AssertRefused(Commands.Merge, "merge: a DIR is empty: give the name of a folder", "", "--out", "c");
            AssertRefused(Commands.Merge, "merge: ./a/: given twice: give each part once", "a",
                "b", "./a/", "--out", "c");
            AssertRefused(Commands.Merge, "--out is missing: merge needs --out DIR", "a");
            AssertRefused(Commands.Merge, "--resume: merge has no such option", "a", "--out", "c", "--resume");
        }

        [Test]
        public void Sea_WithOptions_IsThatSea()
        {
            var recipe = SeaOptions.Read(Parse(Commands.Sea, "--out", "Assets/Sea", "--sea-state", "4", "--wind", "9",
                "--times", "0:6:3", "--tiles", "2x3", "--spectrum", "jonswap", "--fetch", "1e5"));

            Assert.That(recipe.Settings.SignificantWaveHeight, Is.EqualTo((1.25 + 2.5) / 2),
                "the middle of the WMO's range");
            Assert.That((recipe.Settings.WindSpeed, recipe.Settings.Kind), Is.EqualTo((9.0, SeaSpectrumKind.Jonswap)));
            Assert.That(recipe.Times, Is.EqualTo(new double[] { 0, 3, 6 }));
            Assert.That(recipe.Tiles, Is.EqualTo(new int2(2, 3)));
        }

        [Test]
        public void Sea_WithoutOptions_IsNoneOfItsOwn() => Assert.That(SeaOptions.Read(Parse(Commands.Sea)), Is.Null);

        [Test]
        public void Sea_WithSwell_HasIt()
        {
            var settings = SeaOptions.Read(Parse(Commands.Sea, "--out", "Assets/Sea", "--tile", "512",
                "--swell-height", "2", "--swell-period", "9", "--swell-direction", "-30")).Settings;
            Assert.That((settings.SwellHeight, settings.SwellPeriod, settings.SwellDirectionDegrees),
                Is.EqualTo((2.0, 9.0, -30.0)));
        }

        [TestCase("--out is missing", "--wind", "5")]
        [TestCase("--sea-state: not with --wave-height: both set", "--out", "x",
            "--sea-state", "4", "--wave-height", "2")]
        [TestCase("grid size 100 must be a power of two", "--out", "x", "--grid", "100")]
        [TestCase("--wind -3: must be from 0.1 to 100", "--out", "x", "--wind", "-3")]
        [TestCase("--wave-height -1: must be from 0 to 100", "--out", "x", "--wave-height", "-1")]
        [TestCase("significant wave height 0 m", "--out", "x", "--spectrum", "phillips")]
        [TestCase("fetch 0 m must be from 100 to 1e7", "--out", "x", "--spectrum", "jonswap")]
        [TestCase("wind speed 25 m/s must be from 3 to 20", "--out", "x", "--wind", "25")]
        [TestCase("--swell-height -1: must be from 0 to 100", "--out", "x", "--swell-height", "-1")]
        [TestCase("--swell-period 40: must be from 3 to 30", "--out", "x", "--swell-period", "40")]
        [TestCase("must be that of waves from", "--out", "x", "--swell-height", "1")]
        [TestCase("--wave-height NaN: must be a number", "--out", "x", "--wave-height", "NaN")]
        [TestCase("--tile 0: must be from 1 to 8192", "--out", "x", "--tile", "0")]
        [TestCase("--sea-state 9: must be from 1 to 8", "--out", "x", "--sea-state", "9")]
        [TestCase("--times 0:5: a range has three parts", "--out", "x", "--times", "0:5")]
        [TestCase("tile size 10.0001 m must be a multiple of 1/1024 m", "--out", "x", "--tile", "10.0001")]
        [TestCase("--spectrum waves: must be phillips", "--out", "x", "--spectrum", "waves")]
        public void Sea_Unfit_IsRefused(string part, params string[] arguments) =>
            Assert.That(Assert.Throws<UsageException>(() => SeaOptions.Read(Parse(Commands.Sea, arguments))).Message,
                Does.Contain(part));

        [Test]
        public void Option_NotGiven_HasItsDefault()
        {
            var line = Parse(Commands.Run, "plate.stl");

            Assert.That(line.InputKind, Is.EqualTo(InputKind.MeshFile));
            Assert.That(line.IsGiven(Options.Size), Is.False);
            Assert.That(line.Get(Options.Size), Is.EqualTo(new int2(1920, 1080)));
            Assert.That(line.Get(Options.Out), Is.Null);
        }

        [TestCase("--grazing", "-10")]
        [TestCase("--grazing=-10")]
        public void Value_Negative_IsNoOption(params string[] option) =>
            Assert.That(Parse(Commands.Run, option.Concat(new[] { "plate.obj" }).ToArray()).Get(Options.Grazing),
                Is.EqualTo(-10));

        [Test]
        public void Value_AfterEquals_MayHoldAnything() =>
            Assert.That(Parse(Commands.Sweep, "x.unity", "--target=--a=b", "--angles=-1,1").Get(Options.Target),
                Is.EqualTo("--a=b"));

        [Test]
        public void Input_AfterTwoDashes_MayBeginWithADash() =>
            Assert.That(Parse(Commands.Run, "--bounces", "2", "--", "--odd.obj").Input, Is.EqualTo("--odd.obj"));

        [TestCase("a/B.UNITY", InputKind.Scene)]
        [TestCase("Packages/com.glint.scenes/X.unity", InputKind.Scene)]
        [TestCase("a b.OBJ", InputKind.MeshFile)]
        [TestCase("/parts/x.stl", InputKind.MeshFile)]
        public void Input_ByItsEnding_IsSceneOrMeshFile(string input, InputKind kind) =>
            Assert.That(Parse(Commands.Run, input).InputKind, Is.EqualTo(kind));

        [Test]
        public void Bench_WithoutInput_IsOfTheBuiltInScene()
        {
            var line = Parse(Commands.Bench, "--seed", "3", "--size", "64x36");

            Assert.That(line.Input, Is.Null);
            Assert.That(line.InputKind, Is.EqualTo(InputKind.BuiltIn));
            Assert.That(line.Get(Options.SeaTriangles) + line.Get(Options.ShipTriangles), Is.EqualTo(79000));
            Assert.That(line.Get(Options.Peers), Is.Null);
        }

        [Test]
        public void Bench_OfSeveralPeers_KeepsTheirOrder() =>
            Assert.That(Parse(Commands.Bench, "--peer", "A=a", "x.obj", "--peer=B=b").Get(Options.Peers)
                .Select(peer => peer.Name), Is.EqualTo(new[] { "A", "B" }));

        [Test]
        public void Bench_OptionsOfAnotherInput_AreRefusedByName()
        {
            AssertRefused(Commands.Bench,
                "--seed: only for the built-in scene: leave INPUT out", "x.obj", "--seed", "3");
            AssertRefused(Commands.Bench, "--ship-triangles: only for the built-in scene: leave INPUT out", "x.unity",
                "--ship-triangles", "2000");
            AssertRefused(Commands.Bench, "--distance: only for mesh files: a scene has its own camera and objects, "
                + "change it there", "--distance", "3");
            AssertRefused(Commands.Run, "--seed: run has no such option", "x.obj", "--seed", "3");
        }

        [TestCase("Results/corner")]
        [TestCase("a b/x.unity")]
        public void Input_OfReport_IsAFolderWhateverItsEnding(string folder)
        {
            var line = Parse(Commands.Report, folder);
            Assert.That(line.Input, Is.EqualTo(folder));
            Assert.That(line.InputKind, Is.EqualTo(InputKind.Results));
        }

        [TestCase("1", 1)]
        [TestCase("46", 46)]
        [TestCase("none", ReportOptions.NoPose)]
        public void Pose_OfReport_IsARowOrNone(string text, int pose) =>
            Assert.That(Parse(Commands.Report, "x", "--pose", text).Get(ReportOptions.Pose), Is.EqualTo(pose));

        [TestCase("0")]
        [TestCase("1.5")]
        [TestCase("all")]
        public void Pose_OfReport_RefusesOtherWords(string text) =>
            Assert.That(() => Parse(Commands.Report, "x", "--pose", text),
                Throws.TypeOf<UsageException>().With.Message.Contain("--pose").And.Message.Contain("or none"));

        [Test]
        public void Arguments_OfALine_MakeTheSameLine()
        {
            var line = Parse(Commands.Sweep, "--angles", "-10,0", "--unit=mm", "--", "-odd=name.obj");
            var again = CommandLine.Parse(Commands.Sweep, line.Arguments.Skip(1).ToArray());
            Assert.That(line.Arguments[0], Is.EqualTo("sweep"));
            Assert.That(again.Arguments, Is.EqualTo(line.Arguments));
            Assert.That(again.Get(Options.Angles), Is.EqualTo(new[] { -10.0, 0 }));
            Assert.That(again.Get(Options.Unit).Meters, Is.EqualTo(0.001));
        }

        [TestCase(InputKind.Scene, "--size", "--frequency", "--bounces", "--receiver")]
        [TestCase(InputKind.MeshFile, "--size", "--frequency", "--bounces", "--receiver", "--unit", "--up",
            "--distance", "--grazing", "--azimuth", "--fov", "--aim")]
        public void RadarOptions_WithTheInputTheyGoWith_AreTaken(InputKind kind, params string[] flags)
        {
            string input = kind == InputKind.Scene ? "x.unity" : "x.obj";
            foreach (var option in Commands.Run.Options.Where(option => flags.Contains(option.Flag)))
                Assert.That(Parse(Commands.Run, input, option.Flag, option.DefaultText).IsGiven(option),
                    Is.True, option.Flag);
        }

        [TestCase("--unit", "m")]
        [TestCase("--up", "y")]
        [TestCase("--distance", "50")]
        [TestCase("--grazing", "10")]
        [TestCase("--azimuth", "0")]
        [TestCase("--fov", "60")]
        [TestCase("--spacing", "0.01")]
        [TestCase("--aperture", "3")]
        [TestCase("--aim", "0,0,0")]
        public void MeshOption_WithAScene_IsRefusedByName(string flag, string value) =>
            AssertRefused(Commands.Run, flag + ": only for mesh files: a scene has its own camera and objects, "
                + "change it there", "x.unity", flag, value);

        [Test]
        public void Spacing_OfParallelRays_IsTakenWithAndWithoutAnAperture()
        {
            var fitted = Parse(Commands.Run, "x.obj", "--spacing", "0.005");
            Assert.That((fitted.Get(Options.Spacing), fitted.Get(Options.Aperture)),
                Is.EqualTo((0.005, new double2(0, 0))));
            var given = Parse(Commands.Sweep, "x.obj", "--angles", "0", "--aperture", "3x2", "--spacing", "0.005");
            Assert.That(given.Get(Options.Aperture), Is.EqualTo(new double2(3, 2)));
            Assert.That(Parse(Commands.Run, "x.obj").Get(Options.Spacing), Is.Zero);
        }

        [TestCase("--spacing: not with --size: the spacing decides how many rays there are",
            "--size", "3x3", "--spacing", "1")]
        [TestCase("--spacing: not with --fov: parallel rays have no field of view", "--spacing", "1", "--fov", "60")]
        [TestCase("--aperture: needs --spacing M", "--aperture", "3")]
        [TestCase("--aperture: needs --spacing M", "--aperture", "3", "--size", "3x3")]
        public void Spacing_WithWhatItLeavesNoRoomFor_IsRefused(string message, params string[] options) =>
            AssertRefused(Commands.Run, message, options.Prepend("x.obj").ToArray());

        [Test]
        public void Arguments_Wrong_AreRefusedInOneLine()
        {
            AssertRefused(Commands.Run, "run: INPUT is missing: give a scene (.unity) or a mesh file (.obj, .stl)");
            AssertRefused(Commands.Run, "x.fbx: neither a scene (.unity) nor a mesh file (.obj, .stl)", "x.fbx");
            AssertRefused(Commands.Run, "run: INPUT is empty: give a scene (.unity) or a mesh file (.obj, .stl)", "");
            AssertRefused(Commands.Run, "--angles: run has no such option", "x.obj", "--angles", "0:1:1");
            AssertRefused(Commands.Run,
                "--bonces: run has no such option; did you mean --bounces?", "x.obj", "--bonces", "3");
            AssertRefused(Commands.Run,
                "--freq: run has no such option; did you mean --frequency?", "x.obj", "--freq=1e9");
            AssertRefused(Commands.Run, "-out: run has no such option; did you mean --out?", "x.obj", "-out", "here");
            AssertRefused(Commands.Run, "--out: needs a value: --out DIR", "x.obj", "--out");
            AssertRefused(Commands.Run, "--out: needs a value: --out DIR", "x.obj", "--out", "--bounces", "3");
            AssertRefused(Commands.Run, "--out \"\": must not be empty", "x.obj", "--out=");
            AssertRefused(Commands.Run, "--fov: given twice", "x.obj", "--fov", "50", "--fov", "50");
            AssertRefused(Commands.Run, "b.obj: one argument too many: "
                + "INPUT is a.obj already (put names with blanks in quotes)", "a.obj", "b.obj");
            AssertRefused(Commands.Info,
                "x.obj: one argument too many: info takes none (put names with blanks in quotes)", "x.obj");
            AssertRefused(Commands.Sweep,
                "--target: needs --angles ANGLES, --grazing LIST or --distance LIST", "x.unity", "--target", "Ship");
            AssertRefused(Commands.Sweep,
                "--target is missing: sweep needs --target NAME", "x.unity", "--angles", "0:45:1");
            AssertRefused(Commands.Sweep, "--target: only for scenes: the mesh of a file is turned as a whole", "x.obj",
                "--angles", "0:45:1", "--target", "x");
        }

        [Test]
        public void UnityArguments_AfterTheMarker_AreTheCommands()
        {
            var line = CommandLine.FromUnity(Commands.Sweep, new[] { "Unity", "-batchmode", "-executeMethod",
                "Glint.Editor.Batch.Sweep", "--glint", "x.obj", "--angles", "0:1:1" });

            Assert.That(line.Get(Options.Angles), Is.EqualTo(new[] { 0.0, 1 }));
        }

        [Test]
        public void UnityArguments_WithoutTheMarker_AreRefused() =>
            Assert.That(Assert.Throws<UsageException>(
                    () => CommandLine.FromUnity(Commands.Sweep, new[] { "Unity", "-batchmode" })).Message,
                Does.StartWith("--glint is missing"));

        [Test]
        public void UnityArguments_WithADevice_NameUnitysOwnWay() =>
            Assert.That(Assert.Throws<UsageException>(() =>
                CommandLine.FromUnity(Commands.Run, new[] { "Unity", "--glint", "x.obj", "--device", "0" })).Message,
                Is.EqualTo("--device: in Unity use Unity's own -force-device-index"));

        static CommandLine Parse(Command command, params string[] arguments) => CommandLine.Parse(command, arguments);

        static void AssertRefused(Command command, string message, params string[] arguments) =>
            Assert.That(Assert.Throws<UsageException>(() => CommandLine.Parse(command, arguments)).Message,
                Is.EqualTo(message));
    }
}
