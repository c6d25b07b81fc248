using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Glint.Core;
using Glint.Editor;
using Glint.Tests;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>glint rcs: values of known targets, files, resumption, parts, refusals.</summary>
[Category("Slow")]
public sealed class CrossSectionCommandTests
{
    // Metres and hertz.
    const double Width = 0.3, Height = 0.2, Frequency = 10e9, Wavelength = 299792458 / Frequency;

    string _folder;

    [SetUp]
    public void MakePlate()
    {
        _folder = Directory.CreateTempSubdirectory("glint-rcs-").FullName;
        WritePlate("plate.obj", 0);
    }

    [TearDown]
    public void RemovePlate() => Directory.Delete(_folder, true);

    /// <summary>4 pi A^2 / lambda^2: 17.019 dBsm; edges would add their fringe fields.</summary>
    [Test]
    public void Plate_AtNormalIncidence_HasItsClosedForm()
    {
        Run(At("plate.obj"), "--edges", "off", "--tolerance", "0.01", "--out", At("rcs"));
        double expected = 10 * Math.Log10(4 * Math.PI * Math.Pow(Width * Height / Wavelength, 2));
        Assert.That(expected, Is.EqualTo(17.019).Within(0.001));
        var row = Rows("rcs").Single();
        // 95 % of amplitudes are within the tolerance; opposite borders of a symmetric plate err alike.
        foreach (string column in new[] { "vv_dbsm", "hh_dbsm" })
            Assert.That(Number(row, column), Is.EqualTo(expected).Within(0.02), column);
        Assert.That(Amplitude(row, "vv").Magnitude, Is.EqualTo(Math.Pow(10, expected / 20)).Within(0.01));
        Assert.That(Amplitude(row, "hv").Magnitude, Is.LessThan(1e-3), "no cross-polarisation by symmetry");
        Assert.That(row["tolerance_met"], Is.EqualTo("1"));
        Assert.That(row["receiver_azimuth_deg"], Is.Empty, "the radar receives");
    }

    /// <summary>A ship of 130 m, from the command that makes it: at 100 MHz it is 43 wavelengths long.</summary>
    [Test]
    public void Ship_FromItsCommand_HasACrossSection()
    {
        string[] ship = ["ship", "--length", "130", "--triangles", "15000", "--stl", At("ship.stl")];
        var (code, _, error) = TestShell.Run(ship);
        Assert.That(code, Is.Zero, error);
        Run(At("ship.stl"), "--azimuth", "40", "--elevation", "5", "--frequency", "1e8", "--tolerance", "3", "--out",
            At("rcs"));
        var row = Rows("rcs").Single();
        Assert.That(row["tolerance_met"], Is.EqualTo("1"));
        // Less than a plate as long and high as the ship, more than a ball of 1 m.
        Assert.That(Number(row, "vv_dbsm"), Is.InRange(5, 10 * Math.Log10(4 * Math.PI * Math.Pow(130 * 25 / 3.0, 2))));
    }

    /// <summary>A target nearer to the radar by x has S exp(+2jkx): phases are about the file's origin.</summary>
    [Test]
    public void Plate_NearerToTheRadar_HasAnotherPhase()
    {
        const double nearer = 0.004;
        WritePlate("nearer.obj", -nearer);
        foreach (string name in new[] { "plate", "nearer" })
            Run(At(name + ".obj"), "--tolerance", "0.01", "--out", At(name));
        var turn = Amplitude(Rows("nearer").Single(), "hh") / Amplitude(Rows("plate").Single(), "hh");
        var expected = Complex.FromPolarCoordinates(1, 2 * (2 * Math.PI / Wavelength) * nearer);
        Assert.That((turn - expected).Magnitude, Is.LessThan(0.005));
    }

