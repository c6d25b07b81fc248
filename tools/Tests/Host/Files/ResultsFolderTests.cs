using System;
using System.Diagnostics;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Disk failures that Linux provides: /dev/full is always full, /proc accepts no files.</summary>
[Platform("Linux")]
public sealed class ResultsFolderTests
{
    [TestCase("results.csv")]
    [TestCase("results.partial")]
    public void Append_DiskFull_NamesTheFileAndLeavesNothing(string full)
    {
        string path = Path.Combine(Path.GetTempPath(), "glint-tests-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(path);
        try
        {
            File.CreateSymbolicLink(Path.Combine(path, full), "/dev/full");
            using var results = ResultsFolder.Open(path);
            results.Begin(new SweepIdentity(), DateTime.UtcNow);
            var error =
                Assert.Throws<GlintException>(
                    () => results.Append(new SweepRow(new SweepPose(0), new RadarResult(new RadarSums()))));
            Assert.That(error.Message, Does.StartWith(Path.Combine(path, "results.csv"))
                .And.Contain("cannot be written").And.Contain("space"));
            Assert.That(Directory.GetFileSystemEntries(path), Is.Empty);
        }
        finally
        {
            Directory.Delete(path, true);
        }
    }

    /// <summary>The shell's flock acts as another process.</summary>
    [Test]
    public void Open_WhileAnotherProcessHasTheLock_IsRefusedAndAfterItsDeathTaken()
    {
        string path = Directory.CreateTempSubdirectory("glint-tests-").FullName;
        try
        {
            var start = new ProcessStartInfo("flock", ["--close", Path.Combine(path, "results.lock"), "sh", "-c",
                "echo held; exec sleep 60"])
            { RedirectStandardOutput = true };
            using var holder = Process.Start(start);
            holder.StandardOutput.ReadLine();
            Assert.That(Assert.Throws<GlintException>(() => ResultsFolder.Open(path)).Message,
                Does.StartWith(path + ": another run is writing"));
            holder.Kill(true);
            holder.WaitForExit();
            ResultsFolder.Open(path).Dispose();
            Assert.That(Directory.GetFileSystemEntries(path), Is.Empty);
        }
        finally
        {
            Directory.Delete(path, true);
        }
    }

    /// <summary>
    /// Unity's Mono knows share modes within its process only. Without file locking .NET knows none, so that only the
    /// lock by bytes is left between the processes.
    /// </summary>
    [TestCase(true)]
    [TestCase(false)]
    public void Open_WhileAProcessWithoutShareModesHasTheFolder_IsRefused(bool otherFirst)
    {
        string path = Directory.CreateTempSubdirectory("glint-tests-").FullName;
        string swept = Path.Combine(path, "swept"), mesh = Path.Combine(path, "plate.obj");
        File.WriteAllText(mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        try
        {
            if (otherFirst)
            {
                using var holder = StartSweep(mesh, "0:90:0.001", swept);
                try
                {
                    while (!holder.HasExited && !File.Exists(Path.Combine(swept, "results.csv")))
                        Thread.Sleep(1);
                    Assert.That(Assert.Throws<GlintException>(() => ResultsFolder.Open(swept)).Message,
                        Does.StartWith(swept + ": another run is writing"));
                }
                finally
                {
                    holder.Kill();
                    holder.WaitForExit();
                }
                ResultsFolder.Open(swept).Dispose();
            }
            else
            {
                using var results = ResultsFolder.Open(swept);
                // A second attempt in the same process takes nothing from the first.
                Assert.Throws<GlintException>(() => ResultsFolder.Open(swept));
                using var other = StartSweep(mesh, "0", swept);
                string error = other.StandardError.ReadToEnd();
                other.WaitForExit();
                Assert.That(other.ExitCode, Is.EqualTo(1), error);
                Assert.That(error, Does.Contain($"glint: {swept}: another run is writing"));
            }
        }
        finally
        {
            Directory.Delete(path, true);
        }
    }

    static Process StartSweep(string mesh, string angles, string folder)
    {
        var start = new ProcessStartInfo("dotnet", [GlintProcess.Program, "sweep", mesh,
            "--angles", angles, "--size", "16x9", "--out", folder])
        { RedirectStandardError = true };
        start.Environment["DOTNET_SYSTEM_IO_DISABLEFILELOCKING"] = "1";
        return Process.Start(start);
    }

    [Test]
    public void Open_ByManyAtOnce_IsGrantedToOneAtATime()
    {
        string path = Path.Combine(Path.GetTempPath(), "glint-tests-" + Guid.NewGuid().ToString("N"));
        int holders = 0, granted = 0, max = 0;
        Directory.CreateDirectory(path);
        Parallel.For(0, 4000, new ParallelOptions { MaxDegreeOfParallelism = 8 }, _ =>
        {
            try
            {
                using var results = ResultsFolder.Open(path);
                int now = Interlocked.Increment(ref holders);
                max = Math.Max(max, now);
                Interlocked.Increment(ref granted);
                Thread.Yield();
                Interlocked.Decrement(ref holders);
            }
            catch (GlintException)
            {
            }
        });
        Assert.That(max, Is.EqualTo(1));
        Assert.That(granted, Is.GreaterThan(1));
        Directory.Delete(path);
    }

    [Test]
    public void Open_WhereNothingCanBeMade_IsRefusedByName()
    {
        var error = Assert.Throws<GlintException>(() => ResultsFolder.Open("/proc/glint/results"));
        Assert.That(error.Message, Does.StartWith("/proc/glint/results: ").And.Contain("/proc takes no folders"));
        Assert.That(error.ExitCode, Is.EqualTo(1));
    }
}
