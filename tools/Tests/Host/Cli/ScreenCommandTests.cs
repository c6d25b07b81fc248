using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Text.RegularExpressions;
using Glint.Editor;
using Glint.Tests;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>glint ppi: files, radar video, refusals. The scene is the sample with fewer spokes and cells.</summary>
[Category("Slow")]
public sealed class ScreenCommandTests
{
    static readonly string s_root = Project.FindRoot(AppContext.BaseDirectory);

    // _turn: folder of one turn, for all tests that read its files.
    string _folder, _scene, _turn;

    [OneTimeSetUp]
    public void MakeTurn()
    {
        MakeScene();
        _turn = _folder;
        Run("--turns", "1", "--fps", "5", "--asterix", Path.Combine(_turn, "video.ast"), "--detect", "ca",
            "--false-alarm", "1e-4", "--csv");
        RemoveScene();
    }

    [OneTimeTearDown]
    public void RemoveTurn() => Directory.Delete(_turn, true);

    // A turn over a sea takes seconds.
    [SetUp]
    public void MakeSceneWithoutSea()
    {
        MakeScene();
        Write("  _sea: {fileID: 302}", "  _sea: {fileID: 0}");
    }

    void MakeScene()
    {
        _folder = Directory.CreateTempSubdirectory("glint-ppi-").FullName;
        _scene = Path.Combine(s_root, "Scenes", $"Ppi{Guid.NewGuid():N}.unity");
        Write("    Spokes: 4096", "    Spokes: 1024", "    Cells: 1024", "    Cells: 100", "    Side: 1024",
            "    Side: 96", "    RangeScale: 5556", "    RangeScale: 2000", "    PulseNanoseconds: 80",
            "    PulseNanoseconds: 160", "  _motion: 2", "  _motion: 0");
    }

    [TearDown]
    public void Remove()
    {
        Directory.Delete(_folder, true);
        RemoveScene();
    }

    void RemoveScene()
    {
        File.Delete(_scene);
        File.Delete(_scene + ".meta");
    }

    [Test]
    public void Files_HaveTheTurn_AndTheVideoOfAllSpokes()
    {
        var messages = AsterixReader.Read(File.ReadAllBytes(Path.Combine(_turn, "video.ast")));
        // From the heading of 20 degrees on, in clockwise order, each bearing once, and up to two frames of 82.
        Assert.That(messages[0].StartDegrees, Is.EqualTo(20).Within(0.5));
        Assert.That(messages.Count, Is.InRange(1024, 1024 + 2 * 82));
        Assert.That(messages[256].StartDegrees, Is.EqualTo(110).Within(0.5));

        string arrays = Path.Combine(_turn, "video.npz");
        Assert.That(NumpyReader.Read(arrays, "power_dbw").Sizes, Is.EqualTo(new[] { 1024, 100 }));
        double[] shown = NumpyReader.Read(arrays, "video").Numbers;
        int spoke = (int)Math.Round(messages[300].StartDegrees / 360 * 1024 + 0.5);
        for (int cell = 0; cell < 100; cell++)
            Assert.That(messages[300].Cells[cell], Is.EqualTo(255 * shown[spoke * 100 + cell]).Within(0.5001));
        Assert.That(File.ReadAllBytes(Path.Combine(_turn, "picture.png")).Take(4),
            Is.EqualTo(new byte[] { 0x89, 0x50, 0x4E, 0x47 }));
    }

