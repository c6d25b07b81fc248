using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Cli;

/// <summary>
/// What a sea takes from the rays that a ship returns in free space, and what it adds:
/// a ray that comes back by the same pixel over the same length met the ship alone.
/// </summary>
/// <param name="FreeSpace">Amplitude of the ship in free space.</param>
/// <param name="ShipAlone">Amplitude, on the sea, of the rays that met the ship alone.</param>
/// <param name="Unchanged">Their number; <paramref name="Lost"/> more returned in free space.</param>
/// <param name="Added">Rays that met the sea, by their number of bounces from 1.</param>
sealed record SeaShare(double Step, double FreeSpace, double OnSea, double ShipAlone, int Unchanged, int Lost,
    int[] Added)
{
    // Metres: two ways to go are never as alike.
    const double SameLength = 1e-4;

    /// <summary>Angle by angle.</summary>
    /// <param name="freeSpace">Its rows, and those on the sea, carry the rays received.</param>
    public static IEnumerable<SeaShare> Of(SweepResult freeSpace, SweepResult onSea) =>
        freeSpace.Rows.Zip(onSea.Rows, Of);

    static SeaShare Of(SweepRow freeSpace, SweepRow onSea)
    {
        var before = freeSpace.Result.Rays.ToDictionary(ray => ray.Pixel, ray => ray.RefinedPathLength);
        var ofShip = onSea.Result.Rays.ToLookup(ray => before.TryGetValue(ray.Pixel, out double length)
            && Math.Abs(ray.RefinedPathLength - length) < SameLength);
        var added = new int[RadarSettings.Default.MaxBounces];
        foreach (var ray in ofShip[false])
            added[ray.Bounces - 1]++;
        double inPhase = ofShip[true].Sum(ray => (double)ray.InPhase),
            quadrature = ofShip[true].Sum(ray => (double)ray.Quadrature);
        int unchanged = ofShip[true].Count();
        return new SeaShare(SweepResult.StepOf(onSea.Pose), freeSpace.Result.Amplitude, onSea.Result.Amplitude,
            Math.Sqrt(inPhase * inPhase + quadrature * quadrature), unchanged, before.Count - unchanged, added);
    }
}
