using System;
using System.IO;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Failures of the disk that only Linux makes at will: /dev/full is always full, /proc takes no files.</summary>
[Platform("Linux")]
public sealed class ResultsFolderTests
{
    [Test]
    public void Append_DiskFull_NamesTheFileAndLeavesNothing()
    {
        string path = Path.Combine(Path.GetTempPath(), "glint-tests-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(path);
        try
        {
            File.CreateSymbolicLink(Path.Combine(path, "results.csv"), "/dev/full");
            using var results = ResultsFolder.Open(path);
            var error = Assert.Throws<GlintException>(() => results.Append(new SweepRow(0, new RadarResult())));
            Assert.That(error.Message, Does.StartWith(Path.Combine(path, "results.csv")).And.Contain("0 rows").And.Contain("space"));
            Assert.That(Directory.GetFileSystemEntries(path), Is.Empty);
        }
        finally
        {
            Directory.Delete(path, true);
        }
    }

    [Test]
    public void Open_WhereNothingCanBeMade_IsRefusedByName()
    {
        var error = Assert.Throws<GlintException>(() => ResultsFolder.Open("/proc/glint/results"));
        Assert.That(error.Message, Does.StartWith("/proc/glint/results: "));
        Assert.That(error.ExitCode, Is.EqualTo(1));
    }
}
