using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Spectre.Console;

namespace Glint.Cli;

/// <summary>Tables as lines of text: framed on a terminal, plain columns in a file.</summary>
sealed class TableText(Terminal terminal)
{
    /// <param name="names">
    /// Number of columns from the left that are names. The others are numbers, unless they have no title.
    /// </param>
    public Table New(int names, params string[] titles)
    {
        var table = new Table { Border = terminal.SharesScreen ? TableBorder.Rounded : TableBorder.None };
        var padding = terminal.SharesScreen ? new Padding(1, 0, 1, 0) : new Padding(0, 0, 2, 0);
        for (int i = 0; i < titles.Length; i++)
            table.AddColumn(new TableColumn(Markup.Escape(titles[i]))
            {
                Alignment = i >= names && (titles[i].Length > 0 || i == names) ? Justify.Right : Justify.Left,
                NoWrap = true, Padding = padding
            });
        return table;
    }

    public IEnumerable<string> Lines(Table table)
    {
        var text = new StringWriter();
        var console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.No, ColorSystem = ColorSystemSupport.NoColors,
            Interactive = InteractionSupport.No, Out = new AnsiConsoleOutput(text),
        });
        console.Profile.Width = terminal.Width;
        console.Write(table);
        return text.ToString().Split('\n').Select(line => line.TrimEnd()).Where(line => line.Length > 0);
    }

    public static string[] Escaped(params string[] cells) => Array.ConvertAll(cells, cell => Markup.Escape(cell));

    public static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    public static string Ms(double value) => double.IsNaN(value) ? "-" : value.ToString(
        Math.Abs(value) < 1 ? "0.0000" : Math.Abs(value) < 100 ? "0.00" : "0.0", CultureInfo.InvariantCulture);
}
