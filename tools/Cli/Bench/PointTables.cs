using System;
using System.Collections.Generic;
using Spectre.Console;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>Rays of ray tubes and of point sampling as a table.</summary>
sealed class PointTables(Terminal terminal)
{
    readonly TableText _text = new(terminal);

    public IEnumerable<string> Lines(PointResult result)
    {
        yield return $"{result.Device.Name}, driver {result.Device.Driver}";
        yield return Text(
            $"{result.Subject}, {result.Triangles:N0} triangles, {result.FrequencyHz / 1e9:0.###} GHz, {result.GrazingDegrees:0.###} deg of grazing, without edges");
        yield return Text(
            $"Million rays to {PointResult.ToleranceDb} dB by ray tubes and by uniform points, and of {PointResult.UsualAcross} x {PointResult.UsualAcross} points a square of {result.Side:0.####} m. *: not reached");
        yield return Text(
            $"error: measured in dB of the weaker of VV and HH; 95 % of {result.Grids} random grids do not exceed it");
        foreach (string line in _text.Lines(Rows(result)))
            yield return line;
    }

    Table Rows(PointResult result)
    {
        var table = _text.New(1, "azimuth", "dBsm", "tubes", "error", $"of {PointResult.UsualAcross}", "error",
            "across", "rays", "ratio");
        foreach (var row in result.Rows)
        {
            var tubes = row.Tubes[^1];
            var usual = row.Points.Find(points => points.Setting == PointResult.UsualAcross);
            table.AddRow(Escaped(Text($"{row.AzimuthDegrees:0.###}"),
                Text($"{20 * Math.Log10(row.Scale):0.00}"), Millions(tubes.Rays), Bound(row, tubes),
                Millions(usual.Rays), Bound(row, usual), Text($"{row.Enough.Setting}"), Millions(row.Enough.Rays),
                Text($"{row.Ratio:0.0}{(row.IsReached ? "" : " *")}")));
        }
        return table;
    }

    static string Millions(long rays) => Text($"{rays / 1e6:0.000}");

    static string Bound(PointRow row, Sampling sampling) => Text($"{PointRow.BoundDb(row.ErrorOf(sampling)):0.000}");
}
