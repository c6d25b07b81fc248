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
            $"Million rays of a direction. at {PointResult.UsualAcross}: {PointResult.UsualAcross} points along {result.Side:0.####} m; points: those that reach {PointResult.ToleranceDb} dB. *: not to {PointResult.ToleranceDb} dB.");
        yield return Text(
            $"error: in dB of the weaker of VV and HH, of tubes the one measured, of points what 95 % of {result.Offsets} random offsets do not exceed.");
        foreach (string line in _text.Lines(Rows(result)))
            yield return line;
    }

    Table Rows(PointResult result)
    {
        var table = _text.New(1, "azimuth", "dBsm", "tubes", "error", $"at {PointResult.UsualAcross}", "error", "points",
            "rays", "ratio");
        foreach (var row in result.Rows)
        {
            var usual = row.Points.Find(points => points.Across == PointResult.UsualAcross);
            var enough = row.Enough ?? row.Points[^1];
            bool isEnough = row.Enough != null;
            table.AddRow(Escaped(Text($"{row.AzimuthDegrees:0.###}"),
                Text($"{20 * Math.Log10(row.TubesError.Scale):0.00}"),
                Text($"{Millions(row.Tubes.Rays)}{(row.Tubes.IsMet ? "" : " *")}"), Text($"{row.TubesError.ErrorDb:0.000}"),
                Millions(usual.Rays), Text($"{PointRow.BoundDb(usual.Error):0.000}"),
                Text($"{enough.Across}{(isEnough ? "" : " *")}"), Millions(enough.Rays),
                Text($"{(isEnough ? "" : "> ")}{row.Ratio:0.0}")));
        }
        return table;
    }

    static string Millions(long rays) => Text($"{rays / 1e6:0.000}");
}
