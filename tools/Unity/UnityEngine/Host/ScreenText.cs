using System.Collections.Generic;

namespace Glint.Host;

/// <summary>The texts that the last frame put on the screen of a player.</summary>
public static class ScreenText
{
    static readonly List<string> _texts = new();

    public static IReadOnlyList<string> Texts => _texts;

    internal static void Clear() => _texts.Clear();

    internal static void Add(string text)
    {
        if (text.Length > 0)
            _texts.Add(text);
    }
}
