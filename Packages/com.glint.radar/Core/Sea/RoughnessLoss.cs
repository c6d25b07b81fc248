using System;

namespace Glint.Core
{
    /// <summary>
    /// Factor of the reflected field of a facet whose waves are shorter than itself: the part that stays a mirror's.
    /// It multiplies both Fresnel coefficients. Roughness is the product of wave number of the radar (rad/m), root mean
    /// square height of the short waves (m), and sine of the grazing angle.
    /// </summary>
    public static class RoughnessLoss
    {
        // Above it the series for large arguments ends below the rounding of double.
        const double LargeArgument = 30;

        /// <summary>exp(-2 roughness^2): Ament, Proc. IRE 41 (1953) 142, for normally distributed heights.</summary>
        public static double Ament(double roughness) => PortableMath.Exp(-2 * roughness * roughness);

        /// <summary>
        /// Ament's factor times I0(2 roughness^2): Miller, Brown and Vegh, IEE Proc. H 131 (1984) 114, nearer to
        /// measurements of rough seas.
        /// </summary>
        public static double MillerBrown(double roughness) => ScaledBessel(2 * roughness * roughness);

        /// <summary>exp(-x) I0(x), x of 0 or more.</summary>
        internal static double ScaledBessel(double x)
        {
            if (!(x <= LargeArgument))
                return double.IsPositiveInfinity(x) ? 0 : Asymptotic(x);
            double term = 1, sum = 1;
            for (int n = 1; term > sum * 1e-17; n++)
            {
                term *= x * x / (4.0 * n * n);
                sum += term;
            }
            return PortableMath.Exp(-x) * sum;
        }

        // Abramowitz and Stegun 9.7.1.
        static double Asymptotic(double x)
        {
            double term = 1, sum = 1;
            for (int n = 1; term > 1e-17; n++)
            {
                term *= (2 * n - 1) * (2 * n - 1) / (8.0 * n * x);
                sum += term;
            }
            return sum / Math.Sqrt(2 * Math.PI * x);
        }
    }
}
