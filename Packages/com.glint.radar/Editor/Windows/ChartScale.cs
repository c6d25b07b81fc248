using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Glint.Editor
{
    /// <summary>
    /// An axis of a chart: from 0 at its low end to 1 at its high end,
    /// with ticks at whole multiples of 1, 2 or 5 times a power of ten.
    /// </summary>
    sealed class ChartScale
    {
        ChartScale(double min, double max, IEnumerable<double> ticks)
        {
            Min = min;
            Max = max;
            Ticks = ticks.Select(tick => (Of(tick), Label(tick))).ToArray();
        }

        public double Min { get; }

        public double Max { get; }

        /// <summary>Position and label.</summary>
        public IReadOnlyList<(double Position, string Label)> Ticks { get; }

        /// <summary>Position of a value.</summary>
        public double Of(double value) => (value - Min) / (Max - Min);

        /// <summary>A scale from the lowest to the highest value, with ticks between.</summary>
        /// <param name="limit">Approximate maximum number of ticks.</param>
        public static ChartScale Over(double min, double max, int limit = 8)
        {
            Widen(ref min, ref max);
            double step = Step(max - min, limit);
            return new ChartScale(min, max,
                Multiples(Math.Ceiling(min / step - 1e-9), Math.Floor(max / step + 1e-9), step));
        }

        /// <summary>A scale from the tick below the smaller value to the tick above the larger.</summary>
        public static ChartScale Around(double min, double max, int limit = 6)
        {
            Widen(ref min, ref max);
            double step = Step(max - min, limit), first = Math.Floor(min / step + 1e-9),
                last = Math.Ceiling(max / step - 1e-9);
            return new ChartScale(first * step, last * step, Multiples(first, last, step));
        }

        /// <summary>A number for charts: few digits, thousands separated.</summary>
        public static string Label(double value)
        {
            double size = Math.Abs(value);
            return value.ToString(
                size != 0 && (size >= 1e7 || size < 1e-4) ? "0.###e0" : size >= 1000 ? "#,0.##" : "0.######",
                CultureInfo.InvariantCulture);
        }

        // Centres a single value, or values that differ by rounding only.
        static void Widen(ref double min, ref double max)
        {
            if (max - min > 1e-9 * Math.Max(Math.Abs(min), Math.Abs(max)))
                return;
            double half = Math.Max(1, 0.5 * Math.Abs(min));
            (min, max) = (min - half, max + half);
        }

        static double Step(double span, int max)
        {
            double power = Math.Pow(10, Math.Floor(Math.Log10(span / max)));
            return new[] { 1.0, 2, 5, 10 }.Select(factor => factor * power)
                .First(step => span / step <= max * (1 + 1e-9));
        }

        static IEnumerable<double> Multiples(double first, double last, double step)
        {
            for (double i = first; i <= last; i++)
                yield return i * step + 0.0; // -0 becomes 0
        }
    }
}