    /// <summary>
    /// Detections are cells of video.npz above the mean of their reference cells, and video.csv has the same numbers. The
    /// brightest cell of the scene's buoys and ships is among them.
    /// </summary>
    [Test]
    public void Detections_AndTheTable_AreThoseOfTheTurn()
    {
        string arrays = Path.Combine(_turn, "video.npz");
        double[] power = NumpyReader.Read(arrays, "power_dbw").Numbers, ranges = NumpyReader.Read(arrays, "range_m").Numbers,
            bearings = NumpyReader.Read(arrays, "bearing_deg").Numbers, video = NumpyReader.Read(arrays, "video").Numbers;
        double noise = NumpyReader.Read(arrays, "noise_dbw").Numbers[0];
        double[][] table = Table("video.csv", "bearing_deg,range_m,power_dbw,video"),
            detections = Table("detections.csv", "bearing_deg,range_m,level_db,over_threshold_db");
        Assert.That(table, Has.Length.EqualTo(1024 * 100));
        for (int i = 0; i < table.Length; i += 33)
        {
            Assert.That(table[i].Take(2), Is.EqualTo(new[] { bearings[i / 100], ranges[i % 100] }));
            Assert.That(table[i][2], Is.EqualTo(power[i]).Within(0.0051));
            Assert.That(table[i][3], Is.EqualTo(video[i]).Within(5.1e-5));
        }
        Assert.That(detections, Is.Not.Empty);
        foreach (double[] detected in detections)
        {
            int spoke = (int)Math.Round(detected[0] / 360 * 1024), cell = (int)(detected[1] / 20);
            Assert.That(detected[2], Is.EqualTo(power[spoke * 100 + cell] - noise).Within(0.0051));
            // Cells are 20 m, and a pulse of 160 ns covers two of them: two are guarded on each side, and of the cells behind
            // every other one is a reference.
            double[] around = Enumerable.Range(0, 100).Where(at => Math.Abs(at - cell) is > 2 and <= 34 && Math.Abs(at - cell) % 2 == 1)
                .Select(at => Math.Pow(10, (power[spoke * 100 + at] - noise) / 10)).ToArray();
            double factor = around.Length * (Math.Pow(1e-4, -1.0 / around.Length) - 1);
            Assert.That(detected[3], Is.EqualTo(detected[2] - 10 * Math.Log10(factor * around.Average())).Within(0.0101));
        }
        Assert.That(detections.Max(detected => detected[2]), Is.EqualTo(power.Max() - noise).Within(0.0051));
        var run = JObject.Parse(File.ReadAllText(Path.Combine(_turn, "results.json")));
        Assert.That(NumpyReader.Read(arrays, "detected").Numbers, Has.Length.EqualTo(detections.Length));
        Assert.That((double)run["settings"]["false_alarm_rate"]["value"], Is.EqualTo(1e-4));
        Assert.That((double)run["settings"]["range_scale"]["value"], Is.EqualTo(2000));
    }

    /// <summary>The report has the turn in bytes: levels over noise in steps that it names, and video; and the detections.</summary>
    [Test]
    public void Report_HasTheTurn()
    {
        Run("--turns", "1", "--fps", "2", "--detect", "os");
        var (code, _, error) = TestShell.Run("report", _folder);
        Assert.That(code, Is.Zero, error);
        string page = File.ReadAllText(Path.Combine(_folder, "report.html"));
        const string start = "<script type=\"application/json\" id=\"data\">";
        int from = page.IndexOf(start) + start.Length;
        var data = JObject.Parse(page[from..page.IndexOf("</script>", from)]);
        Assert.That((string)data["run"]["table"], Is.EqualTo("ppi"));
        var screen = data["screen"];
        Assert.That(((int)screen["spokes"], (int)screen["cells"]), Is.EqualTo((1024, 100)));
        string arrays = Path.Combine(_folder, "video.npz");
        double[] power = NumpyReader.Read(arrays, "power_dbw").Numbers, video = NumpyReader.Read(arrays, "video").Numbers,
            detected = NumpyReader.Read(arrays, "detected").Numbers;
        double noise = NumpyReader.Read(arrays, "noise_dbw").Numbers[0];
        byte[] levels = Convert.FromBase64String((string)screen["levels"]),
            shown = Convert.FromBase64String((string)screen["video"]),
            marks = Convert.FromBase64String((string)screen["detections"]);
        double lowest = (double)screen["lowest_level"], step = (double)screen["level_step"];
        Assert.That(step, Is.LessThan(1));
        for (int i = 0; i < power.Length; i += 7)
        {
            Assert.That(lowest + step * levels[i], Is.EqualTo(power[i] - noise).Within(0.501 * step));
            Assert.That(shown[i] / 255.0, Is.EqualTo(video[i]).Within(0.5001 / 255));
        }
        Assert.That(Enumerable.Range(0, marks.Length / 4).Select(i => (double)BitConverter.ToInt32(marks, 4 * i)),
            Is.EqualTo(detected));
        (code, _, error) = TestShell.Run("report", _folder, "--pose", "1");
        Assert.That((code, error.Trim()),
            Is.EqualTo((1, "glint: --pose 1: a report of glint ppi shows no pose: leave it out")));
    }

