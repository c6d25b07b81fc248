using Glint.Core;

namespace Glint.Cli;

/// <summary>What a pose takes when a piece of its work is done otherwise, and what that does to the sums.</summary>
sealed class AccuracyCost(string what, Series times, RadarResult result, RadarResult usual)
{
    /// <summary>What is done otherwise, in a few words.</summary>
    public string What { get; } = what;

    public Series Times { get; } = times;

    public long RaysReceived { get; } = result.RaysReceived;

    /// <summary>Sub-rays for the sampling error.</summary>
    public long SubRays { get; } = result.Statistics.SubRays;

    /// <summary>True if all sums are the same bit for bit.</summary>
    public bool IsSame { get; } = result.InPhase == usual.InPhase && result.Quadrature == usual.Quadrature
        && result.RaysHit == usual.RaysHit
        && result.RaysReceived == usual.RaysReceived && result.Bounces == usual.Bounces
        && result.PathLengthMeters == usual.PathLengthMeters;
}
