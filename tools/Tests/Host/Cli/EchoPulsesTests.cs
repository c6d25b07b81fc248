using System;
using System.IO;
using System.Linq;
using Glint.Editor;
using Glint.Tests;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>glint echo with pulses: motion, range-Doppler maps, detection.</summary>
[Category("Slow")]
public sealed class EchoPulsesTests : EchoFixture
{
    // m/s at 1000 Hz.
    const double Blind = 1000 * Wavelength / 2;

    static readonly string[] s_pulses =
        ["--bandwidth", "600e6", "--edges", "off", "--tolerance", "0.1", "--pulses", "32", "--window", "hann"];

    static readonly string[] s_radar =
        ["--range", "1000", "--power", "50", "--gain", "20", "--noise-figure", "6"];

    /// <summary>2 m in half a second are 8 bins of 0.25 m.</summary>
    [Test]
    public void Plate_ThatMovesThroughRangeBins_IsWarnedOf()
    {
        string[] pulses = ["--edges", "off", "--tolerance", "1", "--pulses", "2", "--prf", "2", "--velocity", "0,0,-4"];
        string warning = "up to 2 m along the line of sight in the 0.5 s of the pulses, and a range bin is 0.2498 m";
        string ErrorOf(string bandwidth) => TestShell.Run(["echo", At("plate.obj"), "--bandwidth", bandwidth, .. pulses,
            "--out", At("echo")]).error;
        Assert.That(ErrorOf("600e6"), Does.Contain(warning)
            .And.Contain("end the pulses within 0.0625 s (--pulses, --prf), or give --bandwidth of at most 74e6"));
        Assert.That(ErrorOf("74e6"), Does.Not.Contain("range bin is"));
    }

    /// <summary>A plate that approaches at 4 m/s: 4 pi A^2 / lambda^2 at its range and speed, in every file.</summary>
    [Test]
    public void Plate_ThatApproaches_IsAPointAtItsRangeAndSpeed()
    {
        string output = Run([At("plate.obj"), .. s_pulses, "--velocity", "0,0,-4", "--polarisation", "vv", "--sigmf",
            "--out", At("echo")]);
        Assert.That(output, Does.Contain("32 pulses at 1000 Hz, speed bin 0.4684 m/s, blind speed 14.99 m/s"));
        var table = Table("echo/doppler.csv");
        var highest = table.MaxBy(line => Number(line, "vv_dbsm"));
        double sigma = 4 * Math.PI * Math.Pow(Width * Height / Wavelength, 2);
        Assert.That(Number(highest, "vv_dbsm"), Is.EqualTo(10 * Math.Log10(sigma)).Within(0.4), "between two rows");
        // Where it is in the middle of the burst.
        Assert.That(Number(highest, "range_m"), Is.EqualTo(Range - 4 * 15.5e-3).Within(0.02));
        Assert.That(Number(highest, "speed_mps"), Is.EqualTo(4).Within(Blind / 64 / 2 * 1.01));
        Assert.That(output, Does.Match(@"(?m)^ +0 +0 +1[67]\.\d+ +2\.[45]\d+ +[34]\.\d+ +0\.0\d+\r?$"));

        double[] speed = NumpyReader.Read(At("echo/echo.npz"), "speed").Numbers,
            range = NumpyReader.Read(At("echo/echo.npz"), "range").Numbers;
        var map = NumpyReader.Read(At("echo/echo.npz"), "map");
        Assert.That(map.Sizes, Is.EqualTo(new[] { 1, 1, 2, 2, speed.Length, range.Length }));
        foreach (int cell in new[] { 0, 1234, speed.Length * range.Length - 1 })
        {
            Assert.That(Number(table[cell], "speed_mps"), Is.EqualTo(speed[cell / range.Length]));
            Assert.That(Number(table[cell], "range_m"), Is.EqualTo(range[cell % range.Length]));
            Assert.That(Number(table[cell], "vv_dbsm"), Is.EqualTo(10 * Math.Log10(
                Math.Pow(map.Numbers[2 * cell], 2) + Math.Pow(map.Numbers[2 * cell + 1], 2))).Within(1e-6));
        }
        var s = NumpyReader.Read(At("echo/echo.npz"), "S");
        double[] time = NumpyReader.Read(At("echo/echo.npz"), "time").Numbers;
        int frequencies = NumpyReader.Read(At("echo/echo.npz"), "frequency").Numbers.Length;
        Assert.That(s.Sizes, Is.EqualTo(new[] { 1, 32, frequencies, 1, 2, 2 }));
        Assert.That(time, Is.EqualTo(Enumerable.Range(0, 32).Select(pulse => pulse / 1000.0)).Within(1e-12));
        Assert.That(Table("echo/responses.csv").Select(line => Number(line, "time_s")).Distinct(), Is.EqualTo(time));

        var meta = JObject.Parse(File.ReadAllText(At("echo/echo.sigmf-meta")));
        Assert.That((double)meta["global"]["glint:pulse_repetition_frequency_hz"], Is.EqualTo(1000));
        Assert.That(meta["captures"].Select(capture => (double)capture["glint:time_s"]), Is.EqualTo(time));
        Assert.That(new FileInfo(At("echo/echo.sigmf-data")).Length, Is.EqualTo(32 * range.Length * 8));
    }

