using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Glint.Cli;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>
/// Sweeps that the disk, the device or somebody's editor ends: one line, exit code 1, whole rows kept,
/// and what --resume makes of them.
/// </summary>
[Platform("Linux")]
[Category("Slow")]
public sealed class BrokenSweepTests
{
    const int Poses = 24;

    static readonly string[] s_sweep = ["--angles", "-3:2.75:0.25", "--fov", "2.3", "--size", "100x75"];

    string _folder;

    [SetUp]
    public void MakeCorner()
    {
        _folder = Directory.CreateTempSubdirectory("glint-broken-").FullName;
        File.WriteAllText(Corner, "v 0 0 0\nv -1 0 -1\nv 1 0 -1\nv 0 1.4 0\nf 1 2 3\nf 1 4 2\nf 1 3 4\n");
    }

    [TearDown]
    public void RemoveCorner() => Directory.Delete(_folder, true);

    /// <summary>
    /// A process that may write no file larger than 8 KiB meets what a full disk is, in the middle of a row.
    /// </summary>
    [Test]
    public void Sweep_WhoseDiskIsFull_KeepsItsRowsAndResumes()
    {
        Sweep("whole");
        var start = new ProcessStartInfo("bash", ["-c", "trap '' XFSZ; ulimit -f 8; exec \"$@\"", "bash", "dotnet",
            Path.Combine(AppContext.BaseDirectory, "glint-cli.dll"), "sweep", Corner, .. s_sweep, "--out", At("swept")])
        {
            RedirectStandardOutput = true, RedirectStandardError = true
        };
        // The runtime maps its code from a file of its own otherwise.
        start.Environment["DOTNET_EnableWriteXorExecute"] = "0";
        using var process = Process.Start(start);
        var output = process.StandardOutput.ReadToEndAsync();
        string error = process.StandardError.ReadToEnd();
        process.WaitForExit();

        Assert.That(process.ExitCode, Is.EqualTo(1), error + output.Result);
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
                Does.Contain($" of {Poses} poses are done and kept; the same command with --resume goes on"));
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
        if (content.Length == 0) // ended before the first line was whole
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
        // Rows without results.partial, which a kill does not leave.
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

    // Nothing in the folder is changed by a command that refuses it.
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
