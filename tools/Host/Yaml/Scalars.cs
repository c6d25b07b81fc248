using System;
using System.Globalization;

namespace Glint.Host;

/// <summary>Numbers as Unity writes them.</summary>
internal static class Scalars
{
    /// <summary>Signed, or unsigned of 64 bits, whose pattern is kept.</summary>
    internal static bool TryInteger(string text, out long value)
    {
        if (long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out value))
            return true;
        bool isLarge = ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong large);
        value = unchecked((long)large);
        return isLarge;
    }

    internal static bool TryNumber(string text, out double value)
    {
        if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out value))
            return true;
        value = text?.TrimStart('.').ToLowerInvariant() switch
        {
            "inf" or "+inf" or "+.inf" => double.PositiveInfinity,
            "-inf" or "-.inf" => double.NegativeInfinity,
            string nan when nan.Contains("nan", StringComparison.Ordinal) => double.NaN,
            _ => 0,
        };
        return value != 0;
    }
}
