using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading;
using Glint.Cli;
using Glint.Core;
using Glint.Editor;
using Glint.Reference;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>glint bench with few rays: figures, files, refusals. Times are not tested.</summary>
[Category("Slow")]
public sealed class BenchTests
{
    static readonly string[] Small =
        ["bench", "--size", "96x54", "--rounds", "1", "--sea-triangles", "2000", "--ship-triangles", "2000"];

    string _folder;

    [SetUp] public void MakeFolder() => _folder = Directory.CreateTempSubdirectory("glint-bench-").FullName;

    [TearDown] public void RemoveFolder() => Directory.Delete(_folder, true);

    [Test]
    public void Bench_OfTheBuiltInScene_WritesItsFigures()
    {
        string file = Path.Combine(_folder, "figures.json");
        var (code, output, error) = TestShell.Run([.. Small, "--json", file]);

        Assert.That(code, Is.EqualTo(0), error);
        var figures = JObject.Parse(File.ReadAllText(file));
        long Number(string name) => figures[name].ToObject<long>();
        foreach (string time in new[]
        {
            "pose_ms", "pose_lowest_ms", "pose_gpu_ms", "trace_ms", "build_ms", "upload_ms", "readback_ms", "gather_ms",
            "first_pose_ms"
        })
            Assert.That(figures[time].ToObject<double>(), Is.GreaterThan(0).And.LessThan(60000), time);
        Assert.That(figures["device"].ToString(), Is.EqualTo(GraphicsDevice.Current.Info.Name));
        Assert.That(Number("rays_emitted"), Is.EqualTo(96 * 54));
        Assert.That(Number("rays_hit"), Is.InRange(96 * 54 / 3, 96 * 54));
        Assert.That(Number("segments"), Is.EqualTo(Number("rays_emitted") + Number("bounces")));
        Assert.That(Number("triangles"), Is.EqualTo(
            new SeaAndShip(1, 2000, 2000) is var scene ? scene.Sea.TriangleCount + scene.Ship.TriangleCount : 0));
        foreach (string work in new[]
        {
            "nodes_visited", "pairs_tested", "tiles_traced", "dispatches", "first_bytes_uploaded", "bytes_read_back",
            "bytes_on_device", "trees_built"
        })
            Assert.That(Number(work), Is.GreaterThan(0), work);
        Assert.That(figures["errors"]["rays_judged"].ToObject<int>(), Is.EqualTo(96 * 54));
        Assert.That(figures["errors"]["rays_hit"].ToObject<int>(), Is.InRange(-1, 1));
        Assert.That(figures["errors"]["path_length_relative"].ToObject<double>(), Is.EqualTo(0).Within(1e-3));
        Assert.That(figures["peers"], Is.Empty);
        foreach (string title in new[]
        {
            "next pose", "kernels", "nodes visited", "bytes read back", "5,184 rays compared"
        })
            Assert.That(output, Does.Contain(title));
    }

    [Test]
    public void Bench_OfFacets_TimesTheirEchoBesideTheRays()
    {
        string file = Path.Combine(_folder, "figures.json");
        var (code, output, error) = TestShell.Run([.. Small, "--reference", "none", "--facets", "800", "--json", file]);

        Assert.That(code, Is.EqualTo(0), error);
        Assert.That(output, Does.Contain("diffuse echo of the sea").And.Contain("rays without clutter"));
        var figures = JObject.Parse(File.ReadAllText(file));
        Assert.That(figures["rays_gpu_ms"].ToObject<double>(), Is.GreaterThan(0));
        Assert.That(figures["clutter"].Select(row => row["facets"].ToObject<int>()), Is.All.EqualTo(800));
        var lit = figures["clutter"].Select(row => row["lit_fraction"].ToObject<double>()).ToArray();
        Assert.That(lit, Is.Ordered.And.All.GreaterThan(0).And.All.LessThanOrEqualTo(1));
        Assert.That(figures["clutter"].Select(row => row["sum_gpu_ms"].ToObject<double>()), Is.All.GreaterThan(0));
    }