    [Test]
    public void Rows_OfEveryReceiverFrequencyAndAzimuth_AreInTheArraysToo()
    {
        // 18 receivers take two traces of a pose.
        Run(At("plate.obj"), "--azimuth", "0,20", "--frequency", "10e9,9e9", "--receivers", "-85:85:10",
            "--polarisation", "vv,hh", "--tolerance", "0.5", "--out", At("rcs"));
        var rows = Rows("rcs");
        Assert.That(rows, Has.Count.EqualTo(2 * 2 * 18));
        Assert.That(rows.Select(row => row["receiver_azimuth_deg"]).Take(19),
            Is.EqualTo(Enumerable.Range(0, 19).Select(i => $"{-85 + 10 * (i % 18)}")));
        Assert.That(rows.Select(row => row["frequency_hz"]).Skip(17).Take(2),
            Is.EqualTo(new[] { "9000000000", "10000000000" }));
        Assert.That(rows.Select(row => row["hv_dbsm"] + row["vh_re_m"]), Is.All.Empty, "not asked for");

        string arrays = At("rcs/rcs.npz");
        Assert.That(NumpyReader.Read(arrays, "azimuth").Numbers, Is.EqualTo(new[] { 0, 20 }));
        Assert.That(NumpyReader.Read(arrays, "elevation").Numbers, Is.EqualTo(new[] { 0, 0 }));
        Assert.That(NumpyReader.Read(arrays, "frequency").Numbers, Is.EqualTo(new[] { 9e9, 10e9 }));
        Assert.That(NumpyReader.Read(arrays, "receiver").Sizes, Is.EqualTo(new[] { 18, 2 }));
        Assert.That(NumpyReader.Read(arrays, "error").Numbers,
            Is.EqualTo(rows.Select(row => Number(row, "integration_error_m"))));
        var s = NumpyReader.Read(arrays, "S");
        Assert.That(s.Sizes, Is.EqualTo(new[] { 2, 2, 18, 2, 2 }));
        Assert.That(s.Type, Is.EqualTo("<c16"));
        for (int i = 0; i < rows.Count; i++)
        {
            Assert.That(s.Numbers.Skip(8 * i).Take(2), Is.EqualTo(Parts(rows[i], "vv")), "received in V, sent in V");
            Assert.That(s.Numbers.Skip(8 * i + 2).Take(4), Is.All.NaN);
            Assert.That(s.Numbers.Skip(8 * i + 6).Take(2), Is.EqualTo(Parts(rows[i], "hh")));
        }
    }

    /// <summary>The mirror direction of a plate seen from 30 degrees is at -30 degrees.</summary>
    [Test]
    public void Bistatic_TowardsTheMirrorDirection_IsTheProjectedPlate()
    {
        Run(At("plate.obj"), "--azimuth", "30", "--bistatic", "-30,0", "--edges", "off", "--tolerance", "0.02",
            "--out", At("rcs"));
        double area = Width * Height * Math.Cos(Math.PI / 6);
        Assert.That(Number(Rows("rcs").Single(), "vv_dbsm"),
            Is.EqualTo(10 * Math.Log10(4 * Math.PI * Math.Pow(area / Wavelength, 2))).Within(0.05));
    }

    /// <summary>
    /// Receivers share a trace, at a finite range too; a frequency far from the others, or with a material, has its own.
    /// </summary>
    [TestCase("20,25", "10e9,9.5e9", "--range", "5")]
    [TestCase("20,25", "10e9,5e9")]
    [TestCase("20", "10e9,9.5e9", "--material", "*=metal,4,0.4,1,0,0.002")]
    public void Rows_OfSeveralTraces_AreThoseOfSingleRuns(string receivers, string frequencies, params string[] options)
    {
        string[] rcs = [At("plate.obj"), "--azimuth", "10", "--tolerance", "0.02", .. options];
        Run([.. rcs, "--receivers", receivers, "--frequency", frequencies, "--out", At("all")]);
        foreach (string receiver in receivers.Split(','))
            foreach (string frequency in frequencies.Split(','))
            {
                Run([.. rcs, "--receivers", receiver, "--frequency", frequency, "--out", At("one")]);
                var one = Rows("one").Single();
                var same = Rows("all").Single(row => row["receiver_azimuth_deg"] == one["receiver_azimuth_deg"]
                    && row["frequency_hz"] == one["frequency_hz"]);
                Assert.That(Number(same, "vv_dbsm"), Is.EqualTo(Number(one, "vv_dbsm")).Within(0.04));
                Assert.That(Number(same, "hh_dbsm"), Is.EqualTo(Number(one, "hh_dbsm")).Within(0.04));
            }
    }

