using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Numerics;
using System.Text;
using Glint.Core;
using Glint.Editor;
using Glint.Tests;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>glint echo: profiles, received power, files, resumption, parts, report, refusals.</summary>
[Category("Slow")]
public sealed class EchoCommandTests : EchoFixture
{
    /// <summary>4 pi A^2 / lambda^2 at 2.5 m in every file; the arrays are the sums of the page's formula.</summary>
    [Test]
    public void Plate_AtNormalIncidence_IsAPointOfItsCrossSection()
    {
        string output = Run(At("plate.obj"), "--bandwidth", "600e6", "--edges", "off", "--window", "none",
            "--polarisation", "vv", "--tolerance", "0.01", "--out", At("echo"));
        double expected = 20 * Math.Log10(Math.Sqrt(4 * Math.PI) * Width * Height / Wavelength), bin = C / (2 * 600e6);
        var table = Table("echo/profile.csv");
        var highest = table.MaxBy(line => Number(line, "vv_dbsm"));
        Assert.That(Number(highest, "vv_dbsm"), Is.EqualTo(expected).Within(0.07));
        Assert.That(Number(highest, "range_m"), Is.EqualTo(Range).Within(bin / 15));
        Assert.That(output, Does.Match(@"(?m)^ +0 +0 +16\.9\d+ +2\.\d+ +0\.0\d+\r?$"));
        Assert.That(table.Select(line => line["hh_dbsm"]), Is.All.Empty, "not asked for");

        var f = NumpyReader.Read(At("echo/echo.npz"), "frequency").Numbers;
        Assert.That(f.Average(), Is.EqualTo(Frequency).Within(1e-3));
        Assert.That(f[1] - f[0], Is.EqualTo(600e6 / f.Length).Within(1e-3));
        var s = NumpyReader.Read(At("echo/echo.npz"), "S");
        Assert.That(s.Sizes, Is.EqualTo(new[] { 1, f.Length, 1, 2, 2 }));
        var range = NumpyReader.Read(At("echo/echo.npz"), "range").Numbers;
        var profile = NumpyReader.Read(At("echo/echo.npz"), "profile");
        Assert.That(profile.Sizes, Is.EqualTo(new[] { 1, 1, 2, 2, range.Length }));
        Assert.That(range[0], Is.EqualTo(-f.Length * bin / 2).Within(1e-9));
        foreach (int cell in new[] { 0, 17, range.Length / 2, range.Length - 1 })
        {
            var sum = Enumerable.Range(0, f.Length).Aggregate(Complex.Zero, (all, n) =>
                all + new Complex(s.Numbers[8 * n], s.Numbers[8 * n + 1])
                    * Complex.FromPolarCoordinates(1, 4 * Math.PI * (f[n] - Frequency) * range[cell] / C) / f.Length);
            Assert.That(profile.Numbers[2 * cell], Is.EqualTo(sum.Real).Within(1e-9));
            Assert.That(profile.Numbers[2 * cell + 1], Is.EqualTo(sum.Imaginary).Within(1e-9));
            Assert.That(Number(table[cell], "vv_dbsm"), Is.EqualTo(20 * Math.Log10(sum.Magnitude)).Within(1e-6));
            Assert.That(Number(table[cell], "range_m"), Is.EqualTo(range[cell]));
        }
        Assert.That(profile.Numbers.Skip(2 * range.Length), Is.All.NaN);
    }

