using System;
using System.IO;
using System.Linq;
using System.Threading;
using Glint.Cli;
using Glint.Core;
using Glint.Editor;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>glint bench --sweep with few rays: counts, files, refusals. Times only have to add up.</summary>
[NonParallelizable] // the folder of temporary files belongs to the process
public sealed class SweepBenchTests
{
    static readonly string[] Small =
        ["bench", "--size", "96x54", "--rounds", "1", "--sea-triangles", "2000", "--ship-triangles", "2000"];

    string _folder, _temporary, _before;

    [SetUp]
    public void MakeFolders()
    {
        _folder = Directory.CreateTempSubdirectory("glint-sweep-bench-").FullName;
        _temporary = Directory.CreateDirectory(Path.Combine(_folder, "temporary")).FullName;
        _before = Environment.GetEnvironmentVariable("TMPDIR");
        Environment.SetEnvironmentVariable("TMPDIR", _temporary);
    }

    [TearDown]
    public void RemoveFolders()
    {
        Environment.SetEnvironmentVariable("TMPDIR", _before);
        Directory.Delete(_folder, true);
    }

    [Test]
    public void Sweep_OfTheBuiltInScene_CountsItsRowsAndWork()
    {
        string file = Path.Combine(_folder, "figures.json");
        var (code, output, error) = TestShell.Run([.. Small, "--sweep", "5", "--json", file]);

        Assert.That(code, Is.EqualTo(0), error);
        var figures = JObject.Parse(File.ReadAllText(file));
        double Number(string name) => figures[name].ToObject<double>();
        Assert.That((Number("poses"), Number("rows")), Is.EqualTo((5, 5)));
        Assert.That(Number("round_trips"), Is.EqualTo(1));
        var single = TraceOnce();
        Assert.That(Number("dispatches"), Is.EqualTo(single.Dispatches));
        Assert.That(Number("bytes_read_back"), Is.EqualTo(single.BytesReadBack));
        Assert.That(Number("bytes_uploaded"), Is.GreaterThan(0).And.LessThan(single.BytesUploaded),
            "no pose uploads the BVHs again");
        foreach (string part in new[] { "gather", "dispatch", "wait", "finish", "write", "kernels" })
            Assert.That(Number($"{part}_ms"), Is.GreaterThan(0), part);
        Assert.That(Number("other_ms"), Is.GreaterThanOrEqualTo(0), "no part counts twice");
        Assert.That(Number("wall_over_kernels"), Is.EqualTo(Number("wall_ms") / Number("kernels_ms")).Within(1e-12));
        foreach (string title in new[]
        {
            "sweep of 5 poses", "poses a second", "wall time over kernels", "round trips"
        })
            Assert.That(output, Does.Contain(title));
        Assert.That(Directory.GetFileSystemEntries(_temporary), Is.Empty);
    }

    [Test]
    public void Sweep_OfAMeshFileWithAPeer_GivesItsRatioToTheKernels()
    {
        string plate = Path.Combine(_folder, "plate.obj"), file = Path.Combine(_folder, "figures.json");
        File.WriteAllText(plate, "v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\nf 1 2 3 4\n");
        var (code, _, error) = TestShell.Run("bench", plate, "--grazing", "0", "--fov", "2.29153", "--size", "64x64",
            "--rounds", "2", "--sweep", "3", "--json", file, "--peer", "Plain=test -s {scene} && echo frame 5 ms");

        Assert.That(code, Is.EqualTo(0), error);
        var figures = JObject.Parse(File.ReadAllText(file));
        Assert.That(figures["rows"].ToObject<int>(), Is.EqualTo(3));
        var peer = figures["peers"].Single();
        Assert.That(peer["starts"].ToObject<int>(), Is.EqualTo(2));
        Assert.That(peer["over_pose_gpu"].ToObject<double>(),
            Is.EqualTo(5 / figures["kernels_ms"].ToObject<double>()).Within(1e-9));
        Assert.That(peer["over_pose"].ToObject<double>(),
            Is.EqualTo(5 / figures["wall_ms"].ToObject<double>()).Within(1e-9));
        Assert.That(Directory.GetFileSystemEntries(_temporary), Is.Empty);
    }

    [TestCase("--sweep: must be", "--sweep", "2")]
    [TestCase("--sweep: must be", "--sweep", "100001")]
    [TestCase("--sweep: must be", "--sweep", "many")]
    [TestCase("--sweep: a scene has no target to turn", "Scenes/CornerReflector.unity", "--sweep", "3")]
    [TestCase("--sweep: not with --reference", "--sweep", "3", "--reference", "all")]
    [TestCase("--accuracy: not with --sweep", "--sweep", "3", "--accuracy")]
    public void Sweep_CalledWrongly_IsRefused(string message, params string[] arguments)
    {
        var (code, output, error) = TestShell.Run(["bench", .. arguments]);
        Assert.That(code, Is.EqualTo(2));
        Assert.That(error.Replace($"--sweep {arguments[^1]}:", "--sweep:"), Does.StartWith($"glint: {message}"));
        Assert.That(output, Is.Empty);
    }

    [Test]
    public void Sweep_WhenCancelled_LeavesNoFolder()
    {
        var line = CommandLine.Parse(Commands.Bench, [.. Small[1..], "--sweep", "100000"]);
        Assert.Throws<OperationCanceledException>(() =>
            new BenchCommand(TestShell.Quiet(TextWriter.Null, TextWriter.Null)).Execute(line, new CancelAfterSomePoses()));
        Assert.That(Directory.GetFileSystemEntries(_temporary), Is.Empty);
    }

    static TraceStatistics TraceOnce()
    {
        var loaded = LoadedScene.Open(CommandLine.Parse(Commands.Bench, Small[1..]));
        try
        {
            return loaded.Radar.Trace(RayReadback.None).Statistics;
        }
        finally
        {
            loaded.Radar.Release();
        }
    }

    sealed class CancelAfterSomePoses : IProgressSink
    {
        readonly CancellationTokenSource _source = new();

        public CancellationToken Cancel => _source.Token;

        public void Start(string what, int total, int done = 0) => Assert.That(what, Is.EqualTo("sweeps"));

        public void Report(double value)
        {
            if (value > 1e-5)
                _source.Cancel();
        }

        public void Advance(int done, string note) { }

        public void Finish() { }

        public void Print(string line) { }
    }
}
