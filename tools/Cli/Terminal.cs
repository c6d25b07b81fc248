using System;
using System.IO;
using Glint.Core;
using Spectre.Console;

namespace Glint.Cli;

/// <summary>The command's output streams: results go to standard output, everything else to standard error.</summary>
sealed class Terminal
{
    const int StandardWidth = 100, WidestText = 120;

    /// <summary>
    /// Throws a <see cref="GlintException"/> if standard output fails. A reader that closed the pipe is no failure.
    /// </summary>
    public TextWriter Out { get; init; } = Results(Console.Out);

    /// <summary>Never throws, since a failure could not be reported.</summary>
    public TextWriter Error { get; init; } = Messages(Console.Error);

    /// <summary>Width of texts, in columns.</summary>
    public int Width { get; init; } = WidthOfOutput();

    /// <summary>
    /// Standard error as a terminal that can redraw a line; null for a file, a pipe or a plain terminal.
    /// </summary>
    public IAnsiConsole Live { get; init; } = LiveError();

    /// <summary>True if results and messages go to the same terminal.</summary>
    public bool SharesScreen { get; init; } = !Console.IsOutputRedirected;

    /// <summary>Writes a message, above the progress bar if there is one.</summary>
    public void Report(string message)
    {
        if (Live == null)
            Error.WriteLine(message);
        else
            Live.WriteLine(message);
    }

    internal static TextWriter Results(TextWriter stream) => new GuardedWriter(stream, error =>
        throw new GlintException(
            $"standard output cannot be written: {(error is IOException ? error.Message : "it is closed")}", error));

    internal static TextWriter Messages(TextWriter stream) => new GuardedWriter(stream, _ => { });

    static int WidthOfOutput() => Console.IsOutputRedirected || Console.WindowWidth <= 0
        ? StandardWidth
        : Math.Min(Console.WindowWidth, WidestText);

    static IAnsiConsole LiveError()
    {
        if (Console.IsErrorRedirected)
            return null;
        var console =
            AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Messages(Console.Error)) });
        return console.Profile.Capabilities is { Ansi: true, Interactive: true } ? console : null;
    }
}