    [Test]
    public void Receiver_MoreThan120DegreesAway_IsFlagged()
    {
        var (_, _, error) = Execute(At("plate.obj"), "--receivers", "100,130,180", "--tolerance", "1",
            "--out", At("rcs"));
        Assert.That(Rows("rcs").Select(row => row["outside_physical_optics"]), Is.EqualTo(new[] { "0", "1", "0" }));
        Assert.That(error, Does.Contain("1 of 3 rows are outside physical optics"));
    }

    // 5.73525 degrees: a null, sin = wavelength / width.
    [Test]
    public void Tolerance_ThatCannotBeMet_IsSaidWithTheErrorReached()
    {
        var (code, output, error) = Execute(At("plate.obj"), "--azimuth", "0,5.73525", "--edges", "off",
            "--tolerance", "0.001", "--floor", "-200", "--out", At("rcs"));
        Assert.That(code, Is.Zero, error);
        var row = Rows("rcs")[1];
        Assert.That(row["tolerance_met"], Is.EqualTo("0"));
        Assert.That(error, Does.Match(@"the tolerance of 0\.001 dB was not met in [12] of 2 rows "
            + @"\(column tolerance_met\): the largest standard error reached is [0-9.]+ dB, at azimuth 5\.73525 deg"));
        Assert.That(output, Does.Match(@"(?m)^ +5\.735 .* !\r?$"));
    }

    [Test]
    public void Scene_HasItsBoxsCentreAsPhaseCentre_AndItsDescription()
    {
        Run("Scenes/CornerReflector.unity", "--frequency", "1e9", "--tolerance", "1", "--out", At("rcs"));
        var json = JObject.Parse(File.ReadAllText(At("rcs/results.json")));
        Assert.That((int)json["schema"], Is.EqualTo(ResultsJson.Schema));
        Assert.That((string)json["table"], Is.EqualTo("rcs"));
        var settings = json["settings"];
        // The reflector's own dimensions; its scene has the corner at the origin, and it opens away from +z.
        Assert.That((double)settings["phase_centre_x"]["value"], Is.Zero.Within(1e-3), "symmetric");
        Assert.That((double)settings["phase_centre_z"]["value"], Is.Not.Zero.Within(0.1));
        double radius = (double)settings["scene_radius"]["value"];
        Assert.That((double)settings["floor"]["value"],
            Is.EqualTo(10 * Math.Log10(Math.PI * radius * radius) - 40).Within(1e-9));
        Assert.That((string)settings["conventions"], Does.Contain("exp(+j w t)"));
        Assert.That((string)settings["error"], Does.Contain("not of physical optics"));
        Assert.That((string)json["sweep"]["content"], Has.Length.EqualTo(32));
        Assert.That((string)json["columns"]["vv_dbsm"]["unit"], Is.EqualTo("dBsm"));
    }

    [Test]
    public void Parts_MergeToTheFilesOfAnUndividedRun()
    {
        string[] rcs = [At("plate.obj"), "--azimuth", "0:3:1", "--frequency", "9e9,10e9", "--tolerance", "0.5"];
        Run([.. rcs, "--out", At("whole")]);
        // Eight rows in three parts: they are divided within an azimuth.
        for (int number = 1; number <= 3; number++)
            Run([.. rcs, "--shard", $"{number}/3", "--out", At($"{number}")]);
        Assert.That(File.Exists(At("1/rcs.npz")), Is.False, "the merged whole has the arrays");
        var (code, output, error) = TestShell.Run("merge", At("2"), At("3"), At("1"), "--out", At("merged"));
        Assert.That(code, Is.Zero, error);
        Assert.That(output, Does.Contain("rcs.npz"));
        AssertSame("merged");
    }

