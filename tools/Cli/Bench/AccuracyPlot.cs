using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using static Glint.Cli.TableText;

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
    readonly int _firstTime, _lastTime, _firstError, _lastError; // powers of ten

    AccuracyPlot(Svg svg, AccuracyResult result)
    {
        _svg = svg;
        (_firstTime, _lastTime) = Decades(result.Rows.Select(row => row.Times.Median));
        (_firstError, _lastError) = Decades(result.Rows.SelectMany(
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
        DrawAxes();
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

    void DrawAxes()
    {
        for (int power = _firstTime; power <= _lastTime; power++)
        {
            double x = X(Math.Pow(10, power));
            _svg.Line(x, Top, x, Height - Bottom, "#dddddd");
            _svg.Write(x, Height - Bottom + 20, Power(power), "middle");
        }
        for (int power = _firstError; power <= _lastError; power++)
        {
            double y = Y(Math.Pow(10, power));
            _svg.Line(Left, y, Width - Right, y, "#dddddd");
            _svg.Write(Left - 8, y + 4, Power(power), "end");
        }
        _svg.Write((Left + Width - Right) / 2.0, Height - 18, "time of a pose, milliseconds", "middle");
        double centre = (Top + Height - Bottom) / 2.0;
        _svg.Write(22, centre, "error of the amplitude, relative", "middle",
            ("transform", Text($"rotate(-90 22 {centre})")));
    }

    void DrawScene(string name, AccuracyRow[] rows, int number)
    {
        string colour = s_colours[number % s_colours.Length];
        var points = rows.Select(row => (x: X(row.Times.Median), y: Y(Relative(row, row.AmplitudeError)),
            estimate: Y(Relative(row, row.Result.SamplingError.Value)), row)).ToArray();
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

    static (int first, int last) Decades(IEnumerable<double> values) =>
        ((int)Math.Floor(Math.Log10(values.Min())),
            (int)Math.Max(Math.Ceiling(Math.Log10(values.Max())), Math.Floor(Math.Log10(values.Min())) + 1));

    static string Range(AccuracyResult result) =>
        $"{result.Rows.Min(row => row.Settings.RaysAcross)} to "
        + $"{result.Rows.Max(row => row.Settings.RaysAcross)} rays across";

    static string Power(int power) =>
        power is >= -4 and <= 4 ? Math.Pow(10, power).ToString(CultureInfo.InvariantCulture) : Text($"1e{power}");

    double X(double time) => Left + (Math.Log10(time) - _firstTime) / (_lastTime - _firstTime) * (Width - Right - Left);

    double Y(double error) =>
        Height - Bottom - (Math.Log10(error) - _firstError) / (_lastError - _firstError) * (Height - Bottom - Top);
}
