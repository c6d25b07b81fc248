using System;
using System.Globalization;
using System.Linq;
using System.Text;

namespace Glint.Host;

/// <summary>Numbers and text in one line of YAML, so that they are read back as they were.</summary>
internal static class ScalarText
{
    // What YAML would take for something else at the beginning of a plain text.
    const string Indicators = "-?:,[]{}#&*!|>'\"%@`~";

    /// <summary>The shortest digits that give the same number again.</summary>
    internal static string Of(float value) =>
        Special(value) ?? Digits(value.ToString("R", CultureInfo.InvariantCulture), value);

    internal static string Of(double value) =>
        Special(value) ?? value.ToString("R", CultureInfo.InvariantCulture).Replace('E', 'e');

    /// <summary>Plain where YAML allows, else in quotes; what is no printable ASCII as escapes.</summary>
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
        // Half of a pair of surrogates is no character, and comes out as the one that stands for such.
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
