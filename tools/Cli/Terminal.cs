using System;
using System.IO;
using Glint.Core;
using Spectre.Console;

namespace Glint.Cli;

/// <summary>Where the command writes: results to standard output, everything else to the error stream.</summary>
sealed class Terminal
{
    const int StandardWidth = 100, WidestText = 120;

    /// <summary>
    /// Throws a <see cref="GlintException"/> when standard output takes nothing; a reader that went away is no failure.
    /// </summary>
    public TextWriter Out { get; init; } = Results(Console.Out);

    /// <summary>Never throws: there is no place left to tell of it.</summary>
    public TextWriter Error { get; init; } = Messages(Console.Error);

    /// <summary>Columns for texts.</summary>
    public int Width { get; init; } = WidthOfOutput();

    /// <summary>
    /// The error stream as a terminal that can redraw a line; null when it is a file, a pipe or a plain terminal.
    /// </summary>
    public IAnsiConsole Live { get; init; } = LiveError();

    /// <summary>Whether results go to the same screen as messages.</summary>
    public bool SharesScreen { get; init; } = !Console.IsOutputRedirected;

    /// <summary>Writes a message, above the progress bar when there is one.</summary>
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
