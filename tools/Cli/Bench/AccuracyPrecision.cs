using System;
using System.Linq;
using System.Numerics;
using System.Threading;
using System.Threading.Tasks;
using Glint.Core;
using Glint.Reference;

namespace Glint.Cli;

/// <summary>
/// Error of the tracer's arithmetic: its sums minus the reference tracer's over the same rays. Also the error of path
/// lengths rounded to float32.
/// </summary>
sealed class AccuracyPrecision
{
    AccuracyPrecision(AccuracyScene scene, RadarResult tracer, long hits, double[] lengths, double wavelength)
    {
        Scene = scene;
        var exact = Sum(lengths, wavelength, length => length);
        Complex own = new(tracer.InPhase, tracer.Quadrature);
        RaysReceived = lengths.Length;
        HitsDifference = tracer.RaysHit - hits;
        ReceivedDifference = tracer.RaysReceived - RaysReceived;
        SumDifference = (own - exact).Magnitude;
        Float32Differences = [.. Float32Ranges.Select(
            range => (Sum(lengths, wavelength, length => (float)(length + 2 * range) - 2 * range) - exact).Magnitude)];
    }

    /// <summary>
    /// Ranges added to that of the scene's radar, in metres, at which path lengths are rounded to float32.
    /// </summary>
    public static double[] Float32Ranges { get; } = [0, 10_000, 100_000];

    public AccuracyScene Scene { get; }

    /// <summary>Rays that the reference tracer receives.</summary>
    public long RaysReceived { get; }

    /// <summary>The tracer's hits minus the reference tracer's.</summary>
    public long HitsDifference { get; }
    public long ReceivedDifference { get; }

    /// <summary>Length of the difference of the two phasor sums, in rays.</summary>
    public double SumDifference { get; }

    /// <summary>
    /// The same, with the reference tracer's path lengths rounded to float32 at <see cref="Float32Ranges"/>.
    /// </summary>
    public double[] Float32Differences { get; }

    /// <param name="tracer">The tracer's result over the same rays.</param>
    public static AccuracyPrecision Of(AccuracyScene scene, RadarSettings settings, RadarResult tracer,
        IProgress<double> progress, CancellationToken cancel)
    {
        var referenceTracer = new ReferenceTracer(new RadarPose(scene.Scene, settings, scene.View));
        var lengths = new double[settings.RaysDown][];
        long hits = 0;
        int done = 0;
        Parallel.For(0, settings.RaysDown, new ParallelOptions { CancellationToken = cancel }, row =>
        {
            var rays = Enumerable.Range(0, settings.RaysAcross).Select(column => referenceTracer.Trace(column, row))
                .Where(ray => ray.Bounces > 0).ToArray();
            lengths[row] = [.. rays.Where(ray => ray.Received).Select(ray => ray.PathLength)];
            Interlocked.Add(ref hits, rays.Length);
            progress.Report(Interlocked.Increment(ref done) / (double)settings.RaysDown);
        });
        return new AccuracyPrecision(scene, tracer, hits, [.. lengths.SelectMany(row => row)], settings.Wavelength);
    }

    static Complex Sum(double[] lengths, double wavelength, Func<double, double> rounded) =>
        lengths.Aggregate(Complex.Zero,
            (sum, length) => sum + Complex.FromPolarCoordinates(1, Signal.Phase(rounded(length), wavelength)));
}
