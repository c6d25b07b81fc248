using System;
using System.Linq;
using Glint.Core;

namespace Glint.Cli;

/// <summary>Agreement of a sweep with its published table, in a few numbers.</summary>
sealed class Agreement
{
    /// <summary>Half of one ray's amplitude. Published amplitudes below it are rounding and chance.</summary>
    public const double MinComparedAmplitude = 0.5;

    /// <exception cref="InvalidOperationException">No table was published.</exception>
    public Agreement(SweepResult sweep)
    {
        if (sweep.Published == null)
            throw new InvalidOperationException($"{sweep.Experiment.Title}: no table was published");
        var poses = sweep.Poses.ToArray();
        Poses = poses.Length;
        Hit = new Series(poses.Where(pose => pose.Theirs.RaysHit > 0)
            .Select(pose => (double)pose.Ours.RaysHit / pose.Theirs.RaysHit));
        var both = poses.Where(pose => pose.Theirs.RaysReceived > 0 && pose.Ours.RaysReceived > 0).ToArray();
        (Both, Neither) =
            (both.Length, poses.Count(pose => pose.Theirs.RaysReceived == 0 && pose.Ours.RaysReceived == 0));
        Received = new Series(both.Select(pose => (double)pose.Ours.RaysReceived / pose.Theirs.RaysReceived));
        AmplitudeDb =
            new Series(both.Select(pose => Decibels(pose.Ours.Amplitude, pose.Theirs.Amplitude)).OfType<double>());
        HitDifferencePercent = new Series(poses.Where(pose => pose.Theirs.RaysHit > 0)
            .Select(pose => 100 * Math.Abs((double)pose.Ours.RaysHit / pose.Theirs.RaysHit - 1)));
        ReceivedDifference =
            new Series(poses.Select(pose => (double)Math.Abs(pose.Ours.RaysReceived - pose.Theirs.RaysReceived)));
        AmplitudeDifferenceDb = new Series(both.Where(pose => pose.Theirs.Amplitude > MinComparedAmplitude)
            .Select(pose => Decibels(pose.Ours.Amplitude, pose.Theirs.Amplitude)).OfType<double>().Select(Math.Abs));
        AmplitudeCorrelation = Correlation([.. poses.Select(pose => pose.Ours.Amplitude)],
            [.. poses.Select(pose => pose.Theirs.Amplitude)]);
    }

    public int Poses { get; }

    /// <summary>Ratio of ours to theirs, where theirs is above 0.</summary>
    public Series Hit { get; }

    /// <summary>Poses in which both received rays, and poses in which neither did.</summary>
    public int Both { get; }
    public int Neither { get; }

    /// <summary>Ratio of ours to theirs, where both received rays.</summary>
    public Series Received { get; }

    /// <summary>Ratio of ours to theirs in decibels, where both received rays.</summary>
    public Series AmplitudeDb { get; }

    /// <summary>Pearson's correlation of the linear amplitudes of all poses; NaN if one is constant.</summary>
    public double AmplitudeCorrelation { get; }

    /// <summary>Absolute difference of rays hit, in percent of theirs.</summary>
    public Series HitDifferencePercent { get; }

    /// <summary>Absolute difference of rays received, over all poses.</summary>
    public Series ReceivedDifference { get; }

    /// <summary>
    /// Absolute difference of amplitudes in decibels, where both received rays and theirs is above <see
    /// cref="MinComparedAmplitude"/>.
    /// </summary>
    public Series AmplitudeDifferenceDb { get; }

    /// <summary>Ratio of ours to theirs in decibels; null if either is 0.</summary>
    public static double? Decibels(double ours, double theirs) => Signal.Decibels(ours) - Signal.Decibels(theirs);

    static double Correlation(double[] a, double[] b)
    {
        double meanA = a.Average(), meanB = b.Average();
        double both = a.Zip(b, (x, y) => (x - meanA) * (y - meanB)).Sum();
        return both / Math.Sqrt(a.Sum(x => (x - meanA) * (x - meanA)) * b.Sum(y => (y - meanB) * (y - meanB)));
    }
}
