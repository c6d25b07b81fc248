using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
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

    /// <summary>
    /// Side of the square that points are counted along, metres: a wavelength for targets of 16 of them.
    /// </summary>
    public double Side { get; set; }

    /// <summary>Grids of each spacing and tolerance.</summary>
    public int Grids { get; init; }

    public List<PointRow> Rows { get; } = [];
}

/// <summary>One direction: its cross section, and what it takes.</summary>
/// <param name="azimuth">Degrees.</param>
/// <param name="floorDbsm">The floor of the tolerance.</param>
sealed class PointRow(double azimuth, double floorDbsm)
{
    public double AzimuthDegrees { get; } = azimuth;

    /// <summary>By ray tubes, from <see cref="PointResult.ToleranceDb"/> to a tolerance that reaches it.</summary>
    public List<Sampling> Tubes { get; } = [];

    /// <summary>By points, from few along a side to more than enough.</summary>
    public List<Sampling> Points { get; } = [];

    /// <summary>The mean of the finest points: without bias, as their grids are random.</summary>
    public ScatteringMatrix Converged => Points[^1].Mean;

    /// <summary>Error of <see cref="Converged"/>.</summary>
    public CrossSectionAccuracy ConvergedError =>
        Of(Points[^1].Deviation(Converged) / Math.Sqrt(Points[^1].Matrices.Count - 1));

    /// <summary>Whether both reach the tolerance.</summary>
    public bool IsReached => IsWithin(Tubes[^1]) && IsWithin(Enough);

    /// <summary>The fewest points within the tolerance, or the most.</summary>
    public Sampling Enough => Points.Find(IsWithin) ?? Points[^1];

    /// <summary>Rays of points for each of tubes.</summary>
    public double Ratio => Enough.Rays / (double)Tubes[^1].Rays;

    /// <summary>Measured error of a sampling, root mean square.</summary>
    public CrossSectionAccuracy ErrorOf(Sampling sampling) => Of(sampling.Deviation(Converged));

    // VV and HH alone are measured.
    CrossSectionAccuracy Of(double error) => new(Polarisation.CoPolar, Converged, error, 0, floorDbsm);

    /// <summary>What errors are relative to: the smaller of VV and HH, or the floor; metres.</summary>
    public double Scale => Polarisation.CoPolar.Min(each => CrossSectionAccuracy.ScaleOf(each.Of(Converged), floorDbsm));

    public bool IsWithin(Sampling sampling) => ErrorOf(sampling).Excess(PointResult.ToleranceDb) <= 1;

    /// <summary>The error that 95 % of amplitudes do not exceed, decibels.</summary>
    public static double BoundDb(in CrossSectionAccuracy error) => 20 * Math.Log10(
        1 + error.Excess(PointResult.ToleranceDb) * CrossSectionAccuracy.AllowedBy(PointResult.ToleranceDb));
}

/// <summary>A direction by tubes of a tolerance, or by points of a spacing.</summary>
/// <param name="Setting">The tolerance in decibels, or points along a side.</param>
/// <param name="Rays">Of a grid, on average.</param>
/// <param name="Matrices">Of each grid.</param>
/// <param name="Times">Of a trace, milliseconds.</param>
sealed record Sampling(double Setting, long Rays, IReadOnlyList<ScatteringMatrix> Matrices, Series Times)
{
    public ScatteringMatrix Mean =>
        new Complex(1.0 / Matrices.Count, 0) * Matrices.Aggregate((sum, matrix) => sum + matrix);

    /// <summary>Root mean square difference of VV and HH from those of another matrix, metres.</summary>
    public double Deviation(ScatteringMatrix other) => Math.Sqrt(Matrices.Average(matrix =>
        (Math.Pow((matrix.VV - other.VV).Magnitude, 2) + Math.Pow((matrix.HH - other.HH).Magnitude, 2)) / 2));
}
