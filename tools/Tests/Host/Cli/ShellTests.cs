using System.IO;
using System.Linq;
using Glint.Cli;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Host.Tests;

public sealed class ShellTests
{
    [TestCase("", "glint: a command is missing: COMMANDS (see glint --help)")]
    [TestCase("swep x.obj", "glint: \"swep\": no such command: did you mean sweep? (see glint --help)")]
    [TestCase("dance", "glint: \"dance\": no such command: the commands are COMMANDS (see glint --help)")]
    [TestCase("run x.obj --bounces 17", "glint: --bounces 17: must be from 1 to 16 (see glint run --help)")]
    [TestCase("run x.obj --size 0x5", "glint: --size 0x5: each number must be from 1 to 524280 (see glint run --help)")]
    [TestCase("sweep x.unity --target Ship --angles 0:45", "glint: --angles 0:45: a range has three parts: "
        + "give FROM:TO:STEP, such as 0:45:1, or a list, such as 0,10,45 (see glint sweep --help)")]
    public void Line_Wrong_IsToldInOneLineOfTheErrorStream(string line, string message)
    {
        var (code, output, error) = Run(line.Split(' ', System.StringSplitOptions.RemoveEmptyEntries));

        Assert.That(code, Is.EqualTo(2));
        Assert.That(error, Is.EqualTo(message.Replace("COMMANDS",
            string.Join(", ", Commands.All.Select(command => command.Name))) + System.Environment.NewLine));
        Assert.That(output, Is.Empty);
    }

    [TestCase("--help")]
    [TestCase("sweep --help")]
    [TestCase("run -h")]
    [TestCase("--version")]
    public void Help_Asked_GoesToStandardOutput(string line)
    {
        var (code, output, error) = Run(line.Split(' '));

        Assert.That(code, Is.EqualTo(0));
        Assert.That(output, Is.Not.Empty);
        Assert.That(error, Is.Empty);
    }

    [Test]
    public void Version_OfTheCommand_IsThatOfThePackageAndOfResultFiles() =>
        Assert.That(Run(["--version"]).output.Trim(), Is.EqualTo(Core.GlintVersion.Text));

    static (int code, string output, string error) Run(string[] arguments)
    {
        var (output, error) = (new StringWriter(), new StringWriter());
        int code = new Shell(new Terminal { Out = output, Error = error, Live = null, Width = 100 }).Run(arguments);
        return (code, output.ToString(), error.ToString());
    }
}