    /// <summary>10 m/s is 10 m/s less the blind speed; the range does not know.</summary>
    [Test]
    public void Speed_AboveHalfOfTheBlindSpeed_IsFoldedAndWarnedOf()
    {
        var (code, _, error) = Execute([At("plate.obj"), .. s_pulses, "--velocity", "0,0,-10", "--polarisation", "hh",
            "--out", At("echo")]);
        Assert.That(code, Is.Zero, error);
        Assert.That(error, Does.Contain("up to 10 m/s along the line of sight, and speeds above half of the blind "
            + "speed, 7.495 m/s, are folded; give a --prf of at least 1334"));
        Assert.That(Number(Table("echo/doppler.csv").MaxBy(line => Number(line, "hh_dbsm")), "speed_mps"),
            Is.EqualTo(10 - Blind).Within(Blind / 64));
    }

    /// <summary>
    /// The plate turns about the phase centre, 2.5 m before it: it moves across the line of sight at 90 degrees, and
    /// away from the radar or towards it from the side. Positive turns as azimuths do: the target's far side goes to
    /// the right.
    /// </summary>
    [Test]
    public void TurnRate_MovesThePlateAboutThePhaseCentre()
    {
        double SpeedFrom(int azimuth)
        {
            Run([At("plate.obj"), .. s_pulses, "--turn-rate", "45", "--azimuth", $"{azimuth}", "--polarisation", "vv",
                "--out", At("echo")]);
            return Number(Table("echo/doppler.csv").MaxBy(line => Number(line, "vv_dbsm")), "speed_mps");
        }
        Assert.That(SpeedFrom(0), Is.EqualTo(0).Within(0.2));
        // At azimuth 30 the radar is at x = -sin(30): the plate, at z = 2.5, goes to +x at 1.96 m/s.
        Assert.That(SpeedFrom(30), Is.EqualTo(-2.5 * Math.PI / 4 * Math.Sin(Math.PI / 6)).Within(0.3));
    }

    [Test]
    public void Pulses_OfAStillMesh_AreAllTheSame()
    {
        string output = Run([At("plate.obj"), .. s_pulses, "--polarisation", "vv", "--out", At("echo")]);
        Assert.That(output, Does.Contain("note: nothing moves: all echoes have the speed 0"));
        var rows = Table("echo/responses.csv").GroupBy(line => line["frequency_hz"]);
        foreach (var pulses in rows)
            Assert.That(pulses.Select(line => line["vv_re_m"] + line["vv_im_m"]).Distinct().Count(), Is.EqualTo(1));
    }