    double[][] Table(string name, string header)
    {
        string[] lines = File.ReadAllLines(Path.Combine(_turn, name));
        Assert.That(lines[0], Is.EqualTo(header));
        return [.. lines.Skip(1).Select(line =>
            line.Split(',').Select(cell => double.Parse(cell, CultureInfo.InvariantCulture)).ToArray())];
    }

    /// <summary>The page's example, in Debian's Python.</summary>
    [Test]
    [Platform("Linux")]
    public void PythonExample_OfThePage_ReadsAndPlotsTheFile()
    {
        string output = PythonExample.Run("screen.md", "/usr/bin/python3", _turn);
        Assert.That(output, Does.Match(@"^highest: [5-9]\d\.\d dB at \d+ m, \d+\.\d deg\n$"));
        Assert.That(File.ReadAllBytes(Path.Combine(_turn, "turn.png")).Take(4),
            Is.EqualTo(new byte[] { 0x89, 0x50, 0x4E, 0x47 }));
    }

    [Test]
    public void Video_IsSentByUdp_ToThisMachine()
    {
        using var receiver = new UdpClient(new IPEndPoint(IPAddress.Loopback, 0));
        receiver.Client.ReceiveTimeout = 5000;
        int port = ((IPEndPoint)receiver.Client.LocalEndPoint).Port;
        // A turn takes a quarter of a second. The loopback keeps what its buffer holds: the first datagrams.
        Write("    TurnsAMinute: 24", "    TurnsAMinute: 240");
        var (text, error) = Run("--turns", "1", "--fps", "10", "--udp", $"{port}");
        double seconds = double.Parse(Regex.Match(text, @"1 turn in (\S+) s, 4 frames").Groups[1].Value,
            CultureInfo.InvariantCulture);
        // It is printed in tenths: 0.44 s is the limit.
        Assert.That(error.Contains("not in real time"), Is.EqualTo(seconds > 0.5).Or.EqualTo(seconds > 0.4));
        IPEndPoint from = null;
        var message = AsterixReader.Read(receiver.Receive(ref from)).Single();
        Assert.That((message.Index, message.Cells.Length), Is.EqualTo((0, 100)));
    }

    [Test]
    public void Stream_ThatIsSlowerThanTheClock_IsWarnedOf()
    {
        Assert.That(ScreenCommand.WarningOfDelay("scene", 5.4, 5), Is.Null);
        Assert.That(ScreenCommand.WarningOfDelay("scene", 15.5, 5), Is.EqualTo("scene: the stream was not in real time: it "
            + "took 15.50 s instead of 5.00 s; use a faster device, fewer spokes or cells, or fewer frames a second (--fps)"));
    }

    [TestCase(2, "--udp host:0: give a port from 1 to 65535, or host and port", "--udp", "host:0")]
    [TestCase(1, "UDP: cannot send to 0.0.0.0:4378 (", "--udp", "0.0.0.0:4378")]
    [TestCase(2, "--ttl", "--ttl", "3")]
    [TestCase(2, "--detect go: must be one of ca, os", "--detect", "go")]
    [TestCase(2, "--false-alarm: needs --detect CFAR", "--false-alarm", "1e-3")]
    [TestCase(2, "--turns 0", "--turns", "0")]
    public void Option_ThatIsWrong_IsRefused(int code, string message, params string[] options)
    {
        var (actual, _, error) = TestShell.Run(["ppi", _scene, .. options, "--out", Path.Combine(_folder, "none")]);
        Assert.That(error, Does.Contain(message));
        Assert.That(actual, Is.EqualTo(code));
        Assert.That(Directory.Exists(Path.Combine(_folder, "none")), Is.False);
    }

