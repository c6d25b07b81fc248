using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Spectre.Console;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>The accuracy benchmark's figures as tables.</summary>
sealed class AccuracyTables(Terminal terminal)
{
    readonly TableText _text = new(terminal);

    public IEnumerable<string> Lines(AccuracyResult result)
    {
        yield return $"{result.Device.Name}, driver {result.Device.Driver}; medians of up to {result.Rounds} poses";
        yield return Text(
            $"Amplitudes are normalised to {RadarResult.NormalRays:N0} rays; errors are relative to the converged result. *: flagged as undersampled.");
        foreach (var scene in result.Rows.GroupBy(row => row.Scene))
        {
            var converged = scene.First().Converged;
            yield return "";
            yield return Text(
                $"{scene.Key.Name}: amplitude {converged.Sum.Magnitude:0.00}, uncertainty about {converged.Uncertainty:0.00}");
            foreach (string line in _text.Lines(Rows(scene)))
                yield return line;
        }
        yield return "";
        yield return Text(
            $"The tracer's sums less the reference tracer's over the same rays, {RadarSettings.Default.RaysAcross} x {RadarSettings.Default.RaysDown}, and the change by path lengths in float32, at the same and at larger ranges; in rays");
        foreach (string line in _text.Lines(Precision(result)))
            yield return line;
        yield return "";
        yield return $"Cost of parts of a pose's work: {result.CostScene.Name}, "
            + $"{RadarSettings.Default.RaysAcross} x {RadarSettings.Default.RaysDown} rays";
        foreach (string line in _text.Lines(Costs(result)))
            yield return line;
    }

    Table Rows(IEnumerable<AccuracyRow> rows)
    {
        var table = _text.New(1, "rays", "ms", "received", "amplitude", "error", "estimate",
            "phase, rad", "hits, %", "step, wl");
        foreach (var row in rows)
            table.AddRow(
                Escaped($"{row.Settings.RaysAcross} x {row.Settings.RaysDown}{(row.Result.Undersampled ? " *" : "")}",
                Ms(row.Times.Median), Text($"{row.Result.RaysReceived:N0}"),
                    Text($"{row.Result.NormalisedAmplitude:0.00}"), Text($"{row.AmplitudeError:+0.00;-0.00;0.00}"),
                    Text($"{row.Result.SamplingError:0.00}"),
                    Text($"{row.PhaseError:+0.000;-0.000;0.000}"), Text($"{100 * row.HitsError:+0.000;-0.000;0.000}"),
                    Text($"{row.Result.LargestPathStep:0.00}")));
        return table;
    }

    Table Precision(AccuracyResult result)
    {
        var table = _text.New(1, ["scene", "received", "hits", "sum", .. AccuracyPrecision.Float32Ranges.Select(
            range => range == 0 ? "float32" : Text($"+{range / 1000:0} km"))]);
        foreach (var row in result.Precision)
            table.AddRow(Escaped([row.Scene.Name, Text($"{row.ReceivedDifference:+0;-0;0} of {row.RaysReceived:N0}"),
                Text($"{row.HitsDifference:+0;-0;0}"), Text($"{row.SumDifference:0.0e+0}"),
                .. row.Float32Differences.Select(difference => Text($"{difference:0.0e+0}"))]));
        return table;
    }

    Table Costs(AccuracyResult result)
    {
        var table = _text.New(1, "", "ms", "lowest", "of usual", "received", "sub-rays", "sums");
        double usual = result.Costs[0].Times.Median;
        foreach (var cost in result.Costs)
            table.AddRow(Escaped(cost.What, Ms(cost.Times.Median), Ms(cost.Times.Lowest),
                Text($"{100 * cost.Times.Median / usual:0} %"), Text($"{cost.RaysReceived:N0}"),
                Text($"{cost.SubRays:N0}"), cost.IsSame ? "same" : "other"));
        return table;
    }
}