    [Test]
    public void Run_Resumed_EndsWithTheFilesOfAnUndisturbedOne()
    {
        string[] echo = [At("plate.obj"), "--frequencies", "16", "--tolerance", "0.5", "--pulses", "4", "--velocity",
            "0,0,-4", "--azimuth", "0,1"];
        Run([.. echo, "--out", At("whole")]);
        var line = CommandLine.Parse(Commands.Echo, [.. echo, "--out", At("stopped")]);
        Project.Open(Project.FindRoot(AppContext.BaseDirectory));
        Assert.That(Batch.Execute(line, new CancelAfter(64)), Is.EqualTo(130));
        Run([.. echo, "--out", At("stopped"), "--resume"]);
        foreach (string name in new[] { "responses.csv", "profile.csv", "doppler.csv", "echo.npz" })
            Assert.That(File.ReadAllBytes(At($"stopped/{name}")), Is.EqualTo(File.ReadAllBytes(At($"whole/{name}"))),
                name);
        var (code, _, error) = Execute([At("plate.obj"), "--frequencies", "16", "--tolerance", "0.5", "--pulses", "4",
            "--velocity", "0,0,-5", "--azimuth", "0,1", "--out", At("stopped"), "--resume"]);
        Assert.That((code, error.Contains("is of another sweep")), Is.EqualTo((1, true)), error);
    }

    /// <summary>Of a plate 40 dB above the noise the detections are its cells; the rest is quiet at 1e-6.</summary>
    [Test]
    public void Detections_AreThePlates([Values("ca", "os")] string level, [Values] bool hasPulses)
    {
        string[] pulses = hasPulses ? ["--pulses", "16", "--velocity", "0,0,-4"] : [];
        Run([At("plate.obj"), "--bandwidth", "600e6", "--frequencies", "256", "--edges", "off", "--tolerance", "0.1",
            .. s_radar, .. pulses, "--polarisation", "vv", "--detect", level, "--out", At("echo")]);
        var detections = Table("echo/detections.csv");
        Assert.That(detections, Is.Not.Empty);
        Assert.That(detections.Select(line => Number(line, "range_m")), Is.All.EqualTo(Range).Within(0.6));
        Assert.That(detections.Max(line => Number(line, "level_dbw")),
            Is.EqualTo(Table("echo/profile.csv").Max(line => Number(line, "vv_dbw"))).Within(2));
        if (hasPulses)
            Assert.That(detections.Select(line => Number(line, "speed_mps")), Is.All.EqualTo(4).Within(2));
        else
            Assert.That(detections.Select(line => line["speed_mps"]), Is.All.Empty);
    }

    [Test]
    public void Report_HasTheLevelsOfTheMaps_AndTheDetections()
    {
        Run([At("plate.obj"), .. s_pulses, "--velocity", "0,0,-4", "--azimuth", "0,3", "--polarisation", "vv,hh",
            .. s_radar, "--detect", "os", "--out", At("echo")]);
        var (code, _, error) = TestShell.Run("report", At("echo"));
        Assert.That(code, Is.Zero, error);
        var data = DataOf("echo/report.html");
        Assert.That((bool)data["scene"]["is_changed"], Is.False, "a motion is no other scene");
        var map = data["echo"]["doppler"];
        var table = Table("echo/doppler.csv");
        int cells = (int)map["cells"] * (int)map["rows"];
        Assert.That(table, Has.Count.EqualTo(2 * cells));
        byte[] levels = Convert.FromBase64String((string)map["quantities"][1]["levels"]);
        for (int direction = 0; direction < 2; direction++)
            for (int cell = 0; cell < cells; cell += 7)
                Assert.That(BitConverter.ToInt16(levels, 2 * ((2 * direction + 1) * cells + cell)) / 100.0,
                    Is.EqualTo(Number(table[direction * cells + cell], "hh_dbw")).Within(0.0051));
        Assert.That((double)map["speed_start"] + (double)map["speed_step"],
            Is.EqualTo(Number(table[(int)map["cells"]], "speed_mps")).Within(1e-9));
        Assert.That(data["echo"]["detections"].SelectMany(each => each).Select(each => (double)each["level"]),
            Is.EqualTo(Table("echo/detections.csv").Select(line => Number(line, "level_dbw"))).Within(1e-9));
    }

    /// <summary>Noise alone: as many false alarms as asked for.</summary>
    [TestCase("ca", Category = "Stress")]
    [TestCase("os")]
    public void FalseAlarms_InNoise_AreAsManyAsAskedFor(string level)
    {
        const double rate = 0.01;
        Run(At("plate.obj"), "--frequencies", "1024", "--tolerance", "10", "--edges", "off", "--bounces", "1", "--range", "1e5", "--power", "1e-12",
            "--noise-figure", "6", "--azimuth", "0:24:1", "--detect", level, "--false-alarm", "0.01",
            "--window", "none", "--out", At("echo"));
        double cells = 25 * 4 * 1024, alarms = Table("echo/detections.csv").Count;
        Assert.That(alarms, Is.EqualTo(rate * cells).Within(10).Percent);
    }