    /// <summary>Pt G^2 lambda^2 sigma / ((4 pi)^3 R^4 L), and noise of k T0 B F in each response.</summary>
    [Test]
    public void Received_HasThePowerOfTheRadarEquation_AndTheReceiversNoise()
    {
        string[] echo = [At("plate.obj"), "--bandwidth", "600e6", "--frequencies", "1024", "--edges", "off",
            "--tolerance", "0.1", "--range", "1000", "--power", "50", "--gain", "20", "--loss", "3"];
        Run([.. echo, "--out", At("silent")]);
        double sigma = 4 * Math.PI * Math.Pow(Width * Height / Wavelength, 2);
        double expected = 50 * 1e4 * Wavelength * Wavelength * sigma
            / (Math.Pow(4 * Math.PI, 3) * 1e12 * Math.Pow(10, 0.3));
        Assert.That(Table("silent/profile.csv").Max(line => Number(line, "hh_dbw")),
            Is.EqualTo(10 * Math.Log10(expected)).Within(0.1));

        Run([.. echo, "--noise-figure", "6", "--seed", "5", "--out", At("noisy")]);
        Run([.. echo, "--noise-figure", "6", "--seed", "5", "--polarisation", "hh", "--out", At("again")]);
        double[] Received(string folder) => NumpyReader.Read(At(folder + "/echo.npz"), "received").Numbers;
        double[] silent = Received("silent"), noisy = Received("noisy");
        // 4 polarisations of 1024 responses: the mean power is known to 1.6 %, a standard deviation.
        double noise = noisy.Zip(silent, (a, b) => (a - b) * (a - b)).Sum() / (4 * 1024);
        Assert.That(noise, Is.EqualTo(1.380649e-23 * 290 * 600e6 * Math.Pow(10, 0.6)).Within(7).Percent);
        Assert.That(Received("again").TakeLast(2048), Is.EqualTo(noisy.TakeLast(2048)).Within(1e-15),
            "the same seed, other polarisations");
        Assert.That(Table("noisy/profile.csv").Select(line => line["hh_dbsm"]),
            Is.EqualTo(Table("silent/profile.csv").Select(line => line["hh_dbsm"])), "cross sections have no noise");
    }

    [Test]
    public void Matlab_AndSigMf_HaveTheArraysAndTheProfiles()
    {
        Run(At("plate.obj"), "--azimuth", "0,10", "--frequencies", "16", "--polarisation", "vv,hh", "--tolerance",
            "0.5", "--mat", "--sigmf", "--out", At("echo"));
        var arrays = MatlabReader.Read(File.ReadAllBytes(At("echo/echo.mat")));
        Assert.That(arrays.Select(array => array.Name + ".npy"), Is.EqualTo(NumpyReader.Names(At("echo/echo.npz"))));
        var profile = NumpyReader.Read(At("echo/echo.npz"), "profile");
        var same = arrays.Single(array => array.Name == "profile");
        Assert.That(same.Sizes, Is.EqualTo(profile.Sizes));
        // Indices pose and range, of the received and sent V.
        int cells = profile.Sizes[4];
        for (int pose = 0; pose < 2; pose++)
            Assert.That(same.Real[pose + 8 * 5], Is.EqualTo(profile.Numbers[2 * (4 * cells * pose + 5)]));

        var meta = JObject.Parse(File.ReadAllText(At("echo/echo.sigmf-meta")));
        Assert.That((string)meta["global"]["glint:unit"], Is.EqualTo("m"));
        Assert.That(meta["captures"].Select(capture =>
                $"{capture["glint:azimuth_deg"]} {capture["glint:polarisation"]} {capture["core:sample_start"]}"),
            Is.EqualTo(new[] { "0 vv 0", $"0 hh {cells}", $"10 vv {2 * cells}", $"10 hh {3 * cells}" }));
        byte[] data = File.ReadAllBytes(At("echo/echo.sigmf-data"));
        Assert.That(data, Has.Length.EqualTo(4 * cells * 8));
        // The last capture: received and sent in H.
        for (int i = 0; i < 2 * cells; i++)
            Assert.That(BitConverter.ToSingle(data, 4 * (6 * cells + i)),
                Is.EqualTo((float)profile.Numbers[2 * 7 * cells + i]));
        Run(At("plate.obj"), "--frequencies", "16", "--tolerance", "0.5", "--out", At("echo"));
        Assert.That(File.Exists(At("echo/echo.mat")) || File.Exists(At("echo/echo.sigmf-data")), Is.False,
            "older ones are removed");
    }

