using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>Ray tubes beside uniform rays.</summary>
sealed class TubeResult
{
    public DeviceInfo Device { get; init; }
    public int Rounds { get; init; }

    /// <summary>Poses of ray tubes that are traced together.</summary>
    public int PosesTogether { get; init; }

    public List<TubeScene> Scenes { get; } = [];

    /// <summary>Over the scenes, for each tolerance of the tubes.</summary>
    public IEnumerable<TubeMean> TubeMeans => Means(scene => scene.Tubes);

    /// <summary>Over the scenes, for each number of uniform rays.</summary>
    public IEnumerable<TubeMean> UniformMeans => Means(scene => scene.Uniform);

    /// <summary>Of poses that are traced together; null if none are.</summary>
    public TubeMean TogetherMean => PosesTogether > 1 ? Means(scene => [scene.Together]).Single() : null;

    /// <summary>
    /// What uniform rays take to the goal for each of what tubes take: geometric mean over the scenes in which they reach it.
    /// NaN if there are none.
    /// </summary>
    public double RatioAtGoal(Func<TubeScene, TubeRow> tubesOf, Func<TubeRow, double> value) =>
        new Series(Scenes.Where(scene => scene.FewestUniform != null)
            .Select(scene => value(scene.FewestUniform) / value(tubesOf(scene)))).GeometricMean;

    IEnumerable<TubeMean> Means(Func<TubeScene, IReadOnlyList<TubeRow>> rowsOf) =>
        Enumerable.Range(0, rowsOf(Scenes[0]).Count).Select(i =>
            new TubeMean([.. Scenes.Select(scene => rowsOf(scene)[i])]));
}

/// <summary>One tolerance, or one number of uniform rays, over all scenes.</summary>
sealed class TubeMean(TubeRow[] rows)
{
    readonly Series _errors = new(rows.Select(row => Math.Abs(row.Error)));

    /// <summary>Geometric mean.</summary>
    public double Rays => Mean(row => row.Rays);

    /// <summary>Geometric mean, milliseconds.</summary>
    public double Time => Mean(row => row.Times.Median);

    /// <summary>The same of the kernels; NaN on a device without a clock.</summary>
    public double KernelTime => Mean(row => row.KernelTimes.Median);

    /// <summary>Median of the magnitudes.</summary>
    public double Error => _errors.Median;

    public double LargestError => _errors.Highest;

    double Mean(Func<TubeRow, double> value) => new Series(rows.Select(value)).GeometricMean;
}