    [TestCase(2, "--prf: needs --pulses M", "--prf", "100")]
    [TestCase(2, "--velocity: needs --pulses M", "--velocity", "1,2,3")]
    [TestCase(2, "--turn-rate: needs --pulses M", "--turn-rate", "1")]
    [TestCase(2, "--pulses 1: must be from 2 to 65536", "--pulses", "1")]
    [TestCase(2, "the reference tracer computes a scene that stands still", "--pulses", "4", "--reference", "1")]
    [TestCase(2, "--detect: there is nothing but echoes to detect in: give --noise-figure", "--detect", "ca")]
    [TestCase(2, "--detect go: must be one of ca, os", "--detect", "go")]
    [TestCase(2, "--false-alarm: needs --detect CFAR", "--false-alarm", "1e-3")]
    // 4 polarisations of 360 directions, 128 speeds and 1024 ranges
    [TestCase(2, "--mat: the maps of the run have 188,743,680 complex numbers, and an array of a MAT-file has at most "
        + "134,217,663", "--azimuth", "0:359:1", "--frequencies", "65", "--pulses", "33", "--prf", "2000", "--velocity",
        "0,0,-6", "--mat")]
    public void Options_ThatDoNotGoTogether_AreRefusedBeforeAnyFile(int code, string message, params string[] options) =>
        AssertRefused(code, message, options);

    /// <summary>
    /// A RadarMotion on the dihedral of the stored scene: it turns about its edge and goes to the radar, at azimuth 0,
    /// at 2 m/s. Its double bounce has that speed.
    /// </summary>
    [Test]
    public void Scene_WithARadarMotion_HasItsSpeed()
    {
        string root = Project.FindRoot(AppContext.BaseDirectory), guid = File.ReadLines(Path.Combine(root,
            "Packages/com.glint.radar/Runtime/Components/RadarMotion.cs.meta")).Last()["guid: ".Length..];
        string scene = File.ReadAllText(Path.Combine(root, "Scenes/CrossSection.unity")),
            before = "  - component: {fileID: 141}\n";
        Assert.That(scene, Does.Contain(before));
        using var moving = new TemporaryScene(scene.Replace(before, before + "  - component: {fileID: 949}\n")
            + "--- !u!114 &949\nMonoBehaviour:\n  m_ObjectHideFlags: 0\n"
            + "  m_CorrespondingSourceObject: {fileID: 0}\n"
            + "  m_PrefabInstance: {fileID: 0}\n  m_PrefabAsset: {fileID: 0}\n  m_GameObject: {fileID: 140}\n"
            + "  m_Enabled: 1\n  m_EditorHideFlags: 0\n"
            + $"  m_Script: {{fileID: 11500000, guid: {guid}, type: 3}}\n  m_Name: \n  m_EditorClassIdentifier: \n"
            + "  _velocity: {x: 0, y: 0, z: -2}\n  _turnRates: {x: 0, y: 60, z: 0}\n");
        Run(moving.Path, "--bandwidth", "3e9", "--pulses", "16", "--polarisation", "hh", "--tolerance", "0.2",
            "--material", "*=metal", "--out", At("echo"));
        var highest = Table("echo/doppler.csv").MaxBy(line => Number(line, "hh_dbsm"));
        Assert.That(Number(highest, "speed_mps"), Is.EqualTo(2).Within(Blind / 32));
        Assert.That(Number(highest, "range_m"), Is.EqualTo(0.15 / Math.Sqrt(2) - 2 * 7.5e-3).Within(0.01));
    }

    [Test]
    public void Velocity_OfAScene_IsRefused()
    {
        var (code, _, error) = Execute("Scenes/CrossSection.unity", "--pulses", "4", "--velocity", "1,0,0", "--out",
            At("echo"));
        Assert.That(code, Is.EqualTo(2));
        Assert.That(error, Does.Contain("only for mesh files: objects of a scene have a RadarMotion or Rigidbody of "
            + "their own"));
    }
}
