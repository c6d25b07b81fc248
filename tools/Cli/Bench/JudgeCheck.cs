using System;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Glint.Core;

namespace Glint.Cli;

/// <summary>Compares the kernel's sums with those of the double-precision tracer, over all rays or every N-th.</summary>
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
    public double PathLengthRelative => Relative(Glint.PathLengthMeters - Judge.PathLengthMeters, Judge.PathLengthMeters);

    public double Amplitude => Glint.Amplitude - Judge.Amplitude;

    public double AmplitudeRelative => Relative(Amplitude, Judge.Amplitude);

    /// <summary>Of the summed phasor, radians from -pi to pi.</summary>
    public double Phase => Math.IEEERemainder(PhaseOf(Glint) - PhaseOf(Judge), 2 * Math.PI);

    /// <summary>All rays.</summary>
    public static JudgeCheck All(RadarScene scene, RadarSettings settings, RadarView view, RadarResult glint, IProgress<double> progress, CancellationToken cancel)
    {
        var judge = new Judge(scene, settings, view);
        return new JudgeCheck(glint, judge.Sum(judge.TraceAll(progress, cancel)));
    }

    /// <summary>The rays whose pixel's number is a multiple of <paramref name="every"/>.</summary>
    /// <param name="glint">All rays of the region one by one.</param>
    public static JudgeCheck Some(RadarScene scene, RadarSettings settings, RadarView view, RayData[] glint, int every, IProgress<double> progress, CancellationToken cancel)
    {
        var judge = new Judge(scene, settings, view);
        var rays = Trace(judge, settings, every, progress, cancel);
        for (int i = 0; i < rays.Length; i++)
            if (rays[i].Received)
                rays[i].LengthToLastHit = rays[i].PathLength; // as RayData has it
        return new JudgeCheck(Sum(glint, every), judge.Sum(rays));
    }

    /// <summary>The sums over some of the kernel's rays, as the judge has them.</summary>
    internal static RadarResult Sum(RayData[] rays, int every)
    {
        var sum = new RadarResult();
        foreach (var ray in rays)
        {
            if (ray.Pixel % every != 0)
                continue;
            sum.RaysEmitted++;
            sum.RaysHit += ray.Bounces > 0 ? 1 : 0;
            sum.Bounces += ray.Bounces;
            sum.PathLengthMeters += ray.PathLength;
            if (ray.IsReceived)
                sum.AddReceived(ray.Phase, ray.InPhase, ray.Quadrature);
        }
        return sum;
    }

    // Rows are shared among the processors.
    static JudgeRay[] Trace(Judge judge, RadarSettings settings, int every, IProgress<double> progress, CancellationToken cancel)
    {
        var region = settings.Region.IsWhole ? new RayRegion { Width = settings.RaysAcross, Height = settings.RaysDown } : settings.Region;
        var rows = new JudgeRay[region.Height][];
        int done = 0;
        Parallel.For(0, region.Height, new ParallelOptions { CancellationToken = cancel }, row =>
        {
            int y = region.Bottom + row;
            long first = (long)y * settings.RaysAcross + region.Left;
            int x = region.Left + (int)((every - first % every) % every);
            var rays = new JudgeRay[Math.Max(0, (region.Left + region.Width - x + every - 1) / every)];
            for (int i = 0; i < rays.Length; i++, x += every)
                rays[i] = judge.Trace(x, y);
            rows[row] = rays;
            int finished = Interlocked.Increment(ref done);
            progress.Report((double)finished / region.Height);
        });
        return [.. rows.SelectMany(row => row)];
    }

    static double PhaseOf(RadarResult sum) => Math.Atan2(sum.Quadrature, sum.InPhase);

    static double Relative(double difference, double of) => of == 0 ? 0 : difference / of;
}
