using System;
using System.Globalization;
using System.Linq;

namespace Glint.Core
{
    /// <summary>The angles of a sweep, degrees, written FROM:TO:STEP or as a list with commas.</summary>
    public static class Angles
    {
        /// <summary>Most angles of one sweep.</summary>
        public const int Limit = 1000000;

        const string Forms = "give FROM:TO:STEP, such as 0:45:1, or a list, such as 0,10,45";
        const double SmallestStep = 1e-9;

        // Unity turns objects by single-precision angles: another turn only costs digits.
        static readonly Interval Turn = Interval.Closed(-360, 360);

        // In steps: a STEP written as 0.333333333 still reaches TO.
        const decimal EndTolerance = 1e-6m;

        /// <summary>The angles in the order written. FROM and TO are both included, TO when whole steps reach it.</summary>
        /// <exception cref="UsageException">Malformed, empty, out of range or more than <see cref="Limit"/>.</exception>
        public static double[] Parse(string text)
        {
            try
            {
                return Read(text);
            }
            catch (FormatException error)
            {
                throw new UsageException($"{Values.Shown(text)}: {error.Message}");
            }
        }

        internal static double[] Read(string text)
        {
            if (string.IsNullOrWhiteSpace(text))
                throw new FormatException("no angles: " + Forms);
            return text.Contains(':') ? Range(text.Split(':')) : List(text.Split(','));
        }

        static double[] List(string[] parts) => parts.Length <= Limit ? parts.Select(Angle).ToArray() : throw TooMany("give fewer");

        static double[] Range(string[] parts)
        {
            if (parts.Length != 3)
                throw new FormatException("a range has three parts: " + Forms);
            double first = Angle(parts[0]), last = Angle(parts[1]), step = Number(parts[2]);
            if (step <= 0)
                throw new FormatException("STEP must be above 0");
            if (first > last)
                throw new FormatException("FROM must not be above TO");
            if (first == last)
                return new[] { first };
            if ((last - first) / step >= Limit)
                throw TooMany("take a larger STEP");
            if (step < SmallestStep)
                throw new FormatException("STEP must be at least " + SmallestStep.ToString(CultureInfo.InvariantCulture));
            // A step beyond the range is as good as any other that is, and fits a decimal.
            return Steps(Exact(parts[0]), Exact(parts[1]), step > 1000 ? 1000 : Exact(parts[2]));
        }

        // Decimal arithmetic: 0:1:0.1 has 0.3 in it, not 0.30000000000000004.
        static double[] Steps(decimal from, decimal to, decimal step)
        {
            decimal steps = (to - from) / step, whole = decimal.Round(steps);
            bool reachesEnd = whole > 0 && Math.Abs(steps - whole) <= EndTolerance;
            int last = (int)(reachesEnd ? whole : decimal.Floor(steps));
            var angles = new double[last + 1];
            for (int i = 0; i <= last; i++)
                angles[i] = Nearest(i == last && reachesEnd ? to : from + i * step);
            return angles;
        }

        static double Angle(string text)
        {
            double angle = Number(text);
            return Turn.Contains(angle) ? angle : throw new FormatException($"each angle must be {Turn} degrees");
        }

        static double Number(string text)
        {
            if (text.Trim().Length == 0)
                throw new FormatException("a number is missing: " + Forms);
            // + 0 makes -0 a plain 0.
            return Values.TryReal(text, out double value) ? value + 0.0 : throw new FormatException($"{Values.Shown(text)} is not a number: {Forms}");
        }

        static decimal Exact(string text) => decimal.Parse(text.Trim(), NumberStyles.Float, CultureInfo.InvariantCulture);

        static double Nearest(decimal value) => double.Parse(value.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture) + 0.0;

        static FormatException TooMany(string remedy) => new FormatException($"more than {Limit.ToString("N0", CultureInfo.InvariantCulture)} angles: {remedy}");
    }
}
