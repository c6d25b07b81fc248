using System;

namespace Glint.Core
{
    /// <summary>The error function and its complement, to 1e-13.</summary>
    static class ErrorFunction
    {
        // From here on the continued fraction converges fast.
        const double SeriesEnd = 2.5;
        const int FractionTerms = 60;

        public static double Erf(double x) =>
            Math.Abs(x) < SeriesEnd ? Series(x) : Math.Sign(x) * (1 - Tail(Math.Abs(x)));

        public static double Erfc(double x) => x < SeriesEnd ? 1 - Erf(x) : Tail(x);

        // All terms have one sign.
        static double Series(double x)
        {
            double term = x, sum = x;
            for (int n = 1; Math.Abs(term) > 1e-17 * Math.Abs(sum); n++)
            {
                term *= 2 * x * x / (2 * n + 1);
                sum += term;
            }
            return 2 / Math.Sqrt(Math.PI) * Math.Exp(-x * x) * sum;
        }

        static double Tail(double x)
        {
            double fraction = x;
            for (int n = FractionTerms; n >= 1; n--)
                fraction = x + n / 2.0 / fraction;
            return Math.Exp(-x * x) / (Math.Sqrt(Math.PI) * fraction);
        }
    }
}