    [Test]
    public void Run_CancelledOrInParts_EndsWithTheFilesOfAnUndisturbedOne()
    {
        string[] echo = [At("plate.obj"), "--azimuth", "0:3:1", "--frequencies", "16", "--tolerance", "0.5",
            "--sigmf"];
        Run([.. echo, "--out", At("whole")]);
        var line = CommandLine.Parse(Commands.Echo, [.. echo, "--out", At("stopped")]);
        Project.Open(Project.FindRoot(AppContext.BaseDirectory));
        Assert.That(Batch.Execute(line, new CancelAfter(32)), Is.EqualTo(130));
        // The rows of a direction are written at once: a program killed meanwhile leaves some of them.
        foreach (string name in new[] { "stopped/results.partial", "stopped/responses.csv" })
            File.WriteAllText(At(name), string.Concat(File.ReadAllLines(At(name)).Take(22).Select(each => each + "\n")));
        Assert.That(Run([.. echo, "--out", At("stopped"), "--resume"]),
            Does.Contain("resumed: 21 of 64 rows are done"));
        AssertSame("stopped");
        // Three parts of 64 rows divide directions.
        for (int number = 1; number <= 3; number++)
            Run([.. echo, "--shard", $"{number}/3", "--out", At($"{number}")]);
        Assert.That(File.Exists(At("2/profile.csv")), Is.False, "the merged whole has it");
        var (code, _, error) = TestShell.Run("report", At("2"), "--pose", "none");
        Assert.That((code, error.Trim()), Is.EqualTo((1, "glint: the results are part 2/3 of a run, and a range "
            + "profile takes all of its frequencies: join the parts with glint merge")));
        (code, _, error) = TestShell.Run("merge", At("1"), At("2"), At("3"), "--out", At("merged"));
        Assert.That(code, Is.Zero, error);
        AssertSame("merged");
        (code, _, error) = Execute([.. echo, "--window", "hann", "--out", At("stopped"), "--resume"]);
        Assert.That(code, Is.EqualTo(1));
        Assert.That(error, Does.Contain("is of another sweep: window was taylor and is hann"));
    }

    [Test]
    public void Report_HasARowADirection_AndTheLevelsOfTheProfiles()
    {
        Run(At("plate.obj"), "--azimuth", "0,4,8", "--frequencies", "32", "--edges", "off", "--tolerance", "0.5",
            "--polarisation", "vv,hh", "--out", At("echo"));
        var (code, _, error) = TestShell.Run("report", At("echo"));
        Assert.That(code, Is.Zero, error);
        var data = DataOf("echo/report.html");
        var rows = data["run"]["rows"].ToArray();
        Assert.That(rows.Select(row => (double)row["azimuth_deg"]), Is.EqualTo(new[] { 0, 4, 8 }));
        Assert.That((double)rows[0]["hh_range_m"], Is.EqualTo(Range).Within(0.1));
        var table = Table("echo/profile.csv");
        int cells = (int)data["echo"]["cells"];
        Assert.That(table, Has.Count.EqualTo(3 * cells));
        byte[] levels = Convert.FromBase64String((string)data["echo"]["quantities"][0]["levels"]);
        for (int direction = 0; direction < 3; direction++)
            for (int cell = 0; cell < cells; cell++)
                Assert.That(BitConverter.ToInt16(levels, 2 * ((2 * direction + 1) * cells + cell)) / 100.0,
                    Is.EqualTo(Number(table[direction * cells + cell], "hh_dbsm")).Within(0.0051));
        Assert.That((double)rows[1]["vv_dbsm"],
            Is.EqualTo(table.Skip(cells).Take(cells).Max(line => Number(line, "vv_dbsm"))).Within(1e-9));
        Assert.That((double)data["echo"]["start"], Is.EqualTo(Number(table[0], "range_m")).Within(1e-9));
        (code, _, error) = TestShell.Run("report", At("echo"), "--pose", "4");
        Assert.That((code, error), Is.EqualTo((1, $"glint: --pose 4: must be from 1 to 3, the rows of {At("echo")}, "
            + "or none" + Environment.NewLine)));
    }

