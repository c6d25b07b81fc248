using System;
using System.Collections.Generic;
using System.Linq;
using Spectre.Console;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>The text report of glint verify.</summary>
sealed class VerifyReport(Terminal terminal)
{
    const int MaxShown = 5;

    public IEnumerable<string> Lines(VerifyResult result)
    {
        var (whole, comparison) = (result.Whole, result.Comparison);
        var (kernel, reference) = (comparison.KernelSums, comparison.ReferenceSums);
        var tables = new TableText(terminal);
        var table = tables.New(1, "ray by ray", "", "");
        void Add(string what, FormattableString value, FormattableString note) =>
            table.AddRow(Escaped(what, Text(value), Text(note)));
        Add("rays compared", $"{comparison.Rays:N0}", $"of {whole.RaysEmitted:N0}");
        Add("  same path as the reference tracer", $"{comparison.Same:N0}", $"");
        Add("  other side of an edge", $"{comparison.AtEdge:N0}",
            $"{1e6 * comparison.AtEdge / Math.Max(1, comparison.Rays):0.#} a million");
        Add("  wrong", $"{comparison.Wrong:N0}", $"");
        Add("received, of those with the same path", $"{kernel.RaysReceived:N0}",
            $"of {whole.RaysReceived:N0} in the picture");
        Add("  length, largest difference", $"{1e6 * comparison.LargestLengthDifference:0.0e+0}", $"um");
        Add("  length, rms of the differences", $"{1e6 * comparison.RmsLengthDifference:0.0e+0}", $"um");
        Add("  phase, largest difference", $"{comparison.LargestPhaseDifference:0.0e+0}", $"rad");
        Add("  amplitude by the kernel", $"{kernel.Amplitude:0.000000}", $"");
        Add("  amplitude by the reference tracer", $"{reference.Amplitude:0.000000}",
            $"kernel {kernel.Amplitude - reference.Amplitude:+0.0e+0;-0.0e+0;+0}");

        yield return $"{result.LoadedScene.Name} on {result.Device.Name}, driver {result.Device.Driver}";
        yield return "";
        foreach (string line in tables.Lines(table))
            yield return line;
        yield return "";
        var settings = result.LoadedScene.Radar.Settings;
        foreach (var (ray, other) in comparison.WrongRays.Take(MaxShown))
            yield return Text(
                $"wrong: pixel {settings.PositionOf(ray.Pixel).x}, {settings.PositionOf(ray.Pixel).y}: kernel {PathText(ray.Bounces, ray.IsReceived, ray.RefinedPathLength)}; reference {PathText(other.Bounces, other.Received, other.LengthToEnd)}");
        string allowed = Text(
            $"{1e6 * VerifyCommand.LengthTolerance:0} um and the rounding of two float32 numbers, 2^-44 of the length");
        yield return comparison.Wrong == 0
            ? "Fine: every ray takes the reference tracer's path, or passes an edge; "
                + $"a received ray may be off by {allowed}."
            : Text($"{comparison.Wrong:N0} rays neither take the reference tracer's path nor pass an edge, or are off by more than {allowed}.");
    }

    static string PathText(long bounces, bool isReceived, double length) =>
        Text($"{bounces} bounces, {(isReceived ? "received" : "lost")}, {length:0.000000} m");
}
