using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Glint.Cli;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>
/// Sweeps that fail because of the disk, the device or an edited file. Each gives one line and exit code 1, keeps
/// whole rows, and resumes correctly with --resume.
/// </summary>
[Platform("Linux")]
[Category("Slow")]
public sealed class BrokenSweepTests
{
    const int Poses = 24;

    static readonly string[] s_sweep = ["--angles", "-3:2.75:0.25", "--fov", "2.3", "--size", "40x30"];

    string _folder;

    [SetUp]
    public void MakeCorner()
    {
        _folder = Directory.CreateTempSubdirectory("glint-broken-").FullName;
        File.WriteAllText(Corner, "v 0 0 0\nv -1 0 -1\nv 1 0 -1\nv 0 1.4 0\nf 1 2 3\nf 1 4 2\nf 1 3 4\n");
    }

    [TearDown]
    public void RemoveCorner() => Directory.Delete(_folder, true);

    /// <summary>A file size limit of 8 KiB acts like a full disk in the middle of a row.</summary>
    [Test]
    public void Sweep_WhoseDiskIsFull_KeepsItsRowsAndResumes()
    {
        Sweep("whole");
        var start = new ProcessStartInfo("bash", ["-c", "trap '' XFSZ; ulimit -f 8; exec \"$@\"", "bash", "dotnet",
            GlintProcess.Program, "sweep", Corner, .. s_sweep, "--out", At("swept")])
        {
            RedirectStandardOutput = true, RedirectStandardError = true
        };
        // Otherwise the runtime maps its code from a file of its own, which the limit would affect.
        start.Environment["DOTNET_EnableWriteXorExecute"] = "0";
        var (code, output, error) = GlintProcess.Run(start);

        Assert.That(code, Is.EqualTo(1), error + output);
        Assert.That(error,
            Does.Contain($"glint: {At("swept")}/results.csv: cannot be written (").And.Contain("free the disk"));
        AssertKeptAndResumed(error);
    }

    [Test]
    public void Sweep_WhoseDeviceGoesAway_KeepsItsRowsAndResumes()
    {
        GraphicsDevice.Close();
        Sweep("whole");
        long batches = GraphicsDevice.Current.Recorder.Batch;
        GraphicsDevice.Current.Recorder.LastBatch = batches + batches / 2;
        try
        {
            var (code, error) = Run("sweep", [Corner, .. s_sweep, "--out", At("swept")]);
            Assert.That(code, Is.EqualTo(1));
            Assert.That(error,
                Does.Contain("glint: could not run ").And.Contain("the device was lost").And.Contain("--resume"));
            Assert.That(error,
                Does.Contain($" of {Poses} poses are done and kept; the same command with --resume continues"));
            AssertKeptAndResumed(error, GraphicsDevice.Close);
        }
        finally
        {
            GraphicsDevice.Close();
        }
    }

    [TestCase("results.partial", "")]
    [TestCase("results.partial", "\n")]
    [TestCase("results.partial", "{}\n")]
    [TestCase("results.partial", "[1,2\n")]
    [TestCase("results.partial", "\0\u0001\u0002\n")]
    [TestCase("results.partial", "FOLDER")]
    public void Resume_OfADamagedUnfinishedSweep_IsRefusedOrBegins(string file, string content)
    {
        Directory.CreateDirectory(At("swept"));
        Damage(file, content);
        if (content.Length == 0) // ended before the first complete line
            Assert.That(Run("sweep", [Corner, .. s_sweep, "--out", At("swept"), "--resume"]).code, Is.Zero);
        else
            AssertRefused(file, "sweep", Corner, [.. s_sweep, "--out", At("swept"), "--resume"]);
    }

