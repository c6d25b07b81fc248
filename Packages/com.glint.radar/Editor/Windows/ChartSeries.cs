using System.Collections.Generic;

namespace Glint.Editor
{
    /// <summary>A line of a chart.</summary>
    sealed class ChartSeries
    {
        public ChartSeries(string name, bool isCompared, IReadOnlyList<IReadOnlyList<ChartPoint>> runs)
        {
            Name = name;
            IsCompared = isCompared;
            Runs = runs;
        }

        public string Name { get; }

        /// <summary>Whether it belongs to the compared run.</summary>
        public bool IsCompared { get; }

        /// <summary>
        /// Segments of the line along the axis, interrupted by poses without decibels.
        /// </summary>
        public IReadOnlyList<IReadOnlyList<ChartPoint>> Runs { get; }
    }
}
