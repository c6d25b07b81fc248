using System;
using System.Globalization;
using System.IO;

namespace Glint.Core
{
    /// <summary>Numbers as text in result files.</summary>
    public static class Numbers
    {
        // .NET's R gives the shortest digits, Mono's 15 or 17. Trying 15 to 17 makes both write the same.
        static readonly string[] Formats = { "R", "G15", "G16", "G17" };

        // Whether R gives the shortest digits: the smallest double has one.
        static readonly bool s_isShortest =
            double.Epsilon.ToString("R", CultureInfo.InvariantCulture) == "5E-324";

        // Letters of a double in R, at most: -1.2345678901234567E-123.
        const int MaxLength = 32;

        // From here on R writes powers of ten where more digits without one may be shorter.
        const double MinPower = 1e15;

        /// <summary>
        /// The shortest text that reads back as the same double: '.'
        /// for the point, "1E+20" for large powers, "0" for both zeros.
        /// </summary>
        /// <exception cref="ArgumentOutOfRangeException">The number is NaN or infinite.</exception>
        public static string Format(double value)
        {
            if (double.IsNaN(value) || double.IsInfinity(value))
                throw new ArgumentOutOfRangeException(nameof(value), value, "a result must be finite");
            if (value == 0)
                return "0";
            if (s_isShortest && Math.Abs(value) < MinPower)
                return value.ToString("R", CultureInfo.InvariantCulture);
            string shortest = null;
            foreach (string format in Formats)
            {
                string text = value.ToString(format, CultureInfo.InvariantCulture);
                if ((shortest == null || text.Length < shortest.Length) && ReadsBack(text, value))
                    shortest = text;
            }
            return shortest;
        }

        /// <summary>Writes <see cref="Format"/>, without a string of its own where R is the shortest.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The number is NaN or infinite.</exception>
        public static void Write(TextWriter text, double value)
        {
            Span<char> letters = stackalloc char[MaxLength];
            // Comparisons with NaN are false.
            if (s_isShortest && value != 0 && Math.Abs(value) < MinPower
                && value.TryFormat(letters, out int length, "R", CultureInfo.InvariantCulture))
                text.Write(letters.Slice(0, length));
            else
                text.Write(Format(value));
        }

        // G15 rounds the largest doubles up to numbers that no double holds.
        static bool ReadsBack(string text, double value) =>
            double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double read) && read == value;
    }
}
