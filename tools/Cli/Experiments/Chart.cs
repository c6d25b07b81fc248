using System.Collections.Generic;
using System.IO;
using System.Linq;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>
/// Lines over the steps of a sweep as an SVG picture: panels side by side, all with the same lines and steps.
/// </summary>
sealed class Chart
{
    public const int Width = 1000, Height = 340;

    const int LongNames = 230, ShortNames = 157;

    const int Left = 78, Right = 12, Top = 76, Bottom = 56;

    readonly Svg _svg;
    readonly IReadOnlyList<double> _steps;
    readonly double _panelWidth;

    Chart(Svg svg, IReadOnlyList<double> steps, double panelWidth)
    {
        _svg = svg;
        _steps = steps;
        _panelWidth = panelWidth;
    }

    /// <param name="steps">Angles or snapshots, ascending.</param>
    /// <param name="stepTitle">Title of the steps.</param>
    public static void Write(Stream stream, string title, IReadOnlyList<double> steps,
        string stepTitle, params Panel[] panels)
    {
        using var svg = new Svg(stream, Width, Height);
        var chart = new Chart(svg, steps, (double)Width / panels.Length);
        svg.Write(Left, 24, title, "start");
        chart.DrawLegend(panels[0].Lines, LongNames);
        for (int i = 0; i < panels.Length; i++)
            chart.DrawPanel(panels[i], i * chart._panelWidth, stepTitle);
    }

    /// <summary>One panel of a chart's height within a larger picture, with the legend at its upper right.</summary>
    public static void Draw(Svg svg, double left, IReadOnlyList<double> steps, string stepTitle, Panel panel)
    {
        var chart = new Chart(svg, steps, Width - left);
        chart.DrawLegend(panel.Lines, ShortNames);
        chart.DrawPanel(panel, left, stepTitle);
    }

    void DrawLegend(IReadOnlyList<ChartLine> lines, double length)
    {
        for (int i = 0; i < lines.Count; i++)
        {
            double x = Width - Right - length * (lines.Count - i);
            _svg.Line(x, 20, x + 24, 20, lines[i].Colour, 1.5);
            _svg.Dot(x + 12, 20, lines[i].Colour, false, 2.5);
            _svg.Write(x + 32, 24, lines[i].Name, "start");
        }
    }

    void DrawPanel(Panel panel, double left, string stepTitle)
    {
        double from = left + Left, to = left + _panelWidth - Right;
        _svg.Write((from + to) / 2, Top - 18, panel.Title, "middle");
        foreach (var (position, label) in panel.Scale.Marks)
        {
            _svg.Line(from, Y(position), to, Y(position), "#dddddd");
            _svg.Write(from - 8, Y(position) + 4, label, "end");
        }
        foreach (double step in MarkedSteps())
        {
            _svg.Line(X(step, left), Y(0), X(step, left), Y(0) + 4, "#888888");
            _svg.Write(X(step, left), Y(0) + 20, Text($"{step}"), "middle");
        }
        _svg.Write((from + to) / 2, Height - 12, stepTitle, "middle");
        foreach (var line in panel.Lines)
            Draw(line, panel.Scale, left);
    }

    void Draw(ChartLine line, ValueScale scale, double left)
    {
        if (line.Lowest != null)
        {
            // A value that cannot be shown is drawn at the foot, so that the band reaches down to it.
            var edge = Points(line.Highest).Concat(Points(line.Lowest).Reverse());
            _svg.Area(edge.Select(position => (position.x, double.IsNaN(position.y) ? Y(0) : position.y)), line.Colour);
        }
        var run = new List<(double, double)>();
        foreach (var at in Points(line.Values).Append((double.NaN, double.NaN)))
        {
            if (!double.IsNaN(at.Item2))
            {
                run.Add(at);
                _svg.Dot(at.Item1, at.Item2, line.Colour, false, 2);
                continue;
            }
            if (run.Count > 1)
                _svg.Polyline(run, line.Colour);
            run.Clear();
        }

        IEnumerable<(double x, double y)> Points(IReadOnlyList<double> values) =>
            _steps.Select((step, i) => (X(step, left), Y(scale.Of(values[i]))));
    }

    // A few steps at round numbers.
    IEnumerable<double> MarkedSteps()
    {
        double span = _steps[^1] - _steps[0], every = span > 180 ? 90 : span > 20 ? 15 : 1;
        for (double step = _steps[0]; step <= _steps[^1]; step += every)
            yield return step;
    }

    double X(double step, double left) => left + Left
        + (_steps.Count < 2 ? 0.5 : (step - _steps[0]) / (_steps[^1] - _steps[0])) * (_panelWidth - Left - Right);

    static double Y(double position) => Height - Bottom - position * (Height - Bottom - Top);
}