    // A square plate of side a has 4 pi (a^2 cos / lambda)^2 (sin x / x)^2, x = k a sin.
    [Test]
    public void Bench_OfCrossSections_ComparesRaysOfTubesAndPoints()
    {
        string plate = Path.Combine(_folder, "plate.obj"), file = Path.Combine(_folder, "figures.json");
        File.WriteAllText(plate, "v -0.25 -0.25 0\nv 0.25 -0.25 0\nv 0.25 0.25 0\nv -0.25 0.25 0\nf 1 2 3 4\n");
        var (code, output, error) = TestShell.Run("bench", plate, "--rcs", "20", "--grazing", "0", "--frequency", "3e9",
            "--rounds", "1", "--json", file);

        Assert.That(code, Is.EqualTo(0), error);
        var row = JObject.Parse(File.ReadAllText(file))["directions"].Single();
        double angle = Math.PI / 9, wavelength = 299792458 / 3e9, x = 2 * Math.PI / wavelength * 0.5 * Math.Sin(angle);
        double sigma = 4 * Math.PI * Math.Pow(0.25 * Math.Cos(angle) / wavelength * Math.Sin(x) / x, 2);
        Assert.That(row["vv_dbsm"].ToObject<double>(), Is.EqualTo(10 * Math.Log10(sigma)).Within(0.1));
        Assert.That(row["is_reached"].ToObject<bool>());
        Assert.That(row["tubes"].Last["error_db_95"].ToObject<double>(), Is.LessThan(0.1));
        var points = row["points"].ToArray();
        Assert.That(points.Select(point => point["across_side"].ToObject<int>()), Does.Contain(10).And.Ordered);
        double ratio = points[1]["rays"].ToObject<double>() / points[0]["rays"].ToObject<double>();
        Assert.That(ratio, Is.EqualTo(9.0 / 4).Within(1).Percent, "2 and 3 points along a side");
        Assert.That(points[0]["error_db_95"].ToObject<double>(), Is.GreaterThan(0.1));
        Assert.That(points[^1]["error_db_95"].ToObject<double>(), Is.LessThan(0.1));
        Assert.That(output, Does.Contain("plate.obj").And.Contain("ratio"));
    }

    // The scene of state 5 with a tile of few facets, at a frequency of few tubes.
    [Test]
    public void Bench_OfASceneWithClutter_TimesTheEchoOfItsPicture()
    {
        string root = Project.FindRoot(AppContext.BaseDirectory), file = Path.Combine(_folder, "figures.json"),
            text = Regex.Replace(File.ReadAllText(Path.Combine(root, "Scenes/SeaState5.unity")),
                @"_snapshots:\n(  - .*\n)+", "_snapshots: []\n");
        foreach (var (before, after) in new[]
            {
                ("GridSize: 64", "GridSize: 16"), ("    Cells: 94", "    Cells: 16"),
                ("_extent: {x: 64, y: 128}", "_extent: {x: 64, y: 64}")
            })
        {
            Assert.That(text, Does.Contain(before));
            text = text.Replace(before, after);
        }
        using var scene = new TemporaryScene(text);
        var (code, _, error) = TestShell.Run("bench", scene.Path, "--clutter", "on", "--size", "96x54",
            "--frequency", "1e9", "--rounds", "1", "--reference", "none", "--json", file);
        Assert.That(code, Is.EqualTo(0), error);
        var row = JObject.Parse(File.ReadAllText(file))["clutter"].Single();
        Assert.That(row["facets"].ToObject<int>(), Is.EqualTo(2 * 16 * 16));
        Assert.That(row["lit_fraction"].ToObject<double>(), Is.GreaterThan(0).And.LessThanOrEqualTo(1));
        Assert.That(row["sum_gpu_ms"].ToObject<double>(), Is.GreaterThan(0));
    }

    // The reference tracer traces the same rays, so the sums differ only by rounding.
    [Test]
    public void Bench_ComparingEverySeventhRayOfARegion_ComparesThose()
    {
        string file = Path.Combine(_folder, "figures.json");
        var (code, _, error) = TestShell.Run([.. Small, "--region", "11,5,60,40", "--reference", "7", "--json", file]);

        Assert.That(code, Is.EqualTo(0), error);
        var figures = JObject.Parse(File.ReadAllText(file));
        int expected = Enumerable.Range(5, 40).Sum(y => Enumerable.Range(11, 60).Count(x => (y * 96 + x) % 7 == 0));
        Assert.That(figures["errors"]["rays_judged"].ToObject<int>(), Is.EqualTo(expected));
        Assert.That(figures["errors"]["rays_hit_judge"].ToObject<int>(), Is.GreaterThan(expected / 4));
        Assert.That(figures["errors"]["rays_hit"].ToObject<int>(), Is.InRange(-1, 1));
        Assert.That(figures["rays_emitted"].ToObject<int>(), Is.EqualTo(60 * 40));
        Assert.That(figures["settings"]["region"].Select(number => number.ToObject<int>()),
            Is.EqualTo(new[] { 11, 5, 60, 40 }));
    }

