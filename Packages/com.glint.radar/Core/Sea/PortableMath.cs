using System;

namespace Glint.Core
{
    /// <summary>
    /// Elementary functions from + - * / alone. System.Math uses the platform's library, whose last bits differ between
    /// platforms; these functions give the same bits wherever double is IEEE 754.
    /// </summary>
    static class PortableMath
    {
        /// <summary>Relative error of <see cref="Exp"/>, and of <see cref="Log"/> away from 1.</summary>
        public const double RelativeError = 4e-16;

        /// <summary>Error of <see cref="SinCos"/> for an exact argument.</summary>
        public const double SinCosError = 2e-16;

        /// <summary><see cref="Exp"/> gives 0 below this argument, and is not defined above its negative.</summary>
        public const double MinExponent = -708;

        // ln 2 in two parts: the first has 21 zero bits at its end,
        // so that its multiples by whole numbers up to 2^20 are exact.
        const double Ln2High = 0.6931471803691238, Ln2Low = 1.9082149292705877e-10;

        /// <summary>e^x, for x up to 708.</summary>
        public static double Exp(double x)
        {
            if (x < MinExponent)
                return 0;
            double twos = Math.Floor(x / (Ln2High + Ln2Low) + 0.5);
            double rest = x - twos * Ln2High - twos * Ln2Low;
            // Taylor series from its smallest term. The argument is at most ln 2 / 2, the truncation error 4e-18.
            double sum = 1;
            for (int n = 13; n >= 1; n--)
                sum = 1 + sum * rest / n;
            return sum * BitConverter.Int64BitsToDouble(((long)twos + 1023) << 52);
        }

        /// <summary>Natural logarithm of a normal number above 0.</summary>
        public static double Log(double x)
        {
            long bits = BitConverter.DoubleToInt64Bits(x);
            long twos = (bits >> 52) - 1023;
            double part = BitConverter.Int64BitsToDouble((bits & 0xFFFFFFFFFFFFF) | (1023L << 52));
            if (part > 1.4142135623730951)
            {
                part /= 2;
                twos++;
            }
            // ln p = 2 artanh q, q at most 0.172: the truncation error is 1e-19.
            double q = (part - 1) / (part + 1), square = q * q, sum = 0;
            for (int n = 23; n >= 3; n -= 2)
                sum = (sum + 1.0 / n) * square;
            return twos * Ln2High + (twos * Ln2Low + 2 * q * sum + 2 * q);
        }

        /// <summary>x^y for x above 0.</summary>
        public static double Pow(double x, double y) => Exp(y * Log(x));

        /// <summary>
        /// Sine and cosine of an angle in turns. Range reduction needs no pi: multiples of 1/8 are exact.
        /// </summary>
        public static (double Sine, double Cosine) SinCos(double turns)
        {
            double eighths = 8 * (turns - Math.Floor(turns));
            int quarter = (int)(eighths + 1) / 2;
            double angle = (eighths - 2 * quarter) * (Math.PI / 4), square = angle * angle;
            // Taylor series. The angle is at most pi / 4, the truncation error 1e-19.
            double sine = 1, cosine = 1;
            for (int n = 17; n >= 3; n -= 2)
                sine = 1 - sine * square / (n * (n - 1));
            for (int n = 18; n >= 2; n -= 2)
                cosine = 1 - cosine * square / (n * (n - 1));
            sine *= angle;
            switch (quarter % 4)
            {
                case 0: return (sine, cosine);
                case 1: return (cosine, -sine);
                case 2: return (-sine, -cosine);
                default: return (-cosine, sine);
            }
        }
    }
}
