using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Cuts the slices of an attempt by the rays that each part of the grid took in the attempt before it, so that no
    /// list becomes full.
    /// </summary>
    sealed class SliceForecast
    {
        // Rays grow with 1 / error, by this power: 0.3 to 0.5 on a ship, more where there are borders. Those of a cell
        // before the first attempt.
        const double Growth = 0.5, UnknownRaysACell = 5;

        // What a slice took of its forecast corrects the next one, by this factor at most, and less after fewer rays.
        const double MaxCorrection = 4, FewRays = 1 << 20;

        List<(long End, double RaysACell)> _before, _now = new List<(long, double)>();
        double _error, _growth, _correction;

        /// <summary>Begins an attempt.</summary>
        /// <param name="error">That a cell may have.</param>
        public void Begin(double error)
        {
            (_growth, _correction) = (Math.Pow(Math.Max(1, _error / error), Growth), 1);
            (_before, _now, _error) = (_now, new List<(long, double)>(), error);
        }

        /// <summary>Records a slice.</summary>
        /// <param name="rays">Of each of the equal parts of the slice.</param>
        public void Took(long first, int cells, IReadOnlyList<long> rays)
        {
            double forecast = PartsOf(first, cells).Sum(part => part.Cells * part.RaysACell);
            _correction = math.clamp(_correction * (rays.Sum() + FewRays) / (forecast + FewRays),
                1 / MaxCorrection, MaxCorrection);
            for (int part = 0; part < rays.Count; part++)
            {
                // As the kernels divide whole numbers: CountAt in TubeBindings.hlsl.
                long from = FirstOf(part, cells, rays.Count), to = FirstOf(part + 1, cells, rays.Count);
                if (to > from)
                    _now.Add((first + to, (double)rays[part] / (to - from)));
            }
        }

        static long FirstOf(int part, long cells, int parts) => (part * cells + parts - 1) / parts;

        /// <summary>Cells of the next slice, at most <paramref name="max"/>; takes their rays from those left.</summary>
        public long CellsFrom(long first, long max, ref double raysLeft)
        {
            long count = 0;
            foreach (var (cells, raysACell) in PartsOf(first, max))
            {
                if (cells * raysACell > raysLeft)
                {
                    count += (long)(raysLeft / raysACell);
                    raysLeft = 0;
                    break;
                }
                raysLeft -= cells * raysACell;
                count += cells;
            }
            return count;
        }

        // The parts of a number of cells, each with the forecast of its rays.
        IEnumerable<(long Cells, double RaysACell)> PartsOf(long first, long count)
        {
            long end = first + count;
            foreach (var (partEnd, raysACell) in _before.Append((long.MaxValue, UnknownRaysACell)))
            {
                long cells = Math.Min(partEnd, end) - first;
                if (cells <= 0)
                    continue;
                yield return (cells, Math.Max(1e-3, _correction * _growth * raysACell));
                first += cells;
            }
        }
    }
}
