using System;

namespace Glint.Core
{
    /// <summary>
    /// Attenuation of a horizontal ray by rain: Recommendation ITU-R P.838-3 (2005), k rate^alpha, from 1 to 1000 GHz.
    /// </summary>
    public static class RainAttenuation
    {
        // Tables 1 to 4: a, b, c of the terms a exp(-((x - b) / c)^2) over x, the decimal logarithm of the frequency in GHz.
        static readonly double[,] s_kH =
            {
                { -5.33980, -0.10008, 1.13098 }, { -0.35351, 1.26970, 0.45400 }, { -0.23789, 0.86036, 0.15354 },
                { -0.94158, 0.64552, 0.16817 }
            },
            s_kV =
            {
                { -3.80595, 0.56934, 0.81061 }, { -3.44965, -0.22911, 0.51059 }, { -0.39902, 0.73042, 0.11899 },
                { 0.50167, 1.07319, 0.27195 }
            },
            s_alphaH =
            {
                { -0.14318, 1.82442, -0.55187 }, { 0.29591, 0.77564, 0.19822 }, { 0.32177, 0.63773, 0.13164 },
                { -5.37610, -0.96230, 1.47828 }, { 16.1721, -3.29980, 3.43990 }
            },
            s_alphaV =
            {
                { -0.07771, 2.33840, -0.76284 }, { 0.56727, 0.95545, 0.54039 }, { -0.20238, 1.14520, 0.26809 },
                { -48.2991, 0.791669, 0.116226 }, { 48.5833, 0.791459, 0.116479 }
            };

        /// <summary>Decibels a kilometre, one way.</summary>
        /// <param name="frequency">Hertz, 1 GHz or more.</param>
        /// <param name="rate">mm/h.</param>
        /// <param name="isHorizontal">Whether the polarisation is horizontal; else vertical.</param>
        public static double DecibelsAKilometre(double frequency, double rate, bool isHorizontal)
        {
            if (rate == 0)
                return 0;
            double x = Math.Log10(1e-9 * frequency);
            double k = isHorizontal ? Sum(s_kH, x) - 0.18961 * x + 0.71147 : Sum(s_kV, x) - 0.16398 * x + 0.63297,
                alpha = isHorizontal ? Sum(s_alphaH, x) + 0.67849 * x - 1.95537
                    : Sum(s_alphaV, x) - 0.053739 * x + 0.83433;
            return Math.Pow(10, k) * Math.Pow(rate, alpha);
        }

        static double Sum(double[,] terms, double x)
        {
            double sum = 0;
            for (int i = 0; i < terms.GetLength(0); i++)
                sum += terms[i, 0] * Math.Exp(-Math.Pow((x - terms[i, 1]) / terms[i, 2], 2));
            return sum;
        }
    }
}
