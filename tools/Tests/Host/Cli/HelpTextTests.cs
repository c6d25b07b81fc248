using System.Linq;
using Glint.Cli;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Host.Tests;

public sealed class HelpTextTests
{
    [Test]
    public void Help_OfEachCommand_HasEveryOptionWithItsDefaultAndRange()
    {
        foreach (var command in Commands.All)
        {
            string help = Flat(HelpText.Of(command, 100));
            foreach (var option in command.Options)
            {
                Assert.That(help, Does.Contain(Flat($"{option.Flag} {option.ValueName} {option.Help}")));
                if (option.DefaultText != null)
                    Assert.That(help, Does.Contain(command.Required.Contains(option) ? $"[{option.Range}]"
                        : $"[default {option.DefaultText}; {option.Range}]"));
            }
        }
    }

    [Test]
    public void Examples_OfEachCommand_AreValid()
    {
        foreach (var example in Commands.All.SelectMany(command => command.Examples))
        {
            var words = Arguments(example.Key);
            var command = Commands.All.Single(candidate => candidate.Name == words[0]);
            Assert.That(() => CommandLine.Parse(command, words.Skip(1).ToArray()), Throws.Nothing, example.Key);
        }
    }

    [TestCase(60)]
    [TestCase(80)]
    [TestCase(200)]
    public void Lines_ButForExamples_FitTheWidth(int width)
    {
        foreach (var text in Commands.All.Select(command => HelpText.Of(command, width))
            .Append(HelpText.Overview(width)))
            foreach (var line in text.Split('\n').Where(line => !line.StartsWith("  glint ")))
            {
                Assert.That(line.Length, Is.LessThan(width), line);
                Assert.That(line, Is.EqualTo(line.TrimEnd()));
            }
    }

    static string Flat(string text) =>
        string.Join(" ", text.Split(new[] { ' ', '\n' }, System.StringSplitOptions.RemoveEmptyEntries));

    // Splits like a shell: double quotes keep spaces.
    static string[] Arguments(string line) =>
        line.Split('"').SelectMany((part, i) => i % 2 == 1
            ? new[] { part }
            : part.Split(new[] { ' ' }, System.StringSplitOptions.RemoveEmptyEntries)).ToArray();
}
