using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>A part of an SVG picture with two logarithmic axes, and a line at each power of ten.</summary>
sealed class LogPlane
{
    readonly Svg _svg;
    readonly (double From, double To) _across, _down;
    readonly (int First, int Last) _x, _y; // powers of ten

    /// <param name="across">Left and right border in the picture.</param>
    /// <param name="down">Upper and lower border.</param>
    /// <param name="xs">Values along the horizontal axis, which the decades hold.</param>
    /// <param name="ys">Values along the vertical axis.</param>
    public LogPlane(Svg svg, (double From, double To) across, (double From, double To) down,
        IEnumerable<double> xs, IEnumerable<double> ys)
    {
        (_svg, _across, _down) = (svg, across, down);
        (_x, _y) = (Decades(xs), Decades(ys));
    }

    public double X(double value) =>
        _across.From + (Math.Log10(value) - _x.First) / (_x.Last - _x.First) * (_across.To - _across.From);

    public double Y(double value) =>
        _down.To - (Math.Log10(value) - _y.First) / (_y.Last - _y.First) * (_down.To - _down.From);

    public void Draw(string xTitle, string yTitle)
    {
        for (int power = _x.First; power <= _x.Last; power++)
        {
            double x = X(Math.Pow(10, power));
            _svg.Line(x, _down.From, x, _down.To, "#dddddd");
            _svg.Write(x, _down.To + 20, Power(power), "middle");
        }
        for (int power = _y.First; power <= _y.Last; power++)
        {
            double y = Y(Math.Pow(10, power));
            _svg.Line(_across.From, y, _across.To, y, "#dddddd");
            _svg.Write(_across.From - 8, y + 4, Power(power), "end");
        }
        _svg.Write((_across.From + _across.To) / 2, _down.To + 46, xTitle, "middle");
        double centre = (_down.From + _down.To) / 2, left = _across.From - 58;
        _svg.Write(left, centre, yTitle, "middle", ("transform", Text($"rotate(-90 {left} {centre})")));
    }

    static (int First, int Last) Decades(IEnumerable<double> values)
    {
        var powers = values.Select(Math.Log10).ToArray();
        int first = (int)Math.Floor(powers.Min());
        return (first, Math.Max((int)Math.Ceiling(powers.Max()), first + 1));
    }

    static string Power(int power) =>
        power is >= -4 and <= 4 ? Math.Pow(10, power).ToString(CultureInfo.InvariantCulture) : Text($"1e{power}");
}
