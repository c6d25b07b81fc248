using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>
    /// A quantity of the poses of a sweep over one of its axes, ready to be drawn: a line for each combination of the
    /// other axes, and the lines of a compared run. In a polar chart the angle grows clockwise from the top, like a
    /// turning target seen from above; values grow from the centre, (0.5, 0.5), to the radius 0.5.
    /// </summary>
    sealed class SweepChart
    {
        /// <summary>Maximum number of lines.</summary>
        public const int MaxSeries = 12;

        // Range of decibels below the maximum; lower values are drawn at the bottom.
        const double DeepestDb = 100;

        readonly SweepAxis _axis;
        readonly Quantity _quantity;
        readonly bool _inDecibels;

        /// <param name="rows">The run's poses so far.</param>
        /// <param name="axis">Axis of x, or of the polar angle.</param>
        /// <param name="inDecibels">20 log10 of amplitudes; ignored for other quantities.</param>
        /// <param name="isPolar">Polar chart; ignored if the axis is not an angle.</param>
        /// <param name="compared">The compared run; may be null.</param>
        public SweepChart(IReadOnlyList<PoseFigures> rows, SweepAxis axis, Quantity quantity, bool inDecibels,
            bool isPolar, Comparison compared = null)
        {
            _axis = axis;
            _quantity = quantity;
            _inDecibels = inDecibels && quantity.IsAmplitude;
            IsPolar = isPolar && CanBePolar(axis);
            var groups = Groups(rows, null)
                .Concat(compared == null ? Enumerable.Empty<Group>() : Groups(compared.Rows, compared.Title)).ToArray();
            // The compared run comes last, but takes precedence.
            var shown = groups.Where(group => group.IsCompared).Take(MaxSeries / 2).ToArray();
            shown = groups.Where(group => !group.IsCompared).Take(MaxSeries - shown.Length).Concat(shown).ToArray();
            LeftOut = groups.Length - shown.Length;
            var poses = shown.SelectMany(group => group.Poses.Select(pose => pose.Pose)).ToArray();
            X = IsPolar ? ChartScale.Turn()
                : poses.Length == 0 ? ChartScale.Over(0, 1)
                : ChartScale.Over(poses.Min(At), poses.Max(At));
            Y = Values(poses);
            Series = shown.Select(Line).ToArray();
        }

        /// <summary>Lines of the run, then of the compared run.</summary>
        public IReadOnlyList<ChartSeries> Series { get; }

        /// <summary>Combinations above the maximum, which are not shown.</summary>
        public int LeftOut { get; }

        /// <summary>The axis; in a polar chart one turn.</summary>
        public ChartScale X { get; }

        /// <summary>The values; in a polar chart from the centre outwards.</summary>
        public ChartScale Y { get; }

        public bool IsPolar { get; }

        public string XTitle =>
            _axis == SweepAxis.Frequency ? "Frequency, GHz" : _axis == SweepAxis.Angle ? "Angle, deg" : _axis
                == SweepAxis.Grazing ? "Grazing angle, deg" : _axis == SweepAxis.Range ? "Range, m" : "Snapshot";

        public string YTitle => _inDecibels ? _quantity.Title + ", dB" : _quantity.Title;

        /// <summary>Whether an axis can be polar.</summary>
        public static bool CanBePolar(SweepAxis axis) => axis.Unit == "deg";

        /// <summary>The axes of the poses, the fastest first.</summary>
        public static IReadOnlyList<SweepAxis> AxesOf(IReadOnlyList<PoseFigures> rows)
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

        internal static bool Varies(IReadOnlyList<PoseFigures> rows, SweepAxis axis) =>
            rows.Count > 0 && rows.Any(row => row[axis] != rows[0][axis]);

        // The poses of one combination of the other axes.
        sealed class Group
        {
            public string Name;
            public bool IsCompared;
            public (PoseFigures Pose, int Row)[] Poses;
        }

        // In the order of their first poses.
        IEnumerable<Group> Groups(IReadOnlyList<PoseFigures> rows, string compared)
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

        ChartScale Values(PoseFigures[] poses)
        {
            if (!_inDecibels)
                return ChartScale.Around(0, poses.Select(pose => _quantity.Of(pose) + _quantity.ErrorOf(pose)).Append(0)
                    .Max() is var max && max > 0 ? max : 1);
            var levels = poses.Select(pose => Level(_quantity.Of(pose))).Where(level => level.HasValue)
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
                double value = _quantity.Of(pose), error = _quantity.ErrorOf(pose);
                if (!(Height(value) is double height))
                {
                    isBroken = true;
                    continue;
                }
                if (isBroken)
                    runs.Add(new List<ChartPoint>());
                isBroken = false;
                runs[runs.Count - 1].Add(new ChartPoint(pose, row, PositionOf(pose, height),
                    PositionOf(pose, Height(value - error) ?? 0), PositionOf(pose, Height(value + error) ?? height)));
            }
            return new ChartSeries(group.Name, group.IsCompared, runs);
        }

        (double, double) PositionOf(PoseFigures pose, double height)
        {
            if (!IsPolar)
                return (X.Of(At(pose)), height);
            double angle = pose[_axis].Value * Math.PI / 180;
            return (0.5 + 0.5 * height * Math.Sin(angle), 0.5 + 0.5 * height * Math.Cos(angle));
        }

        double At(PoseFigures pose) => pose[_axis].Value * (_axis == SweepAxis.Frequency ? 1e-9 : 1);

        // Null for a value without decibels.
        double? Height(double value)
        {
            double? level = Level(value);
            return level.HasValue ? Math.Min(1, Math.Max(0, Y.Of(level.Value))) : (double?)null;
        }

        double? Level(double value) => _inDecibels ? Signal.Decibels(value) : value;
    }
}
