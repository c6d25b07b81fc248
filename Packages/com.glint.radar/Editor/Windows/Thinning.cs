using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Editor
{
    /// <summary>
    /// Reduces what is drawn of many poses. UI Toolkit draws nothing of a path with more than 65,535 vertices, which is
    /// reached at 8,000 to 16,000 points.
    /// </summary>
    static class Thinning
    {
        // Columns of a chart. Four points in each are 1,920 for a path.
        const int Columns = 480;

        const int MaxPoints = 4 * Columns;

        /// <summary>
        /// First, lowest, highest and last point of each column, which a line through all points also shows; all points
        /// if they are few.
        /// </summary>
        /// <param name="points">From left to right.</param>
        public static IReadOnlyList<ChartPoint> Line(IReadOnlyList<ChartPoint> points)
        {
            if (points.Count <= MaxPoints)
                return points;
            var kept = new List<ChartPoint>();
            foreach (var (from, to) in ColumnsOf(points))
            {
                int low = from, high = from;
                for (int i = from + 1; i < to; i++)
                {
                    if (points[i].Y < points[low].Y)
                        low = i;
                    if (points[i].Y > points[high].Y)
                        high = i;
                }
                kept.AddRange(new SortedSet<int> { from, low, high, to - 1 }.Select(index => points[index]));
            }
            return kept;
        }

        /// <summary>
        /// The band of the error: in each column a rectangle from the first to the last point, over the bands of all
        /// its points; all points if they are few.
        /// </summary>
        /// <param name="points">From left to right.</param>
        public static IReadOnlyList<ChartPoint> Band(IReadOnlyList<ChartPoint> points)
        {
            if (points.Count <= MaxPoints / 2)
                return points;
            var kept = new List<ChartPoint>();
            foreach (var (from, to) in ColumnsOf(points))
            {
                double lower = points[from].Lower, upper = points[from].Upper;
                for (int i = from + 1; i < to; i++)
                    (lower, upper) = (Math.Min(lower, points[i].Lower), Math.Max(upper, points[i].Upper));
                kept.Add(new ChartPoint { X = points[from].X, Lower = lower, Upper = upper });
                kept.Add(new ChartPoint { X = points[to - 1].X, Lower = lower, Upper = upper });
            }
            return kept;
        }

        // First point of each column, and the one after its last.
        static IEnumerable<(int from, int to)> ColumnsOf(IReadOnlyList<ChartPoint> points)
        {
            for (int from = 0, to; from < points.Count; from = to)
            {
                int column = ColumnOf(points[from]);
                for (to = from + 1; to < points.Count && ColumnOf(points[to]) == column; to++) { }
                yield return (from, to);
            }
        }

        // The right edge belongs to the last column.
        static int ColumnOf(in ChartPoint point) => Math.Min(Columns - 1, (int)(point.X * Columns));
    }
}
