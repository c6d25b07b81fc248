using System;
using System.Threading;
using Glint.Core;
using Glint.Reference;

namespace Glint.Cli;

/// <summary>
/// Compares the kernel's sums with those of the double-precision tracer, over all rays or every N-th.
/// </summary>
sealed class ReferenceCheck
{
    /// <summary>Most rays, and most triangles, that are compared unasked: about a minute's work.</summary>
    public const long Affordable = 4_000_000;

    ReferenceCheck(RadarResult glint, RadarResult reference) => (Glint, Reference) = (glint, reference);

    /// <summary>The sums over the same rays.</summary>
    public RadarResult Glint { get; }
    public RadarResult Reference { get; }

    public long Hits => Glint.RaysHit - Reference.RaysHit;

    public long Bounces => Glint.Bounces - Reference.Bounces;

    /// <summary>Of the sum of lengths; 0 when nothing is hit.</summary>
    public double PathLengthRelative =>
        Relative(Glint.PathLengthMeters - Reference.PathLengthMeters, Reference.PathLengthMeters);

    public double Amplitude => Glint.Amplitude - Reference.Amplitude;

    public double AmplitudeRelative => Relative(Amplitude, Reference.Amplitude);

    /// <summary>Of the summed phasor, radians from -pi to pi.</summary>
    public double Phase => Math.IEEERemainder(PhaseOf(Glint) - PhaseOf(Reference), 2 * Math.PI);

    /// <summary>All rays.</summary>
    public static ReferenceCheck All(RadarPose pose, RadarResult glint, IProgress<double> progress,
        CancellationToken cancel)
    {
        var referenceTracer = new ReferenceTracer(pose);
        return new ReferenceCheck(glint, referenceTracer.Sum(referenceTracer.TraceAll(progress, cancel)));
    }

    /// <summary>The rays whose pixel's number is a multiple of <paramref name="every"/>.</summary>
    /// <param name="glint">All rays of the region one by one.</param>
    public static ReferenceCheck Some(RadarPose pose, RayData[] glint, int every, IProgress<double> progress,
        CancellationToken cancel)
    {
        var referenceTracer = new ReferenceTracer(pose);
        var some = Array.FindAll(glint, ray => ray.Pixel % every == 0);
        var rays = referenceTracer.TraceSame(some, progress, cancel);
        for (int i = 0; i < rays.Length; i++)
            rays[i].LengthToLastHit = rays[i].LengthToEnd; // the only length that the kernel's rays have
        return new ReferenceCheck(Sum(some), referenceTracer.Sum(rays));
    }

    // As the reference tracer sums its own.
    static RadarResult Sum(RayData[] rays)
    {
        var sum = new RadarSums { RaysEmitted = rays.Length };
        foreach (var ray in rays)
        {
            sum.RaysHit += ray.Bounces > 0 ? 1 : 0;
            sum.Bounces += ray.Bounces;
            sum.PathLengthMeters += ray.RefinedPathLength;
            if (ray.IsReceived)
                sum.AddReceived(ray.Phase, ray.InPhase, ray.Quadrature);
        }
        return new RadarResult(sum);
    }

    static double PhaseOf(RadarResult sum) => Math.Atan2(sum.Quadrature, sum.InPhase);

    static double Relative(double difference, double of) => of == 0 ? 0 : difference / of;
}