    [Test]
    public void Run_Cancelled_ResumesToTheFilesOfAnUndisturbedOne()
    {
        string[] rcs = [At("plate.obj"), "--azimuth", "0:5:1", "--frequency", "9e9,10e9", "--tolerance", "0.5"];
        Run([.. rcs, "--out", At("whole")]);
        var line = CommandLine.Parse(Commands.Rcs, [.. rcs, "--out", At("stopped")]);
        Project.Open(Project.FindRoot(AppContext.BaseDirectory));
        Assert.That(Batch.Execute(line, new CancelAfter(5)), Is.EqualTo(130));
        Assert.That(File.Exists(At("stopped/results.partial")));

        string output = Run([.. rcs, "--out", At("stopped"), "--resume"]);
        Assert.That(output, Does.Contain("resumed: 5 of 12 rows are done"));
        AssertSame("stopped");
        Assert.That(Run([.. rcs, "--out", At("stopped"), "--resume"]), Does.Contain("already complete"));
        var progress = new CancelAfter(0);
        Batch.Execute(CommandLine.Parse(Commands.Rcs, [.. rcs, "--out", At("stopped"), "--resume"]), progress);
        Assert.That(progress.Before, Is.EqualTo(12), "rows done before take no time");
        var (code, _, error) = Execute([.. rcs, "--out", At("stopped"), "--resume", "--edges", "off"]);
        Assert.That(code, Is.EqualTo(1));
        Assert.That(error, Does.Contain("is of another sweep: edges was on and is off"));
    }

    [Test]
    public void Resume_OfARowOfAnotherDirection_IsRefusedByItsNumber()
    {
        string[] rcs = [At("plate.obj"), "--azimuth", "0:3:1", "--tolerance", "0.5", "--out", At("changed")];
        Project.Open(Project.FindRoot(AppContext.BaseDirectory));
        Assert.That(Batch.Execute(CommandLine.Parse(Commands.Rcs, rcs), new CancelAfter(3)), Is.EqualTo(130));
        string partial = At("changed/results.partial");
        string text = File.ReadAllText(partial).Replace("\"azimuth_deg\":1,", "\"azimuth_deg\":1.5,");
        File.WriteAllText(partial, text);
        File.Delete(At("changed/rcs.csv"));
        var (code, _, error) = Execute([.. rcs, "--resume"]);
        Assert.That((code, error.Trim()), Is.EqualTo((1, $"glint: {partial}: row 2 is of azimuth 1.5 deg, elevation 0 deg, "
            + "10000000000 Hz instead of azimuth 1 deg, elevation 0 deg, 10000000000 Hz: it was changed; restore it, or "
            + "leave --resume out")));
        Assert.That(File.ReadAllText(partial), Is.EqualTo(text));
    }

    /// <summary>Rows outside physical optics are in both parts: the whole has the warning of all.</summary>
    [Test]
    public void Merge_WarnsAsAnUndividedRunDoes()
    {
        string[] rcs = [At("plate.obj"), "--azimuth", "0", "--receivers", "0,100,120,140", "--tolerance", "0.5"];
        static string[] Warnings(string error) =>
            [.. error.Split('\n').Where(line => line.Contains("outside physical optics"))];
        string[] whole = Warnings(Execute([.. rcs, "--out", At("whole")]).error);
        Assert.That(whole, Has.Length.EqualTo(1));
        for (int number = 1; number <= 2; number++)
            Run([.. rcs, "--shard", $"{number}/2", "--out", At($"{number}")]);
        var (code, _, error) = TestShell.Run("merge", At("1"), At("2"), "--out", At("merged"));
        Assert.That(code, Is.Zero, error);
        Assert.That(Warnings(error), Is.EqualTo(whole));
    }