    [Test]
    public void Bench_OfAMeshFileWithPeers_HandsThemTheScene()
    {
        string plate = Path.Combine(_folder, "plate.obj"), scene = Path.Combine(_folder, "it's a scene.bin"),
            file = Path.Combine(_folder, "figures.json");
        File.WriteAllText(plate, "v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\nf 1 2 3 4\n");
        var (code, output, error) = TestShell.Run("bench", plate, "--grazing", "0", "--fov", "2.29153", "--size", "64x64",
            "--rounds", "2", "--reference", "none",
            "--write-scene", scene, "--json", file, "--peer", "Bytes=echo size $(wc -c < {scene}) ms", "--peer",
            "Fixed=printf 'build 7 ms\\nframe 5 ms\\nframe 6 ms\\n'");

        Assert.That(code, Is.EqualTo(0), error);
        const int bytes = 8 + 4 * 12 + 2 * 12;
        Assert.That(new FileInfo(scene).Length, Is.EqualTo(bytes));
        var figures = JObject.Parse(File.ReadAllText(file));
        Assert.That(figures["rays_received"].ToObject<int>(), Is.EqualTo(1024));
        Assert.That(figures["errors"].Type, Is.EqualTo(JTokenType.Null));
        var peers = figures["peers"].Select(peer => (peer["name"].ToString(), peer["time"].ToString(),
            peer["median_ms"].ToObject<double>(), peer["starts"].ToObject<int>()));
        Assert.That(peers, Is.EqualTo(
            new[] { ("Bytes", "size", (double)bytes, 2), ("Fixed", "build", 7.0, 2), ("Fixed", "frame", 5.5, 2) }));
        Assert.That(output, Does.Contain("Fixed ended with: frame 6 ms").And.Contain($"written: {scene}"));
    }

    [Test]
    public void Bench_WithAPeerOnly_LeavesNoSceneBehind()
    {
        string path = Path.Combine(_folder, "path");
        var (code, _, error) =
            TestShell.Run([.. Small, "--reference", "none", "--peer", $"P=echo {{scene}} > {path}; echo frame 1 ms"]);

        Assert.That(code, Is.EqualTo(0), error);
        string scene = File.ReadAllText(path).Trim();
        Assert.That(scene, Does.EndWith(".bin"));
        Assert.That(File.Exists(scene), Is.False);
    }

    [Test]
    public void Bench_WhosePeerFails_FailsInOneLine()
    {
        var (code, output, error) = TestShell.Run([.. Small, "--peer", "Broken=echo out of luck; exit 9"]);

        Assert.That(code, Is.EqualTo(1));
        Assert.That(error.TrimEnd().Split('\n')[^1].TrimEnd(),
            Is.EqualTo("glint: --peer Broken: ended with exit code 9: out of luck"));
        Assert.That(output, Is.Empty);
    }

    [TestCase("--json")]
    [TestCase("--write-scene")]
    public void Bench_OfAFileThatCannotBeWritten_IsRefusedBeforeTheWork(string flag)
    {
        string file = Path.Combine(_folder, "none", "x");
        var (code, _, error) = TestShell.Run("bench", flag, file);

        Assert.That(code, Is.EqualTo(1));
        Assert.That(error, Does.StartWith($"glint: {flag} {file}: cannot be written").And.Contain("name another file"));
    }

    [Test]
    public void Bench_WhenCancelled_StopsAndLeavesNoFile()
    {
        string file = Path.Combine(_folder, "figures.json");
        var line = CommandLine.Parse(Commands.Bench, [.. Small[1..], "--json", file, "--peer", "Sleeper=sleep 60"]);
        var progress = new CancelInTheFirstRound();

        Assert.Throws<OperationCanceledException>(() => new BenchCommand(TestShell.Quiet(TextWriter.Null, TextWriter.Null))
            .Execute(line, progress));
        Assert.That(File.Exists(file), Is.False);
    }

    [Test]
    public void Table_OnAScreen_IsFramed()
    {
        var output = new StringWriter();
        var terminal =
            new Terminal { Out = output, Error = TextWriter.Null, Live = null, Width = 100, SharesScreen = true };
        Assert.That(new Shell(terminal).Run([.. Small, "--reference", "none"]), Is.EqualTo(0));
        Assert.That(output.ToString(), Does.Contain("│ rays hit").And.Contain("╭"));
    }

    sealed class CancelInTheFirstRound : IProgressSink
    {
        readonly CancellationTokenSource _source = new();

        public CancellationToken Cancel => _source.Token;

        public void Start(string what, int total, int done = 0)
        {
            if (what == "poses and peers")
                _source.CancelAfter(500);
        }

        public void Report(double value) { }

        public void Advance(int done, string note) { }

        public void Finish() { }

        public void Print(string line) { }
    }
}