    /// <summary>A band of two thirds of its centre takes several traces.</summary>
    [Test]
    public void Report_OfSeveralTracesADirection_HasTheMostTubesAndRays()
    {
        Run(At("plate.obj"), "--bandwidth", "6e9", "--polarisation", "vv", "--tolerance", "0.2", "--out", At("echo"));
        Assert.That(TestShell.Run("report", At("echo")).code, Is.Zero);
        var rows = StoredRun.ReadAny(At("echo")).Rows;
        foreach (var column in new[] { CrossSectionColumn.Tubes, CrossSectionColumn.Rays })
        {
            Assert.That(rows.Select(row => row[column]).Distinct().Count(), Is.GreaterThan(1));
            Assert.That((double)DataOf("echo/report.html")["run"]["rows"][0][column.Name],
                Is.EqualTo(rows.Max(row => row[column])));
        }
    }

    [Test]
    public void Report_OfAPlateSeenEdgeOn_HasNoEcho()
    {
        Run(At("plate.obj"), "--azimuth", "90", "--frequencies", "32", "--edges", "off", "--polarisation", "vv",
            "--out", At("echo"));
        var (code, _, error) = TestShell.Run("report", At("echo"), "--pose", "none");
        Assert.That(code, Is.Zero, error);
        var data = DataOf("echo/report.html");
        byte[] levels = Convert.FromBase64String((string)data["echo"]["quantities"][0]["levels"]);
        Assert.That(Enumerable.Range(0, (int)data["echo"]["cells"]).Select(cell => BitConverter.ToInt16(levels, 2 * cell)),
            Is.All.EqualTo(short.MinValue));
        Assert.That(data["run"]["rows"][0]["vv_dbsm"].Type, Is.EqualTo(JTokenType.Null));
    }

    /// <summary>
    /// The phase centre of a scene is the centre of its box. The dihedral's faces of 0.3 m open by 45 degrees to either
    /// side of the radar at azimuth 0: the box is 0.3 / sqrt 2 deep, and its double bounce returns from the edge.
    /// </summary>
    [Test]
    public void Scene_OfADihedral_HasItsEdgeHalfItsDepthBehindThePhaseCentre()
    {
        Run("Scenes/CrossSection.unity", "--bandwidth", "3e9", "--receivers", "0,20", "--polarisation", "hh",
            "--tolerance", "0.2", "--out", At("echo"));
        var table = Table("echo/profile.csv");
        Assert.That(table.Select(line => line["receiver_azimuth_deg"]).Distinct(), Is.EqualTo(new[] { "0", "20" }));
        var highest = table.Where(line => line["receiver_azimuth_deg"] == "0").MaxBy(line => Number(line, "hh_dbsm"));
        Assert.That(Number(highest, "range_m"), Is.EqualTo(0.15 / Math.Sqrt(2)).Within(0.2 * C / (2 * 3e9)));
    }

