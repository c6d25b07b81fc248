using System;

namespace Glint.Core
{
    /// <summary>
    /// Forecasts from the attempts at a pose whether finer cells would meet its tolerance. Errors fall with a power of the
    /// error that a cell may have; where the sum of the currents has no limit, as at silhouettes of facets with mean normals,
    /// they hardly fall.
    /// </summary>
    public sealed class AttemptForecast
    {
        // The power is known from errors of cells that differ by this factor: single errors scatter.
        const double KnownFrom = 32;

        double _firstExcess, _firstCellError;

        /// <summary>Adds an attempt; false if none with larger errors of cells than the minimum would meet the tolerance.</summary>
        /// <param name="excess">Its error, as a multiple of the one allowed.</param>
        /// <param name="cellError">Error that its cells might have.</param>
        /// <param name="minCellError">Of later attempts.</param>
        public bool CanBeMet(double excess, double cellError, double minCellError)
        {
            if (_firstCellError == 0)
                (_firstExcess, _firstCellError) = (excess, cellError);
            if (_firstCellError < KnownFrom * cellError)
                return true;
            double power = Math.Log(_firstExcess / excess) / Math.Log(_firstCellError / cellError);
            return power > 0 && cellError * Math.Pow(excess, -1 / power) >= minCellError;
        }
    }
}
