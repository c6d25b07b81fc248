using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Cli;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>
/// Every command called wrongly gives one line with the command, the option or the file. The exit code is 2 for errors
/// of the command line, and 1 for errors found on opening files.
/// </summary>
public sealed class WrongCallTests
{
    // Valid arguments for each command; DIR and MESH are replaced by existing paths.
    static readonly Dictionary<string, string[]> s_right = new()
    {
        ["sweep"] = ["MESH", "--angles", "0", "--size", "4x4", "--out", "DIR/out"],
        ["merge"] = ["DIR", "--out", "DIR/out"],
        ["run"] = ["MESH", "--size", "4x4"],
        ["rcs"] = ["MESH", "--tolerance", "10", "--out", "DIR/out"],
        ["echo"] = ["MESH", "--tolerance", "10", "--frequencies", "4", "--out", "DIR/out"],
        ["isar"] = ["MESH", "--tolerance", "10", "--frequencies", "4", "--azimuth", "0,1", "--out", "DIR/out"],
        ["clutter"] = ["Scenes/SeaState5.unity", "--clutter", "on", "--grazing", "60", "--out", "DIR/out"],
        ["ppi"] = ["Scenes/HarbourApproach.unity", "--turns", "1", "--out", "DIR/out"],
        ["report"] = ["DIR", "--pose", "none"],
        ["sea"] = [],
        ["ship"] = [],
        ["reflector"] = [],
        ["experiments"] = ["--out", "DIR/out", "--seeds", "1"],
        ["bench"] = ["MESH", "--size", "4x4", "--rounds", "1"],
        ["verify"] = ["MESH", "--size", "4x4"],
        ["info"] = [],
        ["completion"] = ["bash"]
    };

    string _folder;

