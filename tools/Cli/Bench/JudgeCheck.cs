using System;
using System.Threading;
using Glint.Core;

namespace Glint.Cli;

/// <summary>
/// Compares the kernel's sums with those of the double-precision tracer, over all rays or every N-th.
/// </summary>
sealed class JudgeCheck
{
    /// <summary>Most rays, and most triangles, that are judged unasked: about a minute's work.</summary>
    public const long Affordable = 4_000_000;

    JudgeCheck(RadarResult glint, RadarResult judge) => (Glint, Judge) = (glint, judge);

    /// <summary>The sums over the same rays.</summary>
    public RadarResult Glint { get; }
    public RadarResult Judge { get; }

    public long Hits => Glint.RaysHit - Judge.RaysHit;

    public long Bounces => Glint.Bounces - Judge.Bounces;

    /// <summary>Of the sum of lengths; 0 when nothing is hit.</summary>
    public double PathLengthRelative =>
        Relative(Glint.PathLengthMeters - Judge.PathLengthMeters, Judge.PathLengthMeters);

    public double Amplitude => Glint.Amplitude - Judge.Amplitude;

    public double AmplitudeRelative => Relative(Amplitude, Judge.Amplitude);

    /// <summary>Of the summed phasor, radians from -pi to pi.</summary>
    public double Phase => Math.IEEERemainder(PhaseOf(Glint) - PhaseOf(Judge), 2 * Math.PI);

    /// <summary>All rays.</summary>
    public static JudgeCheck All(RadarPose pose, RadarResult glint, IProgress<double> progress,
        CancellationToken cancel)
    {
        var judge = new Judge(pose);
        return new JudgeCheck(glint, judge.Sum(judge.TraceAll(progress, cancel)));
    }

    /// <summary>The rays whose pixel's number is a multiple of <paramref name="every"/>.</summary>
    /// <param name="glint">All rays of the region one by one.</param>
    public static JudgeCheck Some(RadarPose pose, RayData[] glint, int every, IProgress<double> progress,
        CancellationToken cancel)
    {
        var judge = new Judge(pose);
        var some = Array.FindAll(glint, ray => ray.Pixel % every == 0);
        var rays = judge.TraceSame(some, progress, cancel);
        for (int i = 0; i < rays.Length; i++)
            rays[i].LengthToLastHit = rays[i].LengthToEnd; // the only length that the kernel's rays have
        return new JudgeCheck(Sum(some), judge.Sum(rays));
    }

    // As the judge sums its own.
    static RadarResult Sum(RayData[] rays)
    {
        var sum = new RadarSums { RaysEmitted = rays.Length };
        foreach (var ray in rays)
        {
            sum.RaysHit += ray.Bounces > 0 ? 1 : 0;
            sum.Bounces += ray.Bounces;
            sum.PathLengthMeters += ray.ExactPathLength;
            if (ray.IsReceived)
                sum.AddReceived(ray.Phase, ray.InPhase, ray.Quadrature);
        }
        return new RadarResult(sum);
    }

    static double PhaseOf(RadarResult sum) => Math.Atan2(sum.Quadrature, sum.InPhase);

    static double Relative(double difference, double of) => of == 0 ? 0 : difference / of;
}
