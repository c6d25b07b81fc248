using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// Reads the numbers of an option, written FROM:TO:STEP or as a list with commas.
    /// A <see cref="FormatException"/> says what they must be.
    /// </summary>
    public sealed class NumberList
    {
        /// <summary>Maximum number of values of one list.</summary>
        public const int Limit = 1000000;

        const double SmallestStep = 1e-9;

        // In steps, so that a STEP such as 0.333333333 reaches TO.
        const decimal EndTolerance = 1e-6m;

        readonly string _noun, _nouns, _unit;
        readonly (string range, string list) _examples;

        /// <summary>A list of numbers.</summary>
        /// <param name="noun">Noun of a number: "angle".</param>
        /// <param name="range">Of each number.</param>
        /// <param name="unit">"degrees".</param>
        /// <param name="examples">Of a range and of a list: "0:45:1", "0,10,45".</param>
        /// <param name="nouns">Plural of the noun, if it is not the noun with an s.</param>
        public NumberList(string noun, Interval range, string unit,
            (string range, string list) examples, string nouns = null)
        {
            _noun = noun;
            _nouns = nouns ?? noun + "s";
            Range = range;
            _unit = unit;
            _examples = examples;
        }

        /// <summary>Range of each number.</summary>
        public Interval Range { get; }

        /// <summary>Whether the numbers are whole; a range needs no STEP then.</summary>
        public bool IsWhole { get; set; }

        string Forms => $"give FROM:TO{(IsWhole ? "" : ":STEP")}, such as {_examples.range}, "
            + $"or a list, such as {_examples.list}";

        /// <summary>
        /// The numbers in the order given. FROM is included, and TO if whole steps reach it.
        /// </summary>
        /// <exception cref="FormatException">
        /// Malformed, empty, out of range, given twice or more than <see cref="Limit"/>.
        /// </exception>
        public double[] Read(string text)
        {
            if (string.IsNullOrWhiteSpace(text))
                throw new FormatException($"no {_nouns}: {Forms}");
            return text.Contains(':') ? Steps(text.Split(':')) : List(text.Split(','));
        }

        /// <summary>Like <see cref="Read"/>, with a message that names the text and its source.</summary>
        /// <exception cref="UsageException">
        /// Malformed, empty, out of range, given twice or more than <see cref="Limit"/>.
        /// </exception>
        public double[] Parse(string text, string where) => Values.Parse(Read, text, where);

        double[] List(string[] parts)
        {
            if (parts.Length > Limit)
                throw TooMany("give fewer");
            double[] numbers = parts.Select(Value).ToArray();
            var seen = new HashSet<double>();
            foreach (double number in numbers)
                if (!seen.Add(number))
                    throw new FormatException($"the {_noun} {Numbers.Format(number)} {_unit}".TrimEnd()
                        + " is given twice: give each once");
            return numbers;
        }

        double[] Steps(string[] parts)
        {
            if (IsWhole && parts.Length == 2)
                parts = new[] { parts[0], parts[1], "1" };
            if (parts.Length != 3)
                throw new FormatException($"a range has {(IsWhole ? "two or " : "")}three parts: {Forms}");
            double first = Value(parts[0]), last = Value(parts[1]), step = Number(parts[2]);
            if (step <= 0 || IsWhole && step % 1 != 0)
                throw new FormatException($"STEP must be {(IsWhole ? "a whole number " : "")}above 0");
            if (first > last)
                throw new FormatException("FROM must not be above TO");
            if (first == last)
                return new[] { first };
            if ((last - first) / step >= Limit)
                throw TooMany("use a larger STEP");
            if (step < SmallestStep)
                throw new FormatException("STEP must be at least "
                    + SmallestStep.ToString(CultureInfo.InvariantCulture));
            decimal from = ToDecimal(parts[0]), to = ToDecimal(parts[1]);
            if (to == from) // in the places of a decimal
                return new[] { first };
            // Any step larger than the range gives the same list; this one fits a decimal.
            return Steps(from, to, step > 2 * (last - first) ? 2 * (to - from) : ToDecimal(parts[2]));
        }

        // Decimal arithmetic: 0:1:0.1 contains 0.3, not 0.30000000000000004.
        static double[] Steps(decimal from, decimal to, decimal step)
        {
            decimal steps = (to - from) / step, whole = decimal.Round(steps);
            bool reachesEnd = whole > 0 && Math.Abs(steps - whole) <= EndTolerance;
            int last = (int)(reachesEnd ? whole : decimal.Floor(steps));
            var numbers = new double[last + 1];
            for (int i = 0; i <= last; i++)
                numbers[i] = Nearest(i == last && reachesEnd ? to : from + i * step);
            return numbers;
        }

        double Value(string text)
        {
            double value = Number(text);
            return Range.Contains(value) && !(IsWhole && value % 1 != 0)
                ? value
                : throw new FormatException(
                    $"each {_noun} must be {(IsWhole ? "a whole number " : "")}{Range} {_unit}".TrimEnd());
        }

        double Number(string text)
        {
            if (text.Trim().Length == 0)
                throw new FormatException("a number is missing: " + Forms);
            // + 0 turns -0 into 0.
            return Values.TryReal(text, out double value)
                ? value + 0.0
                : throw new FormatException($"{Values.Shown(text)} is not a number: {Forms}");
        }

        static decimal ToDecimal(string text) =>
            decimal.Parse(text.Trim(), NumberStyles.Float, CultureInfo.InvariantCulture);

        static double Nearest(decimal value) =>
            double.Parse(value.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture) + 0.0;

        FormatException TooMany(string remedy) =>
            new FormatException($"more than {Limit.ToString("N0", CultureInfo.InvariantCulture)} {_nouns}: {remedy}");
    }
}
