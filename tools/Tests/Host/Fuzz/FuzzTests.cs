using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;
using System.Threading;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>
/// Damaged scenes, prefabs, assets, .meta files, settings, meshes and command lines. Each is loaded, read or traced,
/// or refused in one line that names the file or the object. Everything else is a finding: another exception, a crash,
/// more than 10 s, unbounded memory, or numbers that are not finite.
/// A case is defined by its seed and number. GLINT_FUZZ_MINUTES=60 runs for an hour, GLINT_FUZZ_SEED=7 uses other
/// cases, and GLINT_FUZZ_CASE=1234 runs one case and leaves its damaged files in the temporary folder. Counts by
/// verdict are printed every minute and at the end.
/// </summary>
[Category("Slow")]
public sealed partial class FuzzTests
{
    const int StandardSeed = 1, StandardCases = 5000, MaxFindings = 50, HangSeconds = 60;
    const long MaxBytes = 300_000_000;
    static readonly TimeSpan LongestCase = TimeSpan.FromSeconds(10);

    readonly SortedDictionary<string, int> _counts = new(StringComparer.Ordinal);
    readonly Dictionary<string, string> _findings = [];
    readonly Stopwatch _case = new();
    SceneCases _scenes;
    int _number;

    [Test]
    public void DamagedInput_OfAnyKind_IsTakenOrRefusedInOneClearLine()
    {
        int seed = Variable("GLINT_FUZZ_SEED") ?? StandardSeed;
        int? minutes = Variable("GLINT_FUZZ_MINUTES"), only = Variable("GLINT_FUZZ_CASE");
        var (first, end) =
            only is int number ? (number, number + 1) : (0, minutes == null ? StandardCases : int.MaxValue);
        var time = minutes is int given ? TimeSpan.FromMinutes(given) : TimeSpan.MaxValue;
        string kept = only == null ? null : Directory.CreateTempSubdirectory("glint-fuzz-").FullName;
        using (_scenes = new SceneCases(Project.FindRoot(ThisFolder()), kept))
        {
            var worker = new Thread(() => RunAll(seed, first, end, time)) { IsBackground = true };
            worker.Start();
            // Seconds are counted, not measured: a suspended computer is not a hang.
            for (int seconds = 1, watched = -1, since = 0; !worker.Join(1000); seconds++)
            {
                if (_number != watched)
                    (watched, since) = (_number, seconds);
                if (seconds - since > HangSeconds)
                    Assert.Fail($"seed {seed}, case {_number}: does not end; {Counts()}");
                if (seconds % 60 == 0)
                    TestContext.Error.WriteLine($"seed {seed}, {seconds / 60} min: {Counts()}");
            }
        }
        TestContext.Error.WriteLine($"seed {seed}: {Counts()}");
        Assert.That(_findings.Count, Is.Zero, string.Join("\n\n", _findings.Values));
    }

    void RunAll(int seed, int first, int end, TimeSpan time)
    {
        var watch = Stopwatch.StartNew();
        for (_number = first; _number < end && watch.Elapsed < time && _findings.Count < MaxFindings; _number++)
        {
            var (kind, outcome) = Run(seed, _number);
            string count = $"{kind} {outcome.Verdict.ToString().ToLowerInvariant()}";
            lock (_counts)
                _counts[count] = _counts.GetValueOrDefault(count) + 1;
            string finding = $"seed {seed}, case {_number}: {kind}: {outcome.Text}";
            if (outcome.Verdict == Verdict.Finding && _findings.TryAdd(Varying().Replace(outcome.Text, "#"), finding))
                TestContext.Error.WriteLine(finding);
        }
    }

    (string Kind, Outcome Outcome) Run(int seed, int number)
    {
        var (kind, outcome, time) = Try(seed, number);
        // A case that took long is repeated, since the computer may have been busy.
        if (time > LongestCase)
            (kind, outcome, time) = Try(seed, number);
        return (kind, outcome.Verdict == Verdict.Finding || time <= LongestCase
            ? outcome
            : Outcome.Finding($"took {time.TotalSeconds} s"));
    }

    (string Kind, Outcome Outcome, TimeSpan Time) Try(int seed, int number)
    {
        var random = RandomOf(seed, number);
        var (kind, run) = random.Next(1000) switch
        {
            0 => ("process", (Func<Random, Outcome>)_scenes.Start),
            < 20 => ("trace", _scenes.Trace),
            < 180 => ("load", _scenes.Load),
            < 400 => ("line", LineCases.Parse),
            _ => ("mesh", MeshCases.Read)
        };
        long bytes = GC.GetAllocatedBytesForCurrentThread();
        _case.Restart();
        var outcome = Outcome.Of(() => run(random), []);
        bytes = GC.GetAllocatedBytesForCurrentThread() - bytes;
        return (kind,
            bytes <= MaxBytes || outcome.Verdict == Verdict.Finding ? outcome : Outcome.Finding($"took {bytes} bytes"),
            _case.Elapsed);
    }

    // The bits are mixed first, since System.Random gives similar numbers for neighbouring seeds.
    static Random RandomOf(int seed, int number)
    {
        ulong bits = (ulong)(uint)seed << 32 | (uint)number;
        bits = (bits ^ bits >> 33) * 0xff51afd7ed558ccd;
        bits = (bits ^ bits >> 33) * 0xc4ceb9fe1a85ec53;
        return new Random((int)(bits ^ bits >> 33));
    }

    string Counts()
    {
        lock (_counts)
            return $"{_counts.Values.Sum()} cases: "
                + $"{string.Join(", ", _counts.Select(count => $"{count.Key} {count.Value}"))}";
    }

    static int? Variable(string name) =>
        Environment.GetEnvironmentVariable(name) is { Length: > 0 } text ? int.Parse(text) : null;

    // Findings that differ only in these are reported once.
    [GeneratedRegex(@"(?<!\w)[\w.\\-]*\d[\w.]*|'[^']*'|""[^""]*""|/tmp\S*")]
    private static partial Regex Varying();

    static string ThisFolder([CallerFilePath] string file = null) => Path.GetDirectoryName(file);
}