    /// <summary>
    /// Trihedrals of 0.3 m with their corners at the origin, 0.6 m to the right of the radar at azimuth 0, and 1.2 m
    /// behind and 0.7 m to the left: each is a point of 4 pi a^4 / (3 lambda^2).
    /// </summary>
    [Test]
    public void Isar_OfThreeTrihedrals_HasThemAtTheirPlaces()
    {
        WriteTrihedrals();
        var (isar, output, problem) = TestShell.Run("isar", At("trihedrals.obj"), "--azimuth", "-2.8125:2.8125:0.375",
            "--bandwidth", "900e6", "--polarisation", "vv", "--edges", "off", "--tolerance", "0.2", "--pixel", "0.04",
            "--out", At("image"));
        Assert.That(isar, Is.Zero, problem);
        Assert.That(output, Does.Contain("cross-range bin 0.1431 m"));
        var table = Table("image/image.csv");
        AssertTrihedrals(table, double.PositiveInfinity);
        int pixels = (int)Math.Sqrt(table.Count);
        double[] levels = table.Select(line => Number(line, "vv_dbsm")).ToArray();
        // Near rows are at the bottom.
        Assert.That(GreysOf(At("image/image-vv.png"), pixels), Is.EqualTo(Enumerable.Range(0, levels.Length).Select(i =>
                255 * Math.Max(0, 1 - (levels.Max() - levels[(pixels - 1 - i / pixels) * pixels + i % pixels]) / 60)))
            .Within(0.501));
        var image = NumpyReader.Read(At("image/image.npz"), "image");
        Assert.That(image.Sizes, Is.EqualTo(new[] { 2, 2, pixels, pixels }));
        Assert.That(10 * Math.Log10(image.Numbers[0] * image.Numbers[0] + image.Numbers[1] * image.Numbers[1]),
            Is.EqualTo(Number(table[0], "vv_dbsm")).Within(1e-6));
        var (code, _, error) = TestShell.Run("report", At("image"));
        Assert.That(code, Is.Zero, error);
        var data = DataOf("image/report.html");
        byte[] shown = Convert.FromBase64String((string)data["echo"]["image"]["levels"]);
        Assert.That((int)data["echo"]["image"]["pixels"], Is.EqualTo(pixels));
        Assert.That(Enumerable.Range(0, levels.Length).Select(i => BitConverter.ToInt16(shown, 2 * i) / 100.0),
            Is.EqualTo(levels).Within(0.02), "of the processor");
        Assert.That((double)data["echo"]["image"]["azimuth"], Is.EqualTo(0).Within(1e-9));
        Assert.That((double)data["echo"]["image"]["start"], Is.EqualTo(Number(table[0], "down_range_m")).Within(1e-9));
        // The target's middle is between its corners, and the phase centre at the file's origin.
        Assert.That(data["echo"]["image"]["centre"].Select(each => (double)each), Is.All.EqualTo(0).Within(1e-9));
        Assert.That((double)data["scene"]["centre"][2], Is.EqualTo((1.2 - TrihedralEdge * Math.Sqrt(1.0 / 3)) / 2).Within(1e-3));
    }

    /// <summary>A track of 2 m, 20 m away: the wave is curved by a wavelength. Parts and a resumption know the track.</summary>
    [Test]
    public void Isar_FromATrack_HasTheTrihedralsAtTheirPlaces()
    {
        WriteTrihedrals();
        string[] image = ["isar", At("trihedrals.obj"), "--range", "20", "--track", "-0.97875:0.97875:0.1305", "--bandwidth",
            "900e6", "--polarisation", "vv", "--edges", "off", "--tolerance", "0.5", "--pixel", "0.04"];
        var (code, output, problem) = TestShell.Run([.. image, "--azimuth", "0", "--out", At("sar")]);
        Assert.That(code, Is.Zero, problem);
        Assert.That(output, Does.Contain("cross-range bin 0.1437 m"));
        AssertTrihedrals(Table("sar/image.csv"), 20);
        double[] distance = NumpyReader.Read(At("sar/echo.npz"), "distance").Numbers;
        Assert.That((distance.Length, distance[0]), Is.EqualTo((16, Math.Sqrt(400 + 0.97875 * 0.97875))));
        string[] coarse = ["isar", At("plate.obj"), "--range", "20", "--track", "-1.001:1.001:1.001", "--bandwidth",
            "900e6", "--polarisation", "vv", "--edges", "off", "--tolerance", "3", "--frequencies", "16", "--azimuth", "0"];
        TestShell.Run([.. coarse, "--out", At("whole")]);
        foreach (int number in new[] { 1, 2 })
            TestShell.Run([.. coarse, "--shard", $"{number}/2", "--out", At($"{number}")]);
        TestShell.Run("merge", At("1"), At("2"), "--out", At("merged"));
        Assert.That(File.ReadAllBytes(At("merged/echo.npz")), Is.EqualTo(File.ReadAllBytes(At("whole/echo.npz"))));
        (code, _, problem) = TestShell.Run([.. image, "--azimuth", "0,1", "--out", At("none")]);
        Assert.That((code, problem), Is.EqualTo((2, "glint: --track: its middle has one azimuth and one elevation: give one "
            + $"for --azimuth and for --elevation (see glint isar --help){Environment.NewLine}")));
        (code, _, problem) = TestShell.Run([.. image, "--azimuth", "0", "--elevation", "90", "--out", At("none")]);
        Assert.That(code, Is.Not.Zero);
        Assert.That(problem, Does.Contain("leads over the target"));
    }

