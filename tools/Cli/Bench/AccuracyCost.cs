using Glint.Core;

namespace Glint.Cli;

/// <summary>Time of a pose with one part of its work changed, and the effect on the sums.</summary>
sealed class AccuracyCost(string what, Series times, RadarResult result, RadarResult usual)
{
    /// <summary>The change, in a few words.</summary>
    public string What { get; } = what;

    public Series Times { get; } = times;

    public long RaysReceived { get; } = result.RaysReceived;

    /// <summary>Time of the sub-rays for the sampling error.</summary>
    public long SubRays { get; } = result.Statistics.SubRays;

    /// <summary>True if all sums are the same bit for bit.</summary>
    public bool IsSame { get; } = result.InPhase == usual.InPhase && result.Quadrature == usual.Quadrature
        && result.RaysHit == usual.RaysHit
        && result.RaysReceived == usual.RaysReceived && result.Bounces == usual.Bounces
        && result.PathLengthMeters == usual.PathLengthMeters;
}
