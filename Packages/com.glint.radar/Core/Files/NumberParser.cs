using System;
using System.Globalization;
using System.Text;

namespace Glint.Core
{
    /// <summary>
    /// Decimal numbers of text files: '.' for the point whatever the culture, correctly rounded to double.
    /// </summary>
    static class NumberParser
    {
        // Integers up to 2^53 and powers of ten up to 10^22 are exact doubles, so that one multiplication or division
        // of the two rounds once.
        const ulong LargestExact = 1UL << 53;
        const int LargestExactPower = 22;
        const int MaxDigits = 18;
        const int ExponentCap = 99999;

        static readonly double[] Powers =
        {
            1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13,
            1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22
        };

        /// <summary>
        /// Reads digits with sign, point and exponent, any of them optional;
        /// false for other text, "nan" and "inf" included.
        /// </summary>
        /// <param name="value">The number; infinite if it exceeds the range of double.</param>
        public static bool TryParse(ReadOnlySpan<byte> text, out double value)
        {
            int at = 0;
            bool negative = Sign(text, ref at);
            ulong mantissa = 0;
            int digits = Digits(text, ref at, ref mantissa);
            int fraction = 0;
            if (at < text.Length && text[at] == '.')
            {
                at++;
                fraction = Digits(text, ref at, ref mantissa);
            }
            int exponent = 0;
            value = 0;
            if (digits + fraction == 0 || !TryExponent(text, ref at, ref exponent) || at < text.Length)
                return false;

            int power = exponent - fraction;
            if (digits + fraction > MaxDigits || mantissa > LargestExact || Math.Abs(power) > LargestExactPower)
                value = ParseSlowly(text);
            else
                value = power < 0 ? mantissa / Powers[-power] : mantissa * Powers[power];
            if (negative)
                value = -value;
            return true;
        }

        static bool Sign(ReadOnlySpan<byte> text, ref int at)
        {
            if (at == text.Length || text[at] != '-' && text[at] != '+')
                return false;
            return text[at++] == '-';
        }

        static int Digits(ReadOnlySpan<byte> text, ref int at, ref ulong number)
        {
            int start = at;
            for (; at < text.Length && text[at] >= '0' && text[at] <= '9'; at++)
                number = unchecked(10 * number + (ulong)(text[at] - '0'));
            return at - start;
        }

        static bool TryExponent(ReadOnlySpan<byte> text, ref int at, ref int exponent)
        {
            if (at == text.Length || text[at] != 'e' && text[at] != 'E')
                return true;
            at++;
            bool negative = Sign(text, ref at);
            int start = at;
            for (; at < text.Length && text[at] >= '0' && text[at] <= '9'; at++)
                exponent = Math.Min(ExponentCap, 10 * exponent + (text[at] - '0'));
            if (negative)
                exponent = -exponent;
            return at > start;
        }

        // The text is known to be a number. Parsing fails only if overflow does not yield infinity, as on Mono.
        static double ParseSlowly(ReadOnlySpan<byte> text)
        {
            bool signed = text[0] == '-' || text[0] == '+';
            string magnitude = Encoding.ASCII.GetString(signed ? text.Slice(1) : text);
            return double.TryParse(magnitude, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
                ? value
                : double.PositiveInfinity;
        }
    }
}
