using System;
using System.IO;
using System.Linq;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>
/// Cross sections over an angle as an SVG picture: VV on the left, HH on the right. The first curve, of others, is
/// broad and pale, the last one dark and drawn over it.
/// </summary>
sealed class CrossSectionPlot
{
    const int Width = 1000, Height = 440, Left = 78, Right = 12, Top = 92, Bottom = 56;

    // Pale to dark: the curves differ in lightness too.
    static readonly (string Colour, double Thickness)[] s_pens = [("#f0b040", 4), ("#999999", 1.5), ("#00518a", 1.5)];

    readonly Svg _svg;
    readonly CrossSectionCurve[] _curves;
    readonly (double Min, double Max) _dbsm;
    readonly double _maxDegrees;

    CrossSectionPlot(Svg svg, CrossSectionCurve[] curves, (double, double) dbsm) =>
        (_svg, _curves, _dbsm, _maxDegrees) = (svg, curves, dbsm, curves[0].Rows[^1].Degrees);

    /// <param name="angle">Title of the angles.</param>
    /// <param name="dbsm">Range shown, multiples of ten. Values outside it lie at its ends.</param>
    /// <param name="curves">Two or three, that of others first.</param>
    public static void Write(Stream stream, string title, string angle, (double Min, double Max) dbsm,
        params CrossSectionCurve[] curves)
    {
        using var svg = new Svg(stream, Width, Height);
        var plot = new CrossSectionPlot(svg, curves, dbsm);
        svg.Write(Left, 24, title, "start");
        for (int i = 0; i < curves.Length; i++)
        {
            double x = Left + 200 * i;
            svg.Line(x, 46, x + 28, 46, plot.PenOf(i).Colour, plot.PenOf(i).Thickness);
            svg.Write(x + 36, 50, curves[i].Name, "start");
        }
        plot.DrawPanel(0, "VV", angle, row => row.VV);
        plot.DrawPanel(Width / 2, "HH", angle, row => row.HH);
    }

    // Two curves take the first and the last pen.
    (string Colour, double Thickness) PenOf(int curve) => s_pens[curve == _curves.Length - 1 ? ^1 : curve];

    void DrawPanel(double left, string title, string angle, Func<(double Degrees, double VV, double HH), double> dbsmOf)
    {
        double from = left + Left, to = left + Width / 2.0 - Right, foot = Height - Bottom;
        double X(double degrees) => from + degrees / _maxDegrees * (to - from);
        double Y(double dbsm) =>
            foot - (Math.Clamp(dbsm, _dbsm.Min, _dbsm.Max) - _dbsm.Min) / (_dbsm.Max - _dbsm.Min) * (foot - Top);
        _svg.Write((from + to) / 2, Top - 12, $"{title}, dBsm", "middle");
        for (double dbsm = _dbsm.Min; dbsm <= _dbsm.Max; dbsm += 10)
        {
            _svg.Line(from, Y(dbsm), to, Y(dbsm), "#dddddd");
            _svg.Write(from - 8, Y(dbsm) + 4, Text($"{dbsm:0}"), "end");
        }
        for (double degrees = 0; degrees <= _maxDegrees; degrees += _maxDegrees / 6)
        {
            _svg.Line(X(degrees), foot, X(degrees), foot + 4, "#888888");
            _svg.Write(X(degrees), foot + 20, Text($"{degrees:0}"), "middle");
        }
        _svg.Write((from + to) / 2, Height - 12, angle, "middle");
        for (int i = 0; i < _curves.Length; i++)
            _svg.Polyline(_curves[i].Rows.Select(row => (X(row.Degrees), Y(dbsmOf(row)))), PenOf(i).Colour,
                PenOf(i).Thickness);
    }
}
