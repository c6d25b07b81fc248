using System;
using System.IO;
using System.Linq;

namespace Glint.Cli;

/// <summary>Error against time as an SVG picture with two logarithmic axes and a line for each scene.</summary>
sealed class AccuracyPlot
{
    const int Width = 1000, Height = 560, Left = 80, Right = 290, Top = 40, Bottom = 64;

    // Lowest relative error drawn: the uncertainty of the converged results.
    const double MinError = 1e-4;

    static readonly string[] s_colours =
        ["#0072b2", "#56b4e9", "#009e73", "#cc79a7", "#e69f00", "#d55e00", "#7f3c8d", "#555555"];

    readonly Svg _svg;
    readonly LogPlane _plane;

    AccuracyPlot(Svg svg, AccuracyResult result)
    {
        _svg = svg;
        _plane = new LogPlane(svg, (Left, Width - Right), (Top, Height - Bottom),
            result.Rows.Select(row => row.Times.Median), result.Rows.SelectMany(
                row => new[] { Relative(row, row.AmplitudeError), Relative(row, row.Result.SamplingError.Value) }));
    }

    public static void Write(Stream stream, AccuracyResult result)
    {
        using var svg = new Svg(stream, Width, Height);
        new AccuracyPlot(svg, result).Draw(result);
    }

    void Draw(AccuracyResult result)
    {
        _svg.Write(Left, 24, "Error of the amplitude against time of a pose, " + result.Device.Name, "start");
        _plane.Draw("time of a pose, milliseconds", "error of the amplitude, relative");
        int number = 0;
        foreach (var scene in result.Rows.GroupBy(row => row.Scene))
            DrawScene(scene.Key.Name, [.. scene], number++);
        int y = Top + 28 + 22 * number;
        foreach (string line in new[]
        {
            "filled: error", "hollow: error, flagged as undersampled", "cross: estimate of the error",
            "left to right: " + Range(result)
        })
            _svg.Write(Width - Right + 20, y += 20, line, "start");
    }

    void DrawScene(string name, AccuracyRow[] rows, int number)
    {
        string colour = s_colours[number % s_colours.Length];
        var points = rows.Select(row => (x: _plane.X(row.Times.Median),
            y: _plane.Y(Relative(row, row.AmplitudeError)), estimate: _plane.Y(Relative(row, row.Result.SamplingError.Value)), row)).ToArray();
        _svg.Polyline(points.Select(point => (point.x, point.y)), colour);
        foreach (var (x, y, estimate, row) in points)
        {
            _svg.Dot(x, y, colour, row.Result.Undersampled);
            _svg.Line(x - 4, estimate - 4, x + 4, estimate + 4, colour);
            _svg.Line(x - 4, estimate + 4, x + 4, estimate - 4, colour);
        }
        int legend = Top + 14 + 22 * number;
        _svg.Line(Width - Right + 20, legend - 4, Width - Right + 44, legend - 4, colour, 1.5);
        _svg.Dot(Width - Right + 32, legend - 4, colour, false);
        _svg.Write(Width - Right + 52, legend, name, "start");
    }

    static double Relative(AccuracyRow row, double error) =>
        Math.Max(MinError, Math.Abs(error) / row.Converged.Sum.Magnitude);

    static string Range(AccuracyResult result) =>
        $"{result.Rows.Min(row => row.Settings.RaysAcross)} to "
        + $"{result.Rows.Max(row => row.Settings.RaysAcross)} rays across";
}
