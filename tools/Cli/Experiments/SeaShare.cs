using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Cli;

/// <summary>
/// The rays of the ship in free space that a sea blocks, and the rays that it adds. A ray that is received in the same
/// pixel with the same length met only the ship.
/// </summary>
/// <param name="FreeSpace">Amplitude of the ship in free space.</param>
/// <param name="ShipAlone">Amplitude, on the sea, of the rays that met only the ship.</param>
/// <param name="Unchanged">Number of these rays; <paramref name="Lost"/> further ones returned in free space.</param>
/// <param name="Added">Rays that met the sea, by number of bounces from 1.</param>
sealed record SeaShare(double Step, double FreeSpace, double OnSea, double ShipAlone, int Unchanged, int Lost,
    int[] Added)
{
    // Metres. Two different paths differ by more.
    const double SameLength = 1e-4;

    /// <summary>The share at each angle.</summary>
    /// <param name="freeSpace">Rows with the rays received, like those on the sea.</param>
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
