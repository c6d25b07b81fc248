using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint
{
    /// <summary>
    /// Cuts the slices of an attempt by the rays that each part of the grid took in the attempt before it, so that no
    /// list becomes full.
    /// </summary>
    sealed class SliceForecast
    {
        // Rays grow with 1 / error, by this power: 0.7 to 1 on a ship. Those of a cell before the first attempt.
        const double Growth = 0.8, UnknownRaysACell = 3;

        List<(long End, double RaysACell)> _before, _now = new List<(long, double)>();
        double _error, _growth;

        /// <summary>Begins an attempt.</summary>
        /// <param name="error">That a cell may have.</param>
        public void Begin(double error)
        {
            _growth = Math.Pow(Math.Max(1, _error / error), Growth);
            (_before, _now, _error) = (_now, new List<(long, double)>(), error);
        }

        /// <summary>Records a slice.</summary>
        public void Took(long first, int cells, long rays) => _now.Add((first + cells, (double)rays / cells));

        /// <summary>Cells of the next slice, at most <paramref name="max"/>; takes their rays from those left.</summary>
        public long CellsFrom(long first, long max, ref double raysLeft)
        {
            long at = first, end = first + max;
            foreach (var (partEnd, raysACell) in _before.Append((long.MaxValue, UnknownRaysACell)))
            {
                long cells = Math.Min(partEnd, end) - at;
                if (cells <= 0)
                    continue;
                double raysOfCell = Math.Max(1e-3, _growth * raysACell);
                if (cells * raysOfCell > raysLeft)
                {
                    at += (long)(raysLeft / raysOfCell);
                    raysLeft = 0;
                    break;
                }
                raysLeft -= cells * raysOfCell;
                at += cells;
            }
            return at - first;
        }
    }
}
