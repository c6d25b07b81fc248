using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Glint.Cli;

/// <summary>
/// Error of ray tubes and of uniform rays as an SVG picture: over the rays on the left, over the time on the right. A
/// small dot is a scene, a line joins what all scenes are like.
/// </summary>
sealed class TubePlot
{
    const int Width = 1000, Height = 480, Left = 80, Gap = 90, Right = 16, Top = 80, Bottom = 64;

    // Lowest relative error drawn: about the uncertainty of the converged results.
    const double MinError = 1e-4;

    const string Tubes = "#0072b2", Uniform = "#e69f00";

    readonly Svg _svg;
    readonly TubeResult _result;

    TubePlot(Svg svg, TubeResult result) => (_svg, _result) = (svg, result);

    public static void Write(Stream stream, TubeResult result)
    {
        using var svg = new Svg(stream, Width, Height);
        new TubePlot(svg, result).Draw();
    }

    void Draw()
    {
        _svg.Write(Left, 24, "Ray tubes beside uniform rays, " + _result.Device.Name, "start");
        DrawLegend(Left, "ray tubes", Tubes, false);
        DrawLegend(Left + 150, "uniform rays", Uniform, true);
        _svg.Write(Left + 320, 52,
            $"small: {_result.Scenes.Count} scenes; large: median error at the geometric mean of rays or time",
            "start");
        double width = (Width - Left - Gap - Right) / 2.0;
        DrawPanel(Left, width, "rays of a pose, sub-rays included", row => row.Rays, mean => mean.Rays);
        DrawPanel(Left + width + Gap, width, "time of a pose, milliseconds", row => row.Times.Median,
            mean => mean.Time);
    }

    void DrawLegend(double x, string name, string colour, bool isHollow)
    {
        _svg.Line(x, 48, x + 28, 48, colour, 2.5);
        _svg.Dot(x + 14, 48, colour, isHollow, 5);
        _svg.Write(x + 36, 52, name, "start");
    }

    void DrawPanel(double left, double width, string title, Func<TubeRow, double> valueOf,
        Func<TubeMean, double> meanOf)
    {
        var all = _result.Scenes.SelectMany(scene => scene.Tubes.Concat(scene.Uniform)).ToArray();
        var plane = new LogPlane(_svg, (left, left + width), (Top, Height - Bottom), all.Select(valueOf),
            all.Select(row => Shown(row.Error)));
        plane.Draw(title, "error of the amplitude, relative");
        Draw(_result.Scenes.SelectMany(scene => scene.Uniform), _result.UniformMeans, Uniform, true);
        Draw(_result.Scenes.SelectMany(scene => scene.Tubes), _result.TubeMeans, Tubes, false);

        void Draw(IEnumerable<TubeRow> rows, IEnumerable<TubeMean> means, string colour, bool isHollow)
        {
            foreach (var row in rows)
                _svg.Dot(plane.X(valueOf(row)), plane.Y(Shown(row.Error)), colour, isHollow, 2.5);
            var line = means.Select(mean => (x: plane.X(meanOf(mean)), y: plane.Y(Shown(mean.Error)))).ToArray();
            _svg.Polyline(line, colour, 2.5);
            foreach (var (x, y) in line)
                _svg.Dot(x, y, colour, isHollow, 5);
        }
    }

    static double Shown(double error) => Math.Max(MinError, Math.Abs(error));
}
