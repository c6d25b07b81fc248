using System;
using System.Globalization;

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

        // G15 rounds the largest doubles up to numbers that no double holds.
        static bool ReadsBack(string text, double value) =>
            double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double read) && read == value;
    }
}
