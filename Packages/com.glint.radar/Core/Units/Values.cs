using System;
using System.Globalization;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Reads the values of options: invariant culture, finite, in range.
    /// A <see cref="FormatException"/> says what the value must be;
    /// the caller puts the option's name and the text before it.
    /// </summary>
    public static class Values
    {
        const NumberStyles RealStyle =
            NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent;
        const int LongestShown = 60;

        /// <summary>Reads a text, and names it and where it is written when it cannot be read.</summary>
        /// <param name="where">Null: the message begins with the text.</param>
        /// <exception cref="UsageException">Malformed or out of range.</exception>
        public static T Parse<T>(Func<string, T> read, string text, string where = null)
        {
            try
            {
                return read(text);
            }
            catch (FormatException error)
            {
                throw new UsageException($"{(where == null ? "" : where + " ")}{Shown(text)}: {error.Message}");
            }
        }

        /// <summary>A finite number.</summary>
        public static double Real(string text, Interval range) =>
            Checked(TryReal(text, out double value)
                ? value
                : throw new FormatException("must be a number, such as 0.5 or 10e9"), range, "must be ");

        /// <summary>A whole number.</summary>
        public static int Whole(string text, Interval range) =>
            (int)Checked(
                TryWhole(text, out double value) ? value : throw new FormatException($"must be a whole number {range}"),
                range, "must be ");

        /// <summary>ACROSSxDOWN.</summary>
        public static int2 Size(string text, Interval range)
        {
            var parts = text.Split('x', 'X');
            if (parts.Length != 2 || !TryWhole(parts[0], out double across) || !TryWhole(parts[1], out double down))
                throw new FormatException("must be ACROSSxDOWN, two whole numbers"
                    + (range.Contains(1920) ? ", such as 1920x1080" : $", each {range}"));
            return new int2((int)Each(across, range), (int)Each(down, range));
        }

        /// <summary>SIDE of a square, or WIDTHxHEIGHT.</summary>
        public static double2 Area(string text, Interval range)
        {
            var parts = text.Split('x', 'X');
            if (parts.Length > 2 || !TryReal(parts[0], out double width)
                || !TryReal(parts[parts.Length - 1], out double height))
                throw new FormatException("must be SIDE or WIDTHxHEIGHT in metres, such as 3 or 4x2.5");
            return new double2(Each(width, range), Each(height, range));
        }

        /// <summary>A,B.</summary>
        public static double2 Pair(string text, Interval range)
        {
            var parts = text.Split(',');
            if (parts.Length != 2 || !TryReal(parts[0], out double first) || !TryReal(parts[1], out double second))
                throw new FormatException("must be two numbers, such as 1.2,22");
            return new double2(Each(first, range), Each(second, range));
        }

        /// <summary>X,Y,Z.</summary>
        public static double3 Point(string text, Interval range)
        {
            var parts = text.Split(',');
            if (parts.Length != 3 || !TryReal(parts[0], out double x) || !TryReal(parts[1], out double y)
                || !TryReal(parts[2], out double z))
                throw new FormatException("must be X,Y,Z, three numbers, such as 0,1.5,-2");
            return new double3(Each(x, range), Each(y, range), Each(z, range));
        }

        /// <summary>LEFT,BOTTOM,WIDTH,HEIGHT.</summary>
        public static RayRegion Region(string text, Interval range)
        {
            var parts = text.Split(',');
            var numbers = new double[parts.Length];
            if (parts.Length != 4 || !parts.Select((part, i) => TryWhole(part, out numbers[i])).All(isWhole => isWhole))
                throw new FormatException("must be LEFT,BOTTOM,WIDTH,HEIGHT, four whole numbers, "
                    + "such as 480,0,960,540");
            var region = new RayRegion
            {
                Left = (int)Each(numbers[0], range), Bottom = (int)Each(numbers[1], range),
                Width = (int)Each(numbers[2], range), Height = (int)Each(numbers[3], range)
            };
            return region.Width > 0 && region.Height > 0
                ? region
                : throw new FormatException("must have a width and a height above 0");
        }

        /// <summary>"all" is 1, "none" 0, N is N.</summary>
        public static int Share(string text, Interval range)
        {
            switch (text)
            {
                case "all": return 1;
                case "none": return 0;
                default:
                    return TryWhole(text, out double value)
                    ? (int)Checked(value, range, "must be all, none or a number ")
                    : throw new FormatException("must be all, none or a whole number, such as 100 for every 100th ray");
            }
        }

        /// <summary>y or z.</summary>
        public static UpAxis Up(string text)
        {
            switch (text)
            {
                case "y": return UpAxis.Y;
                case "z": return UpAxis.Z;
                default: throw new FormatException("must be y or z");
            }
        }

        /// <summary>Value of an option that takes none.</summary>
        public const string GivenText = "given";

        /// <summary>The value of an option that takes none.</summary>
        public static bool Given(string text) => text == GivenText ? true : throw new FormatException("takes no value");

        /// <summary>Any text with more in it than blanks.</summary>
        public static string NotEmpty(string text) =>
            string.IsNullOrWhiteSpace(text) ? throw new FormatException("must not be empty") : text;

        /// <summary>A finite number, blanks around it allowed.</summary>
        public static bool TryReal(string text, out double value) =>
            double.TryParse(text.Trim(), RealStyle, CultureInfo.InvariantCulture, out value) && !double.IsNaN(value)
            && !double.IsInfinity(value);

        /// <summary>
        /// A text for messages: in quotes if its ends would be invisible, shortened if it is long.
        /// </summary>
        public static string Shown(string text)
        {
            if (text.Length > LongestShown)
                text = text.Substring(0, LongestShown) + "...";
            return text.Length == 0 || text.IndexOfAny(new[] { ' ', '\t', '\r', '\n' }) >= 0 ? "\""
                + text.Replace('\r', ' ').Replace('\n', ' ') + "\"" : text;
        }

        // Parsed as double: a number too long for an int is out of range, not malformed.
        static bool TryWhole(string text, out double value) =>
            double.TryParse(text.Trim(), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out value);

        static double Each(double value, Interval range) => Checked(value, range, "each number must be ");

        static double Checked(double value, Interval range, string must) =>
            range.Contains(value) ? value : throw new FormatException(must + range);
    }
}
