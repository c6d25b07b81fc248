using System;
using System.Collections.Generic;
using System.Linq;
using Spectre.Console;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>Ray tubes beside uniform rays as tables.</summary>
sealed class TubeTables(Terminal terminal)
{
    readonly TableText _text = new(terminal);

    public IEnumerable<string> Lines(TubeResult result)
    {
        yield return $"{result.Device.Name}, driver {result.Device.Driver}; medians of {result.Rounds} rounds";
        yield return "";
        yield return "Over all scenes: geometric means of rays and times, median and largest of the errors";
        foreach (string line in _text.Lines(Means(result)))
            yield return line;
        yield return "";
        yield return Text(
            $"Ray tubes to {TubeScene.Goal:0 %}, beside the fewest uniform rays that reach it (*: none does; the most traced)");
        foreach (string line in _text.Lines(AtTheGoal(result)))
            yield return line;
        double rays = result.RatioAtGoal(scene => scene.TubesAtGoal, row => row.Rays);
        if (double.IsNaN(rays))
            yield break;
        yield return "";
        yield return Text($"Where uniform rays reach it, they take {rays:0.0} times the rays and ")
            + TimesOf(result, scene => scene.TubesAtGoal) + " (geometric means)";
        if (result.PosesTogether > 1)
            yield return $"Of {result.PosesTogether} poses of tubes together, they take " + TimesOf(result, scene => scene.Together);
    }

    static string TimesOf(TubeResult result, Func<TubeScene, TubeRow> tubesOf)
    {
        double time = result.RatioAtGoal(tubesOf, row => row.Times.Median),
            kernels = result.RatioAtGoal(tubesOf, row => row.KernelTimes.Median);
        return Text($"{time:0.00} times the time")
            + (double.IsNaN(kernels) ? "" : Text($", {kernels:0.00} times that of the kernels"));
    }

    Table Means(TubeResult result)
    {
        var table = _text.New(1, "", "rays", "ms", "kernels, ms", "error, %", "largest, %");
        void Add(string name, TubeMean mean) => table.AddRow(Escaped(name, Text($"{mean.Rays:N0}"), Ms(mean.Time), Ms(mean.KernelTime),
            Text($"{100 * mean.Error:0.00}"), Text($"{100 * mean.LargestError:0.00}")));
        foreach (var (tolerance, mean) in TubeBench.Tolerances.Zip(result.TubeMeans))
            Add(Text($"tubes, {100 * tolerance} %"), mean);
        if (result.PosesTogether > 1)
            Add(Text($"tubes, {100 * TubeScene.Goal} %, {result.PosesTogether} poses together"), result.TogetherMean);
        foreach (var (across, mean) in AccuracyBench.Across.Zip(result.UniformMeans))
            Add(Text($"uniform, {across} x {AccuracyBench.SettingsOf(across).RaysDown}"), mean);
        return table;
    }

    Table AtTheGoal(TubeResult result)
    {
        var table = _text.New(1, "scene", "converged", "rays", "ms", "error, %", "said, %", "uniform rays", "ms",
            "error, %");
        foreach (var scene in result.Scenes)
        {
            var tubes = scene.TubesAtGoal;
            var uniform = scene.FewestUniform ?? scene.Uniform[^1];
            table.AddRow(Escaped(scene.Scene.Name,
                Text($"{scene.Converged.Magnitude:0.000} ± {scene.Uncertainty:0.000}"),
                Text($"{tubes.Rays:N0}"), Ms(tubes.Times.Median), Percent(tubes.Error),
                Text($"{100 * tubes.Result.SamplingError / tubes.Result.NormalisedAmplitude:0.00}"),
                Text($"{uniform.Rays:N0}{(scene.FewestUniform == null ? " *" : "")}"), Ms(uniform.Times.Median),
                Percent(uniform.Error)));
        }
        return table;
    }

    static string Percent(double error) => Text($"{100 * error:+0.00;-0.00;0.00}");
}
