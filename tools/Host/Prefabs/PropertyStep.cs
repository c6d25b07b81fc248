using System;
using System.Collections.Generic;
using System.Globalization;

namespace Glint.Host;

/// <summary>
/// A step of a property path, for example <c>list.Array.data[0].x</c>: a name, the size of an array, or an index.
/// </summary>
internal readonly record struct PropertyStep(string Name, int Index)
{
    const int SizeMark = -1;

    // Unity nests serialized classes at most ten deep; far longer paths would overflow the stack.
    const int MaxSteps = 100;

    internal bool IsName => Name is not null;

    internal bool IsSize => !IsName && Index == SizeMark;

    internal static PropertyStep Size => new(null, SizeMark);

    /// <summary>Null if the path is malformed.</summary>
    internal static IReadOnlyList<PropertyStep> Parse(string path)
    {
        const string DataStart = "data[";
        List<PropertyStep> steps = new();
        string[] parts = path.Split('.');
        if (parts.Length > MaxSteps)
            return null;
        for (int i = 0; i < parts.Length; i++)
        {
            bool isArray = parts[i] == "Array" && i > 0 && i + 1 < parts.Length;
            if (!isArray)
            {
                if (parts[i].Length == 0)
                    return null;
                steps.Add(new PropertyStep(parts[i], 0));
                continue;
            }
            string next = parts[++i];
            if (next == "size")
                steps.Add(Size);
            else if (next.StartsWith(DataStart, StringComparison.Ordinal) && next.EndsWith(']')
                && int.TryParse(next.AsSpan(DataStart.Length, next.Length - DataStart.Length - 1), NumberStyles.None,
                    CultureInfo.InvariantCulture, out int index))
                steps.Add(new PropertyStep(null, index));
            else
                return null;
        }
        return steps;
    }
}