    [Test]
    [Platform("Linux")]
    [Category("Slow")]
    public void Run_Killed_ResumesToTheFilesOfAnUndisturbedOne()
    {
        string[] rcs = [At("plate.obj"), "--azimuth", "0:40:1", "--tolerance", "0.5"];
        Run([.. rcs, "--out", At("whole")]);
        int seed = Environment.TickCount;
        GlintProcess.KillAt(At("killed/results.partial"), 5000 + new Random(seed).Next(12000),
            ["rcs", .. rcs, "--out", At("killed")]);
        Assert.That(File.Exists(At("killed/results.partial")), "killed before its end");
        Assert.That(Run([.. rcs, "--out", At("killed"), "--resume"]),
            Does.Match("resumed: [0-9]+ of 41 rows are done"));
        AssertSame("killed", $"seed {seed}");
    }

    /// <summary>The reference tracer has its own tubes: it differs, by less than the tolerance.</summary>
    [Test]
    public void Reference_OfTheFirstRows_IsWithinTheTolerance()
    {
        string output = Run(At("plate.obj"), "--azimuth", "0,7,20", "--polarisation", "vv,hh", "--tolerance", "0.05",
            "--reference", "2", "--out", At("rcs"));
        var lines = Regex.Matches(output,
            @"(?m)^(VV|HH) +(\S+) (\S+)j +(\S+) (\S+)j +(\S+) +(\S+)  azimuth (\d+) deg, elevation 0 deg, 10000000000 Hz\r?$");
        Assert.That(lines.Select(line => line.Groups[1].Value + line.Groups[8].Value),
            Is.EqualTo(new[] { "VV0", "HH0", "VV7", "HH7" }), output);
        foreach (Match line in lines)
        {
            var row = Rows("rcs").Single(row => row["azimuth_deg"] == line.Groups[8].Value);
            Complex Printed(int group) => new(double.Parse(line.Groups[group].Value, CultureInfo.InvariantCulture),
                double.Parse(line.Groups[group + 1].Value, CultureInfo.InvariantCulture));
            var (s, reference) = (Printed(2), Printed(4));
            Assert.That((s - Amplitude(row, line.Groups[1].Value.ToLowerInvariant())).Magnitude, Is.LessThan(1e-4));
            double scale = Math.Min(Amplitude(row, "vv").Magnitude, Amplitude(row, "hh").Magnitude);
            double relative = double.Parse(line.Groups[7].Value, CultureInfo.InvariantCulture);
            Assert.That(relative, Is.EqualTo((s - reference).Magnitude / scale).Within(0.06 * relative + 2e-5));
            Assert.That(relative, Is.GreaterThan(0).And.LessThan(Math.Pow(10, 0.05 / 20) - 1));
            Assert.That(double.Parse(line.Groups[6].Value, CultureInfo.InvariantCulture),
                Is.EqualTo(20 * Math.Log10(s.Magnitude / reference.Magnitude)).Within(2e-4));
        }
    }

    // In a null, 5.73525 degrees, 0.001 dB of nearly nothing cannot be met.
    [Test]
    public void Reference_BeyondTheTolerance_EndsWithOneAndKeepsTheFiles()
    {
        var (code, _, error) = Execute(At("plate.obj"), "--azimuth", "5.73525", "--edges", "off", "--tolerance",
            "0.001", "--floor", "-200", "--reference", "--out", At("rcs"));
        Assert.That(code, Is.EqualTo(1));
        Assert.That(error, Does.Match(@"glint: plate: \|dS\| beside the reference tracer is \S+ of its amplitude or the floor at "
            + @"azimuth 5\.73525 deg.*; a tolerance of 0\.001 dB allows 0\.000115: the files are written"));
        Assert.That(Rows("rcs"), Has.Count.EqualTo(1));
    }

