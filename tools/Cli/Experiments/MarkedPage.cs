using System;
using Glint.Core;

namespace Glint.Cli;

/// <summary>A page in which what was measured stands between markers, and words around them that stay.</summary>
/// <param name="path">For messages.</param>
/// <param name="text">The page as it is; empty for a new one.</param>
sealed class MarkedPage(string path, string text)
{
    public string Text { get; private set; } = text;

    /// <summary>
    /// Puts text between the markers of a name; at the page's end, below a title, where there are none.
    /// </summary>
    /// <exception cref="GlintException">Only one of the markers is there.</exception>
    public void Put(string name, string title, string measured)
    {
        var (from, to) = Find(name);
        if (from < 0)
            Text += $"{(Text.Length == 0 ? "" : "\n")}## {title}\n\n{Begin(name)}{measured}{End(name)}";
        else
            Text = Text[..from] + measured + Text[to..];
    }

    /// <summary>Refuses a page into which nothing can be put by a name.</summary>
    /// <exception cref="GlintException">Only one of the markers is there.</exception>
    public void Check(string name) => Find(name);

    // Where the text between the markers begins and ends; -1 without markers.
    (int from, int to) Find(string name)
    {
        int begin = Text.IndexOf(Begin(name), StringComparison.Ordinal),
            end = Text.IndexOf(End(name), StringComparison.Ordinal);
        if (begin < 0 && end < 0)
            return (-1, -1);
        if (begin < 0 || end < begin)
            throw new GlintException($"{path}: of the lines \"{Begin(name).Trim()}\" and \"{End(name).Trim()}\" one is "
                + "missing, or they are in the wrong order: mend the page, or name another folder");
        return (begin + Begin(name).Length, end);
    }

    static string Begin(string name) => $"<!-- measured: {name} -->\n";

    static string End(string name) => $"<!-- end of {name} -->\n";
}
