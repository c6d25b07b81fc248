using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Reference;

namespace Glint.Cli;

/// <summary>A scene with its converged amplitude, and what ray tubes and uniform rays took.</summary>
/// <param name="converged">Converged sum of phasors, normalised.</param>
/// <param name="uncertainty">Difference of its amplitude from that on another grid.</param>
sealed class TubeScene(AccuracyScene scene, Complex converged, double uncertainty)
{
    /// <summary>Relative error that the methods are compared at.</summary>
    public const double Goal = 0.01;

    public AccuracyScene Scene { get; } = scene;
    public Complex Converged { get; } = converged;
    public double Uncertainty { get; } = uncertainty;

    /// <summary>Ray tubes, in descending tolerance.</summary>
    public List<TubeRow> Tubes { get; } = [];

    /// <summary>
    /// Of poses that are traced together, asked for the goal: times of each, and the result of the first; null on a device
    /// that one pose fills.
    /// </summary>
    public TubeRow Together { get; set; }

    /// <summary>Uniform rays, in ascending number.</summary>
    public List<TubeRow> Uniform { get; } = [];

    /// <summary>Ray tubes that are asked for the goal.</summary>
    public TubeRow TubesAtGoal => Tubes[Array.IndexOf(TubeBench.Tolerances, Goal)];

    /// <summary>
    /// The fewest uniform rays within the goal from which on more rays stay so; null if there are none.
    /// </summary>
    public TubeRow FewestUniform =>
        Enumerable.Reverse(Uniform).TakeWhile(row => Math.Abs(row.Error) <= Goal).LastOrDefault();

    /// <summary>Relative error of a normalised amplitude.</summary>
    public double ErrorOf(double amplitude) => amplitude / Converged.Magnitude - 1;
}
