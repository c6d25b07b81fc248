using System.Collections.Generic;

namespace Glint.Cli;

/// <summary>A line of a chart: a value at each step.</summary>
/// <param name="Lowest">
/// With <paramref name="Highest"/> the edges of a band around the line; null without a band.
/// </param>
sealed record ChartLine(string Name, string Colour, IReadOnlyList<double> Values, IReadOnlyList<double> Lowest = null,
    IReadOnlyList<double> Highest = null);
