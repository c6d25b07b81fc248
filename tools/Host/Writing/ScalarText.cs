using System;
using System.Globalization;
using System.Linq;
using System.Text;

namespace Glint.Host;

/// <summary>Numbers and text as YAML scalars that read back unchanged.</summary>
internal static class ScalarText
{
    // Characters with a YAML meaning at the beginning of a plain text.
    const string Indicators = "-?:,[]{}#&*!|>'\"%@`~";

    /// <summary>The shortest digits that read back as the same number.</summary>
    internal static string Of(float value) =>
        Special(value) ?? Digits(value.ToString("R", CultureInfo.InvariantCulture), value);

    internal static string Of(double value) =>
        Special(value) ?? value.ToString("R", CultureInfo.InvariantCulture).Replace('E', 'e');

    /// <summary>Plain where YAML allows it, else in quotes. Characters outside printable ASCII are escaped.</summary>
    internal static string Of(string text)
    {
        if (string.IsNullOrEmpty(text))
            return "";
        if (!text.All(letter => letter is >= ' ' and <= '~'))
            return Escaped(text);
        bool isPlain = !Indicators.Contains(text[0]) && text[0] != ' ' && text[^1] is not (' ' or ':')
            && !text.Contains(": ", StringComparison.Ordinal) && !text.Contains(" #", StringComparison.Ordinal);
        return isPlain ? text : $"'{text.Replace("'", "''", StringComparison.Ordinal)}'";
    }

    // .NET writes a float from 1e9 with an exponent, a double from 1e17: here both begin at 1e17.
    static string Digits(string shortest, float value) => shortest.Contains("E+") && Math.Abs(value) < 1e17
        ? decimal.Parse(shortest, NumberStyles.Float, CultureInfo.InvariantCulture)
            .ToString(CultureInfo.InvariantCulture)
        : shortest.Replace('E', 'e');

    static string Special(double value) =>
        double.IsNaN(value) ? "NaN"
            : double.IsPositiveInfinity(value) ? "Infinity"
            : double.IsNegativeInfinity(value) ? "-Infinity"
            : null;

    static string Escaped(string text)
    {
        StringBuilder quoted = new("\"");
        // Half of a surrogate pair is not a character; it becomes the replacement character.
        foreach (Rune letter in text.EnumerateRunes())
        {
            quoted.Append(letter.Value switch
            {
                '\n' => "\\n",
                '\r' => "\\r",
                '\t' => "\\t",
                '"' => "\\\"",
                '\\' => "\\\\",
                >= ' ' and <= '~' => letter.ToString(),
                <= byte.MaxValue => $"\\x{letter.Value:X2}",
                <= char.MaxValue => $"\\u{letter.Value:X4}",
                _ => $"\\U{letter.Value:X8}",
            });
        }
        return quoted.Append('"').ToString();
    }
}
