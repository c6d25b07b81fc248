using System;
using System.Globalization;

namespace Glint.Core
{
    /// <summary>The range of a number, and the words for it.</summary>
    readonly struct Interval
    {
        readonly double _from, _to;
        readonly bool _withFrom;

        Interval(double from, double to, bool withFrom)
        {
            _from = from;
            _to = to;
            _withFrom = withFrom;
        }

        /// <summary>Both ends allowed.</summary>
        public static Interval Closed(double from, double to) => new Interval(from, to, true);

        /// <summary>More than nothing, at most <paramref name="to"/>.</summary>
        public static Interval Positive(double to) => new Interval(0, to, false);

        /// <summary>False for NaN.</summary>
        public bool Contains(double value) => (_withFrom ? value >= _from : value > _from) && value <= _to;

        /// <summary>"from 1 to 16", "above 0 and at most 179".</summary>
        public override string ToString() => _withFrom ? $"from {Text(_from)} to {Text(_to)}" : $"above {Text(_from)} and at most {Text(_to)}";

        static string Text(double value) => value.ToString(Math.Abs(value) < 1e6 ? "R" : "0.###e0", CultureInfo.InvariantCulture);
    }
}
