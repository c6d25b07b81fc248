using System;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// The snapshots of a sweep, counted from 1, written FROM:TO, FROM:TO:STEP or as a list with commas.
    /// </summary>
    public static class Snapshots
    {
        const string Forms = "give FROM:TO, such as 1:10, or a list, such as 1,4,9";

        static readonly Interval Numbers = Interval.Closed(1, 1000000);

        /// <summary>
        /// The snapshots in the order given. FROM is included, and TO if whole steps reach it.
        /// </summary>
        /// <exception cref="UsageException">Malformed, empty or out of range.</exception>
        public static int[] Parse(string text)
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

        internal static int[] Read(string text)
        {
            if (string.IsNullOrWhiteSpace(text))
                throw new FormatException("no snapshots: " + Forms);
            if (!text.Contains(':'))
                return text.Split(',').Select(Number).ToArray();
            var parts = text.Split(':').Select(Number).ToArray();
            if (parts.Length > 3)
                throw new FormatException("a range has two or three parts: " + Forms);
            int first = parts[0], last = parts[1], step = parts.Length == 3 ? parts[2] : 1;
            if (first > last)
                throw new FormatException("FROM must not be above TO");
            return Enumerable.Range(0, (last - first) / step + 1).Select(i => first + i * step).ToArray();
        }

        static int Number(string text)
        {
            try
            {
                return Values.Whole(text, Numbers);
            }
            catch (FormatException error)
            {
                throw new FormatException($"each number {error.Message}: {Forms}");
            }
        }
    }
}