    const double TrihedralEdge = 0.3;

    static readonly (double down, double cross)[] s_trihedrals = [(0, 0), (0, 0.6), (1.2, -0.7)];

    void WriteTrihedrals() => File.WriteAllText(At("trihedrals.obj"), string.Concat(s_trihedrals.Select((place, i) =>
        Trihedral(TrihedralEdge, place.cross, place.down, i))));

    static void AssertTrihedrals(IReadOnlyList<Dictionary<string, string>> table, double range)
    {
        foreach (var (down, cross) in s_trihedrals)
        {
            var highest = table.Where(line => Math.Abs(Number(line, "down_range_m") - down) < 0.25
                && Math.Abs(Number(line, "cross_range_m") - cross) < 0.25).MaxBy(line => Number(line, "vv_dbsm"));
            Assert.That(Number(highest, "down_range_m"), Is.EqualTo(down).Within(0.03));
            Assert.That(Number(highest, "cross_range_m"), Is.EqualTo(cross).Within(0.03));
            // At a finite range those behind the phase centre are weaker.
            Assert.That(Number(highest, "vv_dbsm") + 40 * Math.Log10(1 + down / range), Is.EqualTo(10 * Math.Log10(
                4 * Math.PI * Math.Pow(TrihedralEdge, 4) / (3 * Wavelength * Wavelength))).Within(0.3));
        }
    }

    /// <summary>Rows are an array; a killed run leaves whole ones and a part of another.</summary>
    [Test]
    public void Isar_CancelledOrInParts_EndsWithTheFilesOfAnUndisturbedOne()
    {
        string[] image = [At("plate.obj"), "--azimuth", "-3:3:1", "--frequencies", "16", "--bandwidth", "600e6",
            "--tolerance", "3", "--pixel", "0.2"];
        TestShell.Run(["isar", .. image, "--out", At("whole")]);
        var line = CommandLine.Parse(Commands.Isar, [.. image, "--out", At("stopped")]);
        Project.Open(Project.FindRoot(AppContext.BaseDirectory));
        Assert.That(Batch.Execute(line, new CancelAfter(64)), Is.EqualTo(130));
        using (var rows = File.OpenWrite(At("stopped/responses.npy")))
            rows.SetLength(128 + 37 * 25 * 8 + 11);
        var (_, output, _) = TestShell.Run(["isar", .. image, "--out", At("stopped"), "--resume"]);
        Assert.That(output, Does.Contain("resumed: 37 of 112 rows are done"));
        foreach (int number in new[] { 1, 2 })
            TestShell.Run(["isar", .. image, "--shard", $"{number}/2", "--out", At($"{number}")]);
        TestShell.Run("merge", At("1"), At("2"), "--out", At("merged"));
        foreach (string folder in new[] { "stopped", "merged" })
            foreach (string name in new[] { "responses.npy", "echo.npz" })
                Assert.That(File.ReadAllBytes(At($"{folder}/{name}")),
                    Is.EqualTo(File.ReadAllBytes(At($"whole/{name}"))), $"{folder}/{name}");
        // The images of merged parts are those of the processor.
        Assert.That(File.ReadAllBytes(At("stopped/image.csv")), Is.EqualTo(File.ReadAllBytes(At("whole/image.csv"))));
        Assert.That(File.Exists(At("merged/image.csv")));
        var written = JObject.Parse(File.ReadAllText(At("whole/results.json")));
        Assert.That((string)written["rows"], Is.EqualTo("responses.npy"));
        Assert.That((int)written["row_count"], Is.EqualTo(112));
        Assert.That(((JObject)written["columns"]).Count, Is.EqualTo(25), "of the array, in its order");
    }

