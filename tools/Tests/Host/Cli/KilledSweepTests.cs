using System;
using System.IO;
using System.Linq;
using Glint.Cli;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>glint sweep in its own process, killed; and the merge of its parts.</summary>
[Platform("Linux")]
[Category("Slow")]
public sealed class KilledSweepTests
{
    const int Poses = 11 * 2 * 2;

    static readonly string[] s_sweep =
        ["--angles", "-3:2:0.5", "--grazing", "0,0.5", "--frequency", "9e9,10e9", "--fov", "2.3"];

    string _folder;

    [SetUp]
    public void MakeCorner()
    {
        _folder = Directory.CreateTempSubdirectory("glint-killed-").FullName;
        File.WriteAllText(Corner, "v 0 0 0\nv -1 0 -1\nv 1 0 -1\nv 0 1.4 0\nf 1 2 3\nf 1 4 2\nf 1 3 4\n");
    }

    [TearDown]
    public void RemoveCorner() => Directory.Delete(_folder, true);

    /// <summary>
    /// The process is killed when results.partial has a certain number of bytes, so that the speed of the machine does
    /// not matter.
    /// </summary>
    [Test]
    public void Sweep_KilledTwice_ResumesToTheFilesOfAnUndisturbedOne()
    {
        // The process is to be killed before its end: a pose takes longer than the time between two looks at the file.
        string[] size = ["--size", "200x150"];
        Run(["sweep", Corner, .. s_sweep, .. size, "--out", At("whole")]);
        int seed = Environment.TickCount;
        var random = new Random(seed);
        foreach (int from in new[] { 500, 15000 })
            GlintProcess.KillAt(At("killed/results.partial"), from + random.Next(12000),
                ["sweep", Corner, .. s_sweep, .. size, "--out", At("killed"), "--resume"]);

        Assert.That(File.Exists(Path.Combine(At("killed"), "results.partial")), "killed before its end");
        string output = Run(["sweep", Corner, .. s_sweep, .. size, "--out", At("killed"), "--resume"]);
        Assert.That(output, Does.Match($"resumed: [0-9]+ of {Poses} poses are done"));
        AssertSame("killed", $"seed {seed}");
    }

    [Test]
    public void Sweep_InParts_MergesToTheFilesOfAnUndividedOne()
    {
        string[] sweep = ["sweep", Corner, .. s_sweep, "--size", "40x30", "--out"];
        Run([.. sweep, At("whole")]);
        for (int number = 1; number <= 3; number++)
            Run([.. sweep, At($"{number}"), "--shard", $"{number}/3"]);
        Run(["merge", At("3"), At("1"), At("2"), "--out", At("merged")]);
        AssertSame("merged", "three parts");
    }

    /// <summary>
    /// Preceding snapshots and radar positions decide how a scene is divided; a part lacks those before its own.
    /// </summary>
    [Test]
    public void Sweep_OverASeaInParts_MergesToTheFilesOfAnUndividedOne()
    {
        string[] sweep = ["sweep", "Scenes/SeaState6.unity", "--target", "Sea", "--snapshots", "2,1,4,3",
            "--grazing", "15,20", "--size", "64x36", "--out"];
        Run([.. sweep, At("whole")]);
        Run([.. sweep, At("1"), "--shard", "1/2"]);
        Run([.. sweep, At("2"), "--shard", "2/2"]);
        Run(["merge", At("1"), At("2"), "--out", At("merged")]);
        Assert.That(Timeless.Csv(At("merged")), Is.EqualTo(Timeless.Csv(At("whole"))));
        Assert.That(Timeless.Json(At("merged")), Is.EqualTo(Timeless.Json(At("whole"))));
    }

    [Test]
    public void Sweep_OfAMeshThatChanged_IsNotResumed()
    {
        string[] sweep = ["sweep", Corner, "--angles", "0,1", "--size", "16x9", "--out", At("swept"), "--resume"];
        Run(sweep);
        Assert.That(Run(sweep), Does.Contain("already complete"));
        File.WriteAllText(Corner, File.ReadAllText(Corner).Replace("1.4", "1.5"));
        var (code, _, error) = Execute(sweep);
        Assert.That(code, Is.EqualTo(1));
        Assert.That(error, Does.StartWith($"glint: {At("swept")}/results.json: is of another sweep: the meshes, "
            + "places or materials of the scene are others (content was "));
    }

    [TestCase("--shard 3/3: the sweep has 2 poses", "--shard", "3/3")]
    [TestCase("--resume yes: takes no value", "--resume=yes")]
    public void Sweep_InAPartOrResumedWrongly_ExitsWithTwo(string message, params string[] options)
    {
        var (code, _, error) = Execute(["sweep", Corner, "--angles", "0,1", .. options]);
        Assert.That(code, Is.EqualTo(2));
        Assert.That(error,
            Does.StartWith("glint: " + message).And.EndsWith("(see glint sweep --help)" + Environment.NewLine));
    }

    void AssertSame(string folder, string message)
    {
        Assert.That(Directory.GetFiles(At(folder)).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "results.csv", "results.json" }), message);
        Assert.That(Timeless.Csv(At(folder)), Is.EqualTo(Timeless.Csv(At("whole"))), message);
        Assert.That(Timeless.Json(At(folder)), Is.EqualTo(Timeless.Json(At("whole"))), message);
        Assert.That(Timeless.Csv(At("whole")).Split('\n').Length, Is.EqualTo(Poses + 2));
    }

    string Corner => At("corner.obj");

    string At(string name) => Path.Combine(_folder, name);

    static string Run(string[] arguments)
    {
        var (code, output, error) = Execute(arguments);
        Assert.That(code, Is.Zero, error);
        return output;
    }

    static (int code, string output, string error) Execute(string[] arguments)
    {
        var (output, error) = (new StringWriter(), new StringWriter());
        int code = new Shell(new Terminal { Out = output, Error = error, Live = null, Width = 100 }).Run(arguments);
        return (code, output.ToString(), error.ToString());
    }
}
