using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// The poses of a sweep, in order: every value of each axis with every value of the others.
    /// The last of <see cref="SweepAxis.All"/> changes fastest, the first slowest: every angle for each grazing angle,
    /// all these for each range, and so on.
    /// </summary>
    public sealed class SweepPlan
    {
        /// <summary>Maximum number of poses of a sweep.</summary>
        public const int Limit = 10000000;

        /// <summary>One pose that moves nothing.</summary>
        public static readonly SweepPlan Single = new SweepPlan();

        static readonly ResultColumn[] s_columns = SweepAxis.All.Select(ResultColumn.Of).ToArray();

        // In the order of SweepAxis.All; null for an axis that is not swept.
        readonly IReadOnlyList<double>[] _values = new IReadOnlyList<double>[SweepAxis.All.Count];

        /// <summary>A plan over angles, snapshots, or both.</summary>
        /// <param name="angles">Turns of the target in degrees; null: not swept.</param>
        /// <param name="snapshots">Snapshots of the sea, from 1; null: not swept.</param>
        public SweepPlan(IReadOnlyList<double> angles, IReadOnlyList<int> snapshots = null)
            : this((SweepAxis.Angle, angles),
                (SweepAxis.Snapshot, snapshots?.Select(number => (double)number).ToArray()))
        {
        }

        /// <summary>A plan over any of the axes.</summary>
        /// <param name="axes">
        /// Each axis once, with its values in its unit; null: not swept.
        /// </param>
        /// <exception cref="UsageException">There are more than <see cref="Limit"/> poses.</exception>
        public SweepPlan(params (SweepAxis axis, IReadOnlyList<double> values)[] axes)
        {
            foreach (var (axis, values) in axes)
                _values[axis.Index] = values;
            long count = 1;
            foreach (var values in _values.Where(values => values != null))
            {
                count *= values.Count;
                if (count > Limit)
                    throw new UsageException("the sweep has more than "
                        + $"{Limit.ToString("N0", CultureInfo.InvariantCulture)} poses: shorten a list");
            }
            Count = (int)count;
        }

        /// <summary>A plan over the axes that a source of lists has values for.</summary>
        /// <param name="values">The values of an axis in its unit; null where it is left alone.</param>
        /// <exception cref="UsageException">There are more than <see cref="Limit"/> poses.</exception>
        public SweepPlan(Func<SweepAxis, IReadOnlyList<double>> values)
            : this(SweepAxis.All.Select(axis => (axis, values(axis))).ToArray())
        {
        }

        /// <summary>The plan whose lists are in an identity.</summary>
        /// <exception cref="FormatException">They are not there, or damaged.</exception>
        /// <exception cref="UsageException">There are more than <see cref="Limit"/> poses.</exception>
        public static SweepPlan Of(SweepIdentity identity)
        {
            if (SweepAxis.All.All(axis => identity.Find(axis.Column) == null))
                throw new FormatException("it has no list of an axis");
            return new SweepPlan(axis => identity.FindList(axis.Column));
        }

        /// <summary>Poses in all.</summary>
        public int Count { get; }

        /// <summary>A pose.</summary>
        /// <param name="pose">Its number, from 0 to <see cref="Count"/> - 1.</param>
        public SweepPose this[int pose]
        {
            get
            {
                var values = new double?[_values.Length];
                for (int i = _values.Length - 1; i >= 0; i--)
                {
                    if (_values[i] == null)
                        continue;
                    values[i] = _values[i][pose % _values[i].Count];
                    pose /= _values[i].Count;
                }
                return new SweepPose(values);
            }
        }

        /// <summary>
        /// What is wrong with the place of a stored row, such as "is of 15 deg instead of 10 deg"; null: nothing.
        /// </summary>
        /// <param name="pose">Its number in the plan.</param>
        public string ProblemOf(int pose, StoredRow stored)
        {
            var row = new SweepRow(this[pose], null);
            var planned = s_columns.Select(column => column.Value(row)).ToArray();
            return planned.SequenceEqual(s_columns.Select(column => stored[column])) ? null
                : $"is of {stored.Name} instead of {new SweepPose(planned)}";
        }

        /// <summary>The values on an axis, in its unit; null if it is not swept.</summary>
        public IReadOnlyList<double> Values(SweepAxis axis) => _values[axis.Index];

        /// <summary>Whether an axis has values.</summary>
        public bool Has(SweepAxis axis) => Values(axis) != null;

        /// <summary>
        /// Index of the first pose whose value on an axis differs from that of the first pose; 0 if there is none.
        /// </summary>
        public int FirstChange(SweepAxis axis)
        {
            if (!Has(axis))
                return 0;
            int inner = 1, change = 1;
            for (int i = axis.Index + 1; i < _values.Length; i++)
                inner *= _values[i]?.Count ?? 1;
            while (change < Values(axis).Count && Values(axis)[change] == Values(axis)[0])
                change++;
            return change < Values(axis).Count ? change * inner : 0;
        }

        /// <summary>Whether an axis has more than one value.</summary>
        public bool Varies(SweepAxis axis) => Has(axis) && Values(axis).Count > 1;
    }
}
