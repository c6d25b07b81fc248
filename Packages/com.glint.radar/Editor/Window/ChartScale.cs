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
        ChartScale(double low, double high, IEnumerable<double> ticks)
        {
            Low = low;
            High = high;
            Ticks = ticks.Select(tick => (Of(tick), Label(tick))).ToArray();
        }

        public double Low { get; }

        public double High { get; }

        /// <summary>Place and label.</summary>
        public IReadOnlyList<(double Place, string Label)> Ticks { get; }

        /// <summary>Place of a value.</summary>
        public double Of(double value) => (value - Low) / (High - Low);

        /// <summary>Just from the lowest to the highest value, with some ticks between.</summary>
        /// <param name="most">Ticks at most, about.</param>
        public static ChartScale Over(double low, double high, int most = 8)
        {
            Widen(ref low, ref high);
            double step = Step(high - low, most);
            return new ChartScale(low, high,
                Multiples(Math.Ceiling(low / step - 1e-9), Math.Floor(high / step + 1e-9), step));
        }

        /// <summary>Beyond both values, to the next ticks.</summary>
        public static ChartScale Around(double low, double high, int most = 6)
        {
            Widen(ref low, ref high);
            double step = Step(high - low, most), first = Math.Floor(low / step + 1e-9),
                last = Math.Ceiling(high / step - 1e-9);
            return new ChartScale(first * step, last * step, Multiples(first, last, step));
        }

        /// <summary>A turn, with a tick every 30 degrees.</summary>
        public static ChartScale Turn() => new ChartScale(0, 360, Multiples(0, 11, 30));

        /// <summary>A number as charts show it: few digits, thousands apart.</summary>
        public static string Label(double value)
        {
            double size = Math.Abs(value);
            return value.ToString(
                size != 0 && (size >= 1e7 || size < 1e-4) ? "0.###e0" : size >= 1000 ? "#,0.##" : "0.######",
                CultureInfo.InvariantCulture);
        }

        // A single value, or values that differ by rounding only, stand in the middle.
        static void Widen(ref double low, ref double high)
        {
            if (high - low > 1e-9 * Math.Max(Math.Abs(low), Math.Abs(high)))
                return;
            double half = Math.Max(1, 0.5 * Math.Abs(low));
            (low, high) = (low - half, high + half);
        }

        static double Step(double span, int most)
        {
            double power = Math.Pow(10, Math.Floor(Math.Log10(span / most)));
            return new[] { 1.0, 2, 5, 10 }.Select(factor => factor * power)
                .First(step => span / step <= most * (1 + 1e-9));
        }

        static IEnumerable<double> Multiples(double first, double last, double step)
        {
            for (double i = first; i <= last; i++)
                yield return i * step + 0.0; // -0 is a plain 0
        }
    }
}
