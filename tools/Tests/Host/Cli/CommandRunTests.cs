using System.Globalization;
using System.IO;
using System.Linq;
using Glint.Cli;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>
/// The commands from their arguments to the printed table, with a 1 x 1 m plate that faces the radar.
/// </summary>
public sealed class CommandRunTests
{
    string _folder;

    [SetUp]
    public void MakePlate()
    {
        _folder = Path.Combine(Path.GetTempPath(), "glint-command-" + System.Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(_folder);
        File.WriteAllText(Plate, "v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\nf 1 2 3 4\n");
    }

    [TearDown]
    public void RemovePlate() => Directory.Delete(_folder, true);

    // The view is 2 m high and wide at the plate, which covers its middle: 32 x 32 of 64 x 64 rays. A ray returns at
    // twice its offset on the plate (the receiver is 0.2 m further away), so within 1.01 m of the axis.
    [Test]
    public void Run_OfAPlateAcrossTheView_ReceivesEveryRayThatHits()
    {
        var (code, output, _) =
            Run("run", Plate, "--grazing", "0", "--distance", "50", "--fov", "2.29153", "--size", "64x64");

        Assert.That(code, Is.EqualTo(0));
        var row = Rows(output).Single();
        Assert.That(row[^1], Is.EqualTo("1024"), "hit");
        Assert.That(row[^2], Is.EqualTo("1024"), "received");
    }

    [Test]
    public void Run_InMillimetres_IsAThousandthOfTheSize()
    {
        var (code, output, _) = Run("run", Plate, "--unit", "mm", "--grazing", "0", "--distance", "0.05",
            "--fov", "2.29153", "--size", "64x64");

        Assert.That(code, Is.EqualTo(0));
        Assert.That(Rows(output).Single()[^1], Is.EqualTo("1024"));
    }

    // The plate covers columns and rows 16 to 47.
    [TestCase("16,16,32,32", 1024)]
    [TestCase("0,0,20,20", 16)]
    [TestCase("40,0,24,64", 256)]
    [TestCase("0,48,64,16", 0)]
    public void Run_OfARegion_CountsItsRaysOnly(string region, int hit)
    {
        string folder = Path.Combine(_folder, "results");
        var (code, output, _) = Run("run", Plate, "--grazing", "0", "--distance", "50", "--fov", "2.29153",
            "--size", "64x64", "--region", region, "--out", folder);

        Assert.That(code, Is.EqualTo(0));
        Assert.That(Rows(output).Single()[^1], Is.EqualTo($"{hit}"));
        var results = JObject.Parse(File.ReadAllText(Path.Combine(folder, "results.json")));
        int[] numbers = region.Split(',').Select(int.Parse).ToArray();
        Assert.That(results["rows"][0]["rays_emitted"].ToObject<int>(), Is.EqualTo(numbers[2] * numbers[3]));
        var settings = results["settings"];
        Assert.That(new[] { "left", "bottom", "width", "height" }
            .Select(name => settings["region_" + name]["value"].ToObject<int>()), Is.EqualTo(numbers));
    }

    [Test]
    public void Run_OfARegionBeyondThePicture_IsRefused()
    {
        var (code, _, error) = Run("run", Plate, "--size", "64x64", "--region", "32,0,33,64");

        Assert.That(code, Is.EqualTo(1));
        Assert.That(error, Does.Contain("region 32,0,33,64").And.Contain("64 x 64"));
    }

    [Test]
    public void Sweep_OfAPlate_LosesTheReturnAsItTurnsAway()
    {
        string results = Path.Combine(_folder, "results");
        var (code, output, _) = Run("sweep", Plate, "--angles", "-10,0,10", "--grazing", "0", "--fov", "2.29153",
            "--size", "64x64", "--out", results);

        Assert.That(code, Is.EqualTo(0));
        Assert.That(Rows(output).Select(row => row[0]), Is.EqualTo(new[] { "-10", "0", "10" }));
        Assert.That(Rows(output).Select(row => row[^2]), Is.EqualTo(new[] { "0", "1024", "0" }));
        Assert.That(File.ReadLines(Path.Combine(results, "results.csv")).Count(), Is.EqualTo(4));
        Assert.That(File.Exists(Path.Combine(results, "results.json")));
    }

    /// <summary>Each pose of a sweep over several axes equals a run with its values, bit for bit.</summary>
    [Test]
    public void Sweep_OverSeveralAxes_HasThePosesOfSingleRuns()
    {
        string results = Path.Combine(_folder, "results");
        string[] common = [Plate, "--fov", "3", "--size", "64x64"];
        Assert.That(Run(["sweep", .. common, "--distance", "40,5000", "--grazing", "0,0.3", "--frequency", "9e9,10e9",
            "--out", results]).code, Is.Zero);
        var rows = JObject.Parse(File.ReadAllText(Path.Combine(results, "results.json")))["rows"];
        Assert.That(rows.Count(), Is.EqualTo(8));
        foreach (var row in rows)
        {
            string single = Path.Combine(_folder, "single");
            Run(["run", .. common, "--distance", (string)row["range_m"], "--grazing", (string)row["grazing_deg"],
                "--frequency", (string)row["frequency_hz"], "--out", single]);
            var alone = JObject.Parse(File.ReadAllText(Path.Combine(single, "results.json")))["rows"][0];
            foreach (string column in new[]
            {
                "in_phase", "quadrature", "rays_hit", "rays_received", "path_length_m", "sampling_error"
            })
                Assert.That((double)row[column], Is.EqualTo((double)alone[column]), $"{column} of {row}");
        }
        Assert.That(rows.Select(row => (double)row["in_phase"]).Distinct().Count(),
            Is.GreaterThan(4), "the poses differ");
    }

    [TestCase("run", "Scenes/None.unity")]
    [TestCase("run", "none.obj")]
    [TestCase("sweep", "Scenes/CornerReflector.unity", "--target", "Nobody", "--angles", "0:1:1")]
    [TestCase("info", "--device", "no such device")]
    public void Command_OfWhatIsNotThere_FailsInOneLineThatNamesIt(params string[] arguments)
    {
        var (code, _, error) = Run(arguments);

        Assert.That(code, Is.EqualTo(1));
        Assert.That(error.Split('\n', System.StringSplitOptions.RemoveEmptyEntries).Length, Is.EqualTo(1), error);
        Assert.That(error, Does.StartWith("glint: ").And.Not.Contain("internal error"));
        Assert.That(error, Does.Contain(arguments.First(argument => argument.StartsWith("N") || argument.Contains("one")
            || argument.Contains("no such"))));
    }

    /// <summary>As glint rcs does. A frequency given in gigahertz is the usual reason.</summary>
    [TestCase("run", "--frequency", "10")]
    [TestCase("sweep", "--frequency", "10e9,10", "--angles", "0")]
    [TestCase("rcs", "--frequency", "10", "--tolerance", "1")]
    [TestCase("echo", "--frequency", "10", "--bandwidth", "1", "--frequencies", "2", "--tolerance", "1")]
    public void TargetFarBelowAWavelength_IsWarnedOf(string command, params string[] options)
    {
        string[] size = command == "run" || command == "sweep" ? ["--size", "16x9"] : [];
        var (code, _, error) = Run([command, Plate, .. options, .. size, "--out", Path.Combine(_folder, "results")]);
        Assert.That(code, Is.Zero, error);
        Assert.That(error, Does.Match("warning: plate: the target is .* wavelengths large at .* Hz: .*: use a higher frequency "
            + @"\(in hertz: 10 GHz is 10e9\), or a full-wave program"));
    }

    [Test]
    public void TargetOfManyWavelengths_IsNotWarnedOf()
    {
        var (code, _, error) = Run("run", Plate, "--size", "16x9");
        Assert.That(code, Is.Zero, error);
        Assert.That(error, Does.Not.Contain("wavelengths large"));
    }

    [Test]
    public void Run_OfAMistypedScene_SaysWhereItWasLookedFor()
    {
        var (code, _, error) = Run("run", "Scene/CornerReflector.unity");

        Assert.That(code, Is.EqualTo(1));
        Assert.That(error, Does.StartWith("glint: Scene/CornerReflector.unity: there is no such scene")
            .And.Contain("/Scene/CornerReflector.unity"));
    }

    [Test]
    public void Run_OfASceneElsewhere_SaysThatItIsOutside()
    {
        string scene = Path.Combine(_folder, "Lost.unity");
        File.WriteAllText(scene, "");
        Assert.That(Run("run", scene).error, Does.StartWith($"glint: {scene}: outside of the Unity project"));
    }

    [Test]
    public void Info_OfADeviceThatIsNotThere_PrintsNothing() =>
        Assert.That(Run("info", "--device", "99").output, Is.Empty);

    [TestCase("info")]
    [TestCase("--help")]
    [TestCase("run --help")]
    [TestCase("run PLATE --size 2x2")]
    public void Command_WhoseOutputIsFull_FailsInOneLine(string line)
    {
        var error = new StringWriter();
        var terminal =
            new Terminal { Out = Terminal.Results(new FullWriter()), Error = error, Live = null, Width = 100 };
        int code = new Shell(terminal).Run(line.Replace("PLATE", Plate).Split(' '));

        Assert.That(code, Is.EqualTo(1));
        // A slow machine shows progress before.
        Assert.That(error.ToString().Split(System.Environment.NewLine).SkipWhile(text => !text.StartsWith("glint: ")),
            Is.EqualTo(new[] { "glint: standard output cannot be written: no space", "" }));
    }

    [Test]
    public void Sweep_WhoseMessagesAreLost_IsDone()
    {
        var output = new StringWriter();
        var terminal =
            new Terminal { Out = output, Error = Terminal.Messages(new FullWriter()), Live = null, Width = 100 };
        string[] sweep =
            ["sweep", Plate, "--angles", "0,1", "--size", "2x2", "--out", Path.Combine(_folder, "results")];

        Assert.That(new Shell(terminal).Run(sweep), Is.EqualTo(0));
        Assert.That(output.ToString(), Does.Contain("written: "));
        Assert.That(new Shell(terminal).Run(["dance"]), Is.EqualTo(2), "a failure that cannot be told");
    }

    sealed class FullWriter : StringWriter
    {
        public override void Write(char value) => throw new IOException("no space");

        public override void Write(string value) => throw new IOException("no space");

        public override void WriteLine(string value) => throw new IOException("no space");

        public override void Flush() => throw new IOException("no space");
    }

    string Plate => Path.Combine(_folder, "plate.obj");

    // Rows of the table begin with a number; a single pose begins with '-'.
    static string[][] Rows(string output) => output.Split('\n')
        .Select(line => line.Split(' ', System.StringSplitOptions.RemoveEmptyEntries))
        .Where(words => words.Length == 5 && (words[0] == "-"
            || double.TryParse(words[0], NumberStyles.Float, CultureInfo.InvariantCulture, out _))).ToArray();

    static (int code, string output, string error) Run(params string[] arguments)
    {
        var (output, error) = (new StringWriter(), new StringWriter());
        int code = new Shell(new Terminal { Out = output, Error = error, Live = null, Width = 100 }).Run(arguments);
        return (code, output.ToString(), error.ToString());
    }
}
