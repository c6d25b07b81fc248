using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Glint.Cli;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Completion in bash: sources the script and calls its function, word by word.</summary>
[Platform("Linux")]
public sealed class CompletionTests
{
    string _folder;

    [SetUp]
    public void MakeFiles()
    {
        _folder = Directory.CreateTempSubdirectory("glint-completion-").FullName;
        foreach (string name in new[] { "Sea.unity", "a ship.obj", "part.stl", "notes.txt" })
            File.WriteAllText(Path.Combine(_folder, name), "");
        Directory.CreateDirectory(Path.Combine(_folder, "Results"));
        File.WriteAllText(Path.Combine(_folder, "script"), new CompletionScript("bash").Write());
    }

    [TearDown]
    public void RemoveFiles() => Directory.Delete(_folder, true);

    [Test]
    public void FirstWord_IsACommand()
    {
        Assert.That(Complete(""),
            Is.EquivalentTo(Commands.All.Select(command => command.Name).Concat(["--help", "--version"])));
        Assert.That(Complete("s"), Is.EquivalentTo(new[] { "sweep", "sea", "ship" }));
    }

    [TestCaseSource(nameof(Names))]
    public void Dashes_AreTheOptionsOfTheCommand(string name)
    {
        var command = Commands.All.Single(known => known.Name == name);
        Assert.That(Complete(name, "--"),
            Is.EquivalentTo(command.Options.Select(option => option.Flag).Append("--help")));
    }

    static IEnumerable<string> Names => Commands.All.Select(command => command.Name);

    [TestCase("Sea.unity|a ship.obj|part.stl|Results", "run", "")]
    [TestCase("Sea.unity", "sweep", "--size", "4x4", "Se")]
    [TestCase("a ship.obj", "verify", "a")]
    [TestCase("Results", "report", "")]
    [TestCase("Results", "merge", "--out", "x", "R")]
    [TestCase("Results", "sweep", "Sea.unity", "--out", "")]
    [TestCase("notes.txt", "bench", "--json", "n")]
    [TestCase("m|mm", "run", "part.stl", "--unit", "m")]
    [TestCase("mm", "run", "part.stl", "--unit", "=", "mm")]
    [TestCase("y|z", "run", "part.stl", "--up", "=")]
    [TestCase("jonswap", "sea", "--spectrum", "j")]
    [TestCase("none", "report", "Results", "--pose", "")]
    [TestCase("", "run", "part.stl", "--frequency", "")]
    [TestCase("", "info", "")]
    [TestCase("bash|zsh|fish", "completion", "")]
    [TestCase("--frequency", "run", "--freq")]
    public void Word_IsCompletedByWhatFits(string expected, params string[] arguments) =>
        Assert.That(Complete(arguments), Is.EquivalentTo(expected.Split('|', StringSplitOptions.RemoveEmptyEntries)));

    [Test]
    public void Choices_OfEveryOption_AreTaken()
    {
        var options = Commands.All.SelectMany(command => command.Options).Distinct()
            .Where(option => option.Choices.Count > 0).ToArray();
        Assert.That(options.Select(option => option.Name),
            Is.SupersetOf(new[] { "unit", "up", "reference", "pose", "spectrum" }));
        foreach (var option in options)
            foreach (string choice in option.Choices)
                Assert.That(() => option.ParseValue(choice), Throws.Nothing, $"{option.Flag} {choice}");
    }

    [TestCase("zsh")]
    [TestCase("fish")]
    public void Script_OfAnotherShell_NamesEveryCommandAndOption(string shell)
    {
        string script = new CompletionScript(shell).Write();
        foreach (var command in Commands.All)
        {
            Assert.That(script, Does.Contain(command.Name));
            foreach (var option in command.Options)
                Assert.That(script, Does.Contain(shell == "fish" ? $"-l {option.Name} " : option.Flag + "["));
        }
    }

    // The last argument is the word being typed.
    string[] Complete(params string[] arguments)
    {
        string[] line = ["glint", .. arguments];
        const string Ask = "cd \"$1\" && source ./script && rm script && shift && COMP_WORDS=(\"$@\") && "
            + "COMP_CWORD=$(($# - 1)) && { _glint; printf '%s\\n' \"${COMPREPLY[@]}\"; }";
        using var bash = Process.Start(new ProcessStartInfo("bash", ["--norc", "-c", Ask, "bash", _folder, .. line])
        {
            RedirectStandardOutput = true, RedirectStandardError = true
        });
        var output = bash.StandardOutput.ReadToEndAsync();
        string error = bash.StandardError.ReadToEnd();
        bash.WaitForExit();
        File.WriteAllText(Path.Combine(_folder, "script"), new CompletionScript("bash").Write());
        Assert.That(error, Is.Empty);
        return output.Result.Split('\n', StringSplitOptions.RemoveEmptyEntries);
    }
}
