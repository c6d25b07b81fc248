using System.IO;
using Glint.Cli;

namespace Glint.Host.Tests;

/// <summary>Runs command lines within the test's process.</summary>
static class TestShell
{
    /// <summary>A terminal without progress.</summary>
    public static Terminal Quiet(TextWriter output, TextWriter error) =>
        new() { Out = output, Error = error, Live = null, Width = 100, SharesScreen = false };

    public static (int code, string output, string error) Run(params string[] arguments)
    {
        var (output, error) = (new StringWriter(), new StringWriter());
        int code = new Shell(Quiet(output, error)).Run(arguments);
        return (code, output.ToString(), error.ToString());
    }
}