    [TestCase(2, "--reference 0: must be from 1 to 1e6", "--reference", "0")]
    [TestCase(2, "--reference: not with --resume", "--reference", "--resume")]
    [TestCase(2, "--frequency 0: each frequency must be from 1 to 1e12 hertz", "--frequency", "0")]
    [TestCase(2, "--frequency -1e9: each frequency must be", "--frequency", "-1e9")]
    [TestCase(2, "--frequency 1e9,1e9: the frequency 1000000000 hertz is given twice", "--frequency", "1e9,1e9")]
    [TestCase(2, "--azimuth 10,10: the azimuth 10 degrees is given twice", "--azimuth", "10,10")]
    [TestCase(2, "--elevation 0,5,0: the elevation 0 degrees is given twice", "--elevation", "0,5,0")]
    [TestCase(2, "--azimuth 0:45: a range has three parts", "--azimuth", "0:45")]
    [TestCase(2, "--azimuth 0,x: x is not a number", "--azimuth", "0,x")]
    [TestCase(2, "--elevation 91: each elevation must be from -90 to 90 degrees", "--elevation", "91")]
    [TestCase(2, "--polarisation vv,rl: rl is none", "--polarisation", "vv,rl")]
    [TestCase(2, "--tolerance 0: must be from 0.001 to 10", "--tolerance", "0")]
    [TestCase(2, "--edges maybe: must be on or off", "--edges", "maybe")]
    [TestCase(2, "--bistatic 10: must be AZ,EL", "--bistatic", "10")]
    [TestCase(2, "--receivers: not with --bistatic", "--receivers", "10", "--bistatic", "10,0")]
    [TestCase(2, "there are 2 elevations, and the receivers have that of the radar: give one", "--receivers", "10", "--elevation", "0,1")]
    [TestCase(2, "the surface * is given two materials", "--material", "*=metal", "--material", "*=itu_wood")]
    [TestCase(2, "--shard 2/2: there are 1 rows", "--shard", "2/2")]
    [TestCase(1, "there is no surface hull to give a material to", "--material", "hull=metal")]
    [TestCase(1, "the surface with material 'itu_wood' is open", "--material", "*=itu_wood")]
    [TestCase(1, "material 'metal,ptfe,0.001' has no data at 1000000 Hz", "--material", "*=metal,ptfe,0.001",
        "--frequency", "1e6")]
    [TestCase(1, "a range of 0.1 m is inside of it", "--range", "0.1")]
    [TestCase(1, "1e+12 Hz is too high for its size of 360.555 m and a tolerance of 0.1 dB: phases in float32 are off by 0.45 rad; "
        + "up to 2.571e+10 Hz is possible, with a larger tolerance up to 2.664e+11 Hz; or compute its parts alone",
        "--unit", "km", "--frequency", "1e12")]
    public void Input_ThatCannotBeComputed_IsRefusedBeforeAnyFile(int code, string message, params string[] options)
    {
        var (actual, _, error) = Execute([At("plate.obj"), .. options, "--out", At("rcs")]);
        Assert.That(error, Does.Contain(message));
        Assert.That(actual, Is.EqualTo(code));
        Assert.That(Directory.Exists(At("rcs")), Is.False);
    }

    // All corners of the first are in a line; those of the second are one place.
    [TestCase("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")]
    [TestCase("v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n")]
    public void Mesh_WithoutArea_IsRefused(string mesh)
    {
        File.WriteAllText(At("line.obj"), mesh);
        var (code, _, error) = Execute(At("line.obj"), "--out", At("rcs"));
        Assert.That(error, Does.Contain("no triangle has an area: it reflects nothing"));
        Assert.That(code, Is.EqualTo(1));
        Assert.That(Directory.Exists(At("rcs")), Is.False);
    }

    [Test]
    public void Mesh_WithTrianglesWithoutArea_IsThatOfTheOthers()
    {
        File.AppendAllText(At("plate.obj"), "v 0 0 0\nf 1 5 3\nf 1 2 2\n");
        Run(At("plate.obj"), "--edges", "off", "--tolerance", "0.05", "--out", At("rcs"));
        Assert.That(Number(Rows("rcs").Single(), "vv_dbsm"), Is.EqualTo(17.019).Within(0.05));
    }

