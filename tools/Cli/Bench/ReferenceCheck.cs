using System;
using System.Threading;
using Glint.Core;
using Glint.Reference;

namespace Glint.Cli;

/// <summary>Compares the kernel's sums with the reference tracer's, over all rays or every N-th.</summary>
sealed class ReferenceCheck
{
    /// <summary>Maximum numbers of rays and triangles compared by default: about a minute's work.</summary>
    public const long Affordable = 4_000_000;

    ReferenceCheck(RadarResult glint, RadarResult reference) => (Glint, Reference) = (glint, reference);

    /// <summary>The sums over the same rays.</summary>
    public RadarResult Glint { get; }
    public RadarResult Reference { get; }

    public long Hits => Glint.RaysHit - Reference.RaysHit;

    public long Bounces => Glint.Bounces - Reference.Bounces;

    /// <summary>Relative to the sum of lengths; 0 without hits.</summary>
    public double PathLengthRelative =>
        Relative(Glint.PathLengthMeters - Reference.PathLengthMeters, Reference.PathLengthMeters);

    public double Amplitude => Glint.Amplitude - Reference.Amplitude;

    public double AmplitudeRelative => Relative(Amplitude, Reference.Amplitude);

    /// <summary>Of the summed phasor, in radians from -pi to pi.</summary>
    public double Phase => Math.IEEERemainder(PhaseOf(Glint) - PhaseOf(Reference), 2 * Math.PI);

    /// <summary>Compares all rays.</summary>
    public static ReferenceCheck All(RadarPose pose, RadarResult glint, IProgress<double> progress,
        CancellationToken cancel)
    {
        var referenceTracer = new ReferenceTracer(pose);
        return new ReferenceCheck(glint, referenceTracer.Sum(referenceTracer.TraceAll(progress, cancel)));
    }

    /// <summary>Compares the rays whose pixel number is a multiple of <paramref name="every"/>.</summary>
    /// <param name="glint">The kernel's result with each ray of the region.</param>
    public static ReferenceCheck Some(RadarPose pose, RayData[] glint, int every, IProgress<double> progress,
        CancellationToken cancel)
    {
        var referenceTracer = new ReferenceTracer(pose);
        var some = Array.FindAll(glint, ray => ray.Pixel % every == 0);
        var rays = referenceTracer.TraceSame(some, progress, cancel);
        for (int i = 0; i < rays.Length; i++)
            rays[i].LengthToLastHit = rays[i].LengthToEnd; // the only length in the kernel's rays
        return new ReferenceCheck(Sum(some), referenceTracer.Sum(rays));
    }

    // The sums are made as in the reference tracer.
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
