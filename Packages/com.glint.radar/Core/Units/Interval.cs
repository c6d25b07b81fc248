using System;
using System.Globalization;

namespace Glint.Core
{
    /// <summary>The range of a number, both ends included, and its text for messages.</summary>
    public readonly struct Interval
    {
        readonly double _from, _to;

        Interval(double from, double to)
        {
            _from = from;
            _to = to;
        }

        /// <summary>A closed interval.</summary>
        public static Interval Closed(double from, double to) => new Interval(from, to);

        /// <summary>False for NaN.</summary>
        public bool Contains(double value) => value >= _from && value <= _to;

        /// <summary>"from 1 to 16", "from 1e-6 to 1e6".</summary>
        public override string ToString() => $"from {Text(_from)} to {Text(_to)}";

        static string Text(double value)
        {
            double size = Math.Abs(value);
            return value.ToString(size < 1e6 && (size >= 0.001 || size == 0) ? "R" : "0.###e0",
                CultureInfo.InvariantCulture);
        }
    }
}
