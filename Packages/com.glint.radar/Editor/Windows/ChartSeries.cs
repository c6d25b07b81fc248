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

        /// <summary>Whether it is of the run that is laid over.</summary>
        public bool IsCompared { get; }

        /// <summary>
        /// The pieces of the line, along the axis. Between two of them is a pose that has no decibels.
        /// </summary>
        public IReadOnlyList<IReadOnlyList<ChartPoint>> Runs { get; }
    }
}