    [TestCase("--azimuth is missing", "--out", "x")]
    [TestCase("--track: needs --range M", "--azimuth", "0", "--track", "-1:1:0.1")]
    [TestCase("an image of azimuths is one from far away", "--azimuth", "0,1", "--range", "100")]
    [TestCase("an image takes at least two places at equal steps", "--azimuth", "0", "--range", "100", "--track", "1")]
    [TestCase("an image takes at least two azimuths at equal steps", "--azimuth", "1")]
    [TestCase("an image takes at least two azimuths at equal steps", "--azimuth", "0,1,3")]
    [TestCase("an image takes one elevation", "--azimuth", "0,1", "--elevation", "0,1")]
    [TestCase("a horizontal image has no down range", "--azimuth", "0,1", "--elevation", "90")]
    [TestCase("at most 4096 are possible: give a smaller --side, or a larger --pixel", "--azimuth", "0,1",
        "--pixel", "1e-4")]
    public void Isar_OfWhatMakesNoImage_IsRefused(string message, params string[] options)
    {
        var (code, _, error) = TestShell.Run(["isar", At("plate.obj"), .. options]);
        Assert.That(error, Does.Contain(message));
        Assert.That(code, Is.EqualTo(2));
    }

    [TestCase(2, "--bandwidth 20000000000: must be below twice --frequency, 20000000000 Hz", "--bandwidth", "2e10")]
    [TestCase(2, "--bandwidth 0: must be from 1 to 1e12", "--bandwidth", "0")]
    [TestCase(2, "--frequencies 1: must be from 2 to 65536", "--frequencies", "1")]
    [TestCase(2, "--window kaiser: must be one of taylor, hann, hamming, blackman, none", "--window", "kaiser")]
    [TestCase(2, "--power: needs --range M", "--power", "10")]
    [TestCase(2, "--gain: needs --power W", "--gain", "10")]
    [TestCase(2, "--seed: needs --noise-figure DB", "--seed", "10")]
    [TestCase(2, "--contributions: echo has no such option", "--contributions")]
    // Bins of 0.0214 m; the farthest corner is 2506.5 m away, half of the plate's diagonal is 180.3 m.
    [TestCase(2, "the target takes 250342 frequencies, at most 65536 are possible", "--bandwidth", "7e9", "--unit",
        "km")]
    [TestCase(1, "is too high for its size", "--unit", "km", "--frequencies", "8", "--frequency", "9e11")]
    public void Input_ThatCannotBeComputed_IsRefusedBeforeAnyFile(int code, string message, params string[] options) =>
        AssertRefused(code, message, options);

    // Of an upright plate before the radar HV and VH are 0.
    [Test]
    public void Table_OfAPolarisationWithoutAnEcho_HasNoRange()
    {
        string output = Run(At("plate.obj"), "--frequencies", "16", "--tolerance", "0.5", "--edges", "off", "--out",
            At("echo"));
        Assert.That(output, Does.Match(@"(?m)^ +0 +0 +1[67]\.\d+ +2\.\d+ +- +- +- +- +1[67]\.\d+ +2\.\d+ "));
    }

    [Test]
    public void Frequencies_TooFewForTheTarget_AreWarnedOf()
    {
        var (code, _, error) = Execute(At("plate.obj"), "--frequencies", "4", "--tolerance", "1", "--out", At("echo"));
        Assert.That(code, Is.Zero, error);
        Assert.That(error, Does.Match(@"plate: the unambiguous range is 3\.997 m, but echoes of up to two bounces take "
            + @"5\.361 m: some may be folded over others; give at least 14 for --frequencies"));
    }

    /// <summary>The page's example, in Debian's Python.</summary>
    [Test]
    [Platform("Linux")]
    public void PythonExample_OfThePage_ReadsAndPlotsTheFile()
    {
        Run(At("plate.obj"), "--azimuth", "-2,0,2", "--edges", "off", "--tolerance", "0.02", "--out", At("."));
        string output = PythonExample.Run("echo.md", "/usr/bin/python3", At("."));
        Assert.That(output, Does.Match(@"^highest: (17\.0|16\.9)\d dBsm at 2\.\d\d m, azimuth 0\.0 deg\n$"));
        Assert.That(File.ReadAllBytes(At("profile.png")).Take(4), Is.EqualTo(new byte[] { 0x89, 0x50, 0x4E, 0x47 }));
    }

