using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>
/// The corner reflector in one picture: the radar's view at two angles, and the sweep's amplitude beside the published
/// one.
/// </summary>
static class ReflectorPicture
{
    /// <summary>
    /// Angles in degrees at which the returns are in phase (three bounces only) and out of phase (with the
    /// dihedral's).
    /// </summary>
    public static readonly double[] Angles = [0, 23];

    const int Margin = 14, Top = 76, ViewWidth = 290, ViewHeight = 208;

    const string Sky = "#20242c", Received = "#ffffff";

    // Colours by number of bounces, the last for all higher numbers. They are Okabe and Ito's, for the colour-blind.
    static readonly string[] s_bounces = ["#d55e00", "#009e73", "#0072b2", "#f0e442"];

    public static void Write(Stream stream, IReadOnlyList<RadarPreviewImage> views, SweepResult sweep)
    {
        using var svg = new Svg(stream, Chart.Width, Chart.Height);
        for (int i = 0; i < views.Count; i++)
            DrawView(svg, Margin + i * (ViewWidth + Margin), Text($"the radar's view at {Angles[i]}\u00b0"), views[i]);
        DrawBounces(svg);
        var poses = sweep.Poses.ToArray();
        ChartLine[] lines =
        [
            new("published", ExperimentPlots.Theirs, [.. poses.Select(pose => pose.Theirs.Amplitude)]),
            new("Glint", ExperimentPlots.Ours, [.. poses.Select(pose => pose.Ours.Amplitude)]),
        ];
        var scale = ValueScale.Linear(lines.Max(line => line.Values.Max()));
        Chart.Draw(svg, views.Count * (ViewWidth + Margin), [.. poses.Select(pose => pose.Step)], "turn, degrees",
            new Panel("amplitude (Table A.2)", scale, lines));
    }

    static void DrawView(Svg svg, double left, string title, RadarPreviewImage view)
    {
        svg.Write(left + ViewWidth / 2.0, Top - 18, title, "middle");
        svg.Rectangle(left, Top, ViewWidth, ViewHeight, Sky);
        double size = Math.Min((double)ViewWidth / view.Part.Width, (double)ViewHeight / view.Part.Height);
        double x = left + (ViewWidth - size * view.Part.Width) / 2,
            y = Top + (ViewHeight - size * view.Part.Height) / 2;
        foreach (var colour in Runs(view).GroupBy(run => run.colour, run => (run.x, run.y, run.length)))
            svg.Pixels(x, y, size, colour.Key, colour);
    }

    // Runs of pixels of one colour; row 0 is at the top.
    static IEnumerable<(string colour, int x, int y, int length)> Runs(RadarPreviewImage view)
    {
        for (int row = 0; row < view.Part.Height; row++)
            for (int x = 0, length; x < view.Part.Width; x += length)
            {
                string colour = ColourOf(view, x, row);
                for (length = 1; x + length < view.Part.Width && ColourOf(view, x + length, row) == colour;)
                    length++;
                if (colour != null)
                    yield return (colour, x, row, length);
            }
    }

    static string ColourOf(RadarPreviewImage view, int x, int row)
    {
        int y = view.Part.Height - 1 - row, bounces = view.Bounces(x, y);
        return bounces == 0 ? null
            : view.IsReceived(x, y) ? Received
            : s_bounces[Math.Min(bounces, s_bounces.Length) - 1];
    }

    static void DrawBounces(Svg svg)
    {
        const int y = Top + ViewHeight + 24, size = 12, step = 92;
        for (int i = 0; i <= s_bounces.Length; i++)
        {
            double x = Margin + step * i;
            bool isReceived = i == s_bounces.Length;
            if (isReceived)
                svg.Rectangle(x - 1, y - 1, size + 2, size + 2, Sky);
            svg.Rectangle(x, y, size, size, isReceived ? Received : s_bounces[i]);
            svg.Write(x + size + 6, y + size - 1,
                isReceived ? "received" : i == 0 ? "1 bounce" : Text($"{i + 1} bounces"), "start");
        }
    }
}
