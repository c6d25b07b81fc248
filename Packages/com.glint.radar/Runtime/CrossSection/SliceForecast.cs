using System;
using System.Collections.Generic;

namespace Glint
{
    /// <summary>
    /// Cuts the slices of an attempt by the rays that each part of the grid took in the attempt before it, so that no
    /// list becomes full.
    /// </summary>
    sealed class SliceForecast
    {
        // Rays grow with 1 / error, by this power: 0.7 to 1 on a ship.
        const double Growth = 0.8;

        readonly long _maxRays;
        List<(long End, double RaysACell)> _before, _now = new List<(long, double)>();
        double _error, _growth;

        /// <param name="maxRays">Of a slice.</param>
        public SliceForecast(long maxRays) => _maxRays = maxRays;

        /// <summary>Begins an attempt.</summary>
        /// <param name="error">That a cell may have.</param>
        public void Begin(double error)
        {
            _growth = Math.Pow(Math.Max(1, _error / error), Growth);
            (_before, _now, _error) = (_now, new List<(long, double)>(), error);
        }

        /// <summary>Records a slice.</summary>
        public void Took(long first, int cells, long rays) => _now.Add((first + cells, (double)rays / cells));

        /// <summary>Cells of the next slice, at most <paramref name="max"/>.</summary>
        public long CellsFrom(long first, long max)
        {
            double rays = _maxRays / _growth;
            long at = first;
            foreach (var (end, raysACell) in _before)
            {
                if (end <= at)
                    continue;
                double taken = (end - at) * raysACell;
                if (taken > rays)
                    return Math.Min(max, Math.Max(1, at - first + (long)(rays / raysACell)));
                rays -= taken;
                at = end;
            }
            return max;
        }
    }
}
