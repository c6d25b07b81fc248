using System;
using System.Globalization;

namespace Glint.Host;

/// <summary>Numbers in Unity's format: a default format for each type, in the invariant culture.</summary>
internal static class FloatFormat
{
    internal static string Tuple(string format, IFormatProvider provider, string defaultFormat, params float[] values)
    {
        return "(" + Join(format, provider, defaultFormat, values) + ")";
    }

    internal static string Join(string format, IFormatProvider provider, string defaultFormat, params float[] values)
    {
        return string.Join(", ", Array.ConvertAll(values, v => Text(v, format, provider, defaultFormat)));
    }

    internal static string Text(float value, string format, IFormatProvider provider, string defaultFormat)
    {
        return value.ToString(string.IsNullOrEmpty(format) ? defaultFormat : format,
            provider ?? CultureInfo.InvariantCulture.NumberFormat);
    }

    internal static string Tuple(string format, IFormatProvider provider, params int[] values)
    {
        var culture = provider ?? CultureInfo.InvariantCulture.NumberFormat;
        return "(" + string.Join(", ", Array.ConvertAll(values, v => v.ToString(format, culture))) + ")";
    }
}
