using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;

namespace Glint.Cli;

/// <summary>
/// Times in a program's output: each number before " ms". Its name is the words before the line's first number: "frame
/// 81.3 ms" is a time named frame, "bvh 1024 nodes 12.5 ms" one named bvh.
/// </summary>
sealed partial class PeerOutput
{
    const string Nameless = "time";

    readonly Dictionary<string, Series> _times = [];
    readonly List<string> _labels = [];

    public PeerOutput(string text)
    {
        foreach (string line in text.Split('\n').Select(line => line.Trim()).Where(line => line.Length > 0))
        {
            LastLine = line;
            Read(line);
        }
    }

    /// <summary>Names of the times, in order of first appearance.</summary>
    public IReadOnlyList<string> Labels => _labels;

    /// <summary>The last line that is not empty; null when there is none.</summary>
    public string LastLine { get; }

    /// <summary>Median of the times of a name.</summary>
    public double Median(string label) => _times[label].Median;

    void Read(string line)
    {
        string label = Nameless;
        int from = 0;
        foreach (Match time in Time().Matches(line))
        {
            string text = SingleSpaced(line[from..time.Index]);
            if (text.Length > 0)
                label = text;
            if (!_times.ContainsKey(label))
            {
                _times[label] = new Series();
                _labels.Add(label);
            }
            _times[label].Add(double.Parse(time.Groups[1].ValueSpan, NumberStyles.Float, CultureInfo.InvariantCulture));
            from = time.Index + time.Length;
        }
    }

    // The text before the first word that begins with a digit, without surrounding punctuation.
    static string SingleSpaced(string text) => string.Join(' ', text.Split(' ', StringSplitOptions.RemoveEmptyEntries)
        .TakeWhile(word => !char.IsAsciiDigit(word[0])).Select(word => word.Trim(',', ';', ':', '=', '(', ')'))
        .Where(word => word.Length > 0));

    [GeneratedRegex(@"(?<![\w.])(\d+(?:\.\d+)?(?:[eE][+-]?\d+)?) ms\b")]
    private static partial Regex Time();
}
