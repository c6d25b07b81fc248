using System;
using Glint.Core;

namespace Glint.Cli;

/// <summary>A page with measured parts between markers; the text around them is kept.</summary>
/// <param name="path">Path for messages.</param>
/// <param name="text">Present text of the page; empty for a new one.</param>
sealed class MarkedPage(string path, string text)
{
    public string Text { get; private set; } = text;

    /// <summary>
    /// Replaces the text between the markers of a name. Without markers it goes to the page's end, below a title.
    /// </summary>
    /// <exception cref="GlintException">One of the markers is missing.</exception>
    public void Put(string name, string title, string measured)
    {
        var (from, to) = Find(name);
        if (from < 0)
            Text += $"{(Text.Length == 0 ? "" : "\n")}## {title}\n\n{Begin(name)}{measured}{End(name)}";
        else
            Text = Text[..from] + measured + Text[to..];
    }

    /// <summary>Refuses a page with incomplete markers of a name.</summary>
    /// <exception cref="GlintException">One of the markers is missing.</exception>
    public void Check(string name) => Find(name);

    // Begin and end of the text between the markers; -1 without markers.
    (int from, int to) Find(string name)
    {
        int begin = Text.IndexOf(Begin(name), StringComparison.Ordinal),
            end = Text.IndexOf(End(name), StringComparison.Ordinal);
        if (begin < 0 && end < 0)
            return (-1, -1);
        if (begin < 0 || end < begin)
            throw new GlintException($"{path}: of the lines \"{Begin(name).Trim()}\" and \"{End(name).Trim()}\" one is "
                + "missing, or they are in the wrong order: correct the page, or name another folder");
        return (begin + Begin(name).Length, end);
    }

    static string Begin(string name) => $"<!-- measured: {name} -->\n";

    static string End(string name) => $"<!-- end of {name} -->\n";
}
