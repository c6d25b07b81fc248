using System;
using System.Diagnostics;
using System.IO;
using System.Threading;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests.Mono;

/// <summary>The lock of a results folder between this process of Mono and another, of Mono or of .NET.</summary>
public sealed class FolderLockTests
{
    string _parent, _folder;

    [SetUp]
    public void MakeFolder()
    {
        _parent = Path.Combine(Path.GetTempPath(), "glint-tests-" + Guid.NewGuid().ToString("N"));
        _folder = Path.Combine(_parent, "results");
        Directory.CreateDirectory(_parent);
        File.WriteAllText(Path.Combine(_parent, "plate.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }

    [TearDown]
    public void RemoveFolder() => Directory.Delete(_parent, true);

    [Test]
    public void Open_WhileAnotherProcessHasTheFolder_IsRefusedAndAfterItsDeathNot(
        [Values("mono", "dotnet")] string program)
    {
        using (var holder = Start(program))
        {
            try
            {
                // The byte is written when the lock is held.
                var file = new FileInfo(Path.Combine(_folder, "results.lock"));
                var watch = Stopwatch.StartNew();
                for (file.Refresh(); !file.Exists || file.Length == 0; file.Refresh())
                {
                    Assert.That(holder.HasExited, Is.False, "the other process");
                    Assert.That(watch.Elapsed.TotalSeconds, Is.LessThan(60), "the other process holds nothing");
                    Thread.Sleep(1);
                }
                AssertRefused();
            }
            finally
            {
                if (!holder.HasExited)
                    holder.Kill();
                holder.WaitForExit();
            }
        }
        ResultsFolder.Open(_folder).Dispose();
    }

    [Test]
    public void Open_ByAnotherProcess_WhileThisOneHasTheFolder_IsRefused(
        [Values("mono", "dotnet")] string program)
    {
        using (ResultsFolder.Open(_folder))
        {
            // A second attempt in the same process takes nothing from the first.
            AssertRefused();
            using (var other = Start(program))
            {
                bool ended = other.WaitForExit(60000);
                if (!ended)
                    other.Kill();
                Assert.That(ended, "the other process has the folder too");
                Assert.That(other.StandardError.ReadToEnd(), Does.Contain("another run is writing"));
                Assert.That(other.ExitCode, Is.EqualTo(1));
            }
        }
    }

    void AssertRefused() => Assert.That(
        Assert.Throws<GlintException>(() => ResultsFolder.Open(_folder)).Message,
        Does.StartWith(_folder + ": another run is writing"));

    // Both hold the folder until they are killed: the sweep has 90,001 poses.
    Process Start(string program) => Process.Start(new ProcessStartInfo(program, program == "mono"
        ? $"\"{typeof(FolderLockTests).Assembly.Location}\" --hold \"{_folder}\""
        : $"\"{Environment.GetEnvironmentVariable("GLINT_CLI")}\" sweep \"{_parent}/plate.obj\" "
            + $"--angles 0:90:0.001 --size 16x9 --out \"{_folder}\"")
    {
        UseShellExecute = false, RedirectStandardError = true, RedirectStandardOutput = true
    });
}
