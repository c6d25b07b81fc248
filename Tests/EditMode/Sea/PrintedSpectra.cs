using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Tests
{
    /// <summary>The spectra as printed in their papers, with System.Math.</summary>
    static class PrintedSpectra
    {
        const double Gravity = 9.81;

        /// <summary>JONSWAP's peak frequency, radians a second.</summary>
        public static double Peak(double wind, double fetch) =>
            22 * Math.Pow(Gravity * Gravity / (wind * fetch), 1 / 3.0);

        /// <summary>
        /// Variance of each wave of the grid by column and row, scaled to the requested height if there is one. Of
        /// each pair k, -k it is the wave with row above 0, or with row 0 and column above 0.
        /// </summary>
        public static Dictionary<(int, int), double> Variances(SeaSettings s)
        {
            double wx = Math.Sin(s.WindDirectionDegrees * Math.PI / 180),
                wz = Math.Cos(s.WindDirectionDegrees * Math.PI / 180);
            int reach = s.GridSize / 2 - 1;
            var waves = new Dictionary<(int, int), double>();
            for (int row = 0; row <= reach; row++)
                for (int column = -reach; column <= reach; column++)
                {
                    if (row == 0 && column <= 0)
                        continue;
                    double k = 2 * Math.PI / s.TileSize * Math.Sqrt(row * row + column * column),
                        cosine = 2 * Math.PI / s.TileSize * (column * wx + row * wz) / k;
                    if (s.Kind == SeaSpectrumKind.Elfouhaily)
                        waves[(column, row)] = Elfouhaily(s, k, cosine);
                    else if (Math.Abs(cosine) > 1e-12)
                        waves[(column, row)] = Printed(s, k) * 2 / Math.PI * cosine * cosine;
                }
            if (s.SignificantWaveHeight == 0)
            {
                double area = Math.Pow(2 * Math.PI / s.TileSize, 2);
                return waves.ToDictionary(wave => wave.Key, wave => area * wave.Value);
            }
            double scale = s.SignificantWaveHeight * s.SignificantWaveHeight / 16 / waves.Values.Sum();
            return waves.ToDictionary(wave => wave.Key, wave => scale * wave.Value);
        }

        // Elfouhaily et al. 1997, equations 3 to 67 by their symbols: both ways along k together.
        static double Elfouhaily(in SeaSettings s, double k, double cosine)
        {
            double u = s.WindSpeed, km = 370, cm = 0.23, k0 = Gravity / (u * u);
            double omega = s.Fetch == 0 ? 0.84
                : 0.84 * Math.Pow(Math.Tanh(Math.Pow(k0 * s.Fetch / 2.2e4, 0.4)), -0.75);
            double Speed(double number) => Math.Sqrt(Gravity / number * (1 + number * number / (km * km)));
            double kp = k0 * omega * omega, cp = Speed(kp), c = Speed(k);
            double friction = Math.Sqrt((0.8 + 0.065 * u) * 1e-3) * u;
            double gamma = omega <= 1 ? 1.7 : 1.7 + 6 * Math.Log10(omega);
            double sigma = 0.08 * (1 + 4 * Math.Pow(omega, -3));
            double root = Math.Sqrt(k / kp) - 1;
            double jp = Math.Pow(gamma, Math.Exp(-root * root / (2 * sigma * sigma)));
            double lpm = Math.Exp(-1.25 * Math.Pow(kp / k, 2));
            double alphaM = 0.01 * (1 + (friction < cm ? 1 : 3) * Math.Log(friction / cm));
            double bl = 0.5 * 0.006 * Math.Sqrt(omega) * cp / c * lpm * jp
                * Math.Exp(-omega / Math.Sqrt(10) * root);
            double bh = 0.5 * alphaM * cm / c * lpm * jp * Math.Exp(-0.25 * Math.Pow(k / km - 1, 2));
            double delta = Math.Tanh(Math.Log(2) / 4 + 4 * Math.Pow(c / cp, 2.5)
                + 0.13 * friction / cm * Math.Pow(cm / c, 2.5));
            double twoSided = (bl + bh) * Math.Pow(k, -4) / (2 * Math.PI)
                * (1 + delta * Math.Cos(2 * Math.Acos(Math.Max(-1, Math.Min(1, cosine)))));
            return 2 * twoSided;
        }

        static double Printed(in SeaSettings s, double k)
        {
            double u = s.WindSpeed, u19 = 1.026 * u, w = Math.Sqrt(Gravity * k);
            if (s.Kind == SeaSpectrumKind.Phillips)
                return Math.Exp(-Math.Pow(k * u * u / Gravity, -2)) * Math.Pow(k, -4);
            double perFrequency;
            if (s.Kind == SeaSpectrumKind.PiersonMoskowitz)
                perFrequency = 0.0081 * Gravity * Gravity * Math.Pow(w, -5)
                    * Math.Exp(-0.74 * Math.Pow(Gravity / (u19 * w), 4));
            else
            {
                double peak = Peak(u, s.Fetch), width = w <= peak ? 0.07 : 0.09;
                double r = Math.Exp(-(w - peak) * (w - peak) / (2 * width * width * peak * peak));
                double alpha = 0.076 * Math.Pow(u * u / (s.Fetch * Gravity), 0.22);
                perFrequency =
                    alpha * Gravity * Gravity * Math.Pow(w, -5) * Math.Exp(-1.25 * Math.Pow(peak / w, 4))
                    * Math.Pow(s.PeakEnhancement, r);
            }
            // dw/dk = g / 2w, and a ring's area.
            return perFrequency * Gravity / (2 * w) / k;
        }
    }
}