    [TestCase("results.json", "")]
    [TestCase("results.json", "{")]
    [TestCase("results.json", "[]")]
    [TestCase("results.json", "null")]
    [TestCase("results.json", "{}")]
    [TestCase("results.json", "{\"rows\":[{\"amplitude\":NaN}],\"settings\":{},\"versions\":{\"glint\":\"0\"}}")]
    [TestCase("results.json", "\0\u0001\u0002")]
    [TestCase("results.json", "FOLDER")]
    public void Results_Damaged_AreRefusedByEveryCommandThatReadsThem(string file, string content)
    {
        Run("sweep", [Corner, "--angles", "0,1", "--size", "4x4", "--shard", "1/2", "--out", At("swept")]);
        Damage(file, content);
        AssertRefused(file, "sweep", Corner,
            ["--angles", "0,1", "--size", "4x4", "--shard", "1/2", "--out", At("swept"), "--resume"]);
        AssertRefused(content == "FOLDER" ? "swept" : file, "merge", At("swept"), ["--out", At("merged")]);
        AssertRefused(content == "FOLDER" ? "swept" : file, "report", At("swept"), ["--pose", "none"]);
    }

    [TestCase("")]
    [TestCase("angle_deg,amplitude\n0,1\n")]
    [TestCase("\0\u0001")]
    [TestCase("FOLDER")]
    public void Resume_WithADamagedCsv_WritesItAnewOrIsRefused(string content)
    {
        Directory.CreateDirectory(At("swept"));
        Sweep("whole");
        GraphicsDevice.Close();
        Run("sweep", [Corner, .. s_sweep, "--out", At("swept"), "--shard", "1/2"]);
        File.Delete(Path.Combine(At("swept"), "results.json"));
        Damage("results.csv", content);
        // Rows without results.partial; a kill does not leave this state.
        AssertRefused("results.csv", "sweep", Corner, [.. s_sweep, "--out", At("swept"), "--shard", "1/2", "--resume"]);
    }

    void AssertKeptAndResumed(string error, Action between = null)
    {
        int kept = File.ReadLines(Path.Combine(At("swept"), "results.csv")).Count() - 1;
        Assert.That(kept, Is.InRange(1, Poses - 1));
        Assert.That(File.ReadAllText(Path.Combine(At("swept"), "results.csv")), Does.EndWith("\n"), "whole rows");
        Assert.That(error, Does.Contain($"{kept} of {Poses} poses are done and kept"));
        between?.Invoke();
        Sweep("swept", "--resume");
        Assert.That(Directory.GetFiles(At("swept")).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "results.csv", "results.json" }));
        Assert.That(Timeless.Csv(At("swept")), Is.EqualTo(Timeless.Csv(At("whole"))));
        Assert.That(Timeless.Json(At("swept")), Is.EqualTo(Timeless.Json(At("whole"))));
    }

    // A refused command leaves the folder unchanged.
    void AssertRefused(string named, string command, string input, string[] options)
    {
        string before = Listing();
        var (code, error) = Run(command, [input, .. options]);
        Assert.That(code, Is.EqualTo(1), error);
        Assert.That(error.Split('\n', StringSplitOptions.RemoveEmptyEntries), Has.Length.EqualTo(1), error);
        Assert.That(error, Does.StartWith("glint: ").And.Contain(named).And.Not.Contain("internal error"));
        Assert.That(Listing(), Is.EqualTo(before), error);
    }

    string Listing() =>
        string.Join("\n", Directory.GetFileSystemEntries(At("swept")).OrderBy(path => path, StringComparer.Ordinal)
            .Select(path => File.Exists(path) ? $"{path} {Convert.ToHexString(File.ReadAllBytes(path))}" : path));

    void Damage(string file, string content)
    {
        string path = Path.Combine(At("swept"), file);
        File.Delete(path);
        if (content == "FOLDER")
            Directory.CreateDirectory(path);
        else
            File.WriteAllText(path, content);
    }

    void Sweep(string folder, params string[] more)
    {
        var (code, error) = Run("sweep", [Corner, .. s_sweep, "--out", At(folder), .. more]);
        Assert.That(code, Is.Zero, error);
    }

    string Corner => At("corner.obj");

    string At(string name) => Path.Combine(_folder, name);

    static (int code, string error) Run(string command, string[] arguments)
    {
        var error = new StringWriter();
        int code = new Shell(new Terminal { Out = TextWriter.Null, Error = error, Live = null, Width = 100 })
            .Run([command, .. arguments]);
        return (code, error.ToString());
    }
}
