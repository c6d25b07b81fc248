using System;
using System.Globalization;

namespace Glint.Host;

/// <summary>Numbers as Unity writes them.</summary>
internal static class Scalars
{
    /// <summary>A number of any size; the field checks the range.</summary>
    internal static bool TryInteger(string text, out Int128 value) =>
        Int128.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out value);

    internal static bool TryNumber(string text, out double value) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && double.IsFinite(value)
        || TryWord(text, out value);

    internal static bool TryNumber(string text, out float value)
    {
        if (float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && float.IsFinite(value))
            return true;
        bool isWord = TryWord(text, out double special);
        value = (float)special;
        return isWord;
    }

    // The word depends on Unity's version and on the system.
    static bool TryWord(string text, out double value)
    {
        string word = (text ?? "").ToLowerInvariant();
        bool isNegative = word.StartsWith('-');
        if (isNegative || word.StartsWith('+'))
            word = word[1..];
        value = word switch
        {
            "nan" or ".nan" => double.NaN,
            "inf" or ".inf" or "infinity" => isNegative ? double.NegativeInfinity : double.PositiveInfinity,
            _ => 0,
        };
        return value != 0;
    }
}
