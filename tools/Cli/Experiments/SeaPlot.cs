using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>
/// Numbers of returning snapshots as an SVG picture. Each wind and choppiness has a column. A disc's area is the
/// number of seas with the same number of returning snapshots.
/// </summary>
sealed class SeaPlot
{
    const int Width = 1000, Height = 420, Left = 70, Right = 12, Top = 96, Bottom = 70;
    const string All = "#0072b2", Stored = "#e69f00", Published = "#d55e00";

    readonly Svg _svg;
    readonly int _max;

    SeaPlot(Svg svg, int max)
    {
        _svg = svg;
        _max = max;
    }

    /// <param name="published">Published number of returning snapshots of a sea, and the number of snapshots.</param>
    public static void Write(Stream stream, IReadOnlyList<SeaFamily> families,
        Func<string, (int ReturningSnapshots, int Snapshots)> published)
    {
        using var svg = new Svg(stream, Width, Height);
        var plot = new SeaPlot(svg, families.Max(family => family.First.Snapshots.Count));
        plot.DrawFrame();
        var seas = families.GroupBy(family => family.Sea).ToArray();
        double width = (double)(Width - Left) / seas.Length;
        for (int i = 0; i < seas.Length; i++)
            plot.DrawSea([.. seas[i]], Left + i * width, width - Right, published(seas[i].Key));
    }

    void DrawFrame()
    {
        _svg.Write(Left, 24, $"Snapshots, of {_max}, that return rays", "start");
        double y = 48;
        _svg.Dot(Left + 8, y - 4, All, false, 6);
        _svg.Write(Left + 22, y, "number of seeds (line: their mean)", "start");
        _svg.Dot(Left + 268, y - 4, Stored, true, 6);
        _svg.Write(Left + 282, y, "the stored seed is among them", "start");
        _svg.Line(Left + 490, y - 4, Left + 514, y - 4, Published, 1.5);
        _svg.Write(Left + 522, y, "published", "start");
        for (int count = 0; count <= _max; count += _max > 5 ? 2 : 1)
            _svg.Write(Left - 8, Y(count) + 4, Text($"{count}"), "end");
    }

    void DrawSea(SeaFamily[] families, double left, double width, (int count, int snapshots) published)
    {
        _svg.Write(left + width / 2, Top - 22, families[0].Sea, "middle");
        for (int count = 0; count <= _max; count += _max > 5 ? 2 : 1)
            _svg.Line(left, Y(count), left + width, Y(count), "#dddddd");
        double theirs = Y((double)published.count / published.snapshots * _max);
        _svg.Line(left, theirs, left + width, theirs, Published, 1.5);
        double column = width / families.Length;
        for (int i = 0; i < families.Length; i++)
            DrawColumn(families[i], left + (i + 0.5) * column);
    }

    void DrawColumn(SeaFamily family, double x)
    {
        foreach (var seas in family.Trials.GroupBy(trial => trial.ReturningSnapshots))
        {
            double radius = Math.Round(3 * Math.Sqrt(seas.Count()), 1);
            _svg.Dot(x, Y(seas.Key), All, false, radius);
            if (seas.Contains(family.First))
                _svg.Dot(x, Y(seas.Key), Stored, true, Math.Max(2, Math.Round(radius / 2, 1)));
            _svg.Write(x + radius + 4, Y(seas.Key) + 4, Text($"{seas.Count()}"), "start");
        }
        double mean = Y(family.Share * _max);
        _svg.Line(x - 22, mean, x + 22, mean, "#333333", 2);
        _svg.Write(x, Height - 44, Text($"{family.First.Waves.WindSpeed:0.##} m/s"), "middle");
        _svg.Write(x, Height - 26, Text($"chop {family.First.Waves.Choppiness:0.##}"), "middle");
        if (family.IsStored)
            _svg.Write(x, Height - 8, "as stored", "middle");
    }

    double Y(double count) => Height - Bottom - count / _max * (Height - Bottom - Top);
}
