using System.IO;
using System.Linq;
using FsCheck;
using FsCheck.Fluent;
using Glint.Cli;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>The System.CommandLine tree and the tables' own parser accept and refuse the same command lines.</summary>
public sealed class CommandTreeTests
{
    const string Refused = "refused";

    static readonly string[] Vocabulary =
    [
        "sweep.unity", "plate.obj", "part.STL", "x.fbx", "-", "--", "", "@file", "[suggest]", "/?x", "-5", "-10:10:5",
        "0:45:1", "0,1", "17", "4", "3x3", "mm", "z", "1,2,3",
        "--target", "--angles", "--out", "--size", "--region", "--seed", "--reference", "--peer", "--json", "a=b",
        "--frequency", "--bounces", "--receiver", "--unit", "--up", "--distance", "--grazing", "--aim", "--device",
        "--target=Ship", "--target=--Ship", "--target=", "--angles=0:2:1", "--bounces=2", "--bounces=x=y", "--fov=60",
        "--peer=a=b", "--peer=", "--region=0,0,1,1", "--unknown", "--unknown=3", "-out", "-b"
    ];

    [TestCase("run")]
    [TestCase("run x.fbx")]
    [TestCase("run x.obj --bounces 17")]
    [TestCase("run x.obj --bounces=17")]
    [TestCase("run x.obj --bounces")]
    [TestCase("run x.obj --out --bounces 3")]
    [TestCase("run x.obj --out --bonces 3")]
    [TestCase("run x.obj --bonces 3")]
    [TestCase("run x.obj --freq=3")]
    [TestCase("run x.obj -out 3")]
    [TestCase("run x.obj --fov 3 --fov 3")]
    [TestCase("run x.obj x.obj")]
    [TestCase("run -- x.obj --fov")]
    [TestCase("run x.unity --aim -1,2,3")]
    [TestCase("run x.obj --target Ship")]
    [TestCase("run x.obj @file")]
    [TestCase("sweep x.unity --target Ship")]
    [TestCase("sweep x.unity --angles 0:45:1")]
    [TestCase("sweep x.unity --angles 0:45:1 --target Corner Reflector")]
    [TestCase("sweep x.obj --angles 0:45:1 --target Ship")]
    [TestCase("sweep x.obj --angles -1:-2:1")]
    [TestCase("run x.obj --region 1,2,3")]
    [TestCase("bench --seed 1 --seed 1")]
    [TestCase("bench --distance 3")]
    [TestCase("bench x.obj --seed 1")]
    [TestCase("bench --peer a=b c=d")]
    [TestCase("bench --peer --peer a=b")]
    [TestCase("info x.obj")]
    [TestCase("info --size 3x3")]
    public void Tree_OfAWrongLine_RefusesItInTheWordsOfTheTable(string line)
    {
        var arguments = line.Split(' ');
        var expected = Assert.Throws<UsageException>(() => CommandLine.Parse(Find(arguments[0]), arguments[1..]));

        Assert.That(Assert.Throws<UsageException>(() => ParseByTree(arguments)).Message, Is.EqualTo(expected.Message));
    }

    [Test]
    public void Tree_OfAnyWords_ReadsWhatTheTablesParserReads()
    {
        // Short command lines with an input first, so that a fair share is valid.
        var lines =
            from name in Gen.Elements("sweep", "run", "bench", "info")
            from input in Gen.Elements(Vocabulary[..3])
            from count in Gen.Choose(0, 5)
            from arguments in Gen.Elements(Vocabulary).ArrayOf(count)
            from position in Gen.Choose(0, count)
            select arguments[..position].Append(input).Concat(arguments[position..]).Prepend(name).ToArray();
        int accepted = 0;
        Prop.ForAll(lines.ToArbitrary(), arguments =>
        {
            string expected = Describe(() => CommandLine.Parse(Find(arguments[0]), arguments[1..]));
            accepted += expected == Refused ? 0 : 1;
            return Describe(() => ParseByTree(arguments)) == expected;
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(5000));
        Assert.That(accepted, Is.GreaterThan(200));
    }

    [Test]
    public void Parser_OfAnyText_RefusesOnlyByUsageException()
    {
        var options = Commands.All.SelectMany(command => command.Options).Distinct().ToArray();
        Prop.ForAll(ArbMap.Default.ArbFor<string>().Filter(text => text != null),
                text => options.All(option => Refuses(option, text)))
            .Check(Config.QuickThrowOnFailure.WithMaxTest(500));
    }

    [TestCase("sweep")]
    [TestCase("run")]
    [TestCase("bench")]
    [TestCase("info")]
    public void Help_OfACommand_IsThatOfTheTable(string name)
    {
        var output = new StringWriter();
        var tree = new CommandTree(Quiet(output), _ => throw new AssertionException("ran"));

        Assert.That(tree.Invoke([name, "--nonsense", "--help"], _ => { }), Is.EqualTo(0));
        Assert.That(output.ToString(), Is.EqualTo(HelpText.Of(Find(name), 100)));
    }

    static bool Refuses(Option option, string text)
    {
        try
        {
            option.ParseValue(text);
        }
        catch (UsageException error)
        {
            return error.Message.StartsWith(option.Flag + " ") && !error.Message.Contains('\n');
        }
        return true;
    }

    // With several errors, the parsers may report different ones first.
    static string Describe(System.Func<CommandLine> parse)
    {
        try
        {
            var line = parse();
            var given = line.Command.Options.Where(line.IsGiven).Select(option => option.Flag);
            return $"{line.Command.Name} {line.Input} {line.Get(Options.Target)} {line.Get(Options.Out)} "
                + $"{line.Get(Options.Bounces)} {line.Get(Options.Peers)?.Length} {string.Join(" ", given)}";
        }
        catch (UsageException)
        {
            return Refused;
        }
    }

    static CommandLine ParseByTree(string[] arguments)
    {
        CommandLine parsed = null;
        new CommandTree(Quiet(TextWriter.Null), line =>
        {
            parsed = line;
            return 0;
        }).Invoke(arguments, _ => { });
        return parsed;
    }

    static Terminal Quiet(TextWriter output) =>
        new() { Out = output, Error = TextWriter.Null, Live = null, Width = 100 };

    static Command Find(string name) => Commands.All.Single(command => command.Name == name);
}