    [Test]
    public void Files_ThatCannotBeWritten_AreRefusedWithTheirName()
    {
        string video = Path.Combine(_folder, "video.ast"), output = Path.Combine(_folder, "taken");
        Directory.CreateDirectory(video);
        var (code, _, error) = TestShell.Run("ppi", _scene, "--asterix", video, "--out", output);
        Assert.That(error.Trim(), Is.EqualTo($"glint: {video}: is a folder: name a file in it with --asterix"));
        Assert.That((code, Directory.Exists(output)), Is.EqualTo((1, false)));
        Directory.CreateDirectory(Path.Combine(output, "picture.png"));
        (code, _, error) = TestShell.Run("ppi", _scene, "--turns", "1", "--fps", "2", "--out", output);
        Assert.That(error, Does.Contain("picture.png: cannot be written: ").And.Contain("choose another results folder"));
        Assert.That(code, Is.EqualTo(1));
    }

    [Test]
    public void Recording_OfARunThatIsRefusedOrStopped_IsTheOlderOne()
    {
        string video = Path.Combine(_folder, "video.ast"), rows = Path.Combine(_folder, "results.csv");
        byte[] older = [240, 1, 2, 3];
        File.WriteAllBytes(video, older);
        File.WriteAllText(rows, "");
        string[] line = [_scene, "--turns", "1", "--fps", "5", "--asterix", video, "--out", _folder];
        var (code, _, error) = TestShell.Run(["ppi", .. line]);
        Assert.That(error, Does.Contain("holds results.csv"));
        Assert.That((code, File.ReadAllBytes(video)), Is.EqualTo((1, older)));

        File.Delete(rows);
        Assert.That(Batch.Execute(CommandLine.Parse(Commands.Ppi, line), new CancelAfter(2)), Is.EqualTo(Batch.Cancelled));
        Assert.That(Directory.GetFiles(_folder), Is.EqualTo(new[] { video }));
        Assert.That(File.ReadAllBytes(video), Is.EqualTo(older));
    }

    [Test]
    public void Recording_InPlaceOfTheScene_OrOfAnotherFile_IsRefusedBeforeWork()
    {
        string scene = File.ReadAllText(_scene), output = Path.Combine(_folder, "none");
        var (code, _, error) = TestShell.Run("ppi", _scene, "--asterix", _scene, "--out", output);
        Assert.That((code, error.Trim()), Is.EqualTo((1, $"glint: {_scene}: is there, and is no radar video that could be "
            + "replaced: name another file with --asterix")));
        Assert.That((File.ReadAllText(_scene), Directory.Exists(output)), Is.EqualTo((scene, false)));
    }

    [TestCase("picture.png")]
    [TestCase("results.json")]
    [TestCase("video.npz")]
    [TestCase("video.csv")]
    [TestCase("detections.csv")]
    public void Recording_InPlaceOfAFileOfTheResults_IsRefused(string name)
    {
        string path = Path.Combine(_folder, name);
        var (code, _, error) = TestShell.Run("ppi", _scene, "--asterix", path, "--out", _folder);
        Assert.That((code, error.Trim()), Is.EqualTo((2, $"glint: --asterix {path}: is a file of the results: name "
            + "another one (see glint ppi --help)")));
        Assert.That(Directory.GetFiles(_folder), Is.Empty);
    }

    [Test]
    public void Turn_WhosePictureCannotBeWritten_LeavesNoFileOfTheTurnBefore()
    {
        foreach (string name in new[] { "picture.png", "video.npz", "results.json" })
            File.WriteAllText(Path.Combine(_folder, name), "older");
        Directory.CreateDirectory(Path.Combine(_folder, "picture.png.tmp"));
        var (code, _, error) = TestShell.Run("ppi", _scene, "--turns", "1", "--fps", "2", "--out", _folder);
        Assert.That(error, Does.Contain("picture.png: cannot be written: ").And.Contain("choose another results folder"));
        Assert.That(code, Is.EqualTo(1));
        Assert.That(Directory.GetFiles(_folder), Is.Empty);
    }

