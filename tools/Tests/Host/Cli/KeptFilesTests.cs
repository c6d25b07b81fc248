using System.IO;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Files of the user that an output must not replace, and warnings of rows that were kept.</summary>
public sealed class KeptFilesTests
{
    // A plate that faces the radar: few rays in long steps.
    const string Plate = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";

    string _folder;

    [SetUp]
    public void MakePlate()
    {
        _folder = Directory.CreateTempSubdirectory("glint-kept-").FullName;
        File.WriteAllText(At("plate.obj"), Plate);
    }

    [TearDown]
    public void RemovePlate() => Directory.Delete(_folder, true);

    [Test]
    public void Report_InPlaceOfAnotherFile_IsRefusedBeforeThePoseIsTraced()
    {
        Run("run", At("plate.obj"), "--size", "16x9", "--out", At("run"));
        string results = File.ReadAllText(At("run/results.json"));
        var (code, output, error) = TestShell.Run("report", At("run"), "--out", At("run/results.json"));
        Assert.That((code, output), Is.EqualTo((1, "")));
        Assert.That(error.Trim(), Is.EqualTo($"glint: {At("run/results.json")}: is there, and is no report that could be "
            + "replaced: name another file with --out"));
        Assert.That(File.ReadAllText(At("run/results.json")), Is.EqualTo(results));
        Run("report", At("run"));
        Run("report", At("run"));
    }

    [Test]
    public void Run_InTheFolderOfAnUnfinishedSweep_IsRefused()
    {
        Directory.CreateDirectory(At("sweep"));
        File.WriteAllText(At("sweep/results.partial"), "{}\n");
        var (code, _, error) = TestShell.Run("run", At("plate.obj"), "--size", "4x4", "--out", At("sweep"));
        Assert.That((code, error.Trim()), Is.EqualTo((1, $"glint: {At("sweep")}: holds a sweep that is not finished: "
            + "finish it by its command with --resume, or choose another folder with --out")));
        Assert.That(File.ReadAllText(At("sweep/results.partial")), Is.EqualTo("{}\n"));
    }

    [Test]
    public void Outputs_OfOneName_AreRefused()
    {
        var (code, _, error) = TestShell.Run("bench", At("plate.obj"), "--size", "4x4", "--json", At("x"),
            "--write-scene", At("./x"));
        Assert.That((code, error.Trim()), Is.EqualTo((2, $"glint: --write-scene {At("./x")}: is the file of --json too: "
            + "name another file (see glint bench --help)")));
    }

    [TestCase("verify", "--json")]
    [TestCase("bench", "--json")]
    [TestCase("bench", "--write-scene")]
    public void Output_NamedAsTheInput_IsRefused(string command, string option)
    {
        var (code, _, error) = TestShell.Run(command, At("plate.obj"), "--size", "4x4", option, At("./plate.obj"));
        Assert.That(code, Is.EqualTo(2));
        Assert.That(error, Does.StartWith($"glint: {option} {At("./plate.obj")}: is the input, which it would replace"));
        Assert.That(File.ReadAllText(At("plate.obj")), Is.EqualTo(Plate));
    }

    [Test]
    public void Merge_IntoAPartByWayOfALink_IsRefused()
    {
        string[] sweep = ["sweep", At("plate.obj"), "--angles", "0,1", "--size", "16x9", "--out"];
        Run([.. sweep, At("1"), "--shard", "1/2"]);
        Run([.. sweep, At("2"), "--shard", "2/2"]);
        Directory.CreateSymbolicLink(At("link"), At("1"));
        string part = File.ReadAllText(At("1/results.json"));
        var (code, _, error) = TestShell.Run("merge", At("1"), At("2"), "--out", At("link"));
        Assert.That(code, Is.EqualTo(1));
        Assert.That(error, Does.Contain("link: is one of the parts"));
        Assert.That(File.ReadAllText(At("1/results.json")), Is.EqualTo(part));
    }

    [Test]
    public void Merge_OverAnUnfinishedSweep_SaysThatItReplacesIt()
    {
        string[] sweep = ["sweep", At("plate.obj"), "--angles", "0,1", "--size", "16x9", "--out"];
        Run([.. sweep, At("1"), "--shard", "1/2"]);
        Run([.. sweep, At("2"), "--shard", "2/2"]);
        Directory.CreateDirectory(At("whole"));
        File.WriteAllText(At("whole/results.partial"), "");
        Assert.That(Run("merge", At("1"), At("2"), "--out", At("whole")),
            Does.Contain("warning: " + At("whole") + ": holds a sweep that is not finished; the whole replaces it"));
    }

    /// <summary>A run that is resumed says of all its rows what is wrong with them.</summary>
    [Test]
    public void Resume_OfRowsWithWarnings_RepeatsThem()
    {
        string[] sweep = ["sweep", At("plate.obj"), "--angles", "30,31", "--distance", "10", "--size", "32x18", "--out", At("sweep"), "--resume"];
        const string silent = "rays hit and none was received";
        Assert.That(Run(sweep), Does.Contain(silent));
        Assert.That(Run(sweep), Does.Contain(silent));
        string[] sections = ["rcs", At("plate.obj"), "--frequency", "1e9", "--tolerance", "3", "--azimuth", "0:20:20",
            "--bistatic", "170,0", "--out", At("rcs"), "--resume"];
        const string outside = "2 of 2 rows are outside physical optics";
        Assert.That(Run(sections), Does.Contain(outside));
        Assert.That(Run(sections), Does.Contain(outside));
    }

    // Neither is said after hours, nor as a number that means nothing.
    [Test]
    public void Calls_OfWhatCannotBeMeant_SaySo()
    {
        var (code, output, error) = TestShell.Run("sweep", "Scenes/ShipSeaState5.unity", "--target", "Ship", "--angles", "0",
            "--frequency", "9.4e9,94e9", "--clutter", "on", "--size", "16x9", "--out", At("seas"));
        Assert.That(code, Is.EqualTo(1), output);
        Assert.That(error, Does.Contain("the frequency 94000000000 Hz must be from 1e9 to 4.7e10 Hz"));
        Assert.That(File.Exists(At("seas/results.csv")), Is.False);
        Assert.That(Run("sweep", "Scenes/CornerReflector.unity", "--target", "Directional Light", "--angles", "0",
            "--size", "16x9", "--out", At("light")), Does.Contain("--target 'Directional Light' has no mesh, sea or radar"));
        Assert.That(Run("echo", At("plate.obj"), "--bandwidth", "150", "--frequencies", "4", "--tolerance", "10",
            "--out", At("echo")), Does.Contain("a range bin of 9.993e+05 m holds all of its echoes"));
        (code, _, error) = TestShell.Run("ship", "--stl", At("ship.obj"));
        Assert.That((code, File.Exists(At("ship.obj"))), Is.EqualTo((2, false)));
        Assert.That(error, Does.Contain("must end with .stl"));
    }

    // What it prints and what it warns of.
    static string Run(params string[] arguments)
    {
        var (code, output, error) = TestShell.Run(arguments);
        Assert.That(code, Is.Zero, error);
        return output + error;
    }

    string At(string name) => Path.Combine(_folder, name);
}