    [Test]
    public void Folder_OfASweep_IsNotTaken_AndThatOfCrossSectionsIsReported()
    {
        Run(At("plate.obj"), "--tolerance", "1", "--out", At("rcs"));
        var (code, _, error) = TestShell.Run("run", At("plate.obj"), "--size", "16x9", "--out", At("rcs"));
        Assert.That((code, error), Is.EqualTo((1, $"glint: {At("rcs")}: holds rcs.csv, the results of glint rcs: "
            + "choose another results folder" + Environment.NewLine)));
        (code, _, error) = TestShell.Run("report", At("rcs"), "--pose", "none");
        Assert.That(code, Is.Zero, error);
        Assert.That(File.ReadAllText(At("rcs/report.html")), Does.Contain("\"table\":\"rcs\""));
    }

    [Test]
    public void CoarseMesh_IsWarnedOfWithItsShareAndFrequency()
    {
        // A cylinder of 24 facets, 15 degrees each: their width is 0.26 m and their sagitta 0.26 x 15 deg / 8 = 8.6 mm.
        const int facets = 24;
        var lines = Enumerable.Range(0, facets).SelectMany(i => new[] { 0.0, 1 }.Select(y =>
            FormattableString.Invariant($"v {Math.Cos(2 * Math.PI * i / facets)} {y} {Math.Sin(2 * Math.PI * i / facets)}"))).Concat(
            Enumerable.Range(0, facets).Select(i =>
                $"f {2 * i + 1} {2 * i + 2} {2 * (i + 1) % (2 * facets) + 2} {2 * (i + 1) % (2 * facets) + 1}"));
        File.WriteAllLines(At("cylinder.obj"), lines);
        var (code, output, error) = Execute(At("cylinder.obj"), "--frequency", "0.5e9,3e9", "--tolerance", "1",
            "--out", At("rcs"));
        Assert.That(code, Is.Zero, error);
        Assert.That(error, Does.Contain("facets are too coarse for curved surfaces on 100 % of the area at 3e+09 Hz")
            .And.Contain("column coarse_area_share"));
        var settings = JObject.Parse(File.ReadAllText(At("rcs/results.json")))["settings"];
        double good = (double)settings["mesh_good_up_to"]["value"];
        // Facets are cut into triangles, each of which has one of the two edges along the cylinder.
        double width = 2 * Math.Sin(Math.PI / facets), sagitta = width * (2 * Math.PI / facets) / 8;
        Assert.That(good, Is.EqualTo(299792458 / (50 * sagitta)).Within(0.01 * good));
        Assert.That(Rows("rcs").Select(row => Number(row, "coarse_area_share")),
            Is.EqualTo(new[] { 0.0, 1 }).Within(1e-6));
        Assert.That(output, Does.Contain("open edges"), "both ends");
    }

    [Test]
    public void EdgesOfCoatedFaces_AreNamedWithTheirLength()
    {
        string[] rcs = [At("plate.obj"), "--tolerance", "1", "--out", At("rcs")];
        string[] coated = [.. rcs, "--material", "*=metal,4,0.4,1,0,0.002"];
        string Output(string[] arguments)
        {
            var (code, output, error) = Execute(arguments);
            Assert.That(code, Is.Zero, error);
            return output;
        }
        Assert.That(Output(coated), Does.Contain("note: 4 edges, 1 m in all, have no fringe fields"));
        foreach (string[] without in new[] { rcs, [.. coated, "--edges", "off"] })
            Assert.That(Output(without), Does.Not.Contain("fringe fields"));
    }

    [Test]
    public void SmallTarget_IsWarnedOf()
    {
        var (code, _, error) = Execute(At("plate.obj"), "--frequency", "1e9", "--tolerance", "1", "--out", At("rcs"));
        Assert.That(code, Is.Zero, error);
        Assert.That(error, Does.Contain("the target is 1.2 wavelengths large at 1e+09 Hz").And.Contain("higher frequency"));
    }

