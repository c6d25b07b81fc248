using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>Cross sections of a target by ray tubes and by point sampling.</summary>
sealed class PointResult
{
    /// <summary>The error that both are to reach, decibels.</summary>
    public const double ToleranceDb = 0.1;

    /// <summary>Usual spacing of point sampling, in points a wavelength.</summary>
    public const int UsualAcross = 10;

    public string Subject { get; init; }
    public DeviceInfo Device { get; init; }
    public long Triangles { get; init; }
    public double FrequencyHz { get; init; }
    public double GrazingDegrees { get; init; }

    /// <summary>Side of the square that points are counted along, metres: a wavelength for targets of 16 of them.</summary>
    public double Side { get; set; }

    /// <summary>Random offsets of each grid of points.</summary>
    public int Offsets { get; init; }

    public List<PointRow> Rows { get; } = [];
}

/// <summary>One direction: its cross section, and what it takes.</summary>
sealed class PointRow(double azimuth, CrossSectionResult converged, CrossSectionResult tubes, double tubesMs)
{
    public double AzimuthDegrees { get; } = azimuth;

    /// <summary>By ray tubes to a small tolerance.</summary>
    public CrossSectionResult Converged { get; } = converged;

    /// <summary>By ray tubes to <see cref="PointResult.ToleranceDb"/>, and the time of a trace.</summary>
    public CrossSectionResult Tubes { get; } = tubes;

    /// <inheritdoc cref="Tubes"/>
    public double TubesMs { get; } = tubesMs;

    /// <summary>Difference of <see cref="Tubes"/> from the converged amplitudes.</summary>
    public CrossSectionAccuracy TubesError => ErrorOf([Tubes]);

    /// <summary>By points, in ascending number.</summary>
    public List<PointSampling> Points { get; } = [];

    /// <summary>The fewest points within the tolerance; null if none are.</summary>
    public PointSampling Enough =>
        Points.Find(points => points.Error.Excess(PointResult.ToleranceDb) <= 1);

    /// <summary>At least so many rays that points take for each ray of the tubes.</summary>
    public double Ratio => (Enough ?? Points[^1]).Rays / (double)Tubes.Rays;

    /// <summary>The error that 95 % of amplitudes do not exceed, decibels.</summary>
    public static double BoundDb(in CrossSectionAccuracy error) => 20 * Math.Log10(
        1 + error.Excess(PointResult.ToleranceDb) * CrossSectionAccuracy.AllowedBy(PointResult.ToleranceDb));

    /// <summary>Root mean square difference of amplitudes from the converged ones, VV and HH.</summary>
    public CrossSectionAccuracy ErrorOf(IReadOnlyList<CrossSectionResult> results)
    {
        var exact = Converged.S[0, 0];
        double square = results.Average(result => result.S[0, 0] is var s
            ? (Math.Pow((s.VV - exact.VV).Magnitude, 2) + Math.Pow((s.HH - exact.HH).Magnitude, 2)) / 2
            : 0);
        return new CrossSectionAccuracy(exact, Math.Sqrt(square), Converged.FloorDbsm);
    }
}

/// <summary>Point sampling of a direction.</summary>
/// <param name="Across">Points along a wavelength.</param>
/// <param name="Rays">Rays of a grid.</param>
/// <param name="Error">Over random offsets of the grid.</param>
/// <param name="Times">Of a trace, milliseconds.</param>
sealed record PointSampling(int Across, long Rays, CrossSectionAccuracy Error, Series Times);
