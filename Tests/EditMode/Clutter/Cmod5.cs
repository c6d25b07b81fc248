using System;

namespace Glint.Tests
{
    /// <summary>
    /// CMOD5.N: sigma0 at C band, VV, fitted to measurements of satellite scatterometers (Hersbach, Stoffelen and de
    /// Haan, JGR 112 (2007) C03006; coefficients for neutral wind: Hersbach, JAOT 27 (2010) 721, table 1, as in
    /// github.com/nansencenter/openwind, openwind/gmf/cmod5n.py, and github.com/umr-lops/xsarsea).
    /// </summary>
    static class Cmod5
    {
        /// <summary>Coefficients of CMOD5.N, numbered from 1 as printed.</summary>
        public static readonly double[] Neutral =
        {
            0, -0.6878, -0.7957, 0.3380, -0.1728, 0.0000, 0.0040, 0.1103, 0.0159, 6.7329, 2.7713, -2.2885, 0.4971,
            -0.7250, 0.0450, 0.0066, 0.3222, 0.0120, 22.7000, 2.0813, 3.0000, 8.3659, -3.3428, 1.3236, 6.2437,
            2.3893, 0.3249, 4.1590, 1.6930
        };

        /// <summary>Coefficients of CMOD5, its predecessor for winds that are not corrected for stability.</summary>
        public static readonly double[] Predecessor =
        {
            0, -0.688, -0.793, 0.338, -0.173, 0, 0.004, 0.111, 0.0162, 6.34, 2.57, -2.18, 0.4, -0.6, 0.045, 0.007,
            0.33, 0.012, 22, 1.95, 3, 8.39, -3.44, 1.36, 5.35, 1.99, 0.29, 3.80, 1.53
        };

        /// <summary>Linear.</summary>
        /// <param name="c">The coefficients.</param>
        /// <param name="wind">Neutral wind, m/s.</param>
        /// <param name="azimuth">0: the radar looks against the wind, deg.</param>
        /// <param name="incidence">deg.</param>
        public static double Sigma0(double[] c, double wind, double azimuth, double incidence)
        {
            double x = (incidence - 40) / 25, phi = azimuth * Math.PI / 180;
            double a0 = c[1] + x * (c[2] + x * (c[3] + x * c[4])), a1 = c[5] + c[6] * x, a2 = c[7] + c[8] * x,
                gamma = c[9] + x * (c[10] + x * c[11]), s0 = c[12] + c[13] * x;
            double s = a2 * wind, a3 = 1 / (1 + Math.Exp(-Math.Max(s, s0)));
            if (s < s0)
                a3 *= Math.Pow(s / s0, s0 * (1 - a3));
            double b0 = Math.Pow(a3, gamma) * Math.Pow(10, a0 + a1 * wind);
            double b1 = (c[14] * (1 + x) - c[15] * wind * (0.5 + x - Math.Tanh(4 * (x + c[16] + c[17] * wind))))
                / (1 + Math.Exp(0.34 * (wind - c[18])));
            return b0 * Math.Pow(1 + b1 * Math.Cos(phi) + B2(c, wind, x) * Math.Cos(2 * phi), 1.6);
        }

        static double B2(double[] c, double wind, double x)
        {
            double v0 = c[21] + x * (c[22] + x * c[23]), d1 = c[24] + x * (c[25] + x * c[26]), d2 = c[27] + c[28] * x;
            double y0 = c[19], n = c[20], y = wind / v0 + 1;
            if (y < y0)
                y = y0 - (y0 - 1) / n + Math.Pow(y - 1, n) / (n * Math.Pow(y0 - 1, n - 1));
            return (-d1 + d2 * y) * Math.Exp(-y);
        }
    }
}