    [Test]
    public void Help_NamesUnitsAndTheErrorsMeaning()
    {
        var (code, output, _) = TestShell.Run("rcs", "--help");
        Assert.That(code, Is.Zero);
        string help = Regex.Replace(output, @"\s+", " ");
        foreach (string words in new[]
        {
            "Units: angles in degrees, frequencies in hertz, lengths in metres, cross sections in dBsm",
            "the error of the integration, not of physical optics", "Frequencies in hertz",
            "Azimuths of the radar in degrees", "Distance in metres", "--unit"
        })
            Assert.That(help, Does.Contain(words));
    }

    /// <summary>The page's example, in Python's own words, on the files of the plate.</summary>
    [Test]
    public void PythonExample_OfThePage_ReadsTheFile()
    {
        Run(At("plate.obj"), "--azimuth", "-2,0,2", "--edges", "off", "--tolerance", "0.02", "--out", At("rcs"));
        string output = PythonExample.Run("batch.md", "python3", _folder);
        Assert.That(output, Does.Match(@"^strongest: 17\.0[12] dBsm at azimuth 0\.0 deg, error 0\.0\d+ dB\r?\n"
            + @"mean: \d+\.\d\d dBsm over 3 angles\r?\n$"));
        double mean = Rows("rcs").Average(row => Math.Pow(10, Number(row, "vv_dbsm") / 10));
        Assert.That(output, Does.Contain(FormattableString.Invariant($"mean: {10 * Math.Log10(mean):0.00} dBsm")));
        double top = Rows("rcs").Max(row => Number(row, "vv_dbsm"));
        string points = XDocument.Load(At("rcs.svg")).Root.Elements().Single().Attribute("points").Value;
        Assert.That(points.Split(' ', ',').Select(text => double.Parse(text, CultureInfo.InvariantCulture)),
            Is.EqualTo(Rows("rcs").SelectMany(row => new[] { Number(row, "azimuth_deg"), top - Number(row, "vv_dbsm") }))
                .Within(0.01), "plot");
    }

    void AssertSame(string folder, string message = null)
    {
        Assert.That(Directory.GetFiles(At(folder)).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "rcs.csv", "rcs.npz", "results.json" }), message);
        Assert.That(File.ReadAllText(At($"{folder}/rcs.csv")), Is.EqualTo(File.ReadAllText(At("whole/rcs.csv"))),
            message);
        Assert.That(File.ReadAllBytes(At($"{folder}/rcs.npz")), Is.EqualTo(File.ReadAllBytes(At("whole/rcs.npz"))),
            message);
        Assert.That(Timeless.Json(At(folder)), Is.EqualTo(Timeless.Json(At("whole"))), message);
    }

    // Upright, facing -Z, where the radar is at azimuth 0.
    void WritePlate(string name, double z)
    {
        string at = z.ToString(CultureInfo.InvariantCulture);
        File.WriteAllText(At(name), $"v -0.15 -0.1 {at}\nv 0.15 -0.1 {at}\nv 0.15 0.1 {at}\nv -0.15 0.1 {at}\n"
            + "f 1 2 3 4\n");
    }

    List<Dictionary<string, string>> Rows(string folder)
    {
        var lines = File.ReadAllLines(At($"{folder}/rcs.csv")).Select(line => line.Split(',')).ToArray();
        return [.. lines.Skip(1).Select(cells =>
            lines[0].Zip(cells).ToDictionary(cell => cell.First, cell => cell.Second))];
    }

    static double Number(Dictionary<string, string> row, string column) =>
        double.Parse(row[column], CultureInfo.InvariantCulture);

    static double[] Parts(Dictionary<string, string> row, string polarisation) =>
        [Number(row, polarisation + "_re_m"), Number(row, polarisation + "_im_m")];

    static Complex Amplitude(Dictionary<string, string> row, string polarisation) =>
        new(Parts(row, polarisation)[0], Parts(row, polarisation)[1]);

    string At(string name) => Path.Combine(_folder, name);

    static string Run(params string[] arguments)
    {
        var (code, output, error) = Execute(arguments);
        Assert.That(code, Is.Zero, error);
        return output;
    }

    static (int code, string output, string error) Execute(params string[] arguments) =>
        TestShell.Run(["rcs", .. arguments]);
}
