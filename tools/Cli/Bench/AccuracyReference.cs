using System;
using System.Linq;
using System.Numerics;
using System.Threading;
using System.Threading.Tasks;
using Glint.Core;
using Glint.Reference;

namespace Glint.Cli;

/// <summary>
/// Converged sums of a scene by the double-precision reference tracer. The picture has 3840 x 2160 rays. Pixels that
/// received a ray, their neighbours and pixels on an outline get 64 sub-rays.
/// </summary>
sealed class AccuracyReference
{
    const int StandardAcross = 3840, SubRays = 8;

    // Error of the whole grid of sub-rays, relative to that of its four half-density grids; the sampling error's
    // estimate uses the same factor.
    const double FineOverHalf = 0.35;

    internal AccuracyReference(Complex sum, double uncertainty, double hits) =>
        (Sum, Uncertainty, Hits) = (sum, uncertainty, hits);

    /// <summary>Phasor sum, scaled to <see cref="RadarResult.NormalRays"/> rays.</summary>
    public Complex Sum { get; }

    /// <summary>Estimated error of the sum's amplitude.</summary>
    public double Uncertainty { get; }

    /// <summary>Rays hit, scaled to <see cref="RadarResult.NormalRays"/> rays.</summary>
    public double Hits { get; }

    /// <param name="settings">The settings; their number of rays is ignored.</param>
    /// <param name="across">Rays across the picture that is refined; the height follows from 16:9.</param>
    public static AccuracyReference Of(AccuracyScene scene, RadarSettings settings, IProgress<double> progress,
        CancellationToken cancel, int across = StandardAcross)
    {
        (settings.RaysAcross, settings.RaysDown) = (across, across * 9 / 16);
        var referenceTracer = new ReferenceTracer(new RadarPose(scene.Scene, settings, scene.View));
        int down = settings.RaysDown;
        var outcomes = new Outcome[down, across];
        ForRows(down, new Part(progress, 0, 2), cancel, row =>
        {
            for (int column = 0; column < across; column++)
            {
                var ray = referenceTracer.Trace(column, row);
                outcomes[row, column] = ray.Received ? Outcome.Received
                    : ray.Bounces > 0 ? Outcome.Hit : Outcome.Nothing;
            }
        });

        // Sums of each row, and of each half-density grid in it, added in the order of the rows.
        var sums = new Complex[down, 4];
        var hits = new long[down];
        ForRows(down, new Part(progress, 1, 2), cancel, row =>
        {
            for (int column = 0; column < across; column++)
                if (IsRefined(outcomes, column, row))
                    hits[row] += TracePixel(referenceTracer, settings.Wavelength, column, row, sums);
                else if (outcomes[row, column] != Outcome.Nothing)
                    hits[row] += SubRays * SubRays;
        });
        var parts = new Complex[4];
        for (int row = 0; row < down; row++)
            for (int part = 0; part < 4; part++)
                parts[part] += sums[row, part];
        return Make(parts, hits.Sum(), RadarResult.NormalRays / ((double)settings.RayCount * SubRays * SubRays));
    }

    static AccuracyReference Make(Complex[] parts, long hits, double scale)
    {
        Complex sum = scale * (parts[0] + parts[1] + parts[2] + parts[3]);
        double squares = parts.Sum(part => Math.Pow((4 * scale * part - sum).Magnitude, 2)) / 4;
        return new AccuracyReference(sum, FineOverHalf * Math.Sqrt(squares), scale * hits);
    }

    static void ForRows(int rows, IProgress<double> progress, CancellationToken cancel, Action<int> doRow)
    {
        int done = 0;
        Parallel.For(0, rows, new ParallelOptions { CancellationToken = cancel }, row =>
        {
            doRow(row);
            progress.Report(Interlocked.Increment(ref done) / (double)rows);
        });
    }

    // True for received rays and their neighbours, and where hits and misses are neighbours.
    static bool IsRefined(Outcome[,] outcomes, int column, int row)
    {
        bool isHit = outcomes[row, column] != Outcome.Nothing;
        for (int y = Math.Max(0, row - 1); y <= Math.Min(outcomes.GetLength(0) - 1, row + 1); y++)
            for (int x = Math.Max(0, column - 1); x <= Math.Min(outcomes.GetLength(1) - 1, column + 1); x++)
                if (outcomes[y, x] == Outcome.Received || outcomes[y, x] != Outcome.Nothing != isHit)
                    return true;
        return false;
    }

    // Returns the number of sub-rays that hit.
    static int TracePixel(ReferenceTracer referenceTracer, double wavelength, int column, int row, Complex[,] sums)
    {
        int hits = 0;
        for (int b = 0; b < SubRays; b++)
            for (int a = 0; a < SubRays; a++)
            {
                var ray = referenceTracer.Trace(column + (a + 0.5) / SubRays - 0.5, row + (b + 0.5) / SubRays - 0.5);
                hits += ray.Bounces > 0 ? 1 : 0;
                if (ray.Received)
                    sums[row, a % 2 + 2 * (b % 2)] +=
                        Complex.FromPolarCoordinates(1, Signal.Phase(ray.PathLength, wavelength));
            }
        return hits;
    }

    enum Outcome : byte
    {
        Nothing,
        Hit,
        Received,
    }
}
