using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Cli;
using Glint.Editor;

namespace Glint.Host.Tests;

/// <summary>Command lines of known and unknown words, read by both parsers but not executed.</summary>
static class LineCases
{
    static readonly string[] Values =
    [
        "", " ", "-", "--", "=", "0", "1", "-1", "-0", "2", "16", "17", "0.5", "1e-6", "1e6", "1e7", "1e400",
        "-1e400", "1e-400", "nan", "NaN", "inf", "Infinity", "∞", "１２", "0x10", "1_000",
        "1,000", " 3 ", "3\n", "+5", "5e", ".", "1.", ".1",
        "64x64", "1X1", "0x0", "524280x524280", "524281x1", "9999999999x1", "x", "1x", "x1", "1x2x3", "-1x-1", "3x3",
        "0,0,0", "1,2", "1,2,3", "1,2,3,4", "1,2,3,4,5", "-1,-2,-3,-4", "0,0,1,1",
        "2147483647,2147483647,2147483647,2147483647", ",,,", "1,,2",
        "0:45:1", "0:45", "45:0:1", "0:1:0", "0:1:1e-9", "0:1:1e-300", "0:1:1e300", "-360:360:0.0001", "-360:360:0.001",
        "0:0:0", "::", "0:1:nan", "0,10,45", "361", "-361", "0:360:360", "0.1:0.2:0.01", "1e-28:1e-27:1e-29",
        "m", "mm", "M", "y", "z", "Y", "all", "none", "ALL", "a=b", "=b", "a=", "a=b=c", "a={scene}", "Ship",
        "Fleet/Ship", "'", "\"", "\\", "/", ".", "..", "/dev/null/x", "/proc/x", "C:\\x", "@file", "[suggest]",
        "/?", "-h", "--help", "--version", "-5", "-b", "a\nb"
    ];

    static readonly string[] Inputs = ["x.unity", "x.obj", "x.STL", "x.fbx", "", " ", "x", ".unity", "-.obj",
        "--.obj", "a b.stl", "a\nb.obj", "-", "zsh"];

    public static Outcome Parse(Random random)
    {
        var words = Make(random);
        var subjects = words.Where(word => word.Length > 0).Append("INPUT").Append("--").Append("\"\"").Append("\" \"")
            .Append("command").ToArray();
        CommandLine byTree = null;
        var outcome = Outcome.Of(() =>
        {
            new CommandTree(new Terminal { Out = TextWriter.Null, Error = TextWriter.Null, Live = null, Width = 100 },
                line =>
                {
                    byTree = line;
                    return 0;
                }).Invoke(words, _ => { });
            return Outcome.Done;
        }, subjects);
        if (outcome.Verdict == Verdict.Finding || Commands.All.All(command => words[0] != command.Name)
            || words.Any(IsForTreeOnly))
            return outcome;
        CommandLine byTable = null;
        var other = Outcome.Of(() =>
        {
            byTable = CommandLine.Parse(Commands.All.Single(command => command.Name == words[0]), words[1..]);
            return Outcome.Done;
        }, subjects);
        if (other.Verdict == Verdict.Finding)
            return other;
        return Describe(byTree) == Describe(byTable)
            ? outcome
            : Outcome.Finding($"'{string.Join("' '", words)}': two parsers, two readings: {outcome} and {other}");
    }

    static string[] Make(Random random)
    {
        var command = Commands.All[random.Next(Commands.All.Count)];
        var words =
            new List<string> { random.Next(50) == 0 ? Pick(Values, random) : command.Name, Pick(Inputs, random) };
        if (random.Next(2) == 0)
            words[^1] = Inputs[random.Next(3)];
        for (int i = command.Options.Count > 0 ? random.Next(5) : 0; i > 0; i--)
        {
            var option = command.Options[random.Next(command.Options.Count)];
            string flag = random.Next(20) == 0 ? option.Flag[..^1] : option.Flag;
            string value = random.Next(3) == 0 ? option.DefaultText ?? "1" : Pick(Values, random);
            words.AddRange(random.Next(3) == 0 ? [$"{flag}={value}"] : random.Next(10) == 0 ? [flag] : [flag, value]);
        }
        if (random.Next(10) == 0)
            words.RemoveAt(random.Next(words.Count));
        if (random.Next(10) == 0)
            words.Insert(random.Next(words.Count + 1), Pick(Values, random));
        return words.Count == 0 ? [""] : words.ToArray();
    }

    // Only the tree handles help and version.
    static bool IsForTreeOnly(string word) => word is "-h" or "/h" or "-?" or "/?" or "--help" or "--version";

    static string Describe(CommandLine line) => line == null ? "refused"
        : $"{line.Input} {line.Get(Options.Bounces)} {line.Get(Options.Fov)} {line.Get(Options.Size)} "
            + $"{line.Get(Options.Out)} {string.Join(" ", line.Command.Options.Where(line.IsGiven))}";

    static T Pick<T>(IReadOnlyList<T> items, Random random) => items[random.Next(items.Count)];
}
