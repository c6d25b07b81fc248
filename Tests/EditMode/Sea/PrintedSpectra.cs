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
        /// Variance of each wave of the grid by column and row, scaled to the requested height. Of each pair k, -k it
        /// is the wave with row above 0, or with row 0 and column above 0.
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
                    if (Math.Abs(cosine) > 1e-12)
                        waves[(column, row)] = Printed(s, k) * cosine * cosine;
                }
            double scale = s.SignificantWaveHeight * s.SignificantWaveHeight / 16 / waves.Values.Sum();
            return waves.ToDictionary(wave => wave.Key, wave => scale * wave.Value);
        }

        static double Printed(in SeaSettings s, double k)
        {
            double u = s.WindSpeed, u19 = 1.026 * u, w = Math.Sqrt(Gravity * k);
            if (s.Kind == SeaSpectrumKind.Phillips)
                return Math.Exp(-Math.Pow(k * u * u / Gravity, -2)) * Math.Pow(k, -4);
            double perFrequency;
            if (s.Kind == SeaSpectrumKind.PiersonMoskowitz)
                perFrequency = Math.Pow(w, -5) * Math.Exp(-0.74 * Math.Pow(Gravity / (u19 * w), 4));
            else
            {
                double peak = Peak(u, s.Fetch), width = w <= peak ? 0.07 : 0.09;
                double r = Math.Exp(-(w - peak) * (w - peak) / (2 * width * width * peak * peak));
                perFrequency =
                    Math.Pow(w, -5) * Math.Exp(-1.25 * Math.Pow(peak / w, 4)) * Math.Pow(s.PeakEnhancement, r);
            }
            // dw/dk = g / 2w, and a ring's area.
            return perFrequency * Gravity / (2 * w) / k;
        }
    }
}