    /// <summary>SciPy reads the arrays of echo.npz in echo.mat, and NumPy the profiles in the SigMF recording.</summary>
    [Test]
    [Platform("Linux")]
    public void Matlab_AndSigMf_AreReadByOtherPrograms()
    {
        Run(At("plate.obj"), "--azimuth", "0,10", "--frequencies", "16", "--polarisation", "vv,hh", "--tolerance",
            "0.5", "--pulses", "4", "--velocity", "0,0,-1", "--mat", "--sigmf", "--out", At("."));
        string output = PythonExample.RunText("""
            import json
            import numpy as np
            import scipy.io
            arrays, matlab = np.load("echo.npz"), scipy.io.loadmat("echo.mat")
            for name in arrays.files:
                assert np.array_equal(np.squeeze(arrays[name]), np.squeeze(matlab[name]), equal_nan=True), name
            meta = json.load(open("echo.sigmf-meta"))
            assert meta["global"]["core:datatype"] == "cf32_le" and meta["global"]["core:version"]
            samples = np.fromfile("echo.sigmf-data", "<c8")
            starts = [capture["core:sample_start"] for capture in meta["captures"]]
            first = samples[starts[0]:starts[1]]
            assert np.array_equal(first, arrays["profile"][0, 0, 0, 0].astype("<c8"))
            print(len(arrays.files), len(starts), len(samples) == starts[-1] + len(first))
            """, "/usr/bin/python3", At("."));
        Assert.That(output, Does.Match(@"^\d+ 16 True\n$"), "2 directions, 2 polarisations, 4 pulses");
    }

    void AssertSame(string folder)
    {
        string[] names = ["responses.csv", "profile.csv", "echo.npz", "echo.sigmf-data", "echo.sigmf-meta"];
        Assert.That(Directory.GetFiles(At(folder)).Select(Path.GetFileName),
            Is.EquivalentTo(names.Append("results.json")));
        foreach (string name in names)
            Assert.That(File.ReadAllBytes(At($"{folder}/{name}")), Is.EqualTo(File.ReadAllBytes(At($"whole/{name}"))),
                name);
        Assert.That(Timeless.Json(At(folder)), Is.EqualTo(Timeless.Json(At("whole"))));
    }

    // Of a square picture of grey levels without filters; the stream's sum is checked.
    static IEnumerable<byte> GreysOf(string path, int pixels)
    {
        byte[] png = File.ReadAllBytes(path);
        Assert.That(new[] { 16, 20 }.Select(at => BinaryPrimitives.ReadInt32BigEndian(png.AsSpan(at))),
            Is.All.EqualTo(pixels));
        Assert.That(png.AsSpan(24, 5).ToArray(), Is.EqualTo(new byte[] { 8, 0, 0, 0, 0 }), "grey levels of 8 bits");
        Assert.That(Encoding.ASCII.GetString(png, 37, 4), Is.EqualTo("IDAT"));
        using var stream = new ZLibStream(
            new MemoryStream(png, 41, BinaryPrimitives.ReadInt32BigEndian(png.AsSpan(33))), CompressionMode.Decompress);
        using var rows = new MemoryStream();
        stream.CopyTo(rows);
        Assert.That(rows.Length, Is.EqualTo(pixels * (pixels + 1)));
        return rows.ToArray().Where((_, i) => i % (pixels + 1) != 0);
    }

    // Open to -Z, its axis horizontal.
    static string Trihedral(double edge, double x, double z, int number)
    {
        var text = new StringBuilder().Append(CultureInfo.InvariantCulture, $"v {x} 0 {z}\n");
        for (int i = 0; i < 3; i++)
        {
            var (sine, cosine) = Math.SinCos(2 * Math.PI * i / 3 + Math.PI / 2);
            double across = edge * Math.Sqrt(2.0 / 3), along = edge * Math.Sqrt(1.0 / 3);
            text.Append(CultureInfo.InvariantCulture, $"v {x + across * cosine} {across * sine} {z - along}\n");
        }
        int first = 4 * number + 1;
        for (int i = 0; i < 3; i++)
            text.Append($"f {first} {first + 1 + i} {first + 1 + (i + 1) % 3}\n");
        return text.ToString();
    }
}
