using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Glint.Editor;

namespace Glint.Cli;

/// <summary>Writes the help of the commands from their tables.</summary>
sealed class HelpText
{
    const int Margin = 2, NarrowestText = 24;

    readonly StringBuilder _text = new StringBuilder();
    readonly int _width;

    HelpText(int width) => _width = width;

    /// <summary>Help of all commands together.</summary>
    /// <param name="width">Columns of the terminal.</param>
    public static string Overview(int width)
    {
        var help = new HelpText(width);
        help.Paragraph(0, Commands.Summary);
        help.Heading("Usage");
        help.Paragraph(Margin, "glint COMMAND [arguments]");
        help.Heading("Commands");
        help.Table(Commands.All.Select(command => (command.Name, command.Summary)));
        help.Heading("Options");
        help.Table(new[] { ("--help", "Help; glint COMMAND --help lists the options of a command with examples."),
            ("--version", "The version of Glint.") });
        help.AddExamples(Commands.All.Select(command => command.Examples[0]));
        help.AddExitCodes();
        return help._text.ToString();
    }

    /// <summary>Help of one command.</summary>
    /// <param name="command">The command.</param>
    /// <param name="width">Columns of the terminal.</param>
    public static string Of(Command command, int width)
    {
        var help = new HelpText(width);
        help.Paragraph(0, command.Summary);
        foreach (var note in command.Notes)
            help.Paragraph(0, note);
        help.Heading("Usage");
        help.Paragraph(Margin, command.Usage);
        if (command.Inputs != InputKind.None)
        {
            help._text.Append('\n');
            help.Table(new[] { (command.InputName.Trim('[', ']'), Commands.InputHelpOf(command)) });
        }
        int nameWidth = command.Options.Select(option => Form(option).Length).DefaultIfEmpty(0).Max();
        foreach (var group in command.Options.GroupBy(option => option.Group))
        {
            help.Heading(group.Key);
            help.Table(group.Select(option => (Form(option), Explanation(command, option))), nameWidth);
        }
        help.AddExamples(command.Examples);
        if (command.UnityMethod != null)
        {
            help.Heading("In Unity");
            help.Paragraph(Margin,
                $"Unity -batchmode -projectPath DIR -executeMethod {command.UnityMethod} {CommandLine.UnityMarker} "
                    + $"{(command.InputName == null ? "" : command.InputName + " ")}[options]");
            help.Paragraph(Margin, "The same arguments, last on the line. "
                + "Neither -nographics (there would be no GPU) nor -quit (the command ends Unity itself).");
        }
        help.AddExitCodes();
        return help._text.ToString();
    }

    static string Form(Option option) => $"{option.Flag} {option.ValueName}".TrimEnd();

    // An option that must be given has no default.
    static string Explanation(Command command, Option option)
    {
        bool hasDefault = option.DefaultText != null && !command.Required.Contains(option);
        var facts = new[] { hasDefault ? "default " + option.DefaultText : null, option.Range }
            .Where(fact => fact != null).ToArray();
        return facts.Length == 0 ? option.Help : $"{option.Help} [{string.Join("; ", facts)}]";
    }

    void AddExamples(IEnumerable<KeyValuePair<string, string>> examples)
    {
        Heading("Examples");
        foreach (var example in examples)
        {
            // Unwrapped, so that it can be copied.
            _text.Append(' ', Margin).Append("glint ").Append(example.Key).Append('\n');
            Paragraph(3 * Margin, example.Value);
        }
    }

    void AddExitCodes()
    {
        Heading("Exit codes");
        Paragraph(Margin, Commands.ExitCodes);
    }

    void Heading(string title)
    {
        _text.Append('\n');
        Paragraph(0, title + ":");
    }

    void Table(IEnumerable<(string name, string meaning)> rows, int nameWidth = 0)
    {
        var all = rows.ToArray();
        int column = Math.Max(nameWidth, all.Max(row => row.name.Length)) + 2 * Margin;
        foreach (var row in all)
        {
            _text.Append(' ', Margin).Append(row.name.PadRight(column - Margin));
            Paragraph(column, row.meaning, column);
        }
    }

    // Wraps words at the width and indents later lines. The first line begins at the current column.
    void Paragraph(int indent, string text, int position = 0)
    {
        int end = Math.Max(_width - 1, indent + NarrowestText);
        bool lineIsEmpty = true;
        foreach (var word in text.Split(' '))
        {
            if (!lineIsEmpty && position + 1 + word.Length > end)
            {
                _text.Append('\n');
                position = 0;
                lineIsEmpty = true;
            }
            if (lineIsEmpty)
                _text.Append(' ', indent - position);
            else
                _text.Append(' ');
            position = (lineIsEmpty ? indent : position + 1) + word.Length;
            _text.Append(word);
            lineIsEmpty = false;
        }
        _text.Append('\n');
    }
}
