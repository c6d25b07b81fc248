using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading;
using Glint.Core;
using Glint.Reference;

namespace Glint.Cli;

/// <summary>
/// Ray tubes of one scene beside uniform rays, and the converged amplitude by clipped tubes in double precision.
/// </summary>
sealed class AccuracyTubes(AccuracyScene scene, RadarResult result, Series times, Complex converged, double uncertainty,
    AccuracyRow uniform)
{
    /// <summary>Tolerance of the tubes: 1 %.</summary>
    public static readonly double ToleranceDb = 20 * Math.Log10(1 + Goal);

    const double Goal = 0.01;

    // Undivided cells across the picture: of the converged amplitude, and of another whose difference is its
    // uncertainty.
    const int Cells = 2880, OtherCells = 1920;

    public AccuracyScene Scene { get; } = scene;
    public RadarResult Result { get; } = result;
    public Series Times { get; } = times;

    /// <summary>Converged sum of phasors, normalised.</summary>
    public Complex Converged { get; } = converged;

    /// <summary>Difference of its amplitude from that on another grid.</summary>
    public double Uncertainty { get; } = uncertainty;

    /// <summary>Those of <see cref="FewestWithin"/>, or the most traced.</summary>
    public AccuracyRow Uniform { get; } = uniform;

    /// <summary>Rays of <see cref="Uniform"/>, with the sub-rays of its sampling error.</summary>
    public long UniformRays => Uniform.Settings.RayCount + Uniform.Result.Statistics.SubRays;

    /// <summary>Whether uniform rays reach 1 %.</summary>
    public bool IsUniformWithin => Math.Abs(UniformError) <= Goal;

    /// <summary>Relative errors of the amplitude.</summary>
    public double Error => ErrorOf(Result, Converged);

    /// <inheritdoc cref="Error"/>
    public double UniformError => ErrorOf(Uniform.Result, Converged);

    /// <summary>The pose of a scene that ray tubes are traced in.</summary>
    public static RadarPose PoseOf(AccuracyScene scene)
    {
        var settings = RadarSettings.Default;
        settings.ToleranceDb = ToleranceDb;
        return new RadarPose(scene.Scene, settings, scene.View);
    }

    /// <param name="rows">Uniform rays of the scene, in ascending number.</param>
    public static AccuracyTubes Of(AccuracyScene scene, RadarResult result, Series times,
        IReadOnlyList<AccuracyRow> rows, IProgress<double> progress, CancellationToken cancel)
    {
        var pose = PoseOf(scene);
        var converged = ReferenceAmplitude.Of(pose, Cells, new Part(progress, 0, 2), cancel);
        var other = ReferenceAmplitude.Of(pose, OtherCells, new Part(progress, 1, 2), cancel);
        return new AccuracyTubes(scene, result, times, converged, Math.Abs(converged.Magnitude - other.Magnitude),
            FewestWithin(rows, converged) ?? rows[^1]);
    }

    /// <summary>The fewest rays within 1 % from which on more rays stay so; null if there are none.</summary>
    /// <param name="rows">In ascending number of rays.</param>
    public static AccuracyRow FewestWithin(IReadOnlyList<AccuracyRow> rows, Complex converged) =>
        rows.Reverse().TakeWhile(row => Math.Abs(ErrorOf(row.Result, converged)) <= Goal).LastOrDefault();

    static double ErrorOf(RadarResult result, Complex converged) =>
        result.NormalisedAmplitude / converged.Magnitude - 1;
}