    // A file that another program keeps open is no more deleted than a folder.
    [Test]
    public void FilesOfARunBefore_ThatCannotBeDeleted_AreRefusedWithTheirName()
    {
        Directory.CreateDirectory(Path.Combine(_folder, "detections.csv"));
        var (code, _, error) = TestShell.Run("ppi", _scene, "--turns", "1", "--fps", "2", "--out", _folder);
        Assert.That(error, Does.Contain("detections.csv: cannot be written: ").And.Contain("choose another results folder"));
        Assert.That(code, Is.EqualTo(1));
    }

    [Test]
    public void Picture_OfADeviceWithoutReadback_IsThatOfTheProcessor()
    {
        GraphicsDevice.HasAsyncReadback = false;
        try
        {
            Run("--turns", "1", "--fps", "2");
        }
        finally
        {
            GraphicsDevice.HasAsyncReadback = true;
        }
        Assert.That(new FileInfo(Path.Combine(_folder, "picture.png")).Length, Is.GreaterThan(96));
    }

    [Test]
    public void RangeScale_BeyondTheUnambiguousRange_IsRefused()
    {
        Write("    TurnsAMinute: 24", "    TurnsAMinute: 24\n    PulseRate: 5e5");
        var (code, _, error) = TestShell.Run("ppi", _scene, "--out", Path.Combine(_folder, "none"));
        Assert.That(error, Does.StartWith("glint: RadarScreen of 'Radar': at a pulse rate of 500000 Hz the next pulse leaves "
            + "before echoes from beyond 300 m are back"));
        Assert.That(code, Is.EqualTo(1));
    }

    [Test]
    public void FrameRate_BelowTwoFramesATurn_IsRefused()
    {
        Write("    TurnsAMinute: 24", "    TurnsAMinute: 60");
        var (code, _, error) = TestShell.Run("ppi", _scene, "--fps", "1", "--out", Path.Combine(_folder, "none"));
        Assert.That((code, error.Trim()), Is.EqualTo((1, "glint: 'Radar' turns 60 times a minute, and a frame shows half "
            + "a turn at most: give at least 2 for --fps")));
    }

    [Test]
    public void Scene_WithoutAScreen_OrWithAWrongOne_IsRefusedBeforeFilesAreMade()
    {
        string output = Path.Combine(_folder, "none");
        var (code, _, error) = TestShell.Run("ppi", "Scenes/SeaState5.unity", "--out", output);
        Assert.That((code, error.Trim()), Is.EqualTo((1, "glint: Scenes/SeaState5.unity: has no radar screen; add a "
            + "RadarScreen (Glint > Radar Screen) to an object of the scene")));
        Write("    Frequency: 9410000000", "    Frequency: 0");
        (code, _, error) = TestShell.Run("ppi", _scene, "--out", output);
        Assert.That(error, Does.StartWith("glint: RadarScreen of 'Radar': frequency 0 Hz must be from"));
        Assert.That(code, Is.EqualTo(1));
        Assert.That(Directory.Exists(output), Is.False);
    }

    void Write(params string[] changes)
    {
        string text = File.ReadAllText(File.Exists(_scene) ? _scene
            : Path.Combine(s_root, "Scenes", "HarbourApproach.unity"));
        for (int i = 0; i < changes.Length; i += 2)
        {
            Assert.That(text, Does.Contain(changes[i]));
            text = text.Replace(changes[i], changes[i + 1]);
        }
        File.WriteAllText(_scene, text);
    }

    (string text, string error) Run(params string[] options)
    {
        var (code, text, error) = TestShell.Run(["ppi", _scene, .. options, "--out", _folder]);
        Assert.That(code, Is.Zero, error);
        Assert.That(text, Does.Contain("main thread").And.Contain("kernels on the device"));
        return (text, error);
    }
}
