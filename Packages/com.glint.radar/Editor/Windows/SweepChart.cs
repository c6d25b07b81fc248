using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>
    /// A figure of the poses of a sweep over one of its axes, ready to be drawn:
    /// a line for each combination of the other axes, and those of a run laid over.
    /// </summary>
    sealed class SweepChart
    {
        /// <summary>Maximum number of lines.</summary>
        public const int MaxSeries = 12;

        // Range of decibels below the maximum; lower values are drawn at the bottom.
        const double DeepestDb = 100;

        readonly SweepAxis _axis;
        readonly ResultColumn _column;
        readonly bool _inDecibels;

        /// <param name="rows">The run's poses so far.</param>
        /// <param name="axis">Along x.</param>
        /// <param name="column">Along y.</param>
        /// <param name="inDecibels">20 log10 of amplitudes; ignored for other quantities.</param>
        /// <param name="compared">The compared run; may be null.</param>
        public SweepChart(IReadOnlyList<StoredRow> rows, SweepAxis axis, ResultColumn column, bool inDecibels,
            Comparison compared = null)
        {
            _axis = axis;
            _column = column;
            _inDecibels = inDecibels && column.IsAmplitude;
            var groups = Groups(rows, null)
                .Concat(compared == null ? Enumerable.Empty<Group>() : Groups(compared.Rows, compared.Title)).ToArray();
            // The compared run comes last, but takes precedence.
            var shown = groups.Where(group => group.IsCompared).Take(MaxSeries / 2).ToArray();
            shown = groups.Where(group => !group.IsCompared).Take(MaxSeries - shown.Length).Concat(shown).ToArray();
            LeftOut = groups.Length - shown.Length;
            var poses = shown.SelectMany(group => group.Poses.Select(pose => pose.Pose)).ToArray();
            X = poses.Length == 0 ? ChartScale.Over(0, 1) : ChartScale.Over(poses.Min(At), poses.Max(At));
            Y = Values(poses);
            HasValues = poses.Length == 0 || poses.Any(pose => pose[column].HasValue);
            Series = shown.Select(Line).ToArray();
        }

        /// <summary>Lines of the run, then of the compared run.</summary>
        public IReadOnlyList<ChartSeries> Series { get; }

        /// <summary>Combinations above the maximum, which are not shown.</summary>
        public int LeftOut { get; }

        /// <summary>Says so.</summary>
        public string LeftOutText => $"{LeftOut} more are not shown";

        /// <summary>The axis.</summary>
        public ChartScale X { get; }

        /// <summary>The values.</summary>
        public ChartScale Y { get; }

        /// <summary>False when no pose has a value in the column.</summary>
        public bool HasValues { get; }

        public string XTitle => _axis.ShownUnit == "1" ? _axis.Title : $"{_axis.Title}, {_axis.ShownUnit}";

        public string YTitle => !HasValues && _column.Missing != null ? $"{_column.Title}: {_column.Missing}"
            : _inDecibels ? _column.Title + ", dB" : _column.Label;

        /// <summary>The axes of the poses, the fastest first.</summary>
        public static IReadOnlyList<SweepAxis> AxesOf(IReadOnlyList<StoredRow> rows)
        {
            var axes = SweepAxis.All.Reverse().Where(axis => Varies(rows, axis)).ToArray();
            return axes.Length > 0 ? axes : new[] { SweepAxis.Angle };
        }

        /// <summary>The pose nearest to a position; null without poses.</summary>
        /// <param name="aspect">Width over height of the chart, to measure distances on the screen.</param>
        public (ChartSeries Series, ChartPoint Point)? Nearest(double x, double y, double aspect)
        {
            (ChartSeries, ChartPoint)? nearest = null;
            double min = double.PositiveInfinity;
            foreach (var series in Series)
                foreach (var point in series.Runs.SelectMany(run => run))
                {
                    double across = (point.X - x) * aspect, up = point.Y - y, distance = across * across + up * up;
                    if (distance >= min)
                        continue;
                    min = distance;
                    nearest = (series, point);
                }
            return nearest;
        }

        internal static bool Varies(IReadOnlyList<StoredRow> rows, SweepAxis axis) =>
            rows.Count > 0 && rows.Any(row => row[axis] != rows[0][axis]);

        // The poses of one combination of the other axes.
        sealed class Group
        {
            public string Name;
            public bool IsCompared;
            public (StoredRow Pose, int Row)[] Poses;
        }

        // In the order of their first poses.
        IEnumerable<Group> Groups(IReadOnlyList<StoredRow> rows, string compared)
        {
            var others = SweepAxis.All.Where(axis => axis != _axis && Varies(rows, axis)).ToArray();
            return rows.Select((pose, row) => (pose, row)).Where(item => item.pose[_axis].HasValue)
                .GroupBy(item => string.Join(", ", others.Where(axis => item.pose[axis].HasValue)
                    .Select(axis => axis.Describe(item.pose[axis].Value))))
                .Select(group => new Group
                {
                    Name = compared == null ? group.Key : group.Key.Length == 0 ? compared : $"{compared}: {group.Key}",
                    IsCompared = compared != null,
                    Poses = group.OrderBy(item => item.pose[_axis].Value).ToArray()
                });
        }

        ChartScale Values(StoredRow[] poses)
        {
            if (!_inDecibels)
            {
                var ends = poses.Where(pose => pose[_column].HasValue)
                    .SelectMany(pose => new[] { pose[_column].Value, pose[_column].Value + ErrorOf(pose) }).Append(0)
                    .ToArray();
                return ChartScale.Around(ends.Min(), ends.Any(end => end != 0) ? ends.Max() : 1);
            }
            var levels = poses.Select(pose => Level(pose[_column] ?? 0)).Where(level => level.HasValue)
                .Select(level => level.Value).ToArray();
            if (levels.Length == 0)
                return ChartScale.Around(-20, 0);
            double height = levels.Max();
            return ChartScale.Around(Math.Max(levels.Min(), height - DeepestDb), height);
        }

        ChartSeries Line(Group group)
        {
            var runs = new List<List<ChartPoint>>();
            bool isBroken = true;
            foreach (var (pose, row) in group.Poses)
            {
                if (!(pose[_column] is double value && Height(value) is double height))
                {
                    isBroken = true;
                    continue;
                }
                if (isBroken)
                    runs.Add(new List<ChartPoint>());
                isBroken = false;
                double error = ErrorOf(pose);
                runs[runs.Count - 1].Add(new ChartPoint
                {
                    Pose = pose, Row = row, X = X.Of(At(pose)), Y = height, Lower = Height(value - error) ?? 0,
                    Upper = Height(value + error) ?? height
                });
            }
            return new ChartSeries { Name = group.Name, IsCompared = group.IsCompared, Runs = runs };
        }

        // Half the width of the error band; 0 without an estimate.
        double ErrorOf(StoredRow pose) =>
            _column.Error == null ? 0 : pose[_column.Error] ?? 0;

        double At(StoredRow pose) => pose[_axis].Value / _axis.ShownScale;

        // Null for a value without decibels.
        double? Height(double value)
        {
            double? level = Level(value);
            return level.HasValue ? Math.Min(1, Math.Max(0, Y.Of(level.Value))) : (double?)null;
        }

        double? Level(double value) => _inDecibels ? Signal.Decibels(value) : value;
    }

    /// <summary>A pose in chart coordinates: x and y from 0 at the left and the bottom to 1.</summary>
    struct ChartPoint
    {
        public StoredRow Pose;

        /// <summary>Index of the pose in its run, from 0.</summary>
        public int Row;

        public double X, Y;

        /// <summary>Ends of the band of the error; the point itself where there is none.</summary>
        public double Lower, Upper;
    }

    /// <summary>A line of a chart.</summary>
    sealed class ChartSeries
    {
        public string Name;

        /// <summary>The name, for a legend.</summary>
        public string Label => Name.Length > 0 ? Name : "this run";

        /// <summary>Whether it belongs to the compared run.</summary>
        public bool IsCompared;

        /// <summary>
        /// The pieces of the line, along the axis. Between two of them is a pose without a value.
        /// </summary>
        public IReadOnlyList<IReadOnlyList<ChartPoint>> Runs;
    }
}
