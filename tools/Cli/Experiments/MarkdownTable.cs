using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Glint.Cli;

/// <summary>A Markdown table with numbers aligned right.</summary>
sealed class MarkdownTable
{
    readonly StringBuilder _text = new();

    /// <param name="titles">The first column holds names, the others numbers.</param>
    public MarkdownTable(params string[] titles)
    {
        Add(titles);
        _text.Append("| --- ").Append(string.Concat(Enumerable.Repeat("| ---: ", titles.Length - 1))).Append("|\n");
    }

    public void Add(params IEnumerable<string> cells) =>
        _text.Append("| ").AppendJoin(" | ", cells.Select(Escaped)).Append(" |\n");

    /// <summary>The table with a line end after each row.</summary>
    public override string ToString() => _text.ToString();

    static string Escaped(string cell) => cell.Replace("\\", "\\\\").Replace("|", "\\|").Replace("<", "&lt;");
}
