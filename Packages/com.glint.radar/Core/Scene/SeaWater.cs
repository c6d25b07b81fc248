using System;

namespace Glint.Core
{
    /// <summary>
    /// Permittivity of sea water by Meissner and Wentz: IEEE TGRS 42 (2004) 1836, with the coefficients of
    /// IEEE TGRS 50 (2012) 3004. Two Debye relaxations and the conductivity of the salt.
    /// </summary>
    static class SeaWater
    {
        /// <summary>Range of the model, Hz.</summary>
        public static readonly Interval Frequencies = Interval.Closed(1e9, 90e9);

        // Range of the model, degrees Celsius and practical salinity units.
        internal static readonly Interval Temperatures = Interval.Closed(-2, 29), Salinities = Interval.Closed(0, 40);

        /// <summary>Refuses water outside the range of the model.</summary>
        /// <exception cref="GlintException">Temperature or salinity is out of its range.</exception>
        public static void Validate(double celsius, double salinity)
        {
            if (!Temperatures.Contains(celsius))
                throw new GlintException($"sea water: temperature {Medium.Number(celsius)} C must be "
                    + $"{Temperatures}, the range of Meissner and Wentz' model: give one in that range, or the "
                    + "water's permittivity itself");
            if (!Salinities.Contains(salinity))
                throw new GlintException($"sea water: salinity {Medium.Number(salinity)} psu must be {Salinities}, "
                    + "the range of Meissner and Wentz' model: give one in that range (the ocean has 35), or the "
                    + "water's permittivity itself");
        }

        /// <summary>Permittivity at a frequency in Hz. No value is refused.</summary>
        /// <param name="t">Temperature, degrees Celsius.</param>
        /// <param name="s">Salinity, practical salinity units.</param>
        public static MediumSample At(double frequency, double t, double s)
        {
            // Permittivity at low, middle and high frequency, and both relaxation frequencies in GHz.
            double low = (3.70886e4 - 82.168 * t) / (421.854 + t) * Math.Exp(s * (-3.33330e-3 + 4.74868e-6 * s)),
                middle = (5.7230 + t * (2.2379e-2 - 7.1237e-4 * t))
                    * Math.Exp(s * (-6.28908e-3 + 1.76032e-4 * s - 9.22144e-5 * t)),
                high = (3.6143 + 2.8841e-2 * t) * (1 + s * (-2.04265e-3 + 1.57883e-4 * t)),
                slow = (45 + t) / (5.0478 + t * (-7.0315e-2 + 6.0059e-4 * t))
                    * (1 + s * (2.3232e-3 + t * (-7.9208e-5 + t * (3.6764e-6 + t * (-3.5594e-7 + t * 8.9795e-9))))),
                fast = (45 + t) / (0.13652 + t * (1.4825e-3 + 2.4166e-4 * t))
                    * (1 + s * (-1.99723e-2 + 1.81176e-4 / 2 * (t + 30)));

            // (e_from - e_to) / (1 + j r) = (e_from - e_to) (1 - j r) / (1 + r^2) for each relaxation.
            double gigahertz = frequency / Medium.HertzPerGigahertz, r1 = gigahertz / slow, r2 = gigahertz / fast;
            double first = (low - middle) / (1 + r1 * r1), second = (middle - high) / (1 + r2 * r2);
            return new MediumSample(frequency, first + second + high,
                first * r1 + second * r2 + Medium.LossOf(Conductivity(t, s), frequency));
        }

        // S/m.
        static double Conductivity(double t, double s)
        {
            double standard = 2.903602 + t * (8.607e-2 + t * (4.738817e-4 + t * (-2.991e-6 + t * 4.3047e-9)));
            double ofSalt = s * (37.5109 + s * (5.45216 + s * 1.4409e-2)) / (1004.75 + s * (182.283 + s));
            double a = (6.9431 + s * (3.2841 - s * 9.9486e-2)) / (84.850 + s * (69.024 + s)),
                b = 49.843 + s * (-0.2276 + s * 1.98e-3);
            return standard * ofSalt * (1 + (t - 15) * a / (b + t));
        }
    }
}
