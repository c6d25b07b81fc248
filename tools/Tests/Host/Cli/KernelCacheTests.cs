using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Glint.Host.Tests.Vulkan;
using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>
/// The user's cache folder holds compiled kernels: the driver's own files, and glint's where the driver hands out what
/// it compiled (<see cref="PipelineCacheTests"/>). Every run is a process with a cache folder of the test's.
/// </summary>
[Platform("Linux")]
[Category("Slow")]
public sealed class KernelCacheTests
{
    // Arithmetic, EntryPointsWide, TraceWideSingleInstance, RefineWide, and the four small ones between them.
    const int KernelsOfARun = 8;

    const string Size = "96x54";

    static readonly string Scene = Path.Combine(Sources.Root, "Scenes/CornerReflector.unity");

    string _folder, _figures;

    // Of the last run.
    static string s_error;

    // The folder is empty before this run, whose figures all others have.
    [OneTimeSetUp]
    public void MakeCache()
    {
        _folder = Directory.CreateTempSubdirectory("glint-cache-").FullName;
        _figures = Run(_folder);
        Assert.That(Regex.Matches(s_error, "compiling kernels for .*: the first run on a device takes longer"),
            Has.Count.EqualTo(1), s_error);
    }

    [OneTimeTearDown]
    public void RemoveCache() => Directory.Delete(_folder, true);

    /// <summary>Mesa writes them on a thread of low priority, which may be late.</summary>
    [Test, Order(1)]
    public void Run_OnASoftwareDevice_KeepsAllOfItsKernels()
    {
        string[] cached = CachedFiles();
        if (SoftwareDevice.IsInUse)
            Assert.That(cached, Has.Length.EqualTo(KernelsOfARun));
        Assert.That(Run(_folder), Is.EqualTo(_figures));
        Assert.That(CachedFiles(), Is.EqualTo(cached), "the second run adds none");
        Assert.That(s_error, Does.Not.Contain("compiling"));
    }

    // Mesa 22.3 compiled the kernel of one instance for each rotation (see Bindings.hlsl), which took most of a sweep's time.
    [Test, Order(2)]
    public void Sweep_OfATargetThatTurns_CompilesNoKernelAgain()
    {
        string[] cached = CachedFiles();
        string folder = Directory.CreateTempSubdirectory("glint-sweep-").FullName;
        try
        {
            Start(_folder, "sweep", Scene, "--target", "Corner Reflector", "--angles", "1:3:1", "--size", Size,
                "--out", folder);
        }
        finally
        {
            Directory.Delete(folder, true);
        }
        Assert.That(CachedFiles(), Is.EqualTo(cached));
    }

    [Test]
    public void Run_WithADamagedCache_GivesTheSameFigures()
    {
        // Every other one is changed, and the rest cut off.
        bool isCut = false;
        foreach (string file in CachedFiles())
        {
            byte[] bytes = File.ReadAllBytes(file);
            for (int i = bytes.Length / 2; i < bytes.Length * 3 / 4; i++)
                bytes[i] ^= 0x5a;
            File.WriteAllBytes(file, isCut ? bytes[..100] : bytes);
            isCut = !isCut;
        }
        Assert.That(Run(_folder), Is.EqualTo(_figures));
    }

    [Test]
    public void Run_WithoutAFolderForItsCache_GivesTheSameFigures()
    {
        string file = Path.GetTempFileName();
        try
        {
            Assert.That(Run(file), Is.EqualTo(_figures));
        }
        finally
        {
            File.Delete(file);
        }
    }

    string[] CachedFiles() => Directory.GetFiles(_folder, "*", SearchOption.AllDirectories)
        .Where(file => Path.GetFileName(file) != "index" && Path.GetExtension(file) != PipelineCacheFile.MarkExtension).Order(StringComparer.Ordinal).ToArray();

    static string Run(string cache)
    {
        string output = Start(cache, "run", Scene, "--size", Size);
        // Before the table Mesa may have printed that it has no folder for its cache.
        return output[output.IndexOf("  angle", StringComparison.Ordinal)..];
    }

    /// <summary>The output of the program with these arguments.</summary>
    static string Start(string cache, params string[] arguments)
    {
        var start = GlintProcess.Of(arguments);
        start.Environment["XDG_CACHE_HOME"] = cache;
        (int code, string output, s_error) = GlintProcess.Run(start);
        Assert.That(code, Is.EqualTo(0), s_error);
        return output;
    }
}