    [SetUp]
    public void MakeFiles()
    {
        _folder = Directory.CreateTempSubdirectory("glint-calls-").FullName;
        File.WriteAllText(Path.Combine(_folder, "mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        File.WriteAllText(Path.Combine(_folder, "file"), "");
        Directory.CreateDirectory(Path.Combine(_folder, "folder.obj"));
        Directory.CreateDirectory(Path.Combine(_folder, "folder.unity"));
    }

    [TearDown]
    public void RemoveFiles() => Directory.Delete(_folder, true);

    static IEnumerable<string> Names => Commands.All.Select(command => command.Name);

    static IEnumerable<TestCaseData> Options => Commands.All.SelectMany(command => command.Options.Select(
        option => new TestCaseData(command.Name, option.Name).SetArgDisplayNames($"{command.Name} {option.Flag}")));

    [Test]
    public void Table_OfTheseTests_HasEveryCommand() => Assert.That(s_right.Keys, Is.EquivalentTo(Names));

    [TestCaseSource(nameof(Names))]
    public void Option_Unknown_IsRefused(string command) =>
        AssertRefused(2, "--nonesuch", [command, .. s_right[command], "--nonesuch"]);

    [TestCaseSource(nameof(Names))]
    public void Argument_OneTooMany_IsRefused(string command)
    {
        if (command != "merge")
            AssertRefused(2, "surplus", [command, .. s_right[command],
                .. command == "bench" || s_right[command].Length > 0 ? new[] { "surplus" } : ["surplus", "surplus"]]);
    }

    [TestCaseSource(nameof(Names))]
    public void Argument_Missing_IsRefused(string command)
    {
        var inputs = Commands.All.Single(known => known.Name == command).Inputs;
        if (inputs != InputKind.None && !inputs.HasFlag(InputKind.BuiltIn))
            AssertRefused(2, command, [command, .. s_right[command].Skip(1)]);
    }

    [TestCaseSource(nameof(Names))]
    public void Argument_Empty_IsRefused(string command)
    {
        if (Commands.All.Single(known => known.Name == command).Inputs != InputKind.None)
            AssertRefused(2, command, [command, "", .. s_right[command].Skip(1)]);
    }

    [TestCaseSource(nameof(Options))]
    public void Option_WithoutValue_IsRefused(string command, string name)
    {
        var option = Find(command, name);
        if (!option.IsSwitch && option.ImpliedText == null)
            AssertRefused(2, option.Flag, [command, .. Without(command, option), option.Flag]);
    }

    [TestCaseSource(nameof(Options))]
    public void Option_OfAnEmptyValue_IsRefused(string command, string name) =>
        AssertRefused(2, $"--{name} \"\"", [command, .. Without(command, Find(command, name)), $"--{name}="]);

    [TestCaseSource(nameof(Options))]
    public void Option_GivenTwice_IsRefused(string command, string name)
    {
        var option = Find(command, name);
        if (!option.IsRepeatable)
            AssertRefused(2, option.Flag, [command, .. Without(command, option), .. option.IsSwitch
                ? [option.Flag, option.Flag]
                : new[] { option.Flag, option.DefaultText ?? "1", option.Flag, option.DefaultText ?? "1" }]);
    }

    // Every range in the table excludes one of these values, and no plain word is a number or a choice.
    [TestCaseSource(nameof(Options))]
    public void Option_OfAValueOutOfRange_IsRefused(string command, string name)
    {
        var option = Find(command, name);
        if (option.Range == null || option.IsSwitch)
            return;
        foreach (string value in new[] { "1e300", "-1e300", "nonsense" })
            if (Assert.Throws<UsageException>(() => option.ParseValue(value)) != null)
                AssertRefused(2, option.Flag, [command, .. Without(command, option), $"{option.Flag}={value}"]);
    }

    [TestCase(1, "none.obj", "run", "DIR/none.obj")]
    [TestCase(1, "none.obj", "sweep", "DIR/none.obj", "--angles", "0")]
    [TestCase(1, "none.obj", "bench", "DIR/none.obj")]
    [TestCase(1, "none.obj", "verify", "DIR/none.obj")]
    [TestCase(1, "none.unity", "run", "none.unity")]
    [TestCase(1, "none", "report", "DIR/none")]
    [TestCase(1, "none", "merge", "DIR/none", "--out", "DIR/out")]
    [TestCase(1, "folder.obj: has no results.json", "merge", "DIR/folder.obj", "--out", "DIR/out")]
    [TestCase(2, "DIR: given twice", "merge", "DIR", "DIR", "--out", "DIR/out")]
    [TestCase(2, "--out DIR/: is one of the parts", "merge", "DIR", "--out", "DIR/")]
    [TestCase(1, "folder.obj: is a folder", "run", "DIR/folder.obj")]
    [TestCase(1, "folder.obj: is a folder", "verify", "DIR/folder.obj")]
    [TestCase(1, "folder.obj: is a folder", "bench", "DIR/folder.obj")]
    [TestCase(1, "folder.unity is a folder", "run", "DIR/folder.unity")]
    [TestCase(1, "file: is a file", "report", "DIR/file")]
    [TestCase(1, "file: is a file", "merge", "DIR/file", "--out", "DIR/out")]
    [TestCase(1, "file is a file", "run", "MESH", "--size", "4x4", "--out", "DIR/file")]
    [TestCase(1, "file is a file", "sweep", "MESH", "--angles", "0", "--size", "4x4", "--out", "DIR/file")]
    [TestCase(1, "file: is a file", "experiments", "--out", "DIR/file")]
    [TestCase(1, "file is a file", "sweep", "MESH", "--angles", "0", "--size", "4x4", "--out", "DIR/file/below")]
    [TestCase(1, "/proc/glint", "sweep", "MESH", "--angles", "0", "--size", "4x4", "--out", "/proc/glint")]
    [TestCase(1, "--json DIR/none/x.json", "verify", "MESH", "--json", "DIR/none/x.json")]
    [TestCase(1, "--json DIR/none/x.json", "bench", "MESH", "--json", "DIR/none/x.json")]
    [TestCase(1, "--write-scene DIR/folder.obj", "bench", "MESH", "--write-scene", "DIR/folder.obj")]
    [TestCase(1, "--accuracy DIR/none/x.svg", "bench", "--accuracy", "DIR/none/x.svg")]
    [TestCase(1, "outside of the Unity project", "sea", "--out", "DIR/out")]
    [TestCase(1, "outside of the Unity project", "ship", "--out", "DIR/out")]
    [TestCase(1, "DIR/none/x.stl: the ship cannot be written", "ship", "--stl", "DIR/none/x.stl")]
    [TestCase(2, "--out is missing", "ship", "--length", "70")]
    [TestCase(2, "--stl", "ship", "--stl", "DIR/x.stl", "--out", "Assets/Ships")]
    [TestCase(1, "no Vulkan device \"nonesuch\"", "run", "MESH", "--size", "4x4", "--device", "nonesuch")]
    [TestCase(2, "--target is missing", "sweep", "Scenes/CornerReflector.unity", "--angles", "0")]
    [TestCase(2, "nothing to step through", "sweep", "MESH")]
    [TestCase(2, "--out is missing", "merge", "DIR")]
    [TestCase(2, "\"surplus\": no such command", "surplus", "run", "MESH")]
    public void Call_OfWhatIsNotThereOrNotEnough_IsRefused(int code, string named, params string[] arguments) =>
        AssertRefused(code, named, arguments);

    void AssertRefused(int code, string named, string[] arguments)
    {
        arguments = Array.ConvertAll(arguments, Put);
        var (output, error) = (new StringWriter(), new StringWriter());
        int actual = new Shell(new Terminal { Out = output, Error = error, Live = null, Width = 100 }).Run(arguments);
        string line = $"glint {string.Join(' ', arguments)}: {error}";
        Assert.That(actual, Is.EqualTo(code), line);
        Assert.That(error.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries), Has.Length.EqualTo(1), line);
        Assert.That(error.ToString(),
            Does.StartWith("glint: ").And.Contain(Put(named)).And.Not.Contain("internal error"));
        Assert.That(output.ToString(), Is.Empty, line);
    }

    string Put(string word) => word.Replace("MESH", "DIR/mesh.obj").Replace("DIR", _folder);

    static Option Find(string command, string name) =>
        Commands.All.Single(known => known.Name == command).Options.Single(option => option.Name == name);

    // The valid arguments without an option and its value.
    static string[] Without(string command, Option option)
    {
        int at = Array.IndexOf(s_right[command], option.Flag);
        return at < 0 ? s_right[command] : [.. s_right[command][..at], .. s_right[command][(at + 2)..]];
    }
}
