using System.Numerics;
using Glint.Core;
using Glint.Reference;

namespace Glint.Cli;

/// <summary>One scene at one number of rays: time of a pose and error against the converged result.</summary>
sealed class AccuracyRow(AccuracyScene scene, RadarSettings settings, RadarResult result, Series times,
    AccuracyReference converged)
{
    public AccuracyScene Scene { get; } = scene;
    public RadarSettings Settings { get; } = settings;
    public RadarResult Result { get; } = result;

    /// <summary>Time of tracing and summing, with the scene already on the device.</summary>
    public Series Times { get; } = times;

    public AccuracyReference Converged { get; } = converged;

    /// <summary>Error of the normalised amplitude.</summary>
    public double AmplitudeError => Result.NormalisedAmplitude - Converged.Sum.Magnitude;

    /// <summary>Error of the summed phasor's phase, in radians from -pi to pi.</summary>
    public double PhaseError => new Complex(Result.InPhase, Result.Quadrature) is var sum && sum != 0
        && Converged.Sum != 0 ? (sum / Converged.Sum).Phase : 0;

    /// <summary>Relative error of the number of rays that hit.</summary>
    public double HitsError =>
        Converged.Hits > 0 ? Result.RaysHit * RadarResult.NormalRays / Result.RaysOfPicture / Converged.Hits - 1 : 0;
}
